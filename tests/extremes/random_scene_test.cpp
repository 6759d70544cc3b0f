// SPDX-License-Identifier: MIT
#include <support/depth.hpp>
#include <support/draws.hpp>
#include <support/random_shapes.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <cstdlib>

namespace kodo {
namespace {

using support::byPrecision;

/// Nine separate bodies of random shape and material in free space that fly towards each other.
World randomScene(std::uint64_t seed) {
    support::RandomNumbers random(seed);
    World world;
    for (int i = 0; i < 9; ++i) {
        BodyDef def;
        def.position = Real(5.5) * Vec2{static_cast<Real>(i % 3) - 1, static_cast<Real>(i / 3) - 1};
        def.rotation = random.rotation();
        def.velocity = Real(-0.7) * def.position + random.point(3);
        def.angularVelocity = random.between(-4, 4);
        def.density = random.between(0.3, 3);
        const Real friction = random.between(0, 1);
        def.material = withFriction(friction, random.between(0, 1));
        const support::Kind kind = support::kAllKinds[random.below(3)];
        def.shape = std::visit([](const auto& own) { return Shape(own); },
                               support::randomPrimitive(random, kind));
        world.add(def);
    }
    return world;
}

/// kg m^2/s, sum of m |r| |v| over all bodies: the scale of angular momentum.
long double spinsOf(const World& world) {
    long double sum = 0;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        sum +=
            static_cast<long double>(body.mass() * length(body.center()) * length(body.velocity()));
    }
    return sum;
}

/// Deviations of conserved quantities and overlap, as shares of their limits.
struct Excess {
    long double momentum = 0;
    long double spin = 0;
    long double depth = 0;

    long double worst() const { return std::max({momentum, spin, depth}); }
};

void expectWhatPhysicsKeeps(std::uint64_t seed, Excess& excess) {
    World world = randomScene(seed);
    World again = randomScene(seed);
    World loaded;
    const support::Totals before = support::totalsOf(world);
    std::size_t hits = 0;
    for (int step = 0; step < 200; ++step) {
        if (step == 70) {
            loaded = fromBytes(toBytes(world));
        }
        world.step(support::kDt);
        again.step(support::kDt);
        hits += world.collisions().size();
        const support::Totals now = support::totalsOf(world);
        const long double displacement = length(now.momentum - before.momentum);
        excess.momentum = std::max(
            excess.momentum, displacement / static_cast<long double>(byPrecision(5e-4, 1e-11)));
        excess.depth =
            std::max(excess.depth, static_cast<long double>(support::maxOverlap(world)) / 0.3L);
        ASSERT_LT(now.kinetic, before.kinetic * (1 + 1e-5L)) << "step " << step;
        ASSERT_EQ(again.stateHash(), world.stateHash()) << "step " << step;
        if (step >= 70) {
            loaded.step(support::kDt);
            ASSERT_EQ(loaded.stateHash(), world.stateHash()) << "step " << step;
        }
    }
    const long double turned = std::abs(support::totalsOf(world).spin - before.spin);
    excess.spin = turned / (1e-3L * spinsOf(randomScene(seed)));
    ASSERT_TRUE(std::isfinite(excess.spin));
    ASSERT_LT(excess.worst(), 2.5L);
    EXPECT_GT(hits, 0u);
}

// Invariants of random scenes. No number becomes NaN. Momentum is conserved to the rounding of some
// hundred impacts of 10 N s. Angular momentum is conserved within 1e-3, since lever arms are
// constant within a step and overlaps are pushed apart. Energy never grows. Overlap stays below the
// motion of a step, 0.3 m at 18 m/s. A repetition and a restored snapshot give the same bits.
//
// One scene in 500 may exceed this by a factor of up to 2.5, but never gain energy. In such a scene
// two large bodies crush a small one, whose ends become faster than any initial speed. The
// environment variable RANDOM_SCENES sets the number of scenes.
TEST(RandomScene, ObeysConservationLaws) {
    const char* const wanted = std::getenv("RANDOM_SCENES");
    const std::uint64_t everyday = static_cast<std::uint64_t>(support::draws(200));
    const std::uint64_t scenes = wanted == nullptr ? everyday : std::stoull(wanted);
    std::uint64_t beyond = 0;
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Excess excess;
        expectWhatPhysicsKeeps(seed, excess);
        beyond += excess.worst() > 1 ? 1 : 0;
    }
    EXPECT_LE(beyond, scenes / 500);
}

} // namespace
} // namespace kodo
