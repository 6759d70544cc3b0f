// SPDX-License-Identifier: MIT
// Changes between two steps. R2: a World keeps its solver state, a restored one computes it again,
// and both must give the same bits. Data that a step updates incrementally must equal data computed
// from scratch.
#include "support/solver.hpp"
#include <kodo/force_field.hpp>
#include <kodo/snapshot.hpp>
#include <support/draws.hpp>
#include <support/same_events.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace kodo {
namespace {

using support::kDt;
using support::run;
using support::Solver;

/// True if a step of the World and one of its restored snapshot give equal states and records.
bool stepsLikeItsSnapshot(World& world) {
    World restored = fromBytes(toBytes(world));
    restored.step(kDt);
    world.step(kDt);
    return restored.stateHash() == world.stateHash() && support::sameRecords(restored, world) &&
           stepStats(restored).contacts == stepStats(world).contacts;
}

// R2: forces that cancel out, or that acted on a body that was removed, leave nothing for the next
// body in its slot.
TEST(Snapshot, ContinuesWithTheSameBitsAfterForcesThatCannotAct) {
    for (const bool removed : {false, true}) {
        World world({.gravity = support::kEarth});
        support::addFloor(world);
        BodyId id = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        run(world, 5);
        world[id].applyForce({3, 1});
        if (removed) {
            world.remove(id);
            id = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        } else {
            world[id].applyForce({-3, -1});
        }
        EXPECT_TRUE(stepsLikeItsSnapshot(world)) << removed;
    }
}

// Without Feature::Friction, contacts discard their friction impulses, even if no step follows.
TEST(Snapshot, ContinuesWithTheSameBitsAfterFrictionWasOffAndOn) {
    World world(support::withoutSleep());
    const Rot slope = Rot::fromAngle(Real(0.3));
    world.add({.shape = Box{20, 1}, .rotation = slope, .type = BodyType::Kinematic});
    const BodyId box =
        world.add({.shape = Box{1, 1}, .position = {Real(-0.3), Real(1.1)}, .rotation = slope});
    run(world, 40);
    ASSERT_LT(length(world[box].velocity()), Real(1e-4)); // friction holds it
    const StepSettings with = world.settings();
    StepSettings without = with;
    without.leaveOut |= Feature::Friction;
    world.setSettings(without);
    world.setSettings(with);
    EXPECT_TRUE(stepsLikeItsSnapshot(world));
}

// Excessive forces freeze a body within the step, after its contacts were carried over.
TEST(Snapshot, ContinuesWithTheSameBitsAfterABodyFroze) {
    World world(support::withoutSleep());
    support::addFloor(world);
    const BodyId lower = world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}});
    world.add({.shape = Box{1, 1}, .position = {0, Real(1.5)}});
    run(world, 40);
    for (int i = 0; i < 2; ++i) {
        world[lower].applyForce({std::numeric_limits<Real>::max(), 0});
    }
    EXPECT_TRUE(stepsLikeItsSnapshot(world));
    EXPECT_EQ(world.frozenBodies().size(), 1u);
    EXPECT_TRUE(stepsLikeItsSnapshot(world));
}

// A sleeping body leaves the region and returns, which counts as a teleport. If a touch wakes it
// within a step, its contacts must not be carried over.
TEST(Snapshot, ContinuesWithTheSameBitsAfterATeleportedSleepingBodyWakes) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId box = world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}});
    run(world, 120);
    ASSERT_TRUE(world[box].flags() & kAsleep);
    world.setRegion(Aabb{{10, -10}, {20, 10}});
    run(world, 1);
    world.setRegion(std::nullopt);
    BodyDef ball = support::ballDef({Real(-1.5), Real(0.5)}, Real(0.5));
    ball.velocity = {Real(0.5), 0};
    world.add(ball);
    int asleep = 0;
    for (int step = 0; step < 120; ++step) {
        asleep += (world[box].flags() & kAsleep) != 0 ? 1 : 0;
        ASSERT_TRUE(stepsLikeItsSnapshot(world)) << "step " << step;
    }
    EXPECT_GT(asleep, 10);
    EXPECT_LT(asleep, 110);
}

