// SPDX-License-Identifier: MIT
// Every way to change a World, times awake, asleep and about to sleep, times touching, overlapping
// and apart, times the type of the body and whether it is a sensor. Sleep must not show: bodies
// move and touch as in a World without sleep. Changes are gentle: tumbling would magnify rounding.
#include <kodo/kodo.hpp>
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <tuple>

namespace kodo {
namespace {

enum class State { Awake, AboutToSleep, Asleep };
enum class Relation { Touching, Overlapping, Apart };

/// A box A rests on the floor, and the subject B is where the relation says.
struct SetterCase {
    State state;
    Relation relation;
    BodyType type;
    bool sensor;
};

struct Pair {
    World world;
    BodyId box;
    BodyId subject;
};

struct NamedChange {
    const char* name;
    std::function<void(World&, BodyId box, BodyId subject)> apply;
};

constexpr Real kStep = support::kDt;
constexpr int kSteps = 60;
constexpr Vec2 kHome{0, Real(0.5)}; // of A

Vec2 placeOf(Relation relation) {
    return relation == Relation::Touching      ? Vec2{0, Real(1.25)}
           : relation == Relation::Overlapping ? Vec2{Real(0.2), Real(0.9)}
                                               : Vec2{3, Real(0.25)};
}

/// A dynamic sensor falls, so it is locked. What overlaps without being a sensor is disabled.
Flags flagsOf(const SetterCase& is) {
    const Flags locked = is.sensor && is.type == BodyType::Dynamic ? kLockMove | kLockRotate : 0;
    const bool disabled = is.relation == Relation::Overlapping && !is.sensor;
    const bool held = disabled && is.type == BodyType::Dynamic;
    return locked | (is.sensor ? kSensor : 0) | (disabled ? kDisabled : 0) |
           (held ? kLockMove | kLockRotate : 0);
}

Pair build(const SetterCase& is) {
    Pair pair{World({.gravity = support::kEarth}), {}, {}};
    support::addFloor(pair.world);
    pair.box = pair.world.add(support::boxDef(kHome, 1, 1));
    BodyDef subject = support::boxDef(placeOf(is.relation), Real(0.5), Real(0.5));
    subject.type = is.type;
    subject.flags = flagsOf(is);
    pair.subject = pair.world.add(subject);
    return pair;
}

/// The same bodies, with the same ids, without sleep.
Pair withoutSleep(Pair pair) {
    pair.world.setSettings({.leaveOut = Feature::Sleep});
    return pair;
}

/// Steps until A sleeps; 0 if it does not.
int stepsToSleep(Pair pair) {
    for (int step = 1; step <= 200; ++step) {
        pair.world.step(kStep);
        if (pair.world[pair.box].isAsleep()) {
            return step;
        }
    }
    return 0;
}

JointEnds endsAt(const World& world, BodyId a, BodyId b) {
    const Vec2 at = world[a].position();
    return {.a = a, .b = b, .anchorB = toLocal(world[b].transform(), at), .collide = true};
}

const std::vector<NamedChange>& bodyChanges() {
    static const std::vector<NamedChange> changes = {
        {"setPosition onto the box",
         [](World& w, BodyId, BodyId b) {
             w[b].setPosition({Real(0.1), Real(1.1)});
         }},
        {"setPosition beside the box",
         [](World& w, BodyId, BodyId b) {
             w[b].setPosition({Real(0.75), Real(0.5)});
         }},
        {"setPosition far away",
         [](World& w, BodyId, BodyId b) {
             w[b].setPosition({9, 9});
         }},
        {"setPosition of the box",
         [](World& w, BodyId a, BodyId) {
             w[a].setPosition({6, 2});
         }},
        {"setRotation",
         [](World& w, BodyId, BodyId b) { w[b].setRotation(Rot::fromAngle(Real(0.7))); }},
        {"setVelocity",
         [](World& w, BodyId, BodyId b) {
             w[b].setVelocity({Real(0.5), 0});
         }},
        {"setVelocity towards the box",
         [](World& w, BodyId, BodyId b) {
             w[b].setVelocity({-3, 0});
         }},
        {"setAngularVelocity", [](World& w, BodyId, BodyId b) { w[b].setAngularVelocity(1); }},
        {"moveTo",
         [](World& w, BodyId, BodyId b) {
             w[b].moveTo(w[b].position() + Vec2{0, Real(0.02)}, kStep);
         }},
        {"applyForce",
         [](World& w, BodyId, BodyId b) {
             w[b].applyForce({30, 0});
         }},
        {"applyTorque", [](World& w, BodyId, BodyId b) { w[b].applyTorque(1); }},
        {"applyImpulse",
         [](World& w, BodyId, BodyId b) {
             w[b].applyImpulse({Real(0.2), Real(0.05)});
         }},
    };
    return changes;
}

const std::vector<NamedChange>& propertyChanges() {
    static const std::vector<NamedChange> changes = {
        {"setType static", [](World& w, BodyId, BodyId b) { w[b].setType(BodyType::Static); }},
        {"setType kinematic",
         [](World& w, BodyId, BodyId b) { w[b].setType(BodyType::Kinematic); }},
        {"setType dynamic", [](World& w, BodyId, BodyId b) { w[b].setType(BodyType::Dynamic); }},
        {"setFlags none", [](World& w, BodyId, BodyId b) { w[b].setFlags(0); }},
        {"setFlags disabled", [](World& w, BodyId, BodyId b) { w[b].setFlags(kDisabled); }},
        {"setFlags sensor", [](World& w, BodyId, BodyId b) { w[b].setFlags(kSensor | kLockMove); }},
        {"setFlags locked",
         [](World& w, BodyId, BodyId b) { w[b].setFlags(kLockMove | kLockRotate); }},
        {"setRequired of a filter",
         [](World& w, BodyId, BodyId b) {
             w[b].setFlags(kMatchAny);
             w[b].setRequired(2);
         }},
        {"setUserData", [](World& w, BodyId, BodyId b) { w[b].setUserData(7); }},
        {"setGroup", [](World& w, BodyId, BodyId b) { w[b].setGroup(-1); }},
        {"setContinuousMode",
         [](World& w, BodyId, BodyId b) { w[b].setContinuousMode(ContinuousMode::Never); }},
        {"setPart",
         [](World& w, BodyId, BodyId b) {
             Part part = w[b].part(0);
             part.filter = CollisionFilter{kSensor};
             w[b].setPart(0, part);
         }},
        {"setMaterial", [](World& w, BodyId, BodyId b) { w[b].setMaterial(support::slippery(1)); }},
        {"setMass", [](World& w, BodyId, BodyId b) { w[b].setMass(3); }},
        {"setMass of the box, with a centre",
         [](World& w, BodyId a, BodyId) {
             w[a].setMass({.mass = 2, .center = Vec2{Real(0.1), Real(-0.2)}});
         }},
        {"setMass and setMassFromDensity",
         [](World& w, BodyId, BodyId b) {
             w[b].setMass(3);
             w[b].setMassFromDensity();
         }},
        {"copyFrom the box",
         [](World& w, BodyId a, BodyId b) {
             w[b].copyFrom(w[a]);
             w[b].setPosition({4, Real(0.25)});
         }},
        {"wake", [](World& w, BodyId, BodyId b) { w[b].wake(); }},
        {"wake the box", [](World& w, BodyId a, BodyId) { w[a].wake(); }},
        {"wake the floor", [](World& w, BodyId, BodyId) { w[w.bodies()[0]].wake(); }},
        {"remove", [](World& w, BodyId, BodyId b) { w.remove(b); }},
        {"remove the floor", [](World& w, BodyId, BodyId) { w.remove(w.bodies()[0]); }},
        {"clone onto the box",
         [](World& w, BodyId, BodyId b) {
             w.clone(b, {0, Real(1.2)});
         }},
        {"weld a part that meets the box",
         [](World& w, BodyId a, BodyId b) {
             const Vec2 at = toLocal(w[b].transform(), w[a].position() + Vec2{0, Real(0.6)});
             w.weld(b, Circle{Real(0.3), at}, {}, 1);
         }},
        {"weld to the box", [](World& w, BodyId a, BodyId b) { w.weld(a, b); }},
        {"weld and unweld",
         [](World& w, BodyId a, BodyId b) {
             w.weld(a, b);
             w.unweld(a, 1);
         }},
    };
    return changes;
}

const std::vector<NamedChange>& worldChanges() {
    static const std::vector<NamedChange> changes = {
        {"add a static body on the box",
         [](World& w, BodyId, BodyId) {
             w.add({.shape = Circle{Real(0.3)},
                    .position = {Real(0.4), Real(1.2)},
                    .type = BodyType::Static});
         }},
        {"add a sensor on the box",
         [](World& w, BodyId, BodyId) {
             w.add({.shape = Circle{Real(0.3)},
                    .position = {Real(0.4), Real(1.2)},
                    .type = BodyType::Static,
                    .flags = kSensor});
         }},
        {"add a joint",
         [](World& w, BodyId a, BodyId b) { w.add(RevoluteJoint{.ends = endsAt(w, a, b)}); }},
        {"add a joint that excludes the pair",
         [](World& w, BodyId a, BodyId b) {
             JointEnds ends = endsAt(w, a, b);
             ends.collide = false;
             w.add(RevoluteJoint{.ends = ends});
         }},
        {"add a mouse joint",
         [](World& w, BodyId a, BodyId) {
             w.add(MouseJoint{.body = a, .target = {1, 2}, .force = 40});
         }},
        {"add and change a joint",
         [](World& w, BodyId a, BodyId b) {
             const JointId id =
                 w.add(DistanceJoint{.ends = endsAt(w, a, b), .limits = Range{0, 9}});
             w.setJoint(id, DistanceJoint{.ends = endsAt(w, a, b),
                                          .length = Real(0.8),
                                          .hertz = Real(0.3),
                                          .damping = 2});
         }},
        {"add and remove a joint",
         [](World& w, BodyId a, BodyId b) {
             w.remove(w.add(RevoluteJoint{.ends = endsAt(w, a, b)}));
         }},
        {"add a field",
         [](World& w, BodyId, BodyId) {
             w.addField({std::make_shared<Gravity>(Vec2{4, 12}), {}});
         }},
        {"remove the fields", [](World& w, BodyId, BodyId) { w.setFields({}); }},
        {"force on all",
         [](World& w, BodyId, BodyId) {
             w.applyForceToAll({30, 20});
         }},
        {"torque on all", [](World& w, BodyId, BodyId) { w.applyTorqueToAll(9); }},
        {"settings without friction",
         [](World& w, BodyId, BodyId) {
             StepSettings settings = w.settings();
             settings.leaveOut |= Feature::Friction;
             w.setSettings(settings);
         }},
        {"settings of the other solver",
         [](World& w, BodyId, BodyId) {
             StepSettings settings = w.settings();
             settings.solver = PropagationSettings{};
             w.setSettings(settings);
         }},
        {"region without the bodies",
         [](World& w, BodyId, BodyId) {
             w.setRegion(Aabb{{50, 50}, {60, 60}});
         }},
        {"region with the box alone",
         [](World& w, BodyId, BodyId) {
             w.setRegion(Aabb{{-1, 0}, {Real(0.5), Real(0.5)}});
         }},
    };
    return changes;
}

using Touch = std::tuple<BodyId, std::uint16_t, BodyId, std::uint16_t>;

/// Pairs of parts that have begun and not ended.
class Touches {
public:
    void read(const World& world) {
        for (const CollisionRecord& record : world.collisions()) {
            const Touch touch{record.a, record.partA, record.b, record.partB};
            if (record.phase == TouchPhase::End) {
                EXPECT_EQ(open_.erase(touch), 1u) << "an end without a begin";
            } else if (record.phase == TouchPhase::Begin) {
                EXPECT_TRUE(open_.insert(touch).second) << "begins twice";
            }
        }
    }
    const std::set<Touch>& open() const { return open_; }

private:
    std::set<Touch> open_;
};

void run(Pair& pair, Touches& touches, int steps) {
    for (int step = 0; step < steps; ++step) {
        pair.world.step(kStep);
        touches.read(pair.world);
    }
}

/// True if both changes were accepted, or both refused.
bool applies(const NamedChange& change, Pair& one, Pair& other) {
    const auto accepted = [&](Pair& pair) {
        try {
            change.apply(pair.world, pair.box, pair.subject);
            return true;
        } catch (const BadDefinition&) {
            return false;
        }
    };
    const bool first = accepted(one);
    EXPECT_EQ(accepted(other), first) << "sleep decides about a refusal";
    return first;
}

void expectSamePlaces(const World& sleeping, const World& awake) {
    ASSERT_EQ(sleeping.bodies(), awake.bodies());
    for (const BodyId id : awake.bodies()) {
        const Real apart = length(sleeping[id].center() - awake[id].center());
        EXPECT_LT(apart, Real(0.02)) << "body " << id.index;
    }
}

void expectSleepDoesNotShow(const SetterCase& is, const NamedChange& change,
                            const Pair& sleepingStart, const Pair& awakeStart, int settled) {
    Pair sleeping = sleepingStart;
    Pair awake = awakeStart;
    Touches one;
    Touches other;
    run(sleeping, one, settled);
    run(awake, other, settled);
    ASSERT_EQ(sleeping.world[sleeping.box].isAsleep(), is.state == State::Asleep);
    if (!applies(change, sleeping, awake)) {
        return;
    }
    for (const int steps : {1, 1, 4}) {
        run(sleeping, one, steps);
        run(awake, other, steps);
        ASSERT_EQ(one.open(), other.open()) << "touches differ soon after";
    }
    run(sleeping, one, kSteps);
    run(awake, other, kSteps);
    EXPECT_EQ(one.open(), other.open()) << "touches differ in the end";
    expectSamePlaces(sleeping.world, awake.world);
}

/// In double and with sanitizers each relation, each type and a sensor are covered, but not each
/// combination.
bool isCovered(const SetterCase& is) {
    const int special = (is.relation != Relation::Touching ? 1 : 0) +
                        (is.type != BodyType::Dynamic ? 1 : 0) + (is.sensor ? 1 : 0);
    return (!support::kSanitized && !support::kDouble) || special <= 1;
}

class SetterMatrix : public testing::TestWithParam<State> {};

TEST_P(SetterMatrix, SleepDoesNotShowAfterAnyChange) {
    for (const Relation relation : {Relation::Touching, Relation::Overlapping, Relation::Apart}) {
        for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic, BodyType::Static}) {
            for (const bool sensor : {false, true}) {
                const SetterCase is{GetParam(), relation, type, sensor};
                if (!isCovered(is)) {
                    continue;
                }
                const Pair sleeping = build(is);
                const Pair awake = withoutSleep(sleeping);
                const int asleep = stepsToSleep(sleeping);
                ASSERT_GT(asleep, 0);
                const int settled = is.state == State::Awake          ? 5
                                    : is.state == State::AboutToSleep ? asleep - 1
                                                                      : asleep + 1;
                for (const auto* const list :
                     {&bodyChanges(), &propertyChanges(), &worldChanges()}) {
                    for (const NamedChange& change : *list) {
                        SCOPED_TRACE(testing::Message()
                                     << change.name << ", relation " << static_cast<int>(relation)
                                     << ", type " << static_cast<int>(type)
                                     << (sensor ? ", sensor" : ""));
                        expectSleepDoesNotShow(is, change, sleeping, awake, settled);
                    }
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(States, SetterMatrix,
                         testing::Values(State::Awake, State::AboutToSleep, State::Asleep));

} // namespace
} // namespace kodo
