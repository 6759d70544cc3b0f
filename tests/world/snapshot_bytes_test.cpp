// SPDX-License-Identifier: MIT
// Which Worlds have the same bytes: copies at any time, and what fromBytes() returns after each
// step.
#include <support/scenes.hpp>

#include <functional>
#include <string>
#include <vector>

namespace kodo {
namespace {

struct Change {
    const char* name;
    std::function<void(World&)> apply;
};

BodyId fifth(const World& world) {
    return world.bodies()[5];
}

const Change kChanges[] = {
    {"nothing", [](World&) {}},
    {"remove", [](World& w) { w.remove(fifth(w)); }},
    {"remove the ground", [](World& w) { w.remove(w.bodies()[0]); }},
    {"remove five",
     [](World& w) {
         const std::vector<BodyId> all = w.bodies();
         for (const std::size_t i : {2u, 3u, 4u, 9u, 10u}) {
             w.remove(all[i]);
         }
     }},
    {"add",
     [](World& w) {
         w.add(support::ballDef({0, 9}, Real(0.5)));
     }},
    {"remove and add",
     [](World& w) {
         w.remove(fifth(w));
         w.add(support::ballDef({0, 9}, Real(0.5)));
     }},
    {"weld", [](World& w) { w.weld(w.bodies()[6], w.bodies()[7]); }},
    {"weld a shape", [](World& w) { w.weld(fifth(w), Circle{Real(0.3)}, {}, 1); }},
    {"unweld",
     [](World& w) {
         w.weld(fifth(w), Circle{Real(0.3)}, {}, 1);
         w.unweld(fifth(w), 1);
     }},
    {"clone",
     [](World& w) {
         w.clone(fifth(w), {20, 3});
     }},
    {"position",
     [](World& w) {
         w[fifth(w)].setPosition({0, 20});
     }},
    {"velocity",
     [](World& w) {
         w[fifth(w)].setVelocity({1, 2});
     }},
    {"sensor", [](World& w) { w[fifth(w)].setFlags(kSensor); }},
    {"disabled", [](World& w) { w[fifth(w)].setFlags(kDisabled); }},
    {"static", [](World& w) { w[fifth(w)].setType(BodyType::Static); }},
    {"mass", [](World& w) { w[fifth(w)].setMass(3); }},
    {"material", [](World& w) { w[fifth(w)].setMaterial(withFriction(Real(0.1), 0)); }},
    {"wake", [](World& w) { w[fifth(w)].wake(); }},
    {"remove a joint", [](World& w) { w.remove(w.joints()[0]); }},
    {"region",
     [](World& w) {
         w.setRegion(Aabb{{-1, -1}, {2, 3}});
     }},
    {"settings",
     [](World& w) {
         StepSettings settings = w.settings();
         settings.leaveOut |= Feature::Friction;
         w.setSettings(settings);
     }},
};

std::ostream& operator<<(std::ostream& out, const Change& change) {
    return out << change.name;
}

/// Four columns of four boxes, two discs on one point, and a pin; awake or asleep.
World pile(const StepSettings& settings, bool asleep) {
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    for (int i = 0; i < 16; ++i) {
        world.add(support::boxDef({Real(1.05) * static_cast<Real>(i / 4),
                                   Real(0.5) + Real(1.01) * static_cast<Real>(i % 4)},
                                  1, 1));
    }
    for (int i = 0; i < 2; ++i) {
        world.add(support::ballDef({10, 1}, Real(0.5)));
    }
    world.add(RevoluteJoint{.ends = {.a = world.bodies()[4],
                                     .b = world.bodies()[8],
                                     .anchorA = {Real(0.525), 0},
                                     .anchorB = {Real(-0.525), 0}}});
    for (int step = 0; step < (asleep ? 400 : 30); ++step) {
        world.step(support::kDt);
    }
    return world;
}

class SnapshotBytes : public testing::TestWithParam<std::tuple<bool, bool>> {
protected:
    static World start() {
        const auto& [thesis, asleep] = GetParam();
        return pile(thesis ? thesis2006() : StepSettings{}, asleep);
    }
};

// R2: right after a change too, not only after the next step.
TEST_P(SnapshotBytes, AreThoseOfACopyWithTheSameChange) {
    const World world = start();
    for (const Change& change : kChanges) {
        SCOPED_TRACE(change);
        World changed = world;
        World copy = world;
        change.apply(changed);
        change.apply(copy);
        EXPECT_EQ(toBytes(copy), toBytes(changed));
        const World copyNow = changed;
        EXPECT_EQ(toBytes(copyNow), toBytes(changed));
        EXPECT_EQ(toBytes(fromBytes(toBytes(changed))), toBytes(changed));
        for (int step = 0; step < 3; ++step) {
            changed.step(support::kDt);
            copy.step(support::kDt);
            EXPECT_EQ(toBytes(copy), toBytes(changed)) << step;
        }
    }
}

// R2: what fromBytes() returned has the same bytes after each step, whatever has changed before.
TEST_P(SnapshotBytes, AreThoseOfTheOriginalAfterAStep) {
    const World world = start();
    for (const Change& change : kChanges) {
        SCOPED_TRACE(change);
        World changed = world;
        World read = fromBytes(toBytes(world));
        change.apply(changed);
        change.apply(read);
        EXPECT_EQ(read.stateHash(), changed.stateHash());
        for (int step = 0; step < 3; ++step) {
            changed.step(support::kDt);
            read.step(support::kDt);
            EXPECT_EQ(toBytes(read), toBytes(changed)) << step;
        }
    }
}

// C13: the records in the bytes are those of the last step, also of bodies that have changed since.
TEST_P(SnapshotBytes, HoldTheRecordsOfTheStep) {
    const World world = start();
    const std::vector<CollisionRecord> before = [&] {
        World own = world;
        const auto records = own.collisions();
        return std::vector<CollisionRecord>(records.begin(), records.end());
    }();
    for (const Flags flags : {kSensor, kDisabled, kLockRotate}) {
        World changed = world;
        changed[fifth(changed)].setFlags(flags);
        World read = fromBytes(toBytes(changed));
        const auto records = read.collisions();
        ASSERT_EQ(records.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(records[i].point, before[i].point) << flags << ", " << i;
            EXPECT_EQ(records[i].points, before[i].points) << flags << ", " << i;
            EXPECT_EQ(records[i].totalImpulse, before[i].totalImpulse) << flags << ", " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Starts, SnapshotBytes, testing::Combine(testing::Bool(), testing::Bool()),
                         [](const auto& start) {
                             return std::string(std::get<0>(start.param) ? "Thesis" : "Soft") +
                                    (std::get<1>(start.param) ? "Asleep" : "Awake");
                         });

} // namespace
} // namespace kodo
