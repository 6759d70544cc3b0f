// SPDX-License-Identifier: MIT
// Reports on mass, inertia and joints far from the centre of mass.
#include <gtest/gtest.h>

#include <cmath>

#include "field_scene.hpp"

namespace field {
namespace {

// A compound swings erratically about a pivot far from its centre of mass; as two bodies it is
// calm. https://github.com/liabru/matter-js/issues/1240
TEST(FieldMass, ACompoundSwingsAboutAFarPivotWithoutGainingEnergy) {
    World world = underGravity();
    const BodyId hook = world.add({.shape = kodo::Circle{Real(0.1)}, .type = BodyType::Static});
    kodo::Compound anchor; // of a clock: an arm and two pallets, all below the pivot
    anchor.parts = {kodo::Box{Real(0.1), 3, {0, Real(-1.5)}},
                    kodo::Circle{Real(0.4), {Real(-0.8), -3}},
                    kodo::Circle{Real(0.4), {Real(0.8), -3}}};
    const BodyId body = world.add({.shape = anchor, .rotation = kodo::Rot::fromAngle(1)});
    world.add(kodo::RevoluteJoint{.ends = {.a = hook, .b = body}});
    const auto energy = [&] {
        const auto view = world[body];
        const Vec2 v = view.velocity();
        const Real spin = view.angularVelocity();
        return view.mass() * (dot(v, v) / 2 + 10 * view.center().y) +
               view.inertia() * spin * spin / 2;
    };
    const Real start = energy();
    const Real arm = length(world[body].center());
    const Real swing = world[body].mass() * 10 * arm * (1 - std::cos(Real(1)));
    for (int i = 0; i < 60 * 30; ++i) {
        world.step(kDt);
        ASSERT_NEAR(length(world[body].center()), arm, 0.004) << "step " << i; // a slop
        ASSERT_LT(energy() - start, swing / 100) << "step " << i;
        ASSERT_GT(energy() - start, Real(-0.03) * swing) << "step " << i;
    }
}

// Setting a mass after the body was made static leaves a moment of inertia that is not a number.
// https://github.com/liabru/matter-js/issues/989
TEST(FieldMass, ABodyThatWasStaticHasItsMassAndInertiaBack) {
    World world = underGravity();
    const BodyId box = world.add({.shape = kodo::Box{2, 1}, .density = 3});
    const Real mass = world[box].mass();
    const Real inertia = world[box].inertia();
    world[box].setType(BodyType::Static);
    EXPECT_EQ(world[box].mass(), mass);
    world.step(kDt);
    world[box].setType(BodyType::Dynamic);
    EXPECT_EQ(world[box].mass(), mass);
    EXPECT_EQ(world[box].inertia(), inertia);
    world[box].applyImpulse({0, mass}, world[box].center() + Vec2{Real(0.5), 0});
    EXPECT_NEAR(world[box].velocity().y, 1, 1e-5);
    EXPECT_NEAR(world[box].angularVelocity(), mass * Real(0.5) / inertia, 1e-5);
}

// Scaling a body that cannot rotate resets its inertia, and it rotates.
// https://github.com/phaserjs/phaser/issues/6369
TEST(FieldMass, ABodyWithLockedRotationStaysLockedWhenItsShapeChanges) {
    World world = underGravity();
    addGround(world);
    const BodyId body =
        world.add({.shape = kodo::Box{1, 1}, .position = {0, 3}, .flags = kodo::kLockRotate});
    world.weld(body, kodo::Box{Real(0.5), 2, {Real(0.7), 0}}, {}, 5);
    run(world, 2);
    EXPECT_EQ(world[body].angularVelocity(), 0);
    EXPECT_NEAR(world[body].rotation().angle(), 0, 1e-6);
    const BodyId part = world.unweld(body, 1, kodo::kLockRotate);
    world[part].applyImpulse({0, 5}, world[part].center() + Vec2{1, 0});
    run(world, 1);
    EXPECT_EQ(world[part].angularVelocity(), 0);
    EXPECT_EQ(world[body].angularVelocity(), 0);
}

// With twice the mass a body slides another way until it stops.
// https://github.com/liabru/matter-js/issues/1311
TEST(FieldMass, TheWayUntilABoxStopsDoesNotDependOnItsMass) {
    for (const Real density : {Real(0.01), Real(1), Real(1000)}) {
        World world = underGravity();
        addGround(world, kodo::withFriction(Real(0.5)));
        const BodyId box = world.add({.shape = kodo::Box{1, Real(0.5)},
                                      .position = {-10, Real(0.25)},
                                      .velocity = {5, 0},
                                      .material = kodo::withFriction(Real(0.5)),
                                      .density = density});
        run(world, 2);
        EXPECT_NEAR(world[box].position().x, -7.5, 0.015) << density; // v^2 / (2 mu g)
    }
}

// Density given later leaves the old moment of inertia.
// https://github.com/liabru/matter-js/issues/378
TEST(FieldMass, InertiaGrowsWithDensityInEveryWayToGiveIt) {
    World world;
    const BodyId light = world.add({.shape = kodo::Box{2, 1}, .density = 1});
    const BodyId heavy = world.add({.shape = kodo::Box{2, 1}, .density = 10});
    const BodyId grown = world.add({.shape = kodo::Box{1, 1, {Real(-0.5), 0}}, .density = 10});
    world.weld(grown, kodo::Box{1, 1, {Real(0.5), 0}}, {}, 10);
    EXPECT_NEAR(world[heavy].inertia(), 10 * world[light].inertia(), 1e-4);
    EXPECT_NEAR(world[grown].inertia(), world[heavy].inertia(), 1e-4);
    EXPECT_NEAR(world[grown].mass(), 20, 1e-4);
}

// Small bodies shake by friction although nothing moves.
// https://github.com/liabru/matter-js/issues/169
TEST(FieldMass, SmallBoxesOnEachOtherStandStillAndSleep) {
    World world({.gravity = {0, -10}, .lengthUnit = Real(0.02)});
    addGround(world, kodo::withFriction(1));
    std::vector<BodyId> boxes;
    for (int i = 0; i < 6; ++i) {
        boxes.push_back(world.add({.shape = kodo::Box{Real(0.02), Real(0.02)},
                                   .position = {0, Real(0.01) + Real(0.02) * static_cast<Real>(i)},
                                   .material = kodo::withFriction(1)}));
    }
    run(world, 4);
    for (const BodyId id : boxes) {
        EXPECT_TRUE(world[id].isAsleep());
        EXPECT_NEAR(world[id].position().x, 0, 1e-4);
    }
}

} // namespace
} // namespace field
