// SPDX-License-Identifier: MIT
#include <support/phase_book.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::kEpsilon;
using support::near;
using support::nearShare;
using support::recordOf;
using support::run;
using support::Totals;
using support::totalsOf;

// R5: a welded shape is given in the frame of the body and takes its velocity. A second unit square
// makes a 2 x 1 box, and every point keeps its velocity.
TEST(WeldShape, AddsAPartAndKeepsTheVelocityOfEveryPoint) {
    World world;
    BodyDef def = boxDef({3, 4}, 1, 1);
    def.rotation = Rot{0, 1}; // its x axis points up
    def.velocity = {2, -1};
    def.angularVelocity = 3;
    const BodyId id = world.add(def);
    EXPECT_EQ(world.weld(id, Box{1, 1, {1, 0}}, Material{}, Real(1)), 1u);
    const BodyView body = world[id];
    EXPECT_EQ(body.mass(), 2);
    EXPECT_TRUE(near(body.inertia(), 2.0L * 5 / 12, 4 * kEpsilon));
    EXPECT_TRUE(near(body.center(), Vec2{3, Real(4.5)}, 8 * kEpsilon));
    EXPECT_TRUE(near(body.position(), Vec2{3, 4}, 8 * kEpsilon));
    EXPECT_TRUE(near(body.velocityAt({3, 4}), Vec2{2, -1}, 8 * kEpsilon));
    EXPECT_TRUE(near(body.velocityAt({4, 4}), Vec2{2, 2}, 16 * kEpsilon));
    EXPECT_EQ(body.angularVelocity(), 3);
    EXPECT_TRUE(body.contains({3, Real(5.4)}));
    EXPECT_EQ(body.partCount(), 2u);
}

TEST(WeldShape, HasItsOwnDensityAndMaterial) {
    World world;
    const BodyId id = world.add(boxDef({0, 0}, 1, 1));
    world.weld(id, Circle{1, {0, 2}}, withFriction(Real(0.1), Real(0.9)), Real(4));
    const long double disc = 4 * std::numbers::pi_v<long double>;
    EXPECT_TRUE(nearShare(world[id].mass(), 1 + disc, 4 * kEpsilon));
    EXPECT_TRUE(near(world[id].center().y, 2 * disc / (1 + disc), 8 * kEpsilon));
    // Parallel axis theorem: the inertia of each part plus that about the common centre.
    const long double inertia = 1 / 6.0L + disc / 2 + disc / (1 + disc) * 4;
    EXPECT_TRUE(nearShare(world[id].inertia(), inertia, 8 * kEpsilon));
    EXPECT_EQ(world[id].part(1).material.restitution, Real(0.9));
    EXPECT_EQ(world[id].part(0).material.restitution, 0);
}

TEST(WeldShape, RefusesInvalidArguments) {
    World world;
    const BodyId id = world.add(boxDef({0, 0}, 1, 1));
    const std::uint64_t before = world.stateHash();
    EXPECT_THROW(world.weld(id, Circle{-1}, Material{}, Real(1)), BadDefinition);
    EXPECT_THROW(world.weld(id, Circle{1}, Material{}, Real(0)), BadDefinition);
    EXPECT_THROW(world.weld(id, Circle{1}, Material{-1, -1, 0, 0}, Real(1)), BadDefinition);
    EXPECT_THROW(world.weld(id, Plane{}, Material{}, Real(1)), BadDefinition); // is dynamic
    EXPECT_THROW(world.weld(id, id), BadDefinition);
    EXPECT_THROW(world.unweld(id, 0), BadDefinition); // one part must stay
    EXPECT_THROW(world.unweld(id, 1), BadDefinition);
    EXPECT_EQ(world.stateHash(), before);
}

// R5: after half of a rotating 2 x 1 box is unwelded, the points of both halves keep their
// velocity.
TEST(Unweld, BothBodiesKeepTheVelocityOfTheirPoints) {
    World world;
    const Compound pair{{Box{1, 1, {Real(-0.5), 0}}, Box{1, 1, {Real(0.5), 0}}}};
    const BodyId whole =
        world.add({.shape = pair, .position = {10, 5}, .velocity = {1, 2}, .angularVelocity = 4});
    const BodyId freed = world.unweld(whole, 1, 0x20);
    for (const auto& [id, x] : {std::pair(whole, Real(9.5)), std::pair(freed, Real(10.5))}) {
        const BodyView body = world[id];
        EXPECT_EQ(body.partCount(), 1u);
        EXPECT_EQ(body.mass(), 1);
        EXPECT_TRUE(near(body.inertia(), 1 / 6.0L, 2 * kEpsilon));
        EXPECT_TRUE(near(body.center(), Vec2{x, 5}, 16 * kEpsilon));
        EXPECT_TRUE(near(body.velocity(), Vec2{1, 2 + 4 * (x - 10)}, 8 * kEpsilon));
        EXPECT_EQ(body.angularVelocity(), 4);
        EXPECT_TRUE(near(body.position(), Vec2{10, 5}, 16 * kEpsilon)); // the frame is inherited
    }
    EXPECT_EQ(world[freed].flags(), 0x20u);
    EXPECT_EQ(world[whole].flags(), 0u);
    EXPECT_EQ(world.bodyCount(), 2u);
}

