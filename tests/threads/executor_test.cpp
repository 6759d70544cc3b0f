// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <utility>

namespace kodo {
namespace {

/// A heap of more bodies than a step must have before it is helped, with fast balls that bounce, a
/// sensor, a chain, a ring of pins and deep overlaps: every stage of a step has something to do.
World bigWorld(Strategy strategy) {
    StepSettings settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{};
    World world({.gravity = support::kEarth, .settings = settings});
    support::addHeap(world, 21, 500);
    world.add({.shape = Box{Real(6), Real(0.5)}, .position = {0, 3}, .flags = kSensor | kLocked});
    for (int i = 0; i < 40; ++i) {
        BodyDef ball =
            support::ballDef({static_cast<Real>(i % 20) - 10, Real(40 + i / 20)}, Real(0.2));
        ball.material.restitution = 1;
        ball.velocity = {Real(3), -Real(60)};
        world.add(ball);
    }
    world.add({.shape = Box{4, Real(0.5)}, // pushes along what it meets
               .position = {0, 6},
               .velocity = {Real(0.5), -1},
               .flags = kLocked});
    for (int i = 0; i < 12; ++i) {
        world.add(support::ballDef({Real(-4), Real(30)}, Real(0.3))); // on one point
    }
    BodyId last = world.add({.shape = Circle{Real(0.1)}, .position = {12, 20}, .flags = kLocked});
    for (int i = 1; i <= 8; ++i) {
        const BodyId link =
            world.add(support::ballDef({12 + Real(0.5) * static_cast<Real>(i), 20}, Real(0.2)));
        world.add(Pin{.ends = {last, link, {Real(0.25), 0}, {Real(-0.25), 0}}});
        last = link;
    }
    std::vector<BodyId> ring; // of four, which falls
    for (const Vec2 place : {Vec2{-12, 15}, Vec2{-11, 15}, Vec2{-11, 16}, Vec2{-12, 16}}) {
        ring.push_back(world.add(support::ballDef(place, Real(0.4))));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const BodyId next = ring[(i + 1) % ring.size()];
        const Vec2 half = Real(0.5) * (world[next].position() - world[ring[i]].position());
        world.add(Pin{.ends = {.a = ring[i], .b = next, .anchorA = half, .anchorB = -half}});
    }
    return world;
}

/// The hash after each step; some bodies go and come meanwhile.
std::vector<std::uint64_t> hashes(Strategy strategy, Executor* executor) {
    World world = bigWorld(strategy);
    std::vector<std::uint64_t> hashes;
    for (int step = 0; step < 90; ++step) {
        world.step(support::kDt, {.executor = executor});
        hashes.push_back(world.stateHash());
        if (step % 20 == 19) {
            const std::vector<BodyId> bodies = world.bodies();
            world.remove(bodies[bodies.size() / 2]);
            world.add(support::ballDef({Real(step) / 10, 30}, Real(0.4)));
        }
    }
    return hashes;
}

// The same bits from 1, 2, 3, 4 and 8 threads, in every step.
TEST(Executor, ChangesNoBit) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        const std::vector<std::uint64_t> alone = hashes(strategy, nullptr);
        for (const int threads : {1, 2, 3, 4, 8}) {
            ThreadPool pool(threads - 1);
            EXPECT_EQ(hashes(strategy, &pool), alone) << threads << " threads";
        }
    }
}

/// Towers of a thousand contacts of each colour, so that the passes of the solver are shared.
World towers() {
    World world(support::wakeful());
    support::addFloor(world);
    for (int x = 0; x < 200; ++x) {
        for (int y = 0; y < 40; ++y) {
            world.add(support::boxDef(
                {Real(1.5) * static_cast<Real>(x - 100), static_cast<Real>(y) + Real(0.5)}, 1, 1));
        }
    }
    return world;
}

// Nor where the passes are shared. Lanes are dealt out anew in the second step with help, and later
// without: that changes no bit either.
TEST(Executor, ChangesNoBitOfAThousandContactsOfAColour) {
    World alone = towers();
    World helped = alone;
    ThreadPool pool(1);
    for (int step = 1; step <= 70; ++step) {
        alone.step(support::kDt);
        helped.step(support::kDt, {.executor = &pool});
        if (step % 10 == 0) {
            ASSERT_EQ(helped.stateHash(), alone.stateHash()) << step;
        }
    }
}

