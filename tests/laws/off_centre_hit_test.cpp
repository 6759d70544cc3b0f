// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::slippery;

// Rounding only: about ten operations on speeds of up to 6 m/s.
constexpr Real kTolerance = byPrecision(1e-6, 1e-14);

/// A ball of 1 kg flies up at 3 m/s towards a resting rod of 2 kg, at the distance d from its
/// centre.
struct Hit {
    World world;
    BodyId rod;
    BodyId ball;
    long double rodMass = 2;
    long double rodInertia = 2 * (16 + 0.25L) / 12;

    Hit(Real d, const Material& material) {
        BodyDef def = support::boxDef({0, 2}, 4, Real(0.5), material);
        rod = world.add(def);
        def = support::ballDef({d, 0}, Real(0.5), material);
        def.density = 4 / std::numbers::pi_v<Real>;
        def.velocity = {0, 3};
        ball = world.add(def);
    }
    void run() {
        for (int i = 0; i < 120 && world[rod].velocity() == Vec2{}; ++i) {
            world.step(support::kDt);
        }
    }
};

// S1: J = (1 + e) v / (1/m + 1/M + d^2/I),  V = J/M,  omega = J d / I,  v' = v - J/m.
TEST(OffCentreHit, OnARodFollowsTheFormula) {
    for (const Real d : {Real(0), Real(0.5), Real(1.25), Real(-1.9)}) {
        for (const Real e : {Real(1), Real(0.5)}) {
            SCOPED_TRACE(testing::Message() << "d " << d << ", e " << e);
            Hit hit(d, slippery(e));
            hit.run();
            const auto arm = static_cast<long double>(d);
            const long double j = (1 + static_cast<long double>(e)) * 3 /
                                  (1 + 1 / hit.rodMass + arm * arm / hit.rodInertia);
            EXPECT_TRUE(near(hit.world[hit.rod].velocity().y, j / hit.rodMass, kTolerance));
            EXPECT_TRUE(
                near(hit.world[hit.rod].angularVelocity(), j * arm / hit.rodInertia, kTolerance));
            EXPECT_TRUE(near(hit.world[hit.ball].velocity().y, 3 - j, kTolerance));
            EXPECT_TRUE(near(hit.world[hit.ball].velocity().x, 0, kTolerance));
        }
    }
}

// The record holds the same impulse.
TEST(OffCentreHit, TheRecordHoldsTheImpulse) {
    Hit hit(Real(1.25), slippery(1));
    hit.run();
    const CollisionRecord* record = support::recordOf(hit.world, hit.rod, hit.ball);
    ASSERT_NE(record, nullptr);
    const long double j = 6 / (1 + 1 / hit.rodMass + 1.5625L / hit.rodInertia);
    EXPECT_TRUE(near(record->maxImpulse, j, 4 * kTolerance));
    EXPECT_TRUE(near(record->approachSpeed, 3, kTolerance));
    EXPECT_TRUE(near(record->point.x, 1.25L, kTolerance));
}

// Oblique impact of two equal discs. A tangential impulse of m v_t / 6 would stop all sliding.
// Friction applies it, limited by mu times the normal impulse. Both discs get the same spin, and
// momentum is conserved. Continuous collision stops the discs slop / 65536 before the touch (slop /
// 1024 in float), or at 1.5 times that. The normal is off by at most 6e-8 (4e-6 in float), which
// deflects the same share of 3 m/s.
TEST(OffCentreHit, AnObliqueImpactOfTwoDiscsObeysTheFrictionCone) {
    constexpr Real kAslant = byPrecision(1.2e-5, 2e-7);
    for (const Real e : {Real(0.5), Real(1)}) {
        for (const Real mu : {Real(0), Real(0.1), Real(0.3), Real(1)}) {
            SCOPED_TRACE(testing::Message() << "mu " << mu << ", e " << e);
            World world;
            BodyDef def = support::ballDef({-2, -1}, Real(0.5), withFriction(mu, e));
            def.density = 4 / std::numbers::pi_v<Real>; // 1 kg
            // They meet at the leftmost point of the other disc, where both tangents are y.
            def.velocity = {3, 2};
            const BodyId one = world.add(def);
            def.position = {Real(0.5), 0};
            def.velocity = {};
            const BodyId other = world.add(def);
            support::run(world, 60);
            const long double normal = (1 + static_cast<long double>(e)) * 3 / 2;
            const long double frictionImpulse =
                std::min(static_cast<long double>(mu) * normal, 2.0L / 6);
            EXPECT_TRUE(near(world[other].velocity().x, normal, kAslant));
            EXPECT_TRUE(near(world[other].velocity().y, frictionImpulse, kAslant));
            EXPECT_TRUE(near(world[one].velocity().x, 3 - normal, kAslant));
            EXPECT_TRUE(near(world[one].velocity().y, 2 - frictionImpulse, kAslant));
            // omega = r J / I = J / (r m / 2)
            EXPECT_TRUE(near(world[one].angularVelocity(), -4 * frictionImpulse, 4 * kAslant));
            EXPECT_TRUE(near(world[other].angularVelocity(), -4 * frictionImpulse, 4 * kAslant));
        }
    }
}

// While sliding, the friction impulse is mu times the normal impulse for any restitution: vx' = vx
// - mu (1 + e) vy.
TEST(OffCentreHit, FrictionIsMuTimesTheNormalImpulseWhileItSlides) {
    for (const Real e : {Real(0.5), Real(1)}) {
        for (const Real mu : {Real(0), Real(0.05), Real(0.1)}) {
            SCOPED_TRACE(testing::Message() << "mu " << mu << ", e " << e);
            World world;
            support::addFloor(world, withFriction(mu, e));
            BodyDef def = support::ballDef({0, 1}, Real(0.5), withFriction(mu, e));
            def.velocity = {3, -4};
            const BodyId ball = world.add(def);
            support::run(world, 30);
            const long double normal = 4 * (1 + static_cast<long double>(e));
            EXPECT_TRUE(near(world[ball].velocity().x, 3 - static_cast<long double>(mu) * normal,
                             kTolerance));
            EXPECT_TRUE(near(world[ball].velocity().y, normal - 4, kTolerance));
        }
    }
}

// No impact adds energy, for any angle, restitution, friction and spin. Friction that stops all
// sliding at full restitution could, for a rod that hits the floor with its end. Impacts of both
// ends in one step add their roundings.
TEST(OffCentreHit, FrictionAndRestitutionTogetherGainNoEnergy) {
    constexpr std::uint64_t kSeed = 17;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const Material material = withFriction(random.between(0, 2), random.between(0.2, 1));
        World world;
        support::addFloor(world, material);
        BodyDef def = support::boxDef({0, Real(1.5)}, 2, random.between(0.1, 1), material);
        def.rotation = random.rotation();
        def.velocity = {random.between(-4, 4), -4};
        def.angularVelocity = random.between(-3, 3);
        world.add(def);
        const long double before = support::totalsOf(world).kinetic;
        bool hit = false;
        for (int step = 0; step < 30; ++step) {
            world.step(support::kDt);
            hit = hit || !world.collisions().empty();
            ASSERT_LE(support::totalsOf(world).kinetic,
                      before * (1 + static_cast<long double>(64 * support::kEpsilon)))
                << "rod " << i << ", step " << step;
        }
        EXPECT_TRUE(hit) << "rod " << i;
    }
}

} // namespace
} // namespace kodo
