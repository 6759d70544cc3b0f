// SPDX-License-Identifier: MIT
#include <kodo/executor.hpp>
#include <kodo/query.hpp>
#include <kodo/snapshot.hpp>
#include <kodo/step_stats.hpp>
#include <support/scenes.hpp>

#include <functional>
#include <stdexcept>
#include <string>

namespace kodo {
namespace {

/// A heap that moves, with a joint and a field.
struct GuardedScene {
    World world{{.gravity = support::kEarth}};
    BodyId box;
    BodyId ball;
    JointId pin;

    GuardedScene() {
        support::addHeap(world, 5, 20);
        box = world.add(support::boxDef({0, 30}, 1, 1));
        ball = world.add(support::ballDef({1, 30}, Real(0.5)));
        pin = world.add(RevoluteJoint{.ends = {box, ball, {Real(0.5), 0}, {Real(-0.5), 0}}});
        support::run(world, 20);
    }
};

struct GuardedCall {
    const char* name; // as the message names it
    std::function<void(GuardedScene&)> make;
};

const GuardedCall kChanges[] = {
    {"World::add", [](GuardedScene& s) { s.world.add(BodyDef{}); }},
    {"World::add",
     [](GuardedScene& s) {
         s.world.add(FixedJoint{.ends = {s.box, s.ball}});
     }},
    {"World::remove", [](GuardedScene& s) { s.world.remove(s.ball); }},
    {"World::remove", [](GuardedScene& s) { s.world.remove(s.pin); }},
    {"World::clone", [](GuardedScene& s) { s.world.clone(s.ball, {}); }},
    {"World::weld", [](GuardedScene& s) { s.world.weld(s.box, s.ball); }},
    {"World::weld", [](GuardedScene& s) { s.world.weld(s.box, Circle{1}, {}, 1); }},
    {"World::unweld", [](GuardedScene& s) { s.world.unweld(s.box, 0); }},
    {"World::setJoint", [](GuardedScene& s) { s.world.setJoint(s.pin, s.world.joint(s.pin)); }},
    {"World::addField", [](GuardedScene& s) { s.world.addField(s.world.fields()[0]); }},
    {"World::setFields", [](GuardedScene& s) { s.world.setFields({}); }},
    {"World::applyForceToAll",
     [](GuardedScene& s) {
         s.world.applyForceToAll({1, 0});
     }},
    {"World::applyTorqueToAll", [](GuardedScene& s) { s.world.applyTorqueToAll(1); }},
    {"World::step", [](GuardedScene& s) { s.world.step(support::kDt); }},
    {"World::setRegion", [](GuardedScene& s) { s.world.setRegion({}); }},
    {"World::setSettings", [](GuardedScene& s) { s.world.setSettings(thesis2006()); }},
    {"World::operator=", [](GuardedScene& s) { s.world = static_cast<const World&>(World{}); }},
    {"BodyRef::setPosition", [](GuardedScene& s) { s.world[s.box].setPosition({}); }},
    {"BodyRef::setRotation", [](GuardedScene& s) { s.world[s.box].setRotation({}); }},
    {"BodyRef::setVelocity", [](GuardedScene& s) { s.world[s.box].setVelocity({}); }},
    {"BodyRef::setAngularVelocity", [](GuardedScene& s) { s.world[s.box].setAngularVelocity(0); }},
    {"BodyRef::moveTo", [](GuardedScene& s) { s.world[s.box].moveTo({}, 1); }},
    {"BodyRef::applyForce",
     [](GuardedScene& s) {
         s.world[s.box].applyForce({1, 0});
     }},
    {"BodyRef::applyForce",
     [](GuardedScene& s) {
         s.world[s.box].applyForce({1, 0}, {});
     }},
    {"BodyRef::applyTorque", [](GuardedScene& s) { s.world[s.box].applyTorque(1); }},
    {"BodyRef::applyImpulse",
     [](GuardedScene& s) {
         s.world[s.box].applyImpulse({1, 0});
     }},
    {"BodyRef::applyImpulse",
     [](GuardedScene& s) {
         s.world[s.box].applyImpulse({1, 0}, {});
     }},
    {"BodyRef::setType", [](GuardedScene& s) { s.world[s.box].setType(BodyType::Static); }},
    {"BodyRef::setFlags", [](GuardedScene& s) { s.world[s.box].setFlags(1); }},
    {"BodyRef::setRequired", [](GuardedScene& s) { s.world[s.box].setRequired(1); }},
    {"BodyRef::setUserData", [](GuardedScene& s) { s.world[s.box].setUserData(1); }},
    {"BodyRef::setGroup", [](GuardedScene& s) { s.world[s.box].setGroup(1); }},
    {"BodyRef::setContinuousMode",
     [](GuardedScene& s) { s.world[s.box].setContinuousMode(ContinuousMode::Never); }},
    {"BodyRef::setPart",
     [](GuardedScene& s) { s.world[s.box].setPart(0, s.world[s.box].part(0)); }},
    {"BodyRef::setMaterial", [](GuardedScene& s) { s.world[s.box].setMaterial({}); }},
    {"BodyRef::setMass", [](GuardedScene& s) { s.world[s.box].setMass(1); }},
    {"BodyRef::setMassFromDensity", [](GuardedScene& s) { s.world[s.box].setMassFromDensity(); }},
    {"BodyRef::copyFrom", [](GuardedScene& s) { s.world[s.box].copyFrom(s.world[s.ball]); }},
    {"BodyRef::wake", [](GuardedScene& s) { s.world[s.box].wake(); }},
};

/// Reads that need a World between two steps.
const GuardedCall kCopies[] = {
    {"A copy of this World", [](GuardedScene& s) { const World copy = s.world; }},
    {"toBytes", [](GuardedScene& s) { toBytes(s.world); }},
};

void expectRefused(GuardedScene& scene, const GuardedCall& change, const char* when) {
    SCOPED_TRACE(change.name);
    try {
        change.make(scene);
        ADD_FAILURE() << "not refused";
    } catch (const std::logic_error& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find(std::string(change.name) + " is not possible "), 0u) << text;
        EXPECT_NE(text.find(when), std::string::npos) << text;
    }
}

/// Calls a function in one stage.
class InStage final : public StageListener {
public:
    InStage(StepStage stage, std::function<void()> call) : stage_(stage), call_(std::move(call)) {}
    void enter(StepStage stage) override {
        if (stage == stage_) {
            call_();
        }
    }
    void leave() override {}

private:
    StepStage stage_;
    std::function<void()> call_;
};

constexpr StepStage kStages[] = {StepStage::Broad,     StepStage::Narrow, StepStage::Forces,
                                 StepStage::Solve,     StepStage::Record, StepStage::Sleep,
                                 StepStage::Continuous};

TEST(ChangeGuard, AStageListenerCannotChangeTheWorld) {
    for (const StepStage stage : kStages) {
        SCOPED_TRACE(static_cast<int>(stage));
        GuardedScene scene;
        World untouched = scene.world;
        InStage listener(stage, [&] {
            for (const GuardedCall& change : kChanges) {
                expectRefused(scene, change, "within a step");
            }
            for (const GuardedCall& copy : kCopies) {
                expectRefused(scene, copy, "within a step");
            }
            const std::uint64_t reads = scene.world.stateHash() + scene.world.bodyCount();
            EXPECT_NE(reads, 0u);
            EXPECT_NO_THROW(scene.world[scene.box].position());
            EXPECT_NO_THROW(closestPoint(scene.world, {}, 1));
        });
        for (int i = 0; i < 3; ++i) {
            scene.world.step(support::kDt, {.listener = &listener});
            untouched.step(support::kDt);
            ASSERT_EQ(scene.world.stateHash(), untouched.stateHash());
        }
        for (const GuardedCall& copy : kCopies) {
            EXPECT_NO_THROW(copy.make(scene));
        }
    }
}

/// Calls a function on the stepping thread.
class CallingField final : public ForceField {
public:
    explicit CallingField(std::function<void()> call) : call_(std::move(call)) {}
    FieldForce at(const BodyView&, Real) const override {
        call_();
        return {};
    }

private:
    std::function<void()> call_;
};

TEST(ChangeGuard, AForceFieldCannotChangeTheWorld) {
    GuardedScene scene;
    int calls = 0;
    scene.world.addField({std::make_shared<CallingField>([&] {
        if (++calls == 1) {
            for (const GuardedCall& change : kChanges) {
                expectRefused(scene, change, "within a step");
            }
        }
    })});
    support::run(scene.world, 3);
    EXPECT_GT(calls, 1);
}

/// Calls a function when a step asks for threads; it lends none.
class AskedExecutor final : public Executor {
public:
    explicit AskedExecutor(std::function<void()> call) : call_(std::move(call)) {}
    int helpers() const override { return 1; }
    void begin(void (*)(void*), void*) override { call_(); }
    void end() override {}

private:
    std::function<void()> call_;
};

TEST(ChangeGuard, AnExecutorCannotChangeTheWorld) {
    GuardedScene scene;
    for (int i = 0; i < 300; ++i) { // enough for helpers
        scene.world.add(support::ballDef({Real(2 * i), 60}, Real(0.5)));
    }
    int calls = 0;
    AskedExecutor executor([&] {
        ++calls;
        for (const GuardedCall& change : kChanges) {
            expectRefused(scene, change, "within a step");
        }
    });
    scene.world.step(support::kDt, {.executor = &executor});
    EXPECT_EQ(calls, 1);
}

TEST(ChangeGuard, AVisitorOfAQueryCannotChangeTheWorld) {
    GuardedScene scene;
    int visits = 0;
    const auto visit = [&] {
        ++visits;
        for (const GuardedCall& change : kChanges) {
            expectRefused(scene, change, "while a query visits");
        }
        for (const GuardedCall& copy : kCopies) {
            EXPECT_NO_THROW(copy.make(scene));
        }
        EXPECT_NO_THROW(overlap(scene.world, Aabb{{-1, -1}, {1, 1}})); // a query within a query
        return false;
    };
    visitRay(scene.world, {-20, 30}, {20, Real(29.9)}, [&](const QueryHit&) { return visit(); });
    visitOverlaps(scene.world, Box{90, 90}, {}, [&](BodyId) { return visit(); });
    EXPECT_EQ(visits, 2);
    EXPECT_NO_THROW(scene.world.remove(scene.ball));
}

TEST(ChangeGuard, EndsWhenAVisitorThrows) {
    GuardedScene scene;
    EXPECT_THROW(visitOverlaps(scene.world, Box{90, 90}, {},
                               [](BodyId) -> bool { throw std::runtime_error("visitor"); }),
                 std::runtime_error);
    EXPECT_NO_THROW(scene.world.remove(scene.ball));
}

// Whatever stage it interrupts: the World can be used, and a copy from before continues as if
// nothing had happened.
TEST(ChangeGuard, EndsWhenAListenerThrows) {
    for (const StepStage stage : kStages) {
        SCOPED_TRACE(static_cast<int>(stage));
        GuardedScene scene;
        scene.world.setRegion(Aabb{{-30, -5}, {4, 50}});
        support::run(scene.world, 5);
        const World before = scene.world;
        InStage listener(stage, [] { throw std::runtime_error("listener"); });
        EXPECT_THROW(scene.world.step(support::kDt, {.listener = &listener}), std::runtime_error);
        scene.world[scene.box].setVelocity({1, 0});
        scene.world.remove(scene.ball);
        support::run(scene.world, 60);
        EXPECT_FALSE(toBytes(scene.world).empty());
        World undisturbed = before;
        scene.world = before; // back, in place
        support::run(scene.world, 60);
        support::run(undisturbed, 60);
        EXPECT_EQ(scene.world.stateHash(), undisturbed.stateHash());
    }
}

} // namespace
} // namespace kodo