// The solver counts the lanes of deep contacts. The count must fall when such a contact is removed.
TEST(Snapshot, ContinuesWithTheSameBitsAfterADeepContactIsRemoved) {
    StepSettings settings = support::withoutSleep().settings;
    settings.soft().pushSpeed = Real(0.5); // so that they stay deep for several steps
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    for (int row = 0; row < 20; ++row) {
        for (int i = 0; i < 20 - row; ++i) {
            const Vec2 place{static_cast<Real>(2 * i + row) / 2 - 30, static_cast<Real>(row)};
            world.add({.shape = Box{1, 1}, .position = place + Vec2{0, Real(0.5)}});
        }
    }
    BodyId last;
    for (int pair = 0; pair < 4; ++pair) {
        for (const Real x : {Real(0), Real(0.3)}) {
            const Real right = static_cast<Real>(10 * pair);
            last = world.add({.shape = Circle{1}, .position = {right + x, 1}});
        }
    }
    run(world, 5);
    world.remove(last);
    for (int step = 0; step < 20; ++step) {
        ASSERT_TRUE(stepsLikeItsSnapshot(world)) << "step " << step;
    }
}

// A pair is parked, found again because one of its bodies wakes, and parked again.
TEST(Snapshot, StoresAPairParkedTwiceOnce) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId box = world.add({.shape = Box{1, 1}, .position = {0, Real(0.5)}});
    run(world, 120);
    world.add({.shape = Box{1, 1}, .position = {Real(1.01), Real(0.5)}, .flags = kNeverSleep});
    run(world, 3);
    ASSERT_TRUE(world[box].flags() & kAsleep);
    world.setRegion(Aabb{{-50, -50}, {Real(0.505), 50}}); // the other box is outside
    run(world, 1);
    world[box].applyImpulse({0, Real(0.001)});
    run(world, 1);
    world.setRegion(Aabb{{200, 0}, {210, 10}}); // both are outside
    world.setRegion(std::nullopt);
    EXPECT_TRUE(stepsLikeItsSnapshot(world));
}

// Sleeping bodies of a restored World still depend on the same supports.
TEST(Snapshot, ARestoredSleepingBodyWakesWhenItsFloorIsRemoved) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    run(world, 60);
    ASSERT_NE(world[box].flags() & kAsleep, 0u);
    World read = fromBytes(toBytes(world));
    read.remove(floor);
    EXPECT_EQ(read[box].flags() & kAsleep, 0u);
}

/// A heap in a trough under random changes.
class Heap {
public:
    explicit Heap(std::uint64_t seed) : random_(seed), world_({.gravity = support::kEarth}) {
        world_.add({.shape = Box{40, 1},
                    .position = {0, Real(-0.5)},
                    .type = BodyType::Kinematic,
                    .flags = 1});
        for (const Real x : {Real(-6), Real(6)}) {
            world_.add({.shape = Box{1, 20},
                        .position = {x, 10},
                        .type = BodyType::Kinematic,
                        .flags = 1});
        }
        for (int i = 0; i < 30; ++i) {
            addOne();
        }
    }
    World& world() { return world_; }

    /// Applies a random change and returns its number.
    std::size_t change() {
        const std::vector<BodyId> bodies = world_.bodies();
        const BodyId id = bodies[random_.below(bodies.size())];
        BodyRef body = world_[id];
        const std::size_t what = random_.below(12);
        switch (what) {
        case 0:
            body.setFlags(someFlags());
            break;
        case 1:
            body.setPosition({random_.between(-5, 5), random_.between(1, 8)});
            break;
        case 2:
            body.setVelocity(random_.point(5));
            break;
        case 3:
            toggle(static_cast<std::uint8_t>(1u << random_.below(7)));
            break;
        case 4:
            setStrategy();
            break;
        case 5:
            setRegion();
            break;
        case 6:
            body.applyForce({random_.below(8) == 0 ? std::numeric_limits<Real>::max() : 50, 0});
            break;
        case 7:
            body.setMaterial(
                {.restitution = random_.between(0, 1), .rollingResistance = Real(0.2)});
            break;
        case 8:
            addOne();
            break;
        case 9:
            if (bodies.size() > 25) {
                world_.remove(id);
            }
            break;
        case 10:
            setFields();
            break;
        default:
            world_.setSettings(substeps());
            break;
        }
        return what;
    }
    bool oneIn(std::size_t count) { return random_.below(count) == 0; }

private:
    Flags someFlags() {
        Flags flags = 1u << random_.below(3);
        flags |= oneIn(8) ? kLockMove | kLockRotate : 0;
        flags |= oneIn(8) ? kSensor : 0;
        flags |= oneIn(8) ? kLockRotate : 0;
        return flags;
    }
    void addOne() {
        BodyDef def = oneIn(2) ? support::ballDef({}, random_.between(0.2, 0.5))
                               : support::boxDef({}, random_.between(0.3, 1), 1);
        def.position = {random_.between(-5, 5), random_.between(1, 8)};
        def.flags = someFlags();
        world_.add(def);
    }
    void toggle(std::uint8_t feature) {
        StepSettings settings = world_.settings();
        settings.leaveOut.bits ^= feature;
        world_.setSettings(settings);
    }
    void setStrategy() {
        StepSettings settings = world_.settings();
        settings.solver = support::settingsOf(oneIn(3) ? Solver::Propagation : Solver::Soft).solver;
        world_.setSettings(settings);
    }
    void setRegion() {
        if (oneIn(2)) {
            world_.setRegion(std::nullopt);
        } else {
            const Vec2 lower{random_.between(-6, 0), -2};
            world_.setRegion(Aabb{lower, {random_.between(1, 6), random_.between(2, 9)}});
        }
    }
    /// Gravity for all bodies or for some categories, sometimes with drag.
    void setFields() {
        const Vec2 pull{random_.between(-3, 3), -9};
        const auto gravity = std::make_shared<Gravity>(pull);
        const auto some = static_cast<std::uint16_t>(1u << random_.below(3));
        std::vector<FieldEntry> fields{
            {gravity, oneIn(2) ? CollisionFilter{} : CollisionFilter{kMatchAny, some}}};
        if (oneIn(3)) {
            fields.push_back({std::make_shared<Drag>(DragLaw{1, 1})});
        }
        world_.setFields(std::move(fields));
    }
    StepSettings substeps() {
        StepSettings settings = world_.settings();
        settings = support::withSubsteps(settings, 1 + static_cast<int>(random_.below(6)));
        return settings;
    }

