// SPDX-License-Identifier: MIT
// B4: a change in one of the last steps before an island sleeps starts its count again.
#include "support/solver.hpp"
#include <support/sleeping.hpp>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace kodo {
namespace {

using support::isAsleep;

struct Case {
    Real gravity;
    int rate; // Hz
    support::Solver solver;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 240}) {
            for (const Real gravity : {Real(1.62), Real(10), Real(25)}) {
                all.push_back({gravity, rate, solver});
            }
        }
    }
    return all;
}

struct Scene {
    World world;
    BodyId floor;
    BodyId box;
    Real dt;

    explicit Scene(const Case& row, bool pulled = true)
        : world({.gravity = pulled ? Vec2{0, -row.gravity} : Vec2{},
                 .settings = support::settingsOf(row.solver)}),
          dt(Real(1) / static_cast<Real>(row.rate)) {
        BodyDef ground;
        ground.shape = Box{20, 1};
        ground.position = {0, -Real(0.5)};
        ground.type = BodyType::Static;
        floor = world.add(ground);
        box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    }

    /// Steps until the box sleeps.
    int stepsToSleep() const {
        Scene copy = *this;
        int steps = 0;
        while (!isAsleep(copy.world, copy.box) && steps < 2000) {
            copy.world.step(dt);
            ++steps;
        }
        return steps;
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(dt);
        }
    }
};

/// Makes the change `before` steps ahead of sleep, and expects that the box falls.
template <typename Change>
void expectFall(const Case& row, int before, Change change) {
    SCOPED_TRACE(testing::Message()
                 << "g " << row.gravity << ", " << row.rate << " Hz, solver "
                 << static_cast<int>(row.solver) << ", " << before << " steps before sleep");
    Scene scene(row);
    scene.run(scene.stepsToSleep() - before);
    ASSERT_EQ(isAsleep(scene.world, scene.box), before == 0);
    change(scene);
    scene.run(row.rate); // 1 s
    EXPECT_LT(scene.world[scene.box].position().y, Real(0.5) - row.gravity / 3)
        << "it should have fallen by g / 2";
}

TEST(SleepCount, ABoxFallsWhenItsFloorGoesJustBeforeItSleeps) {
    for (const Case& row : cases()) {
        for (const int before : {0, 1, 2, 3}) {
            expectFall(row, before, [](Scene& s) { s.world.remove(s.floor); });
            expectFall(row, before, [](Scene& s) { s.world[s.floor].setPosition({0, 99}); });
            expectFall(row, before, [](Scene& s) { s.world[s.floor].setFlags(kDisabled); });
            expectFall(row, before, [](Scene& s) { s.world[s.floor].setFlags(kSensor); });
            expectFall(row, before, [](Scene& s) { s.world[s.floor].setFlags(kMatchAny); });
        }
    }
}

/// Steps until all boxes sleep.
void runUntilAsleep(Scene& scene, const std::vector<BodyId>& boxes) {
    const auto asleep = [&](BodyId box) { return isAsleep(scene.world, box); };
    for (int i = 0; i < 2000 && !std::all_of(boxes.begin(), boxes.end(), asleep); ++i) {
        scene.world.step(scene.dt);
    }
    ASSERT_TRUE(std::all_of(boxes.begin(), boxes.end(), asleep));
}

/// Several boxes sleep on one floor. One of them wakes and sleeps again; then the floor goes.
template <typename Change>
void expectAllFall(const Case& row, int count, int woken, Change change) {
    SCOPED_TRACE(testing::Message()
                 << "g " << row.gravity << ", " << row.rate << " Hz, solver "
                 << static_cast<int>(row.solver) << ", box " << woken << " of " << count);
    Scene scene(row);
    std::vector<BodyId> boxes{scene.box};
    for (int i = 1; i < count; ++i) {
        boxes.push_back(
            scene.world.add(support::boxDef({Real(1.5) * static_cast<Real>(i), Real(0.5)}, 1, 1)));
    }
    for (int sleep = 0; sleep < 3; ++sleep) {
        ASSERT_NO_FATAL_FAILURE(runUntilAsleep(scene, boxes));
        if (sleep < 2) {
            scene.world[boxes[static_cast<std::size_t>(woken)]].setVelocity({0, Real(0.01)});
        }
    }
    change(scene);
    scene.run(row.rate); // 1 s
    for (const BodyId box : boxes) {
        EXPECT_LT(scene.world[box].position().y, Real(0.5) - row.gravity / 3) << box.index;
    }
}

TEST(SleepCount, EachBoxFallsWhenItsFloorGoesAfterOneHasSleptTwice) {
    for (const Case& row : cases()) {
        for (const auto& [count, woken] :
             {std::pair(1, 0), {2, 1}, {3, 0}, {3, 2}, {5, 3}, {5, 4}}) {
            expectAllFall(row, count, woken, [](Scene& s) { s.world.remove(s.floor); });
            expectAllFall(row, count, woken, [](Scene& s) {
                s.world[s.floor].setPosition({0, 99});
            });
            expectAllFall(row, count, woken,
                          [](Scene& s) { s.world[s.floor].setFlags(kDisabled); });
            expectAllFall(row, count, woken, [](Scene& s) {
                s.world = fromBytes(toBytes(s.world));
                s.world.remove(s.floor);
            });
        }
    }
}

// Without forces a body that rests is calm at once. Gravity is switched on in its last calm steps.
TEST(SleepCount, AFieldThatIsSwitchedOnPullsWhatIsAboutToSleep) {
    for (const Case& row : cases()) {
        for (const int before : {0, 1, 2}) {
            SCOPED_TRACE(testing::Message() << row.gravity << ", " << row.rate << ", " << before);
            Scene scene(row, false);
            scene.world.remove(scene.floor);
            scene.run(scene.stepsToSleep() - before);
            scene.world.addField({std::make_shared<Gravity>(Vec2{0, -row.gravity})});
            scene.run(row.rate);
            EXPECT_LT(scene.world[scene.box].position().y, Real(0.5) - row.gravity / 3);
        }
    }
}

} // namespace
} // namespace kodo
