// SPDX-License-Identifier: MIT
// Calls that concern many bodies visit those that they change.
#include <kodo/query.hpp>
#include <kodo/snapshot.hpp>
#include <support/draws.hpp>
#include <support/outside.hpp>
#include <support/random_numbers.hpp>
#include <support/sleeping.hpp>

namespace kodo {
namespace {

constexpr int kBodies = 1000;
constexpr Flags kRare = 4; // a user flag

/// Bodies, parts and parked contacts visited by a call and the step after it.
template <typename Call>
std::uint64_t visitsOf(World& world, Call call) {
    const std::uint64_t before = stepStats(world).changeVisits;
    call();
    world.step(support::kDt);
    return stepStats(world).changeVisits - before;
}

/// A row of boxes that sleep on the floor, half a metre apart.
struct SleepingRow {
    World world{WorldDef{.gravity = support::kEarth}};
    std::vector<BodyId> boxes;

    SleepingRow() {
        support::addFloor(world);
        for (int i = 0; i < kBodies; ++i) {
            BodyDef def = support::boxDef({static_cast<Real>(i - kBodies / 2) / 2, Real(0.125)},
                                          Real(0.25), Real(0.25));
            def.flags = 2;
            boxes.push_back(world.add(def));
        }
        support::run(world, 120);
        EXPECT_EQ(support::countAsleep(world), std::size_t{kBodies});
    }
    template <typename Call>
    std::uint64_t visits(Call call) {
        return visitsOf(world, call);
    }
};

Aabb regionAt(Real x, Real reach) {
    return {{x - reach, -10}, {x + reach, 100}};
}

// Regression: it visited all bodies and contacts, and the next step searched all pairs.
TEST(ChangeVisits, AMoveOfTheRegionVisitsWhatCrossesItsEdges) {
    SleepingRow row;
    row.world.setRegion(regionAt(0, 100));
    row.world.step(support::kDt);
    for (int move = 1; move <= 20; ++move) {
        const std::uint64_t pairWork = stepStats(row.world).pairWork;
        const auto x = static_cast<Real>(move);
        // Two boxes enter, two leave, as many are near, and the floor is on all edges.
        EXPECT_LE(row.visits([&] { row.world.setRegion(regionAt(x, 100)); }), 16u);
        EXPECT_LE(stepStats(row.world).pairWork - pairWork, 20u);
        EXPECT_EQ(stepStats(row.world).bodies, 0u);
    }
    for (const BodyId id : row.boxes) {
        const Aabb box = row.world[id].bounds();
        EXPECT_EQ(support::isOutside(row.world, id), box.upper.x < -80 || box.lower.x > 120);
    }
}

// Regression: it took the impulses of all contacts.
TEST(ChangeVisits, AMoveOfTheRegionLeavesWhatStaysInsideAsItIs) {
    World still(support::withoutSleep());
    support::addHeap(still, 17, 40);
    World moving = still;
    for (int step = 0; step < 200; ++step) {
        moving.setRegion(regionAt(static_cast<Real>(step % 20), 50));
        still.step(support::kDt);
        moving.step(support::kDt);
        for (const BodyId id : still.bodies()) {
            ASSERT_EQ(support::stateOf(still, id), support::stateOf(moving, id)) << step;
        }
    }
}

// With awake, sleeping, kinematic and static bodies, planes, and bodies that come and go.
TEST(ChangeVisits, OutsideIsWhatDoesNotMeetTheRegionAfterEachMove) {
    support::RandomNumbers random(31);
    World world({.gravity = support::kEarth});
    support::addHeap(world, 31, 60);
    world.add({.shape = Plane{}, .position = {0, -3}, .type = BodyType::Static});
    BodyDef def = support::boxDef({0, 12}, 1, 1);
    def.type = BodyType::Kinematic;
    def.velocity = {Real(0.5), 0};
    world.add(def);
    for (int move = 0; move < 300; ++move) {
        const Vec2 corner{random.between(-8, 6), random.between(-4, 9)};
        const Vec2 size{random.between(1, 6), random.between(1, 6)};
        world.setRegion(Aabb{corner, corner + size});
        for (const BodyId id : world.bodies()) {
            ASSERT_EQ(support::isOutside(world, id), !overlap(*world.region(), world[id].bounds()))
                << "move " << move << ", body " << id.index;
        }
        support::run(world, move % 4);
        if (move % 7 == 0) {
            world.remove(world.bodies()[1 + static_cast<std::size_t>(move) % 30]);
            world.add(support::ballDef({random.between(-5, 5), random.between(3, 9)}, Real(0.4)));
        }
    }
}

// Regression: moves searched the bounds of parts alone, so the body stayed outside. A copy, which
// visits all bodies, went on with other bits.
TEST(ChangeVisits, ARegionInTheGapOfACompoundHasItsBodyInside) {
    World world;
    BodyDef def;
    def.shape = Compound{{Circle{1, {-5, 0}}, Circle{1, {5, 0}}}};
    const BodyId body = world.add(def);
    def.shape = Circle{1};
    def.position = {0, 40};
    world.add(def);
    const auto isOutsideOf = [&](Vec2 center) {
        world.setRegion(Aabb{center - Vec2{1, 1}, center + Vec2{1, 1}});
        return support::isOutside(world, body);
    };
    EXPECT_TRUE(isOutsideOf({20, 0}));
    (void)rayCast(world, {0, 50}, {0, 45}); // builds the tree of queries
    EXPECT_FALSE(isOutsideOf({0, 0}));
    EXPECT_TRUE(isOutsideOf({20, 0}));
    world[body].setPosition({20, 7});
    EXPECT_TRUE(isOutsideOf({0, 0}));
    EXPECT_FALSE(isOutsideOf({20, 7}));
    World copy = world;
    world.remove(body);
    EXPECT_EQ(copy.bodyCount(), 2u);
    world.setRegion(Aabb{{-1, -1}, {1, 1}});
    EXPECT_EQ(world.bodyCount(), 1u);
}

/// Stacks of four boxes outside the region, each on its own plate, and a box inside.
struct ParkedStacks {
    World world{WorldDef{.gravity = support::kEarth}};
    std::vector<BodyId> boxes;
    BodyId inside = world.add(support::boxDef({-20, 5}, 1, 1));
    static constexpr std::uint64_t kOfStack = 4; // contacts

