// SPDX-License-Identifier: MIT
// Filter, sensor, user data, material, density and shape of one part of a body.
#include <kodo/kodo.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace kodo {
namespace {

constexpr Real kStep = Real(1) / 60;
constexpr Flags kRed = category(30);

/// A floor of two tiles, the left one part 0 and the right one part 1, with a ball above each. The
/// right ball is red.
struct Tiles {
    explicit Tiles(const StepSettings& settings = {})
        : world({.gravity = {0, -10}, .settings = settings}),
          floor(world.add({.shape = Compound{{Box{2, 1, {-2, 0}}, Box{2, 1, {2, 0}}}},
                           .type = BodyType::Static})),
          left(world.add({.shape = Circle{Real(0.5)}, .position = {-2, 2}})),
          right(world.add({.shape = Circle{Real(0.5)}, .position = {2, 2}, .flags = kRed})) {}

    void set(std::size_t part, const CollisionFilter& filter) {
        Part own = world[floor].part(part);
        own.filter = filter;
        world[floor].setPart(part, own);
    }
    void run(int steps = 90) {
        for (int i = 0; i < steps; ++i) {
            world.step(kStep);
        }
    }
    bool lies(BodyId ball) const { return world[ball].position().y > Real(0.9); }

    World world;
    BodyId floor;
    BodyId left;
    BodyId right;
};

std::vector<StepSettings> bothSolvers() {
    return {StepSettings{}, thesis2006()};
}

TEST(PartFilter, HoldsForItsPartAlone) {
    for (const StepSettings& settings : bothSolvers()) {
        for (std::size_t part = 0; part < 2; ++part) {
            Tiles tiles(settings);
            tiles.set(part, {.flags = kMatchEqual, .required = category(5)});
            tiles.run();
            EXPECT_EQ(tiles.lies(tiles.left), part == 1);
            EXPECT_EQ(tiles.lies(tiles.right), part == 0);
        }
    }
}

TEST(PartFilter, ReplacesThatOfTheBody) {
    Tiles tiles;
    tiles.world[tiles.floor].setFlags(kMatchAny); // of no category: neither ball
    tiles.set(1, {.flags = kMatchAny, .required = kRed});
    EXPECT_EQ(tiles.world[tiles.floor].filter(0).flags, kMatchAny);
    EXPECT_EQ(tiles.world[tiles.floor].filter(1).required, kRed);
    tiles.run(40); // it has landed, and does not sleep yet
    EXPECT_EQ(tiles.world.collisions(tiles.right).at(0).partA, 1u);
    tiles.run();
    EXPECT_FALSE(tiles.lies(tiles.left));
    EXPECT_TRUE(tiles.lies(tiles.right));
    tiles.world[tiles.floor].setFlags(kDisabled); // flags of the engine count for all parts
    tiles.run();
    EXPECT_FALSE(tiles.lies(tiles.right));
}

// A sensor part reports its touches and lets everything through; the other part blocks.
TEST(PartFilter, MakesOnePartASensor) {
    for (const StepSettings& settings : bothSolvers()) {
        Tiles tiles(settings);
        tiles.set(0, {.flags = kSensor});
        int begins = 0;
        int ends = 0;
        Real impulses = 0;
        for (int i = 0; i < 90; ++i) {
            tiles.world.step(kStep);
            for (const CollisionRecord& record : tiles.world.collisions(tiles.left)) {
                EXPECT_EQ(record.partA, 0u);
                begins += record.phase == TouchPhase::Begin ? 1 : 0;
                ends += record.phase == TouchPhase::End ? 1 : 0;
                impulses += record.totalImpulse;
            }
        }
        EXPECT_EQ(begins, 1);
        EXPECT_EQ(ends, 1);
        EXPECT_EQ(impulses, 0);
        // Free fall in substeps: y = 2 - g t^2 / 2, and at most g t dt / 2 less.
        EXPECT_NEAR(tiles.world[tiles.left].position().y, 2 - 5 * Real(2.25), Real(0.13));
        EXPECT_TRUE(tiles.lies(tiles.right));
    }
}

// A moving body with a feeler: it feels the wall before its hull stops there.
TEST(PartFilter, FeelerOfAMovingBodyTakesNoImpulse) {
    for (const StepSettings& settings : bothSolvers()) {
        World world({.settings = settings});
        const BodyId car = world.add({.shape = Compound{{Box{1, 1}, Box{2, Real(0.2), {1, 0}}}},
                                      .velocity = {2, 0},
                                      .mass = MassDef{1, Vec2{0, 0}, Real(0.5)}});
        const BodyId wall =
            world.add({.shape = Box{1, 4}, .position = {5, 0}, .type = BodyType::Static});
        Part feeler = world[car].part(1);
        feeler.filter = CollisionFilter{kSensor};
        world[car].setPart(1, feeler);
        Real felt = -1;
        Real stopped = -1;
        for (int i = 1; i <= 180; ++i) {
            world.step(kStep);
            for (const CollisionRecord& record : world.collisions(wall)) {
                if (record.phase == TouchPhase::Begin) {
                    (record.partA == 1 ? felt : stopped) = static_cast<Real>(i) * kStep;
                }
            }
        }
        // The feeler reaches to 2 m and the hull to 0.5 m, at 2 m/s, of the 4.5 m to the wall.
        EXPECT_NEAR(felt, Real(1.25), 2 * kStep);
        EXPECT_NEAR(stopped, Real(2), 2 * kStep);
        EXPECT_NEAR(world[car].position().x, 4, Real(0.02));
    }
}

TEST(PartFilter, CountsInQueries) {
    Tiles tiles;
    tiles.set(0, {.flags = kRed});
    const CollisionFilter red{kMatchAny, kRed};
    const auto hit = rayCast(tiles.world, {-5, 0}, {5, 0}, red);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->part, 0u);
    EXPECT_EQ(rayCastAll(tiles.world, {-5, 0}, {5, 0}, red).size(), 1u);
    EXPECT_EQ(rayCastAll(tiles.world, {-5, 0}, {5, 0}).size(), 2u);
    const std::vector<BodyId> near = overlap(tiles.world, Aabb{{1, -1}, {3, 0}}, red);
    EXPECT_TRUE(near.empty()); // part 1 is not red
}

