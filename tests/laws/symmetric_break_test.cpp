// SPDX-License-Identifier: MIT
// C4: simultaneous contacts are hit simultaneously.
#include <support/scenes.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::nearShare;

/// Fifteen balls of radius 0.5 m in a triangle, and one that hits its tip at 10 m/s.
struct Break {
    World world;
    BodyId cue;
    std::vector<BodyId> balls;
    std::vector<std::size_t> mirror; // by ball: the one on the other side

    Break(const Material& material, Real gap) {
        BodyDef def = support::ballDef({-5, 0}, Real(0.5), material);
        def.velocity = {10, 0};
        cue = world.add(def);
        for (int row = 0; row < 5; ++row) {
            for (int i = 0; i <= row; ++i) {
                const Real side = (static_cast<Real>(i) - static_cast<Real>(row) / 2) * (1 + gap);
                const Real along = static_cast<Real>(row) * (1 + gap) * std::sqrt(Real(0.75));
                mirror.push_back(balls.size() + static_cast<std::size_t>(row) -
                                 2 * static_cast<std::size_t>(i));
                balls.push_back(world.add(support::ballDef({along, side}, Real(0.5), material)));
            }
        }
    }
};

// Both sides move alike to 0.02 of 10 m/s, whatever restitution and friction. No energy is gained,
// and none is lost at e = 1 without friction.
TEST(SymmetricBreak, StaysSymmetric) {
    for (const Real restitution : {Real(0.5), Real(0.95), Real(1)}) {
        for (const Real friction : {Real(0), Real(0.1), Real(0.6)}) {
            for (const Real gap : {Real(0), Real(0.0005), Real(0.001)}) {
                Break scene(withFriction(friction, restitution), gap);
                const support::Totals before = support::totalsOf(scene.world);
                support::run(scene.world, 120);
                const support::Totals after = support::totalsOf(scene.world);
                const auto what = testing::Message() << "e " << restitution << ", friction "
                                                     << friction << ", gap " << gap;
                for (std::size_t i = 0; i < scene.balls.size(); ++i) {
                    const Vec2 here = scene.world[scene.balls[i]].velocity();
                    const Vec2 there = scene.world[scene.balls[scene.mirror[i]]].velocity();
                    EXPECT_LT(length(here - Vec2{there.x, -there.y}), Real(0.02)) << what;
                }
                EXPECT_LT(std::abs(scene.world[scene.cue].velocity().y), Real(0.02)) << what;
                EXPECT_TRUE(support::near(after.momentum, before.momentum, 1e-4L)) << what;
                EXPECT_LT(after.kinetic, before.kinetic * (1 + 1e-5L)) << what;
                if (restitution == 1 && friction == 0) {
                    EXPECT_TRUE(nearShare(after.kinetic, before.kinetic, 1e-4L)) << what;
                }
            }
        }
    }
}

// Three equal balls: the solution of two simultaneous impacts at 30 degrees is known. With e = 1
// the first one goes on with -1/5 of its speed, the others get 2 sqrt(3) / 5 each.
TEST(SymmetricBreak, OneBallHitsTwo) {
    World world;
    BodyDef def = support::ballDef({-2, 0}, Real(0.5), support::slippery(1));
    def.velocity = {10, 0};
    const BodyId first = world.add(def);
    const Real along = std::sqrt(Real(0.75));
    const BodyId left =
        world.add(support::ballDef({along, Real(0.5)}, Real(0.5), support::slippery(1)));
    const BodyId right =
        world.add(support::ballDef({along, Real(-0.5)}, Real(0.5), support::slippery(1)));
    support::run(world, 60);
    EXPECT_TRUE(support::near(world[first].velocity().x, -2, 0.01L));
    const long double each = 4 * std::sqrt(3.0L);
    EXPECT_TRUE(nearShare(length(world[left].velocity()), each, 0.002L));
    EXPECT_TRUE(nearShare(length(world[right].velocity()), each, 0.002L));
}

} // namespace
} // namespace kodo
