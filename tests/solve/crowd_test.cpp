// SPDX-License-Identifier: MIT
// A9: many bodies that are added on one point.
#include <kodo/step_stats.hpp>
#include <kodo/world.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

constexpr Real kPushSpeed = 3; // m/s, see SoftSettings::pushSpeed

enum class Crowd { Boxes, Discs, Mixed };
constexpr Crowd kCrowds[] = {Crowd::Boxes, Crowd::Discs, Crowd::Mixed};

/// Bodies of half a metre at one place.
std::vector<BodyId> addCrowd(World& world, Crowd crowd, int count, Vec2 place) {
    const Polygon wedge{{{Real(-0.3), Real(-0.2)}, {Real(0.3), Real(-0.2)}, {0, Real(0.3)}}};
    std::vector<BodyId> bodies;
    for (int i = 0; i < count; ++i) {
        const int kind = crowd == Crowd::Boxes ? 0 : crowd == Crowd::Discs ? 1 : i % 3;
        BodyDef def{.shape = Box{Real(0.5), Real(0.5)}, .position = place};
        if (kind == 1) {
            def.shape = Circle{Real(0.25)};
        } else if (kind == 2) {
            def.shape = wedge;
        }
        bodies.push_back(world.add(def));
    }
    return bodies;
}

Real fastestOf(const World& world, const std::vector<BodyId>& bodies) {
    Real fastest = 0;
    for (const BodyId body : bodies) {
        fastest = std::max(fastest, length(world[body].velocity()));
    }
    return fastest;
}

Real highestOf(const World& world, const std::vector<BodyId>& bodies) {
    Real highest = 0;
    for (const BodyId body : bodies) {
        highest = std::max(highest, world[body].position().y);
    }
    return highest;
}

// In free space they part at no more than the push speed, and keep three quarters of that.
TEST(Crowd, PartsInFreeSpaceBelowThePushSpeed) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Crowd crowd : kCrowds) {
            SCOPED_TRACE(testing::Message() << "solver " << static_cast<int>(solver) << ", crowd "
                                            << static_cast<int>(crowd));
            World world({.settings = support::settingsOf(solver)});
            const std::vector<BodyId> bodies = addCrowd(world, crowd, 20, {});
            std::vector<Vec2> last(bodies.size());
            for (int step = 0; step < 300; ++step) {
                world.step(support::kDt);
                for (std::size_t i = 0; i < bodies.size(); ++i) {
                    const Vec2 now = world[bodies[i]].position();
                    ASSERT_LT(length(now - last[i]), Real(1.3) * kPushSpeed * support::kDt) << step;
                    last[i] = now;
                }
            }
            EXPECT_LT(fastestOf(world, bodies), Real(0.75) * kPushSpeed);
        }
    }
}

// Over a floor they build no tower, and none leaps. Bodies that fall from the heap become faster
// than the push speed, and all do on the slope.
TEST(Crowd, PartsOverAFloorWithoutATower) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Crowd crowd : kCrowds) {
            for (const Real slope : {Real(0), Real(0.2)}) {
                SCOPED_TRACE(testing::Message()
                             << "solver " << static_cast<int>(solver) << ", crowd "
                             << static_cast<int>(crowd) << ", slope " << slope);
                World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
                const BodyId floor = support::addFloor(world);
                world[floor].setRotation(Rot::fromAngle(-slope));
                const std::vector<BodyId> bodies = addCrowd(world, crowd, 20, {0, Real(0.3)});
                Real highest = 0;
                for (int step = 0; step < 180; ++step) {
                    world.step(support::kDt);
                    highest = std::max(highest, highestOf(world, bodies));
                    const Real slid = 10 * slope * support::kDt * static_cast<Real>(step);
                    ASSERT_LT(fastestOf(world, bodies), 2 * kPushSpeed + slid) << step;
                }
                EXPECT_LT(highest, Real(2.6));
            }
        }
    }
}

// Two hundred of them have 19,900 pairs, which would take 480,000 visits in a step. About a tenth
// is solved at a time, and they become few as the bodies part.
TEST(Crowd, OfTwoHundredTakesBoundedWork) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> bodies = addCrowd(world, Crowd::Mixed, 200, {0, Real(0.3)});
    std::size_t most = 0;
    for (int step = 0; step < 300; ++step) {
        world.step(support::kDt);
        most = std::max(most, stepStats(world).contacts);
        ASSERT_LT(highestOf(world, bodies), 7) << step;
    }
    EXPECT_LT(most, 300000u);
    EXPECT_LT(stepStats(world).contacts, 100000u);
}

} // namespace
} // namespace kodo
