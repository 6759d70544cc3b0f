// SPDX-License-Identifier: MIT
#include <support/depth.hpp>
#include <support/random_shapes.hpp>
#include <support/scenes.hpp>

#include <cstdlib>
#include <string>

namespace kodo {
namespace {

using support::byPrecision;

/// Nine bodies of any kind and material in free space, apart, that fly at each other.
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

/// The sum (kg m^2/s) of what each body's flight has of angular momentum, whatever its sign.
long double spinsOf(const World& world) {
    long double sum = 0;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        sum +=
            static_cast<long double>(body.mass() * length(body.center()) * length(body.velocity()));
    }
    return sum;
}

void expectWhatPhysicsKeeps(std::uint64_t seed) {
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
        ASSERT_TRUE(support::near(now.momentum, before.momentum, byPrecision(5e-4, 1e-11)));
        ASSERT_LT(now.kinetic, before.kinetic * (1 + 1e-5L)) << "step " << step;
        ASSERT_LT(support::deepest(world), Real(0.3)) << "step " << step;
        ASSERT_EQ(again.stateHash(), world.stateHash()) << "step " << step;
        if (step >= 70) {
            loaded.step(support::kDt);
            ASSERT_EQ(loaded.stateHash(), world.stateHash()) << "step " << step;
        }
    }
    const support::Totals after = support::totalsOf(world);
    EXPECT_TRUE(support::near(after.spin, before.spin, 1e-3L * spinsOf(randomScene(seed))));
    EXPECT_GT(hits, 0u);
}

// Whatever flies at whatever: nobody gets lost in a NaN; momentum stays to the rounding of some
// hundred blows of 10 N s, angular momentum to a thousandth, since arms are fixed for a step; no
// energy is made; no two are pressed into each other deeper than they come in a step, 0.3 m at 18
// m/s; the same again gives the same bits, and so does what was saved on the way. RANDOM_SCENES in
// the environment asks for so many scenes.
TEST(RandomScene, KeepsWhatPhysicsKeeps) {
    const char* const wanted = std::getenv("RANDOM_SCENES");
    const std::uint64_t scenes = wanted == nullptr ? 200 : std::stoull(wanted);
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        expectWhatPhysicsKeeps(seed);
    }
}

} // namespace
} // namespace kodo
