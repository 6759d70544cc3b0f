// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <utility>

namespace kodo {
namespace {

using support::kSolvers;
using support::settingsOf;
using support::Solver;

/// A heap with more bodies than the threshold for helpers. It has fast bouncing balls, a sensor, a
/// chain, a ring of revolute joints and deep overlaps, so every stage of a step has work.
World bigWorld(Solver strategy) {
    StepSettings settings = settingsOf(strategy);
    World world({.gravity = support::kEarth, .settings = settings});
    support::addHeap(world, 21, 500);
    world.add({.shape = Box{Real(6), Real(0.5)},
               .position = {0, 3},
               .type = BodyType::Static,
               .flags = kSensor});
    for (int i = 0; i < 40; ++i) {
        BodyDef ball =
            support::ballDef({static_cast<Real>(i % 20) - 10, Real(40 + i / 20)}, Real(0.2));
        ball.material.restitution = 1;
        ball.velocity = {Real(3), -Real(60)};
        world.add(ball);
    }
    world.add({.shape = Box{4, Real(0.5)}, // pushes bodies along
               .position = {0, 6},
               .velocity = {Real(0.5), -1},
               .type = BodyType::Kinematic});
    for (int i = 0; i < 12; ++i) {
        world.add(support::ballDef({Real(-4), Real(30)}, Real(0.3))); // at one point
    }
    BodyId last =
        world.add({.shape = Circle{Real(0.1)}, .position = {12, 20}, .type = BodyType::Static});
    for (int i = 1; i <= 8; ++i) {
        const BodyId link =
            world.add(support::ballDef({12 + Real(0.5) * static_cast<Real>(i), 20}, Real(0.2)));
        world.add(RevoluteJoint{.ends = {last, link, {Real(0.25), 0}, {Real(-0.25), 0}}});
        last = link;
    }
    std::vector<BodyId> ring; // of four bodies, falling
    for (const Vec2 place : {Vec2{-12, 15}, Vec2{-11, 15}, Vec2{-11, 16}, Vec2{-12, 16}}) {
        ring.push_back(world.add(support::ballDef(place, Real(0.4))));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const BodyId next = ring[(i + 1) % ring.size()];
        const Vec2 half = Real(0.5) * (world[next].position() - world[ring[i]].position());
        world.add(
            RevoluteJoint{.ends = {.a = ring[i], .b = next, .anchorA = half, .anchorB = -half}});
    }
    return world;
}

/// Hashes after each step; meanwhile some bodies are removed and added.
std::vector<std::uint64_t> hashes(Solver strategy, Executor* executor) {
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

// The same bits with 1, 2, 3, 4 and 8 threads, in every step. With a sanitizer 2 and 4.
TEST(Executor, ChangesNoBit) {
    for (const Solver strategy : kSolvers) {
        const std::vector<std::uint64_t> alone = hashes(strategy, nullptr);
        for (const int threads :
             support::kSanitized ? std::vector{2, 4} : std::vector{1, 2, 3, 4, 8}) {
            ThreadPool pool(threads - 1);
            EXPECT_EQ(hashes(strategy, &pool), alone) << threads << " threads";
        }
    }
}

/// Towers with a thousand contacts per colour, so that threads share the passes of the solver.
World towers() {
    World world(support::withoutSleep());
    support::addFloor(world);
    for (int x = 0; x < 200; ++x) {
        for (int y = 0; y < 40; ++y) {
            world.add(support::boxDef(
                {Real(1.5) * static_cast<Real>(x - 100), static_cast<Real>(y) + Real(0.5)}, 1, 1));
        }
    }
    return world;
}

// Also if threads share the passes. The constraint graph is rebuilt in the second step with
// helpers, and later without: that changes no bit either.
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

/// A heap of 4,000 balls in random order, with rolling resistance; some are at one point. A plank
/// on top and a drum that only rotates, both with large ids, have more contacts than there are
/// colours. With `links` there are also a kinematic body and a revolute joint, so threads wait for
/// each other in each substep.
World crowd(bool links) {
    World world(support::withoutSleep());
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
                   .type = BodyType::Kinematic});
        const BodyId bob = world.add(support::ballDef({5, 10}, Real(0.3)));
        world.add(RevoluteJoint{.ends = {world.bodies().front(), bob, {5, 12}, {0, 2}}});
    }
    return world;
}

/// Changes that a game may make between two steps.
void meddle(World& world, int step) {
    const std::vector<BodyId> bodies = world.bodies();
    const auto at = static_cast<std::size_t>(step);
    world.remove(bodies[at * 8]);
    world.add(support::ballDef({Real(step) / 10, 21}, Real(0.4)));
    BodyRef body = world[bodies[at * 16 + 1]];
    body.setFlags(body.flags() ^ (kLockMove | kLockRotate));
}

