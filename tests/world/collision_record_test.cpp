// SPDX-License-Identifier: MIT
#include <support/phase_book.hpp>

#include <set>
#include <tuple>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::PhaseBook;
using support::recordOf;
using support::slippery;

/// A ball of 2 kg hits a wall at 3 m/s. Steps until the pair has a record.
struct Shot {
    World world;
    BodyId wall;
    BodyId ball;
    CollisionRecord hit;

    explicit Shot(Real restitution) {
        wall = support::addWall(world, 2, 1, slippery(restitution));
        BodyDef def = ballDef({0, 0}, Real(0.5), slippery(restitution));
        def.density = 2 / (std::numbers::pi_v<Real> / 4);
        def.velocity = {3, 0};
        ball = world.add(def);
        for (int i = 0; i < 60; ++i) {
            world.step(kDt);
            if (const CollisionRecord* record = recordOf(world, wall, ball)) {
                hit = *record;
                return;
            }
        }
    }
};

// S2: J = m v (1 + e).
TEST(CollisionRecord, ImpulseOfABounceIsMassTimesSpeedTimesOnePlusE) {
    for (const Real e : {Real(1), Real(0.5), Real(0.25)}) {
        SCOPED_TRACE(e);
        const Shot shot(e);
        const Real exact = byPrecision(2e-6, 1e-13);
        EXPECT_EQ(shot.hit.phase, TouchPhase::Begin);
        EXPECT_EQ(shot.hit.pointCount, 1);
        EXPECT_TRUE(nearShare(shot.hit.approachSpeed, 3, exact));
        EXPECT_TRUE(nearShare(shot.hit.maxImpulse, 6 * (1 + static_cast<long double>(e)), exact));
        EXPECT_TRUE(nearShare(shot.hit.totalImpulse, 6 * (1 + static_cast<long double>(e)), exact));
    }
}

// S2: the normal points from a, the body with the lower index, to b.
TEST(CollisionRecord, NormalPointsFromTheLowerToTheHigherIndex) {
    const Shot shot(1);
    EXPECT_EQ(shot.hit.a, shot.wall);
    EXPECT_EQ(shot.hit.b, shot.ball);
    EXPECT_TRUE(near(shot.hit.normal, Vec2{-1, 0}, 4 * support::kEpsilon));
    EXPECT_TRUE(near(shot.hit.point, Vec2{2, 0}, shot.world.tolerances().slop));
    EXPECT_TRUE(shot.hit.involves(shot.ball));
    EXPECT_EQ(shot.hit.other(shot.ball), shot.wall);
}

// Without restitution the impulse is m v. A speculative contact may apply part of it one step
// earlier, so the sum over all steps is compared.
TEST(CollisionRecord, ImpulsesOfAPlasticImpactSumToTheMomentum) {
    World world;
    const BodyId wall = support::addWall(world, 2, 1, slippery());
    BodyDef def = ballDef({0, 0}, Real(0.5), slippery());
    def.velocity = {3, 0};
    const BodyId ball = world.add(def);
    long double sum = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(kDt);
        if (const CollisionRecord* hit = recordOf(world, wall, ball)) {
            sum += static_cast<long double>(hit->totalImpulse);
        }
    }
    EXPECT_TRUE(nearShare(sum, 3 * static_cast<long double>(world[ball].mass()), 1e-3L));
}

// S2: at rest the impulse of a step is m g dt, divided between two corners.
TEST(CollisionRecord, ImpulseUnderABoxAtRestIsItsWeightTimesDt) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    BodyDef def = boxDef({0, Real(0.5)}, 1, 1);
    def.flags = kNeverSleep; // a sleeping body has no new impulses
    const BodyId box = world.add(def);
    support::run(world, 120);
    const CollisionRecord* hit = recordOf(world, floor, box);
    ASSERT_NE(hit, nullptr);
    EXPECT_EQ(hit->phase, TouchPhase::Persist);
    EXPECT_EQ(hit->pointCount, 2);
    // The impulse converges over the steps; after 2 s its error is at most 1e-3.
    EXPECT_TRUE(nearShare(hit->totalImpulse, 10.0L / 60, 1e-3L));
    const int substeps = world.settings().soft().substeps;
    EXPECT_TRUE(nearShare(hit->maxImpulse, 10.0L / 60 / substeps, 2e-3L));
    EXPECT_TRUE(nearShare(hit->maxPointImpulse(), 10.0L / 60 / (2 * substeps), 2e-3L));
    EXPECT_TRUE(near(hit->normal, Vec2{0, 1}, byPrecision(1e-5, 1e-9)));
    EXPECT_LT(hit->approachSpeed, Real(1e-3));
}

