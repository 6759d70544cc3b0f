// SPDX-License-Identifier: MIT
// C3: the profile thesis2006() takes shock passes, so that stacks stand and sleep
// [Thesis06, 4.2.2].
#include <support/sleeping.hpp>

#include <cmath>

namespace kodo {
namespace {

// X9: ten boxes stand and sleep.
TEST(ThesisProfile, AStackStandsAndSleeps) {
    for (const int rate : {30, 60, 120, 240}) {
        for (const int count : {1, 3, 10, 20, 40}) {
            SCOPED_TRACE(testing::Message() << rate << " Hz, " << count << " boxes");
            World world({.gravity = support::kEarth, .settings = thesis2006()});
            support::addFloor(world);
            const std::vector<BodyId> boxes = support::addStack(world, count);
            support::run(world, 2 * rate, Real(1) / static_cast<Real>(rate));
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                EXPECT_TRUE(support::isAsleep(world, boxes[i])) << i;
                const Vec2 place{0, Real(0.5) + static_cast<Real>(i)};
                EXPECT_LT(length(world[boxes[i]].position() - place), Real(1e-3)) << i;
            }
        }
    }
}

// Without sleep it stands as well: the plain passes alone let a stack of three fall after 15 s.
TEST(ThesisProfile, AStackStandsForAMinuteWithoutSleep) {
    StepSettings settings = thesis2006();
    settings.leaveOut = Feature::Sleep;
    for (const int count : {3, 10}) {
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, count);
        support::run(world, 1800, Real(1) / 30);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Vec2 place{0, Real(0.5) + static_cast<Real>(i)};
            EXPECT_LT(length(world[boxes[i]].position() - place), Real(0.01)) << count << ", " << i;
        }
    }
}

} // namespace
} // namespace kodo