// Also if threads run substeps independently, or wait for each other, while contacts come and go.
// The run is long enough for a rebuild of the constraint graph with shared passes.
class ExecutorThreads : public testing::TestWithParam<int> {};

TEST_P(ExecutorThreads, ChangeNoBitOfALargeHeap) {
    const int threads = GetParam();
    // With three threads, that rebuild is in the 82nd step. With a sanitizer only the steps around
    // it are compared.
    const bool late = support::kSanitized && threads == 3;
    const int first = late ? 71 : 1;
    const int steps = support::kSanitized && !late ? 30 : late ? 90 : 100;
    World alone = crowd(threads == 3);
    for (int step = 1; step < first; ++step) {
        alone.step(support::kDt);
        if (step % 8 == 0) {
            meddle(alone, step);
        }
    }
    World helped = alone;
    ThreadPool pool(threads - 1);
    for (int step = first; step <= steps; ++step) {
        alone.step(support::kDt);
        helped.step(support::kDt, {.executor = step % 20 == 0 ? nullptr : &pool});
        ASSERT_EQ(helped.stateHash(), alone.stateHash()) << "step " << step;
        if (step % 8 == 0) {
            meddle(alone, step);
            meddle(helped, step);
        }
    }
}

// Three threads take longest: they start first.
INSTANTIATE_TEST_SUITE_P(Counts, ExecutorThreads,
                         testing::ValuesIn(support::kDouble ? std::vector{3}
                                                            : std::vector{3, 2, 8}),
                         testing::PrintToStringParamName());

// A World continues identically with other helpers, or without any.
TEST(Executor, MayChangeBetweenSteps) {
    World world = bigWorld(Solver::Soft);
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

/// Offers helpers that start only when the step is over.
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

// A step does not wait for helpers that have not started.
TEST(Executor, MayStartItsHelpersTooLate) {
    Latecomers late;
    EXPECT_EQ(hashes(Solver::Soft, &late), hashes(Solver::Soft, nullptr));
    EXPECT_EQ(late.rounds(), 90);
    World alone = towers();
    World helped = alone;
    for (int step = 1; step <= 5; ++step) {
        alone.step(support::kDt);
        helped.step(support::kDt, {.executor = &late});
    }
    EXPECT_EQ(helped.stateHash(), alone.stateHash());
}

// A step with little work does not use helpers.
TEST(Executor, IsNotUsedForSmallSteps) {
    Latecomers late;
    World world({.gravity = support::kEarth});
    support::addHeap(world, 22, 40);
    support::run(world, 1);
    world.step(support::kDt, {.executor = &late});
    EXPECT_EQ(late.rounds(), 0);
}

/// Runs the task at once, on the stepping thread.
class Immediate final : public Executor {
public:
    int helpers() const override { return 3; }
    void begin(void (*task)(void*), void* data) override {
        for (int i = 0; i < helpers(); ++i) {
            task(data);
        }
    }
    void end() override { ++rounds_; }
    int rounds() const { return rounds_; }

private:
    int rounds_ = 0;
};

// A begin() that runs the task itself gets no help from it, and the step does not hang.
TEST(Executor, MayRunItsTaskAtOnce) {
    Immediate immediate;
    EXPECT_EQ(hashes(Solver::Soft, &immediate), hashes(Solver::Soft, nullptr));
    EXPECT_EQ(immediate.rounds(), 90);
}

/// Steps another World with the same threads while a step runs.
class Nested : public StageListener {
public:
    Nested(World& other, ThreadPool& pool) : other_(other), pool_(pool) {}
    void enter(StepStage stage) override {
        if (stage == StepStage::Solve) {
            EXPECT_THROW(other_.step(support::kDt, {.executor = &pool_}), std::logic_error);
        }
    }
    void leave() override {}

private:
    World& other_;
    ThreadPool& pool_;
};

// One pool serves one step at a time: a second one is refused, changes nothing, and may follow.
TEST(Executor, OfAStepThatRunsRefusesAnother) {
    for (const Solver strategy : kSolvers) {
        World world = bigWorld(strategy);
        World other = world;
        const World before = world;
        ThreadPool pool(2);
        Nested nested(other, pool);
        world.step(support::kDt, {.executor = &pool, .listener = &nested});
        EXPECT_EQ(other.stateHash(), before.stateHash());
        other.step(support::kDt, {.executor = &pool});
        EXPECT_EQ(other.stateHash(), world.stateHash());
    }
}

} // namespace
} // namespace kodo
