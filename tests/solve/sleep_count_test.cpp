// SPDX-License-Identifier: MIT
// B4: a change in one of the last steps before an island sleeps starts its count again.
#include "support/solver.hpp"
#include <support/sleeping.hpp>

#include <memory>
#include <vector>

namespace kodo {
namespace {

using support::rests;

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
        while (!rests(copy.world, copy.box) && steps < 2000) {
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
    ASSERT_EQ(rests(scene.world, scene.box), before == 0);
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