    ParkedStacks() {
        for (int column = 0; column < kBodies / 4; ++column) {
            const auto x = static_cast<Real>(2 * column);
            world.add({.shape = Box{Real(1.5), 1},
                       .position = {x, Real(-0.5)},
                       .type = BodyType::Static});
            for (int row = 0; row < 4; ++row) {
                boxes.push_back(
                    world.add(support::boxDef({x, static_cast<Real>(row) + Real(0.5)}, 1, 1)));
            }
        }
        support::run(world, 3);
        world.setRegion(regionAt(-50, 45));
        support::run(world, 3);
        EXPECT_EQ(stepStats(world).bodies, 1u);
    }
    template <typename Call>
    std::uint64_t visits(Call call) {
        return visitsOf(world, call);
    }
};

// Regression: each of these calls visited all parked contacts.
TEST(ChangeVisits, ACallOnABodyOutsideVisitsItsOwnParkedContacts) {
    ParkedStacks stacks;
    World& world = stacks.world;
    const auto box = [&](std::size_t i) { return world[stacks.boxes[i]]; };
    constexpr std::uint64_t kOwn = 2;
    EXPECT_LE(stacks.visits([&] { box(4 * 50 + 1).setMaterial(withFriction(0)); }), kOwn);
    EXPECT_LE(stacks.visits([&] { box(4 * 60 + 1).setPosition({70, 30}); }), kOwn);
    EXPECT_LE(stacks.visits([&] { box(4 * 70 + 1).setVelocity({1, 0}); }), kOwn);
    EXPECT_LE(stacks.visits([&] { world.remove(stacks.boxes[4 * 80 + 1]); }), kOwn);
    EXPECT_LE(stacks.visits([&] { world[stacks.inside].setMaterial(withFriction(0)); }), 0u);
}

// Regression: they visited all parked contacts.
TEST(ChangeVisits, ABodyThatLeavesOrEntersTheRegionVisitsItsOwnParkedContacts) {
    ParkedStacks stacks;
    World& world = stacks.world;
    (void)rayCast(world, {0, 50}, {0, 40}); // builds the tree of queries
    world.setRegion(regionAt(-50, Real(45.5)));
    BodyRef inside = world[stacks.inside];
    const auto leave = [&] {
        inside.setPosition({-6, 5});
        inside.setVelocity({200, 0});
        world.step(support::kDt);
    };
    EXPECT_LE(stacks.visits(leave), 0u);
    EXPECT_TRUE(support::isOutside(world, stacks.inside));
    EXPECT_LE(stacks.visits([&] { inside.setPosition({-20, 5}); }), 0u);
    EXPECT_FALSE(support::isOutside(world, stacks.inside));
    // The plate and its boxes enter, then leave: each is visited, and both ends of each contact, by
    // the call and by the step.
    const std::uint64_t most = 6 * ParkedStacks::kOfStack;
    EXPECT_LE(stacks.visits([&] { world.setRegion(regionAt(-50, 50)); }), most);
    EXPECT_FALSE(support::isOutside(world, stacks.boxes[3]));
    EXPECT_LE(stacks.visits([&] { world.setRegion(regionAt(-50, 45)); }), most);
    EXPECT_TRUE(support::isOutside(world, stacks.boxes[3]));
}

// Regression: the parts of all later bodies got new indices.
TEST(ChangeVisits, AWeldVisitsTheBodyThatIsWelded) {
    SleepingRow row;
    const auto part = [](int i) { return Circle{Real(0.05), {0, static_cast<Real>(i) / 8}}; };
    for (int i = 1; i <= 20; ++i) {
        EXPECT_LE(row.visits([&] { row.world.weld(row.boxes[5], part(i), {}, 100); }), 40u);
    }
    EXPECT_LE(row.visits([&] { row.world.weld(row.boxes[7], row.boxes[8]); }), 2u);
    EXPECT_LE(row.visits([&] { row.world.weld(row.boxes[7], row.boxes[5]); }), 24u);
    EXPECT_EQ(row.visits([&] { row.world.unweld(row.boxes[7], 1); }), 0u);
    EXPECT_LE(row.visits([&] { row.world.add({.shape = Compound{{part(1), part(2)}}}); }), 2u);
    support::run(row.world, 300);
    EXPECT_LE(row.visits([] {}), 0u);
}

/// Welds, unwelds and adds. The copy, from bytes, has all parts in the order of their bodies.
void changeParts(World& world, std::uint64_t seed) {
    support::RandomNumbers random(seed);
    const std::vector<BodyId> bodies = world.bodies();
    const auto any = [&] {
        return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
    };
    const BodyId into = any();
    const BodyId other = any();
    const auto where = static_cast<Real>(random.between(-0.3, 0.3));
    if (seed % 5 == 0) {
        world.weld(into, Circle{Real(0.1), {where, 0}}, {}, 1000);
    } else if (seed % 5 == 1 && into != other) {
        world.weld(into, other);
    } else if (seed % 5 == 2) {
        world.add(
            {.shape = Compound{{Circle{Real(0.1)}, Box{1, Real(0.1)}}}, .position = {where, 9}});
    } else if (world[into].partCount() > 1) {
        world.unweld(into, 0);
    }
}

// Contacts are in the order of the bodies, whatever the indices of their parts.
TEST(ChangeVisits, PartsInAnotherOrderGiveTheSameBits) {
    for (const int still : {0, 200, 1500}) { // compared one by one; in the tree from 512 on
        World world({.gravity = support::kEarth});
        for (int i = 0; i < still; ++i) {
            world.add(
                {.shape = Box{1, 1}, .position = {Real(20 + 2 * i), 0}, .type = BodyType::Static});
        }
        support::addHeap(world, 5, 40);
        for (std::uint64_t step = 0; step < (support::kSanitized ? 15 : 120); ++step) {
            changeParts(world, step);
            World ordered = fromBytes(toBytes(world));
            world.step(support::kDt);
            ordered.step(support::kDt);
            ASSERT_EQ(world.stateHash(), ordered.stateHash()) << still << ", step " << step;
        }
    }
}

TEST(ChangeVisits, AForceOnFlagsThatNoBodyHasVisitsNone) {
    SleepingRow row;
    EXPECT_EQ(row.visits([&] { row.world.applyForceToAll({9, 0}, {kMatchAny, kRare}); }), 0u);
    EXPECT_EQ(row.visits([&] { row.world.applyTorqueToAll(9, {kMatchEqual, kRare}); }), 0u);
    EXPECT_EQ(support::countAsleep(row.world), std::size_t{kBodies});
    row.world[row.boxes[700]].setFlags(kRare);
    EXPECT_LE(row.visits([&] { row.world.applyForceToAll({9, 0}, {kMatchAny, kRare}); }), 64u);
    EXPECT_GT(row.world[row.boxes[700]].velocity().x, 0);
    World read = fromBytes(toBytes(row.world));
    read.applyForceToAll({-900, 0}, {kMatchAll, kRare});
    read.step(support::kDt);
    EXPECT_LT(read[read.bodies()[701]].velocity().x, 0);
}

// Regression: it woke all bodies that the filter accepts.
TEST(ChangeVisits, NoForceWakesNoBody) {
    SleepingRow row;
    BodyRef box = row.world[row.boxes[0]];
    EXPECT_EQ(row.visits([&] { row.world.applyForceToAll({}); }), 0u);
    row.world.applyTorqueToAll(0);
    box.applyForce({});
    box.applyForce({}, box.center() + Vec2{1, 0});
    box.applyTorque(0);
    EXPECT_EQ(support::countAsleep(row.world), std::size_t{kBodies});
}

// Regression: a World without a region visited all bodies at each call without one.
TEST(ChangeVisits, NoRegionInPlaceOfNoneVisitsNone) {
    SleepingRow row;
    EXPECT_EQ(row.visits([&] { row.world.setRegion({}); }), 0u);
}

} // namespace
} // namespace kodo
