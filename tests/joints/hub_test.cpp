// SPDX-License-Identifier: MIT
// Many joints at one body, and how exactly joints are held.
#include <support/solver.hpp>

#include <joints/rig.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace kodo {
namespace {

using joints::kPi;
using support::kEarth;

/// A hub of radius 0.5 m and 0.8 kg, with bars of 1 x 0.1 m around it.
struct Hub {
    World world;
    BodyId hub;
    std::vector<BodyId> bars;

    /// `density`: of the bars. A hub at height `y` (m) over ground.
    Hub(const StepSettings& settings, int count, Real density, Real y, bool welded)
        : world({.gravity = kEarth, .settings = settings}) {
        world.add({.shape = Box{40, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Static});
        hub = world.add({.shape = Circle{Real(0.5)}, .position = {0, y}});
        for (int i = 0; i < count; ++i) {
            const Rot turn = Rot::fromAngle(static_cast<Real>(2 * kPi * i / count));
            const Vec2 out = turn * Vec2{1, 0};
            bars.push_back(world.add({.shape = Box{1, Real(0.1)},
                                      .position = Vec2{0, y} + out,
                                      .rotation = turn,
                                      .density = density,
                                      .group = -1}));
            const JointEnds ends{
                .a = hub, .b = bars.back(), .anchorA = Real(0.5) * out, .anchorB = {Real(-0.5), 0}};
            if (welded) {
                world.add(FixedJoint{.ends = ends, .reference = turn.angle()});
            } else {
                world.add(RevoluteJoint{.ends = ends});
            }
        }
    }

    /// m/s, the fastest that a body is within `seconds`.
    Real fastest(Real rate, Real seconds) {
        Real most = 0;
        for (int step = 0; step < static_cast<int>(seconds * rate); ++step) {
            world.step(1 / rate);
            for (const BodyId id : world.bodies()) {
                most = std::max(most, length(world[id].velocity()));
            }
        }
        return most;
    }
};

// Springs of 33 and more pins, each as stiff as its own two bodies allow, moved the hub too far
// together: bars flew at 300 km/s. The fall is 5.4 m/s; a bar that lands on its end whips around.
TEST(Hub, OfManyJointsLands) {
    for (const StepSettings& settings : {fast(), balanced(), thesis2006()}) {
        for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
            for (const bool welded : {false, true}) {
                for (const int count : {12, 40, 100}) {
                    for (const Real density : {Real(1), Real(10)}) {
                        Hub star(settings, count, density, Real(2.2), welded);
                        EXPECT_LT(star.fastest(rate, 2), welded ? 10 : 40)
                            << count << (welded ? " welded bars" : " pinned bars") << " of density "
                            << density << " at " << rate << " Hz, solver "
                            << settings.solver.index();
                        EXPECT_TRUE(star.world.frozenBodies().empty());
                    }
                }
            }
        }
    }
}

// A turning hub that hangs on a pin: 40 to 120 bars were torn off within a second.
TEST(Hub, OnAPinKeepsItsBars) {
    for (const StepSettings& settings : {fast(), balanced(), accurate(), thesis2006()}) {
        for (const int count : {20, 40, 100}) {
            Hub wheel(settings, count, 1, 6, false);
            const BodyId post = wheel.world.add({.shape = Box{1, 1},
                                                 .position = {0, 6},
                                                 .type = BodyType::Static,
                                                 .flags = kDisabled});
            wheel.world.add(RevoluteJoint{.ends = {.a = post, .b = wheel.hub}});
            wheel.world[wheel.hub].setAngularVelocity(3);
            EXPECT_LT(wheel.fastest(60, 3), 15) << count << ", solver " << settings.solver.index();
        }
    }
}

/// A chain of balls that swings from level.
Real widestGap(Real jointGap) {
    StepSettings settings;
    settings.soft().jointGap = jointGap;
    settings.leaveOut = Feature::Sleep;
    joints::Rig rig(kEarth, settings);
    std::vector<JointEnds> ends;
    BodyId before = rig.post;
    for (int i = 0; i < 40; ++i) {
        const BodyId ball = rig.world.add({.shape = Circle{Real(0.2)},
                                           .position = {Real(0.5) * static_cast<Real>(i + 1), 0},
                                           .flags = kDisabled});
        ends.push_back({.a = before, .b = ball, .anchorB = {Real(-0.5), 0}});
        rig.world.add(RevoluteJoint{.ends = ends.back()});
        before = ball;
    }
    Real widest = 0;
    for (int step = 0; step < 120; ++step) {
        rig.world.step(support::kDt);
        for (const JointEnds& joint : ends) {
            widest = std::max(widest, length(joints::gapOf(rig.world, joint)));
        }
    }
    return widest;
}

// Springs hold 40 links with gaps of a part of a ball; the direct solve has none that one can see.
TEST(JointGap, AChainIsSolvedDirectlyWhereItWouldOpen) {
    EXPECT_LT(widestGap(Real(0.04)), Real(1e-3));
    EXPECT_GT(widestGap(10), 10 * widestGap(Real(0.04)));
    EXPECT_LT(widestGap(10), Real(0.4));
}

/// Most parts of a substep of a cart of 1 t on wheels of 1.6 kg.
std::uint32_t partsOfACart(Real jointGap) {
    StepSettings settings;
    settings.soft().jointGap = jointGap;
    World world({.gravity = kEarth, .settings = settings});
    world.add({.shape = Box{40, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Static});
    const BodyId cart =
        world.add({.shape = Box{4, Real(0.5)}, .position = {0, Real(0.4)}, .density = 500});
    for (const Real x : {Real(-1.5), Real(1.5)}) {
        const BodyId wheel = world.add(
            {.shape = Circle{Real(0.4)}, .position = {x, Real(0.4)}, .density = Real(3.2)});
        world.add(RevoluteJoint{.ends = {.a = cart, .b = wheel, .anchorA = {x, 0}}});
    }
    std::uint32_t most = 0;
    for (int step = 0; step < 60; ++step) {
        world.step(support::kDt);
        most = std::max(most, stepStats(world).mostParts);
    }
    return most;
}

// A gap ten times as large takes a third of the parts.
TEST(JointGap, LoadedPinsTakeThePartsThatTheirGapNeeds) {
    const std::uint32_t usual = partsOfACart(SoftSettings{}.jointGap);
    EXPECT_GT(usual, 1u);
    EXPECT_LT(partsOfACart(10 * SoftSettings{}.jointGap), usual);
}

} // namespace
} // namespace kodo
