// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

// Collisions without external forces conserve momentum to rounding: 100 balls and boxes in free
// space, 300 steps. Each of some thousand impacts rounds momenta of up to 10 kg m/s.
TEST(Momentum, IsConservedToRounding) {
    constexpr std::uint64_t kSeed = 151;
    support::RandomNumbers random(kSeed);
    World world;
    for (int i = 0; i < 100; ++i) {
        const Vec2 place{static_cast<Real>(i % 10) * 2, static_cast<Real>(i / 10) * 2};
        BodyDef def =
            i % 2 == 0 ? support::ballDef(place, Real(0.6)) : support::boxDef(place, 1, 1);
        def.rotation = random.rotation();
        def.velocity = Real(0.5) * (Vec2{9, 9} - place) + random.point(1);
        def.material.restitution = random.between(0, 1);
        world.add(def);
    }
    const support::Totals before = support::totalsOf(world);
    std::size_t hits = 0;
    for (int step = 0; step < 300; ++step) {
        world.step(support::kDt);
        hits += world.collisions().size();
    }
    const support::Totals after = support::totalsOf(world);
    EXPECT_GT(hits, 1000u) << "seed " << kSeed;
    EXPECT_TRUE(support::near(after.momentum, before.momentum, support::byPrecision(1e-3, 1e-11)));
    EXPECT_LE(after.kinetic, before.kinetic);
}

} // namespace
} // namespace kodo
