// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::addStack;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::near;
using support::run;

WorldDef wakeful() {
    WorldDef def{.gravity = support::kEarth};
    def.settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
    return def;
}

// W4: ten boxes stand for 60 s, without the help of resting. A corner may sink by the slop.
TEST(Stack, OfTenBoxesStandsForAMinute) {
    World world(wakeful());
    addFloor(world);
    const std::vector<BodyId> boxes = addStack(world, 10);
    run(world, 3600);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const BodyView box = world[boxes[i]];
        const Real height = static_cast<Real>(i) + Real(0.5);
        const Real sink = static_cast<Real>(i + 1) * world.tolerances().slop;
        EXPECT_TRUE(near(box.position().x, 0, Real(1e-3))) << i;
        EXPECT_LE(box.position().y, height + Real(1e-3)) << i;
        EXPECT_GE(box.position().y, height - sink) << i;
        EXPECT_LT(length(box.velocity()), Real(1e-3)) << i;
        EXPECT_TRUE(near(box.rotation().s, 0, Real(1e-3))) << i;
    }
}

// The same with resting on: it ends where it stands.
TEST(Stack, ComesToRest) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const std::vector<BodyId> boxes = addStack(world, 10);
    run(world, 600);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_NE(world[boxes[i]].flags() & kResting, 0u) << i;
        EXPECT_TRUE(near(world[boxes[i]].position().y, static_cast<Real>(i) + Real(0.5),
                         static_cast<Real>(i + 1) * world.tolerances().slop));
    }
}

// A pyramid of 10 rows, symmetric, stays so to the eye: no box wanders by more than 1 cm.
TEST(Stack, APyramidStands) {
    World world(wakeful());
    addFloor(world);
    std::vector<std::pair<BodyId, Vec2>> boxes;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            const Vec2 place{Real(1.1) * (static_cast<Real>(i) + static_cast<Real>(row) / 2),
                             static_cast<Real>(row) + Real(0.5)};
            boxes.emplace_back(world.add(boxDef(place, 1, 1)), place);
        }
    }
    run(world, 900);
    for (const auto& [id, place] : boxes) {
        EXPECT_TRUE(near(world[id].position().x, place.x, Real(0.01)));
        EXPECT_TRUE(near(world[id].position().y, place.y, 10 * world.tolerances().slop));
    }
}

// A box with 5 m/s and friction 0.5 stops after v^2 / (2 mu g) = 2.5 m.
TEST(Sliding, ABoxStopsWhereFrictionSays) {
    World world(wakeful());
    addFloor(world, withFriction(Real(0.5)));
    BodyDef def = boxDef({0, Real(0.5)}, 1, 1, withFriction(Real(0.5)));
    def.velocity = {5, 0};
    const BodyId box = world.add(def);
    run(world, 180);
    EXPECT_TRUE(near(world[box].position().x, 2.5L, 0.025L)); // 1 %
    EXPECT_TRUE(near(world[box].velocity().x, 0, byPrecision(1e-5, 1e-9)));
}

// Collisions without outer forces keep momentum and angular momentum to rounding: 100 balls and
// boxes in free space, 300 steps. Each of some thousand hits rounds momenta of up to 10.
TEST(Momentum, IsKeptToRounding) {
    constexpr std::uint64_t kSeed = 151;
    support::RandomNumbers random(kSeed);
    World world;
    for (int i = 0; i < 100; ++i) {
        const Vec2 place{static_cast<Real>(i % 10) * 2, static_cast<Real>(i / 10) * 2};
        BodyDef def = i % 2 == 0 ? support::ballDef(place, Real(0.6)) : boxDef(place, 1, 1);
        def.rotation = random.rotation();
        def.velocity = Real(0.5) * (Vec2{9, 9} - place) + random.point(1);
        def.material.restitution = random.between(0, 1);
        world.add(def);
    }
    const support::Totals before = support::totalsOf(world);
    std::size_t hits = 0;
    for (int step = 0; step < 300; ++step) {
        world.step(kDt);
        hits += world.collisions().size();
    }
    const support::Totals after = support::totalsOf(world);
    EXPECT_GT(hits, 1000u) << "seed " << kSeed;
    EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(1e-3, 1e-11)));
    EXPECT_LE(after.kinetic, before.kinetic);
}

} // namespace
} // namespace kodo
