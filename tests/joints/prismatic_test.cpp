// SPDX-License-Identifier: MIT
#include <joints/rig.hpp>

#include <algorithm>

namespace kodo {
namespace {

using joints::kG;
using joints::kPi;
using joints::Rig;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

Vec2 axisAt(double angle) {
    return Rot::fromAngle(static_cast<Real>(angle)).xAxis();
}

// F1: on an inclined axis a load slides with g sin and does not rotate, also with an off-centre
// anchor. The joint force is m g cos.
TEST(PrismaticJoint, SlidesAlongItsAxisWithoutRotation) {
    for (const double angle : {0.0, -0.5, -kPi / 2, 2.5}) {
        Rig rig;
        const BodyId load = rig.world.add(support::boxDef({1, 0}, 1, Real(0.5)));
        const JointId slider = rig.world.add(PrismaticJoint{
            .ends = {.a = rig.post, .b = load, .anchorB = {-1, 0}}, .axis = axisAt(angle)});
        run(rig.world, 120);
        const double along = -kG * std::sin(angle) * 4 / 2; // a t^2 / 2 after 2 s
        const double moved =
            static_cast<double>(dot(axisAt(angle), rig.world[load].position() - Vec2{1, 0}));
        // A substep moves with the velocity at its end, which adds a share of h / t.
        EXPECT_TRUE(near(moved, along, 0.003 * std::abs(along) + 1e-3)) << angle;
        // No deflection across the axis, despite a lever arm of 1 m.
        EXPECT_TRUE(
            near(dot(perp(axisAt(angle)), rig.world[load].position() - Vec2{1, 0}), 0, Real(1e-4)));
        EXPECT_TRUE(near(rig.world[load].rotation().s, 0, Real(1e-3)));
        EXPECT_TRUE(near(length(rig.world.jointForce(slider)),
                         rig.weightOf(load) * std::abs(std::cos(angle)),
                         rig.weightOf(load) * 1e-3));
    }
}

// F1: limits stop the load and hold its weight.
TEST(PrismaticJoint, StopsAtItsLimits) {
    Rig rig;
    const BodyId load = rig.world.add(support::boxDef({0, 0}, 1, 1));
    const JointId slider = rig.world.add(
        PrismaticJoint{.ends = {.a = rig.post, .b = load}, .axis = {0, 1}, .limits = Range{-2, 1}});
    Real lowest = 0;
    Real highest = 0;
    const auto follow = [&](int steps) {
        for (int step = 0; step < steps; ++step) {
            rig.world.step(kDt);
            lowest = std::min(lowest, rig.world[load].position().y);
            highest = std::max(highest, rig.world[load].position().y);
        }
    };
    follow(300);
    EXPECT_TRUE(near(rig.world[load].position().y, -2, Real(1e-3)));
    EXPECT_TRUE(near(rig.world.jointForce(slider), Vec2{0, 10}, Real(0.01)));
    rig.world[load].applyImpulse({0, 12}); // would rise by 7.2 m without the limit
    follow(60);
    EXPECT_GT(lowest, Real(-2.005));
    EXPECT_LT(highest, Real(1.005));
    EXPECT_GT(highest, Real(0.995));
}

// F1: a sufficient motor lifts the load at its speed. A weaker one reduces the fall to g - F / m.
TEST(PrismaticJoint, AMotorLiftsAWeightBelowItsForce) {
    for (const double share : {0.5, 1.5}) {
        Rig rig;
        const BodyId load = rig.world.add(support::boxDef({0, 0}, 1, 1));
        const JointId slider =
            rig.world.add(PrismaticJoint{.ends = {.a = rig.post, .b = load},
                                         .axis = {0, 1},
                                         .motorSpeed = 2,
                                         .motorForce = static_cast<Real>(10 * share)});
        run(rig.world, 60);
        if (share > 1) { // (F - m g) / m = 5 m/s^2 up to the motor speed
            EXPECT_TRUE(near(rig.world[load].velocity().y, 2, byPrecision(1e-4, 1e-9)));
            EXPECT_TRUE(near(rig.world.jointForce(slider).y, 10, 0.01));
        } else {
            EXPECT_TRUE(nearShare(rig.world[load].velocity().y, -5, byPrecision(1e-4, 1e-9)));
            EXPECT_TRUE(nearShare(rig.world.jointForce(slider).y, 5, byPrecision(1e-4, 1e-9)));
        }
    }
}

// F1: the axis is fixed to the first body and rotates with it. Momenta of the pair are conserved to
// rounding.
TEST(PrismaticJoint, ItsAxisRotatesWithTheFirstBody) {
    World world;
    BodyDef def = support::boxDef({}, 4, Real(0.25));
    def.angularVelocity = 2;
    def.density = 10;
    const BodyId rail = world.add(def);
    BodyDef bead = support::boxDef({Real(0.5), 0}, Real(0.25), Real(0.25));
    bead.angularVelocity = 2;
    bead.velocity = {0, 1};
    const BodyId id = world.add(bead);
    world.add(PrismaticJoint{.ends = {.a = rail, .b = id}, .limits = Range{-2, 2}});
    const support::Totals before = support::totalsOf(world);
    for (int step = 0; step < 300; ++step) {
        world.step(kDt);
        const Vec2 place =
            unrotate(world[rail].rotation(), world[id].position() - world[rail].position());
        ASSERT_TRUE(near(place.y, 0, Real(3e-3))) << step;
        ASSERT_LT(place.x, Real(2.01));
    }
    EXPECT_TRUE(near((world[id].rotation() * world[rail].rotation().inverse()).s, 0, Real(3e-3)));
    const support::Totals after = support::totalsOf(world);
    // 1500 substeps round momenta and angular momenta of about 10.
    EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(1e-3, 1e-11)));
    EXPECT_TRUE(near(after.spin, before.spin, byPrecision(1e-3, 1e-11)));
}

} // namespace
} // namespace kodo
