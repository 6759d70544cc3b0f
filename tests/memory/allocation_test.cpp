// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/every_kind.hpp>
#include <support/scenes.hpp>

#include <bench/heap.hpp>

#include <deque>
#include <new>

namespace kodo {
namespace {

using support::kSolvers;
using support::Solver;

using bench::allocationCount;

/// A heap in a bin with a moving platform, a bridge of revolute joints and one joint of each other
/// kind, in wind and water, with an attractor.
struct Scene {
    World world;
    BodyId platform;
    std::vector<BodyId> loose;
    std::size_t eventCount = 0; // begins and ends that were read

    explicit Scene(const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        support::addHeap(world, 21, 60);
        for (const BodyId id : world.bodies()) {
            if (world[id].type() == BodyType::Dynamic) {
                loose.push_back(id);
            }
        }
        platform = world.add(
            {.shape = Box{2, Real(0.2)}, .position = {0, Real(0.2)}, .type = BodyType::Kinematic});
        addBridge();
        addOneOfEachJoint();
        addFields();
    }

    void addBridge() {
        BodyId last = world.add(
            {.shape = Circle{Real(0.1)}, .position = {-4, 20}, .type = BodyType::Kinematic});
        for (int i = 0; i < 8; ++i) {
            const BodyId link =
                world.add(support::boxDef({static_cast<Real>(i) - Real(3.5), 20}, 1, Real(0.2)));
            world.add(RevoluteJoint{
                .ends = {last, link, {i == 0 ? Real(0) : Real(0.5), 0}, {Real(-0.5), 0}},
                .limits = Range{-1, 1}});
            last = link;
        }
        world.add(MouseJoint{.body = last, .target = {4, 20}, .force = 500});
    }

    void addOneOfEachJoint() {
        const auto pair = [&](Real x) {
            const BodyId a =
                world.add({.shape = Box{1, 1}, .position = {x, 25}, .type = BodyType::Kinematic});
            const BodyId b = world.add(support::boxDef({x, 23}, 1, 1));
            return JointEnds{a, b, {0, -1}, {0, 1}};
        };
        const JointEnds rope = pair(24);
        const support::EveryKind<JointDef> kinds{
            FixedJoint{.ends = pair(0)},
            DistanceJoint{.ends = pair(3), .hertz = 2, .damping = Real(0.1), .limits = Range{0, 3}},
            PrismaticJoint{
                .ends = pair(6), .limits = Range{-1, 1}, .motorSpeed = 1, .motorForce = 9},
            MotorJoint{.ends = pair(9), .force = 100, .torque = 10},
            MouseJoint{.body = rope.b, .target = {24, 23}, .force = 1},
            RevoluteJoint{.ends = pair(12), .motorSpeed = 2, .motorTorque = 100},
            RevoluteJoint{.ends = pair(15), .limits = Range{-9, 9}, .hertz = 2},
            FixedJoint{.ends = pair(18), .hertz = 3},
            WheelJoint{
                .ends = pair(21), .hertz = 4, .damping = 1, .motorSpeed = 1, .motorTorque = 9},
            PulleyJoint{rope, {24, 30}, {24, 26}, 10, 1},
            GearJoint{.ends = rope},
            FilterJoint{.ends = pair(27)}};
        for (const JointDef& def : kinds.list) {
            world.add(def);
        }
    }

    void addFields() {
        world.addField({std::make_shared<Drag>(DragLaw{Real(0.1), Real(0.1)}), {}});
        world.addField({std::make_shared<Buoyancy>(Buoyancy::Fluid{Real(0.3), Real(0.1)},
                                                   Vec2{0, 1}, support::kEarth),
                        {}});
        world.addField(
            {std::make_shared<Attractor>(Attractor::Law::InverseSquare, Vec2{0, 3}, Real(0.1), 1),
             {}});
    }