TEST(Unweld, LaterPartsMoveUpByOne) {
    World world;
    const Compound row{{Circle{1, {0, 0}}, Circle{2, {5, 0}}, Circle{3, {12, 0}}}};
    const BodyId id = world.add({.shape = row});
    const BodyId freed = world.unweld(id, 1);
    EXPECT_EQ(world[id].partCount(), 2u);
    EXPECT_EQ(world[id].part(0).convex.radius, 1);
    EXPECT_EQ(world[id].part(1).convex.radius, 3);
    EXPECT_EQ(world[freed].part(0).convex.radius, 2);
    EXPECT_TRUE(near(world[freed].center(), Vec2{5, 0}, 8 * kEpsilon));
}

/// Corners of all parts of a body in world coordinates.
std::vector<Vec2> cornersOf(const World& world, BodyId id) {
    std::vector<Vec2> corners;
    for (std::size_t part = 0; part < world[id].partCount(); ++part) {
        for (const Vec2 vertex : world[id].part(part).convex.vertices) {
            corners.push_back(world[id].massFrame() * vertex);
        }
    }
    return corners;
}

Primitive randomPart(support::RandomNumbers& random) {
    const Vec2 center = random.point(2);
    const Real size = random.between(0.3, 1.5);
    switch (random.below(3)) {
    case 0:
        return Circle{size, center};
    case 1:
        return Box{size, 2 * size, center, random.rotation()};
    default:
        return Polygon{{center, center + Vec2{size, 0}, center + Vec2{0, size}}};
    }
}

BodyDef randomCompound(support::RandomNumbers& random, std::size_t parts) {
    Compound compound;
    for (std::size_t i = 0; i < parts; ++i) {
        compound.parts.push_back(randomPart(random));
    }
    BodyDef def;
    def.shape = compound;
    def.position = random.point(3);
    def.rotation = random.rotation();
    def.velocity = random.point(5);
    def.angularVelocity = random.between(-5, 5);
    def.density = random.between(0.5, 2);
    return def;
}

// R5: unwelding conserves mass, momentum, angular momentum and energy, and no corner moves.
TEST(Unweld, KeepsMassMomentaEnergyAndCorners) {
    constexpr std::uint64_t kSeed = 181;
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", body " << i);
        World world;
        const std::size_t parts = 2 + random.below(5);
        const BodyId id = world.add(randomCompound(random, parts));
        const Totals before = totalsOf(world);
        const Real mass = world[id].mass();
        const std::vector<Vec2> corners = cornersOf(world, id);
        const BodyId freed = world.unweld(id, parts - 1);
        std::vector<Vec2> after = cornersOf(world, id);
        const std::vector<Vec2> more = cornersOf(world, freed);
        after.insert(after.end(), more.begin(), more.end());
        const Totals sums = totalsOf(world);
        // Values of up to 1000, about thirty roundings.
        const long double exact = static_cast<long double>(byPrecision(1e-5, 1e-14));
        ASSERT_TRUE(nearShare(world[id].mass() + world[freed].mass(), mass, 8 * kEpsilon));
        ASSERT_TRUE(near(sums.momentum, before.momentum, 100 * exact));
        ASSERT_TRUE(near(sums.spin, before.spin, 1000 * exact));
        ASSERT_TRUE(nearShare(sums.kinetic, before.kinetic, 10 * exact));
        ASSERT_EQ(after.size(), corners.size());
        for (std::size_t k = 0; k < corners.size(); ++k) {
            ASSERT_TRUE(near(after[k], corners[k], 60 * kEpsilon));
        }
    }
}

// R5: 1000 cycles of unwelding and welding random parts restore mass, inertia, centre and corners
// within 1e-5. Each cycle rounds positions of up to 8 m, which the spin of up to 5 rad/s turns into
// velocities. So momenta are compared with those of a point at 5 + 5 * 3 = 20 m/s.
TEST(WeldCycles, AThousandRestoreTheBody) {
    for (std::uint64_t seed = 182; seed < 188; ++seed) {
        support::RandomNumbers random(seed);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        World world;
        const BodyId id = world.add(randomCompound(random, 6));
        const Totals before = totalsOf(world);
        const Real mass = world[id].mass();
        const Real inertia = world[id].inertia();
        const Vec2 center = world[id].center();
        const std::vector<Vec2> corners = cornersOf(world, id);
        for (int cycle = 0; cycle < 1000; ++cycle) {
            const BodyId freed = world.unweld(id, random.below(6));
            world.weld(id, freed);
            ASSERT_EQ(world.bodyCount(), 1u);
        }
        const Real share = byPrecision(1e-5, 1e-13);
        EXPECT_TRUE(nearShare(world[id].mass(), mass, share));
        EXPECT_TRUE(nearShare(world[id].inertia(), inertia, share));
        EXPECT_TRUE(near(world[id].center(), center, 8 * share));
        const Totals after = totalsOf(world);
        EXPECT_TRUE(near(after.momentum, before.momentum, 20 * share * mass));
        EXPECT_TRUE(near(after.spin, before.spin, 8 * 20 * share * mass));
        // The order of the parts has changed: compares each corner with the nearest one.
        for (const Vec2 corner : cornersOf(world, id)) {
            Real nearest = 100;
            for (const Vec2 original : corners) {
                nearest = std::min(nearest, length(corner - original));
            }
            EXPECT_LT(nearest, 8 * share);
        }
    }
}