TEST(SetPart, ChangesMassByDensityAndShape) {
    World world;
    const BodyId body = world.add({.shape = Compound{{Box{2, 1, {-1, 0}}, Box{2, 1, {1, 0}}}},
                                   .velocity = {3, 1},
                                   .angularVelocity = 2});
    const Vec2 point{2, 1};
    const Vec2 before = world[body].velocityAt(point);
    Part part = world[body].part(1);
    part.density = 3;
    part.userData = 8;
    world[body].setPart(1, part);
    EXPECT_NEAR(world[body].mass(), 8, 1e-5);             // 2 + 6 kg
    EXPECT_NEAR(world[body].center().x, Real(0.5), 1e-5); // (-2 + 6) / 8
    EXPECT_LT(length(world[body].velocityAt(point) - before), Real(1e-5));
    part.primitive = Circle{1, {1, 0}};
    world[body].setPart(1, part);
    EXPECT_NEAR(world[body].mass(), 2 + 3 * 3.14159265, 1e-4);
    EXPECT_LT(length(world[body].velocityAt(point) - before), Real(1e-5));
    EXPECT_TRUE(world[body].contains({1, Real(0.9)}));
    EXPECT_EQ(world[body].part(1).userData, 8u);
}

TEST(SetPart, GivesGroundAnotherShapeUnderWhatLiesOnIt) {
    Tiles tiles;
    tiles.run();
    Part part = tiles.world[tiles.floor].part(0);
    part.primitive = Box{2, Real(0.5), {-2, Real(-0.25)}}; // half as high
    tiles.world[tiles.floor].setPart(0, part);
    tiles.run();
    EXPECT_NEAR(tiles.world[tiles.left].position().y, Real(0.5), Real(0.01));
    EXPECT_NEAR(tiles.world[tiles.right].position().y, Real(1), Real(0.01));
}

TEST(SetPart, RefusesWhatAddWould) {
    Tiles tiles;
    const auto refused = [&](BodyId body, auto change) {
        Part part = tiles.world[body].part(0);
        change(part);
        const std::uint64_t hash = tiles.world.stateHash();
        EXPECT_THROW(tiles.world[body].setPart(0, part), BadDefinition);
        EXPECT_EQ(tiles.world.stateHash(), hash);
    };
    refused(tiles.left, [](Part& p) { p.density = 0; });
    refused(tiles.left, [](Part& p) { p.material.restitution = 9; });
    refused(tiles.left, [](Part& p) { p.primitive = Circle{-1}; });
    refused(tiles.left, [](Part& p) { p.primitive = Plane{}; });
    refused(tiles.left, [](Part& p) { p.primitive = Circle{Real(1e30)}; });
    refused(tiles.left, [](Part& p) { p.filter = CollisionFilter{kNeverSleep}; });
    refused(tiles.left, [](Part& p) { p.filter = CollisionFilter{kMatchAny | kMatchAll, 1}; });
    refused(tiles.left, [](Part& p) { p.filter = CollisionFilter{kMatchAny}; });
    refused(tiles.left, [](Part& p) { p.filter = CollisionFilter{0, 1}; });
    tiles.world[tiles.left].setMass(2);
    refused(tiles.left, [](Part& p) { p.primitive = Circle{1}; });
    EXPECT_THROW(tiles.world[tiles.left].setPart(1, Part{}), std::out_of_range);
    EXPECT_THROW(static_cast<void>(tiles.world[tiles.left].filter(1)), std::out_of_range);
}

TEST(SetPart, IsState) {
    Tiles tiles;
    const std::uint64_t plain = tiles.world.stateHash();
    tiles.set(1, {.flags = kSensor | kRed, .group = -2});
    EXPECT_NE(tiles.world.stateHash(), plain);
    World restored = fromBytes(toBytes(tiles.world));
    EXPECT_EQ(restored.stateHash(), tiles.world.stateHash());
    World copy = restored;
    EXPECT_EQ(copy[copy.clone(tiles.floor, {0, 20})].filter(1).group, -2);
    Tiles again = tiles;
    again.world = restored;
    tiles.run();
    again.run();
    EXPECT_EQ(again.world.stateHash(), tiles.world.stateHash());
    EXPECT_FALSE(again.lies(again.right));
}

TEST(SetPart, StaysWithThePartInWeldAndUnweld) {
    Tiles tiles;
    tiles.set(1, {.flags = kSensor});
    const BodyId plate =
        tiles.world.add({.shape = Box{4, 1}, .position = {0, -5}, .type = BodyType::Static});
    const std::size_t first = tiles.world.weld(plate, tiles.floor);
    EXPECT_EQ(tiles.world[plate].filter(first + 1).flags, kSensor);
    const BodyId freed = tiles.world.unweld(plate, first + 1);
    EXPECT_EQ(tiles.world[freed].filter(0).flags, kSensor);
    EXPECT_EQ(tiles.world[plate].filter(first).flags, Flags{0});
}

} // namespace
} // namespace kodo