    support::RandomNumbers random_;
    World world_;
};

// R2: random changes between two steps.
TEST(Snapshot, ContinuesWithTheSameBitsAfterRandomChanges) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t{support::draws(20)}; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Heap heap(seed);
        std::string changes;
        for (int step = 0; step < 150; ++step) {
            for (int more = 0; heap.oneIn(3) && more < 3; ++more) {
                changes += " " + std::to_string(heap.change());
            }
            ASSERT_TRUE(stepsLikeItsSnapshot(heap.world())) << "step " << step << changes;
        }
    }
}

// S2: random changes between a step and the reading of its events.
TEST(Events, MatchTheRecordsAfterRandomChanges) {
    for (std::uint64_t seed = 201; seed <= std::uint64_t{200 + support::draws(20)}; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Heap heap(seed);
        std::string changes;
        for (int step = 0; step < 150; ++step) {
            heap.world().step(kDt);
            ASSERT_TRUE(support::eventsMatchRecords(heap.world())) << "step " << step << changes;
            const World before = heap.world();
            bool changed = false;
            for (int more = 0; heap.oneIn(3) && more < 3; ++more) {
                changes += " " + std::to_string(heap.change());
                changed = true;
            }
            if (changed) {
                ASSERT_TRUE(support::eventsMatchRecords(heap.world())) << step << changes;
                ASSERT_TRUE(support::sameRecords(heap.world(), before)) << step << changes;
            }
        }
    }
}

/// Succeeds if exactly the bodies with a touching record have kColliding.
testing::AssertionResult flagsTellWhoTouches(const World& world) {
    std::vector<BodyId> touched;
    for (const CollisionRecord& record : world.collisions()) {
        if (record.phase != TouchPhase::End) {
            touched.insert(touched.end(), {record.a, record.b});
        }
    }
    for (const BodyId id : world.bodies()) {
        const bool flag = (world[id].flags() & kColliding) != 0;
        const bool touches = std::find(touched.begin(), touched.end(), id) != touched.end();
        if (flag != touches) {
            return testing::AssertionFailure() << "body " << id.index << ": kColliding is " << flag;
        }
    }
    return testing::AssertionSuccess();
}

// R8: random changes between two steps.
TEST(CollidingFlag, MarksTouchingBodiesAfterRandomChanges) {
    for (std::uint64_t seed = 101; seed <= 124; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Heap heap(seed);
        std::string changes;
        std::size_t touched = 0;
        for (int step = 0; step < 150; ++step) {
            for (int more = 0; heap.oneIn(3) && more < 3; ++more) {
                changes += " " + std::to_string(heap.change());
            }
            heap.world().step(kDt);
            if (heap.world().settings().has(Feature::Records)) {
                ASSERT_TRUE(flagsTellWhoTouches(heap.world())) << "step " << step << changes;
                touched += heap.world().collisions().size();
            }
        }
        EXPECT_GT(touched, 0u);
    }
}

} // namespace
} // namespace kodo