// R5: a cluster that is unwelded and welded again in free flight conserves momentum, angular
// momentum and mass.
TEST(WeldCycles, InFlightKeepBothMomenta) {
    constexpr std::uint64_t kSeed = 183;
    support::RandomNumbers random(kSeed);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    World world;
    BodyDef def = randomCompound(random, 6);
    def.flags = kDisabled; // separated parts must not collide
    def.velocity = {};
    const BodyId id = world.add(def);
    const Totals before = totalsOf(world);
    const Real mass = world[id].mass();
    for (int cycle = 0; cycle < 1000; ++cycle) {
        const BodyId freed = world.unweld(id, random.below(6), kDisabled);
        run(world, 1, Real(1) / 1000);
        world.weld(id, freed);
    }
    const Totals after = totalsOf(world);
    const Real share = byPrecision(1e-5, 1e-13);
    EXPECT_TRUE(nearShare(world[id].mass(), mass, share));
    // Speeds of up to 10 m/s within the cluster, 2000 roundings.
    EXPECT_TRUE(near(after.momentum, before.momentum, 10 * share * mass));
    EXPECT_TRUE(nearShare(after.spin, before.spin, 20 * share));
    EXPECT_LE(after.kinetic, before.kinetic * (1 + 20 * static_cast<long double>(share)));
}

/// Three boxes in a row on the floor under a common top; each box has its own record.
struct Table {
    World world{{.gravity = support::kEarth}};
    BodyId floor;
    BodyId row;
    support::PhaseBook book;

    Table() {
        floor = support::addFloor(world);
        const Compound boxes{{Box{1, 1, {0, Real(0.5)}}, Box{1, 1, {2, Real(0.5)}},
                              Box{1, 1, {4, Real(0.5)}}, Box{5, Real(0.5), {2, Real(1.25)}}}};
        row = world.add({.shape = boxes, .flags = kNeverSleep});
        step(30);
    }
    void step(int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(kDt);
            book.read(world);
        }
    }
    const CollisionRecord* record(BodyId body, std::uint16_t part) const {
        for (const CollisionRecord& r : world.collisions()) {
            if (r.b == body && r.partB == part) {
                return &r;
            }
        }
        return nullptr;
    }
};

// R5: contacts persist through a weld and keep their impulses; none begins or ends.
TEST(WeldContacts, PersistThroughAWeld) {
    Table table;
    const Real impulse = table.record(table.row, 2)->totalImpulse;
    table.world.weld(table.row, Circle{Real(0.01), {2, 3}}, Material{}, Real(1e-3));
    table.step(1);
    EXPECT_EQ(table.world.collisions().size(), 3u);
    for (const std::uint16_t part : {std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2}}) {
        ASSERT_NE(table.record(table.row, part), nullptr);
        EXPECT_EQ(table.record(table.row, part)->phase, TouchPhase::Persist);
    }
    EXPECT_TRUE(nearShare(table.record(table.row, 2)->totalImpulse, impulse, 0.01));
}

// R5: unwelding ends only the contact of the removed part, which begins again for the new body.
// Contacts of later parts persist under their new indices.
TEST(WeldContacts, PersistThroughAnUnweld) {
    Table table;
    const BodyId freed = table.world.unweld(table.row, 1, kNeverSleep);
    table.world.step(kDt);
    ASSERT_NE(table.record(table.row, 0), nullptr);
    EXPECT_EQ(table.record(table.row, 0)->phase, TouchPhase::Persist);
    bool ended = false;
    bool persists = false;
    for (const CollisionRecord& r : table.world.collisions()) {
        if (r.b == table.row && r.partB == 1) {
            ended = ended || r.phase == TouchPhase::End;
            persists = persists || r.phase == TouchPhase::Persist;
        }
    }
    EXPECT_TRUE(ended);
    EXPECT_TRUE(persists);
    ASSERT_NE(recordOf(table.world, table.floor, freed), nullptr);
    EXPECT_EQ(recordOf(table.world, table.floor, freed)->phase, TouchPhase::Begin);
    run(table.world, 60);
    EXPECT_TRUE(near(table.world[table.row].position(), Vec2{0, 0}, Real(0.01)));
    EXPECT_TRUE(near(table.world[freed].position(), Vec2{0, 0}, Real(0.01)));
}

} // namespace
} // namespace kodo
