// SPDX-License-Identifier: MIT
// Bodies that slide off the top of a ramp: the straight extension of the ramp must not lift them.
#include <kodo/kodo.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

enum class RampGround { Heightmap, Segments };

/// Rises by `slope` up to x = 4 m, then level at height 0 for 20 m.
Shape rampOf(RampGround ground, Real slope) {
    if (ground == RampGround::Heightmap) {
        return Heightmap{.origin = {}, .spacing = 4, .heights = {-4 * slope, 0, 0, 0, 0, 0, 0}};
    }
    return Compound{{Segment{{0, -4 * slope}, {4, 0}}, Segment{{4, 0}, {24, 0}}}};
}

struct Slide {
    StepSettings settings;
    RampGround ground;
    Real slope;
    Real rate;  // Hz
    Real speed; // m/s
};

/// Largest height (m) that a body gains which slides on level ground, its rear over the ramp.
/// `shape` stands on its origin and is 0.6 m wide.
Real liftOf(const Slide& slide, const Shape& shape, Real start, Flags flags) {
    World world({.gravity = {0, -10}, .settings = slide.settings});
    world.add({.shape = rampOf(slide.ground, slide.slope), .type = BodyType::Static});
    const BodyId body = world.add({.shape = shape,
                                   .position = {Real(4.05) + start, 0},
                                   .velocity = {slide.speed, 0},
                                   .material = withFriction(0),
                                   .flags = flags | kNeverSleep});
    Real lift = 0;
    for (int step = 0; step < static_cast<int>(slide.rate); ++step) {
        world.step(1 / slide.rate);
        lift = std::max(lift, world[body].position().y);
    }
    return lift;
}

template <typename Check>
void forSlides(Check check) {
    for (const support::Solver solver : support::kSolvers) {
        for (const RampGround ground : {RampGround::Heightmap, RampGround::Segments}) {
            for (const Real slope : {Real(0.03), Real(0.125), Real(0.6)}) {
                for (const Real rate : {Real(30), Real(60), Real(120)}) {
                    for (const Real speed : {Real(1), Real(3), Real(8)}) {
                        SCOPED_TRACE(::testing::Message()
                                     << "solver " << static_cast<int>(solver) << ", ground "
                                     << static_cast<int>(ground) << ", slope " << slope << ", rate "
                                     << rate << ", speed " << speed);
                        check(Slide{support::settingsOf(solver), ground, slope, rate, speed});
                    }
                }
            }
        }
    }
}

// The last corner over the ramp comes to its plane exactly at the top, so it never touches. It was
// lifted by up to 666 mm at 8 m/s and 36 mm at 3 m/s. The bound is a quarter of the slop.
TEST(Hilltop, LiftsNoBoxThatSlidesOffARamp) {
    const Shape box = Box{Real(0.6), Real(1.4), {0, Real(0.7)}};
    forSlides([&](const Slide& slide) {
        for (const Real start : {Real(0), Real(0.04), Real(0.1)}) {
            EXPECT_LT(liftOf(slide, box, start, kLockRotate), Real(0.001)) << "start " << start;
        }
    });
}

TEST(Hilltop, LiftsNoPolygonOnItsLowestCorner) {
    const Shape kite = Polygon{{{0, 0}, {Real(0.3), Real(0.05)}, {0, 1}, {Real(-0.3), Real(0.05)}}};
    forSlides([&](const Slide& slide) {
        EXPECT_LT(liftOf(slide, kite, Real(0.02), kLockRotate), Real(0.001));
    });
}

// A body that can turn leans a little as its support moves along its face. Then the rear corner may
// touch the ramp, from a depth of a slop on with an impact.
TEST(Hilltop, LiftsAFreeBoxLittle) {
    const Shape box = Box{Real(0.6), Real(1.4), {0, Real(0.7)}};
    forSlides([&](const Slide& slide) {
        if (slide.rate > 30) {
            EXPECT_LT(liftOf(slide, box, Real(0.04), 0), Real(0.002));
        }
    });
}