// S2: each Begin has one End, in a heap in which bodies are added, removed, welded and unwelded.
TEST(CollisionRecord, PhasesAreAlwaysPaired) {
    constexpr std::uint64_t kSeed = 141;
    support::RandomNumbers random(kSeed);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    World world({.gravity = support::kEarth});
    support::addHeap(world, kSeed, 40);
    PhaseBook book;
    for (int step = 0; step < 600; ++step) {
        world.step(kDt);
        book.read(world);
        const std::vector<BodyId> bodies = world.bodies();
        if (step % 20 == 10) {
            const BodyId victim = bodies[3 + random.below(bodies.size() - 3)];
            if (step % 40 == 10) {
                world.remove(victim);
                world.add(ballDef({random.between(-4, 4), 8}, Real(0.3)));
            } else if (step % 80 == 30 && world[bodies[3]].partCount() > 1) {
                world.unweld(bodies[3], world[bodies[3]].partCount() - 1);
            } else if (victim != bodies[3]) {
                world.weld(bodies[3], victim);
            }
        }
        ASSERT_FALSE(HasFailure()) << "step " << step;
    }
    EXPECT_GT(book.ended, 100);
    for (const BodyId id : world.bodies()) {
        world.remove(id);
    }
    world.step(kDt);
    book.read(world);
    EXPECT_EQ(book.openCount(), 0u);
}

TEST(CollisionRecord, EndsWhenABodyIsRemoved) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    support::run(world, 5);
    world.remove(box);
    EXPECT_NE(recordOf(world, floor, box), nullptr); // records of the last step stay valid
    world.step(kDt);
    const CollisionRecord* end = recordOf(world, floor, box);
    ASSERT_NE(end, nullptr);
    EXPECT_EQ(end->phase, TouchPhase::End);
    EXPECT_EQ(end->b, box);
    world.step(kDt);
    EXPECT_TRUE(world.collisions().empty());
}

// S2: calls between two steps do not change the records of the last step.
TEST(CollisionRecord, StaysValidUntilTheNextStep) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 7, 30);
    support::run(world, 120);
    const std::span<const CollisionRecord> records = world.collisions();
    const std::vector<CollisionRecord> copy(records.begin(), records.end());
    ASSERT_GT(copy.size(), 20u);
    const std::vector<BodyId> bodies = world.bodies();
    for (int i = 0; i < 100; ++i) {
        world.add(ballDef({100, static_cast<Real>(i)}, Real(0.3)));
    }
    world.weld(bodies[5], bodies[6]);
    for (std::size_t i = 7; i < bodies.size(); ++i) {
        world.remove(bodies[i]);
    }
    ASSERT_EQ(records.size(), copy.size());
    for (std::size_t i = 0; i < copy.size(); ++i) {
        EXPECT_EQ(records[i].a, copy[i].a);
        EXPECT_EQ(records[i].point, copy[i].point);
        EXPECT_EQ(records[i].totalImpulse, copy[i].totalImpulse);
    }
}

TEST(CollisionRecord, IsSortedByBodiesAndParts) {
    World world({.gravity = support::kEarth});
    support::addHeap(world, 8, 60);
    for (int step = 0; step < 200; ++step) {
        world.step(kDt);
        const CollisionRecord* last = nullptr;
        for (const CollisionRecord& r : world.collisions()) {
            ASSERT_LT(r.a.index, r.b.index);
            if (last != nullptr) {
                ASSERT_LT(std::tie(last->a, last->partA, last->b, last->partB),
                          std::tie(r.a, r.partA, r.b, r.partB));
            }
            last = &r;
        }
    }
}

// R6: each pair of parts has its own record.
TEST(CollisionRecord, NamesThePartsOfACompound) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const Compound table{{Box{4, Real(0.2), {0, 1}}, Box{Real(0.2), 1, {-1, Real(0.5)}},
                          Box{Real(0.2), 1, {1, Real(0.5)}}}};
    const BodyId id = world.add({.shape = table});
    support::run(world, 5);
    std::set<int> parts;
    for (const CollisionRecord& record : world.collisions()) {
        EXPECT_EQ(record.a, floor);
        EXPECT_EQ(record.b, id);
        EXPECT_EQ(record.partA, 0);
        parts.insert(record.partB);
    }
    EXPECT_EQ(parts, (std::set<int>{1, 2})); // the legs; the top touches nothing
}

// R8: a step sets and clears kColliding, which the thesis calls IS_COLLIDING.
TEST(CollisionRecord, AgreesWithTheCollidingFlag) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId ball = world.add(ballDef({0, 100}, 1));
    support::run(world, 3);
    EXPECT_NE(world[box].flags() & kColliding, 0u);
    EXPECT_NE(world[floor].flags() & kColliding, 0u);
    EXPECT_EQ(world[ball].flags() & kColliding, 0u);
    world[box].setPosition({0, 50});
    world.step(kDt);
    EXPECT_EQ(world[box].flags() & kColliding, 0u);
    EXPECT_EQ(world[floor].flags() & kColliding, 0u);
}

// W3: without records nothing else changes.
TEST(CollisionRecord, LeavingItOutChangesNothingElse) {
    WorldDef def{.gravity = support::kEarth};
    World with(def);
    def.settings.leaveOut = Feature::Records;
    World without(def);
    support::addHeap(with, 9, 30);
    support::addHeap(without, 9, 30);
    support::run(with, 90); // not asleep yet
    support::run(without, 90);
    EXPECT_FALSE(with.collisions().empty());
    EXPECT_TRUE(without.collisions().empty());
    without.setSettings(with.settings()); // which are part of the hash
    EXPECT_EQ(with.stateHash(), without.stateHash());
}

} // namespace
} // namespace kodo
