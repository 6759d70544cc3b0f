// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <bench/heap.hpp>

#include <deque>
#include <new>

namespace kodo {
namespace {

using bench::allocationCount;

/// A heap in a bin that a platform stirs, a bridge of pins and one joint of each other kind, in
/// wind and water, under an attractor.
struct Scene {
    World world;
    BodyId platform;
    std::vector<BodyId> loose;

    explicit Scene(const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        support::addHeap(world, 21, 60);
        for (const BodyId id : world.bodies()) {
            if ((world[id].flags() & kLocked) == 0) {
                loose.push_back(id);
            }
        }
        platform =
            world.add({.shape = Box{2, Real(0.2)}, .position = {0, Real(0.2)}, .flags = kLocked});
        addBridge();
        addOneOfEachJoint();
        addFields();
    }

    void addBridge() {
        BodyId last =
            world.add({.shape = Circle{Real(0.1)}, .position = {-4, 20}, .flags = kLocked});
        for (int i = 0; i < 8; ++i) {
            const BodyId link =
                world.add(support::boxDef({static_cast<Real>(i) - Real(3.5), 20}, 1, Real(0.2)));
            world.add(Pin{.ends = {last, link, {i == 0 ? Real(0) : Real(0.5), 0}, {Real(-0.5), 0}},
                          .limits = Range{-1, 1}});
            last = link;
        }
        world.add(Mouse{.body = last, .target = {4, 20}, .force = 500});
    }

    void addOneOfEachJoint() {
        const auto pair = [&](Real x) {
            const BodyId a = world.add({.shape = Box{1, 1}, .position = {x, 25}, .flags = kLocked});
            const BodyId b = world.add(support::boxDef({x, 23}, 1, 1));
            return JointEnds{a, b, {0, -1}, {0, 1}};
        };
        world.add(Weld{.ends = pair(0)});
        world.add(Spring{.ends = pair(3), .hertz = 2, .damping = Real(0.1), .limits = Range{0, 3}});
        world.add(
            Slider{.ends = pair(6), .limits = Range{-1, 1}, .motorSpeed = 1, .motorForce = 9});
        world.add(Motor{.ends = pair(9), .force = 100, .torque = 10});
        world.add(Pin{.ends = pair(12), .motorSpeed = 2, .motorTorque = 100});
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

    /// Steps while the platform goes up and down, faster or slower.
    void stir(int steps, Real height) {
        for (int i = 0; i < steps; ++i) {
            const int phase = i % 60;
            const Real share = static_cast<Real>(phase < 30 ? phase : 60 - phase) / 30;
            world[platform].moveTo({0, Real(0.2) + height * share}, support::kDt);
            world.step(support::kDt);
        }
    }
};

StepSettings settingsOf(Strategy strategy, bool rests) {
    StepSettings settings;
    if (strategy == Strategy::Propagation) {
        settings = thesis2006();
        settings.shockPasses = 2;
    }
    settings.leaveOut = rests ? std::uint8_t{0} : static_cast<std::uint8_t>(Feature::Resting);
    return settings;
}

constexpr Strategy kStrategies[] = {Strategy::SoftStep, Strategy::Propagation};

TEST(Allocation, TheCounterCounts) {
    const std::uint64_t before = allocationCount();
    ::operator delete(::operator new(8));
    ::operator delete (::operator new (64, std::align_val_t{64}),
                       std::align_val_t{64}); // as blocks
    EXPECT_EQ(allocationCount(), before + 2);
}

// After a warm-up that was wilder than what follows, no step allocates: with contacts that come and
// go, every joint, fields, records, sweeps.
TEST(Allocation, AStepOfAStirredPileAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsOf(strategy, false));
        scene.stir(1500, 3);
        std::vector<BodyId> more; // than in the measured steps, and so more contacts
        for (int i = 0; i < 16; ++i) {
            more.push_back(scene.world.add(support::ballDef({0, Real(10 + i)}, Real(0.4))));
        }
        scene.stir(600, Real(0.5)); // calmer, but more of it touches
        for (const BodyId id : more) {
            scene.world.remove(id);
        }
        scene.stir(600, Real(0.5));
        const std::uint64_t before = allocationCount();
        scene.stir(300, Real(0.5));
        EXPECT_EQ(allocationCount(), before);
        EXPECT_GT(scene.world.collisions().size(), 50u);
    }
}

// Each way to look for pairs has its first turn at some time.
TEST(Allocation, TheFirstTurnOfASearchForPairsAllocatesNothing) {
    for (const PairSearch way : {PairSearch::Grid, PairSearch::SortAndSweep}) {
        SCOPED_TRACE(static_cast<int>(way));
        Scene scene(settingsOf(Strategy::SoftStep, false));
        scene.world.setPairSearch(PairSearch::BruteForce);
        scene.stir(1500, 3);
        scene.stir(600, Real(0.5));
        scene.world.setPairSearch(way);
        const std::uint64_t before = allocationCount();
        scene.stir(60, Real(0.5));
        EXPECT_EQ(allocationCount(), before);
    }
}

// Nor does one of a pile that rests, with the platform still, and the joints at work.
TEST(Allocation, AStepOfARestingPileAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        Scene scene(settingsOf(strategy, true));
        scene.stir(300, 1);
        scene.world[scene.platform].setVelocity({});
        support::run(scene.world, 2400);
        const std::uint64_t before = allocationCount();
        support::run(scene.world, 300);
        EXPECT_EQ(allocationCount(), before);
    }
}

// Going to rest and waking, again and again, needs no new memory once it was done.
TEST(Allocation, GoingToRestAndWakingAllocatesNothing) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = settingsOf(strategy, true);
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 6);
        const auto cycle = [&] {
            world[boxes[0]].setVelocity({0, Real(0.001)});
            support::run(world, 120);
            ASSERT_NE(world[boxes[0]].flags() & kResting, 0u);
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

/// Balls in a row, each on a tile of its own, and as many tiles far below.
struct TilesAndBalls {
    World world{support::wakeful()};
    std::vector<BodyId> balls;

    explicit TilesAndBalls(int count) {
        for (int i = 0; i < count; ++i) {
            for (const int y : {-1, -61}) {
                world.add({.shape = Box{1, 1}, .position = at(i, y), .flags = kLocked});
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

// Who leaves one and meets another in the same step is told twice that it is touched or not.
TEST(Allocation, ChangingPartnersAllocatesNothing) {
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

// What happens while nobody steps is not remembered one by one.
TEST(Allocation, ARegionThatGoesAboutInAPausedWorldHoldsNoMoreMemory) {
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

// A pile from which the oldest body goes whenever a new one falls on it holds, after 1000 of them,
// no more memory than after 300. What a single body takes, kept, would make 400 KB; there may be 64
// KB more (128 KB in double), since the pile is not the same and one list may have doubled its
// room.
TEST(Allocation, AChurnedPileHoldsNoMoreMemory) {
    for (const Strategy strategy : kStrategies) {
        SCOPED_TRACE(static_cast<int>(strategy));
        World world({.gravity = support::kEarth, .settings = settingsOf(strategy, true)});
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

} // namespace
} // namespace kodo