    /// Steps while the platform moves up and down by `height` (m).
    void stir(int steps, Real height) {
        for (int i = 0; i < steps; ++i) {
            const int phase = i % 60;
            const Real share = static_cast<Real>(phase < 30 ? phase : 60 - phase) / 30;
            world[platform].moveTo({0, Real(0.2) + height * share}, support::kDt);
            world.step(support::kDt);
            eventCount += world.begunCollisions().size() + world.endedCollisions().size();
        }
    }
};

StepSettings settingsFor(Solver strategy, bool sleeps) {
    StepSettings settings;
    if (strategy == Solver::Propagation) {
        settings = support::settingsOf(strategy);
        settings.propagation().shockPasses = 2;
    }
    settings.leaveOut = sleeps ? Features() : Feature::Sleep;
    return settings;
}

TEST(Allocation, TheCounterCountsAllocations) {
    const std::uint64_t before = allocationCount();
    ::operator delete(::operator new(8));
    ::operator delete (::operator new (64, std::align_val_t{64}),
                       std::align_val_t{64}); // like solver blocks
    EXPECT_EQ(allocationCount(), before + 2);
}

// After a warm-up with more motion than the measured steps, no step allocates, nor does reading
// begins and ends: with changing contacts, every joint, fields and continuous collision.
TEST(Allocation, AStepOfAStirredPileAllocatesNothing) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsFor(strategy, false));
        scene.stir(1500, 3);
        std::vector<BodyId> more; // more bodies and contacts than in the measured steps
        for (int i = 0; i < 16; ++i) {
            more.push_back(scene.world.add(support::ballDef({0, Real(10 + i)}, Real(0.4))));
        }
        scene.stir(600, Real(0.5)); // less motion, but more contacts
        for (const BodyId id : more) {
            scene.world.remove(id);
        }
        scene.stir(600, Real(0.5));
        const std::uint64_t before = allocationCount();
        scene.eventCount = 0;
        scene.stir(300, Real(0.5));
        EXPECT_EQ(allocationCount(), before);
        EXPECT_GT(scene.eventCount, 50u);
        EXPECT_GT(scene.world.collisions().size(), 50u);
    }
}

// A sleeping pile with the platform at rest and active joints.
TEST(Allocation, AStepOfASleepingPileAllocatesNothing) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsFor(strategy, true));
        scene.stir(300, 1);
        scene.world[scene.platform].setVelocity({});
        support::run(scene.world, 2400);
        const std::uint64_t before = allocationCount();
        support::run(scene.world, 300);
        EXPECT_EQ(allocationCount(), before);
    }
}

// Falling asleep and waking needs no new memory after it happened once.
TEST(Allocation, FallingAsleepAndWakingAllocatesNothing) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = settingsFor(strategy, true);
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 6);
        const auto cycle = [&] {
            world[boxes[0]].setVelocity({0, Real(0.001)});
            support::run(world, 120);
            ASSERT_NE(world[boxes[0]].flags() & kAsleep, 0u);
        };
        support::run(world, 120);
        cycle();
        cycle();
        const std::uint64_t before = allocationCount();
        cycle();
        cycle();
        EXPECT_EQ(allocationCount(), before);
    }
}

/// Balls in a row, each on a tile, and as many tiles far below.
struct TilesAndBalls {
    World world{support::withoutSleep()};
    std::vector<BodyId> balls;

    explicit TilesAndBalls(int count) {
        for (int i = 0; i < count; ++i) {
            for (const int y : {-1, -61}) {
                world.add({.shape = Box{1, 1}, .position = at(i, y), .type = BodyType::Kinematic});
            }
            balls.push_back(world.add(support::ballDef(at(i, 0), Real(0.5))));
        }
    }
    static Vec2 at(int i, int y) {
        return {static_cast<Real>(4 * i), static_cast<Real>(y) + Real(0.5)};
    }
    void put(int i, int y) {
        BodyRef ball = world[balls[static_cast<std::size_t>(i)]];
        ball.setPosition(at(i, y));
        ball.setVelocity({});
    }
};

// A body that leaves one contact and enters another in the same step changes its touch state twice.
TEST(Allocation, ChangingContactsAllocatesNothing) {
    constexpr int kBalls = 16;
    TilesAndBalls scene(kBalls);
    for (int cycle = 0; cycle < 6; ++cycle) {
        for (const int y : {60, 0}) {
            for (int i = 0; i < kBalls; ++i) {
                scene.put(i, y);
            }
            support::run(scene.world, 10);
        }
    }
    for (int i = 0; i < kBalls; ++i) {
        for (const int y : {-60, 0}) {
            scene.put(i, y);
            const std::size_t before = allocationCount();
            support::run(scene.world, 10);
            EXPECT_EQ(allocationCount(), before) << "ball " << i << ", to " << y;
        }
    }
}