// The ramp still carries a box that falls onto it beside its top.
TEST(Hilltop, CarriesWhatFallsBesideIt) {
    forSlides([](const Slide& slide) {
        World world({.gravity = {0, -10}, .settings = slide.settings});
        world.add({.shape = rampOf(slide.ground, slide.slope), .type = BodyType::Static});
        const BodyId box = world.add({.shape = Box{Real(0.3), Real(0.3)},
                                      .position = {Real(3.8), Real(0.6)},
                                      .velocity = {slide.speed, -3},
                                      .material = withFriction(0),
                                      .flags = kLockRotate | kNeverSleep});
        Real lowest = 1;
        for (int step = 0; step < static_cast<int>(slide.rate); ++step) {
            world.step(1 / slide.rate);
            const Vec2 at = world[box].position();
            const Real ground = std::min(Real(0), slide.slope * (at.x + Real(0.15) - 4));
            lowest = std::min(lowest, at.y - Real(0.15) - ground);
        }
        EXPECT_GT(lowest, -3 / slide.rate * Real(0.5)) << "half of the way of a step";
    });
}

// Without friction, spin has no effect. The contact of a disc does not move with its rim.
TEST(Hilltop, CarriesABallThatSpins) {
    for (const RampGround ground : {RampGround::Heightmap, RampGround::Segments}) {
        for (const Real rate : {Real(20), Real(60), Real(240)}) {
            for (const Real spin : {Real(-100), Real(-30), Real(30)}) {
                World world({.gravity = {0, -10}});
                world.add({.shape = rampOf(ground, Real(0.3)), .type = BodyType::Static});
                const BodyId ball = world.add({.shape = Circle{Real(0.3)},
                                               .position = {Real(3.87), Real(0.8)},
                                               .velocity = {0, -5},
                                               .angularVelocity = spin,
                                               .material = withFriction(0)});
                Real deepest = 0; // m, below the flank
                for (int step = 0; step < static_cast<int>(rate / 4); ++step) {
                    world.step(1 / rate);
                    const Vec2 arm = world[ball].position() - Vec2{4, 0};
                    const Vec2 normal = normalize(Vec2{Real(-0.3), 1});
                    deepest = std::max(deepest, Real(0.3) - dot(normal, arm));
                }
                EXPECT_LT(deepest, Real(0.002)) << "ground " << static_cast<int>(ground)
                                                << ", rate " << rate << ", spin " << spin;
            }
        }
    }
}

// A corner that strikes the ramp 0.1 m before its top rebounds by the law of reflection: twice the
// angle of the ramp.
TEST(Hilltop, ReflectsWhatStrikesBesideIt) {
    const Shape kite =
        Polygon{{{0, 0}, {Real(0.3), Real(0.2)}, {0, Real(0.5)}, {Real(-0.3), Real(0.2)}}};
    forSlides([&](const Slide& slide) {
        World world({.settings = slide.settings});
        world.add({.shape = rampOf(slide.ground, slide.slope),
                   .material = withFriction(0, 1),
                   .type = BodyType::Static});
        const BodyId body = world.add({.shape = kite,
                                       .position = {Real(3.4), -slide.slope / 10},
                                       .velocity = {slide.speed, 0},
                                       .material = withFriction(0, 1),
                                       .flags = kLockRotate});
        for (int step = 0; step < static_cast<int>(slide.rate / slide.speed); ++step) {
            world.step(1 / slide.rate);
        }
        const Real rise = slide.speed * std::sin(2 * std::atan(slide.slope));
        EXPECT_NEAR(world[body].velocity().y, rise, Real(0.01) * rise);
    });
}

// Both ends of a face that lands flush on the ramp touch at once, one of them at its top. With
// soft contacts the box turns by up to 0.4 rad/s; without the end at the top it turned by 1.4.
TEST(Hilltop, AFlushLandingOverTheTopHardlySpins) {
    const Real angle = std::atan(Real(0.4));
    const Vec2 along{std::cos(angle), std::sin(angle)};
    for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
        World world({.gravity = {0, -10}});
        world.add({.shape = Heightmap{.origin = {-6, Real(-2.4)},
                                      .spacing = 6,
                                      .heights = {0, Real(2.4), Real(1.2)}},
                   .material = withFriction(0),
                   .type = BodyType::Static});
        const BodyId box = world.add({.shape = Box{1, Real(0.6)},
                                      .position = Real(0.5) * perp(along) - Real(0.2) * along,
                                      .rotation = Rot::fromAngle(angle),
                                      .velocity = along - 2 * perp(along),
                                      .material = withFriction(0)});
        Real spin = 0;
        for (int step = 0; step < static_cast<int>(rate / 5); ++step) {
            world.step(1 / rate);
            spin = std::max(spin, std::abs(world[box].angularVelocity()));
        }
        EXPECT_LT(spin, Real(0.6)) << "rate " << rate;
    }
}

} // namespace
} // namespace kodo