/// A heap of 4,000 balls, in no order, that lie on each other and roll with resistance; some are in
/// one place. A plank on top and a drum that only turns, both with large ids, have more contacts
/// than there are colours. With `links`, something drives and something is pinned, too: then
/// threads wait for each other in each substep.
World crowd(bool links) {
    World world(support::wakeful());
    support::addFloor(world);
    support::RandomNumbers random(31);
    std::vector<int> places(4000);
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = static_cast<int>(i);
        std::swap(places[i], places[random.below(i + 1)]);
    }
    for (const int place : places) {
        BodyDef ball = support::ballDef({static_cast<Real>(place % 100) * Real(0.5) - 25,
                                         static_cast<Real>(place / 100) * Real(0.47) + Real(0.3)},
                                        random.between(0.23, 0.25));
        ball.material.rollingResistance = Real(0.1);
        world.add(ball);
    }
    for (int i = 0; i < 12; ++i) {
        world.add(support::ballDef({Real(10), Real(25)}, Real(0.3)));
    }
    world.add(support::boxDef({0, Real(19.5)}, 40, Real(0.5)));
    BodyDef drum = support::ballDef({-10, 6}, 4);
    drum.flags = kLockMove;
    drum.angularVelocity = 1;
    world.add(drum);
    if (links) {
        world.add({.shape = Box{4, Real(0.5)},
                   .position = {20, 6},
                   .velocity = {Real(0.5), -1},
                   .flags = kLocked});
        const BodyId bob = world.add(support::ballDef({5, 10}, Real(0.3)));
        world.add(Pin{.ends = {world.bodies().front(), bob, {5, 12}, {0, 2}}});
    }
    return world;
}

/// What a game may do between two steps.
void meddle(World& world, int step) {
    const std::vector<BodyId> bodies = world.bodies();
    const auto at = static_cast<std::size_t>(step);
    world.remove(bodies[at * 8]);
    world.add(support::ballDef({Real(step) / 10, 21}, Real(0.4)));
    BodyRef body = world[bodies[at * 16 + 1]];
    body.setFlags(body.flags() ^ kLocked);
}

// Nor where the substeps of all threads run on by themselves, or meet, as contacts come and go; for
// so long that so many lie anywhere that lanes are dealt out anew while they are shared.
TEST(Executor, ChangesNoBitOfACrowd) {
    for (const int threads : {2, 3, 8}) {
        // With three, lanes are dealt out anew in the 82nd step, while they are shared.
        const int steps = support::kSanitized && threads != 3 ? 30 : 100;
        World alone = crowd(threads == 3);
        World helped = alone;
        ThreadPool pool(threads - 1);
        for (int step = 1; step <= steps; ++step) {
            alone.step(support::kDt);
            helped.step(support::kDt, {.executor = step % 20 == 0 ? nullptr : &pool});
            ASSERT_EQ(helped.stateHash(), alone.stateHash()) << threads << " threads " << step;
            if (step % 8 == 0) {
                meddle(alone, step);
                meddle(helped, step);
            }
        }
    }
}

// A World that goes on with other helpers, or with none, is the same World.
TEST(Executor, MayComeAndGo) {
    World world = bigWorld(Strategy::SoftStep);
    World alone = world;
    ThreadPool two(1);
    ThreadPool three(2);
    Executor* const executors[] = {&two, nullptr, &three};
    for (int step = 0; step < 60; ++step) {
        world.step(support::kDt, {.executor = executors[step / 7 % 3]});
        alone.step(support::kDt);
        ASSERT_EQ(world.stateHash(), alone.stateHash()) << step;
    }
}

/// Promises helpers of which none comes before the step is over.
class Latecomers final : public Executor {
public:
    int helpers() const override { return 3; }
    void begin(void (*task)(void*), void* data) override {
        task_ = task;
        data_ = data;
    }
    void end() override {
        std::exchange(task_, nullptr)(data_);
        ++rounds_;
    }
    int rounds() const { return rounds_; }

private:
    void (*task_)(void*) = nullptr;
    void* data_ = nullptr;
    int rounds_ = 0;
};

// Nothing waits for who has not begun.
TEST(Executor, MayComeTooLate) {
    Latecomers late;
    EXPECT_EQ(hashes(Strategy::SoftStep, &late), hashes(Strategy::SoftStep, nullptr));
    EXPECT_EQ(late.rounds(), 90);
    World alone = towers();
    World helped = alone;
    for (int step = 1; step <= 5; ++step) {
        alone.step(support::kDt);
        helped.step(support::kDt, {.executor = &late});
    }
    EXPECT_EQ(helped.stateHash(), alone.stateHash());
}

// A step with hardly anything to do is not worth anybody's help.
TEST(Executor, IsNotTroubledBySmallSteps) {
    Latecomers late;
    World world({.gravity = support::kEarth});
    support::addHeap(world, 22, 40);
    support::run(world, 1);
    world.step(support::kDt, {.executor = &late});
    EXPECT_EQ(late.rounds(), 0);
}

} // namespace
} // namespace kodo