// Changes between steps are not accumulated.
TEST(Allocation, RegionChangesInAPausedWorldHoldNoMoreMemory) {
    TilesAndBalls scene(100);
    support::run(scene.world, 20);
    const auto goAbout = [&](int times) {
        for (int i = 0; i < times; ++i) {
            scene.world.setRegion(Aabb{{-900, 30}, {900, 40}});
            scene.world.setRegion(std::nullopt);
        }
    };
    goAbout(20);
    const std::size_t before = bench::liveBytes();
    goAbout(500);
    EXPECT_LE(bench::liveBytes(), before);
}

// Regression: arrays that were built at rest had no room, and the first body that was added moved
// them all. 3 KB are a tenth of the nodes of the tree alone.
TEST(Allocation, ABodyAddedAfterARestMovesNoArrayOfAllBodies) {
    constexpr int kBoxes = 1500; // arrays of bodies have room for 2048
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    for (int i = 0; i < kBoxes; ++i) {
        const auto x = static_cast<Real>(i - kBoxes / 2) / 4;
        world.add(support::boxDef({x, Real(0.05)}, Real(0.1), Real(0.1)));
    }
    support::run(world, 120);
    ASSERT_EQ(stepStats(world).bodies, 0u);
    const std::size_t before = bench::liveBytes();
    world.add({.shape = Circle{1}, .position = {0, -500}, .type = BodyType::Static});
    world.step(support::kDt);
    EXPECT_LT(bench::liveBytes(), before + 3072);
}

// A pile that loses its oldest body for each new one holds no more memory after 1000 bodies than
// after 300. If the data of removed bodies were kept, that would be 400 KB. The tolerance is 64 KB
// (128 KB in double), since the pile changes and one list may have doubled its capacity.
TEST(Allocation, AChurnedPileHoldsNoMoreMemory) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        World world({.gravity = support::kEarth, .settings = settingsFor(strategy, true)});
        support::addFloor(world);
        support::addWall(world, -4, 1, {});
        support::addWall(world, 3, 1, {});
        std::deque<BodyId> pile;
        support::RandomNumbers random(5);
        const auto churn = [&](int bodies) {
            for (int i = 0; i < bodies; ++i) {
                const Real size = random.between(0.3, 0.6);
                BodyDef def = support::boxDef({random.between(-2, 2), 8}, size, size);
                def.shape = i % 2 == 0 ? Shape(Box{size, size}) : Shape(Circle{size / 2});
                pile.push_back(world.add(def));
                if (pile.size() > 50) {
                    world.remove(pile.front());
                    pile.pop_front();
                }
                support::run(world, 6);
            }
        };
        churn(300);
        const std::size_t before = bench::liveBytes();
        churn(700);
        EXPECT_LT(bench::liveBytes(), before + 16384 * sizeof(Real));
    }
}

// Regression: the first contact, bounce, stop and sleep of a World sized arrays of all its bodies
// within the step. 16 KB are four bytes for each of them.
TEST(Allocation, TheFirstUseOfAFeatureSizesNoArrayOfAllBodies) {
    constexpr int kBoxes = 4096;
    const auto make = [] {
        World world({.gravity = support::kEarth});
        for (int i = 0; i < kBoxes; ++i) {
            world.add({.shape = Box{1, 1},
                       .position = {static_cast<Real>(2 * i), 0},
                       .type = BodyType::Static});
        }
        world.add({.shape = Box{40, 1}, .position = {-100, 0}, .type = BodyType::Static});
        for (int i = 0; i < 4; ++i) {
            const Real x = static_cast<Real>(4 * i) - 110;
            BodyDef ball = support::ballDef({x, 3}, Real(0.5));
            ball.material.restitution = i < 2 ? Real(0.5) : Real(0);
            ball.velocity = {0, i == 1 ? Real(-300) : Real(0)};
            world.add(ball);
        }
        return world;
    };
    const auto play = [](World world) {
        world.step(support::kDt);
        world.step(support::kDt);
        for (int i = 0; i < 600; ++i) {
            const std::size_t before = bench::liveBytes();
            world.step(support::kDt);
            ASSERT_LT(bench::liveBytes(), before + 4 * kBoxes) << i;
        }
        EXPECT_EQ(stepStats(world).bodies, 0u);
    };
    const World world = make();
    play(make());
    play(world);
    play(fromBytes(toBytes(world)));
}

} // namespace
} // namespace kodo
