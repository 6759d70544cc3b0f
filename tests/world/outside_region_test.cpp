// SPDX-License-Identifier: MIT
#include <support/outside.hpp>
#include <support/phase_book.hpp>
#include <support/sleeping.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::ballDef;
using support::boxDef;
using support::isOutside;
using support::kDt;
using support::near;
using support::run;
using support::State;
using support::stateOf;

// A body outside the region is static for bodies inside: impulses do not move it, and no body
// passes through it.
TEST(OutsideRegion, ABodyIsStaticForBodiesInside) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const BodyId tower = world.add(boxDef({0, Real(2.5)}, 1, 5));
    BodyDef def = boxDef({0, 8}, 1, 1);
    def.velocity = {0, -5};
    const BodyId falling = world.add(def);
    BodyDef ball = ballDef({6, 6}, Real(0.25));
    ball.velocity = {-8, 0};
    const BodyId thrown = world.add(ball);
    world.setRegion(Aabb{{-10, Real(5.2)}, {10, 20}});
    ASSERT_TRUE(isOutside(world, tower));
    run(world, 120);
    EXPECT_EQ(stateOf(world, tower), (State{{0, Real(2.5)}, {}, {}, 0}));
    EXPECT_TRUE(near(world[falling].position(), Vec2{0, Real(5.5)}, Real(0.02)));
    EXPECT_FALSE(isOutside(world, falling));
    EXPECT_LT(world[thrown].position().y, Real(5.2)); // fell out of the region
}

// The stored velocity of a body outside does not count in contacts. A ball of the same velocity
// approaches it, bounces off, and its record holds the speed of the ball alone.
TEST(OutsideRegion, VelocityDoesNotCountInContacts) {
    for (const Real kept : {Real(5), Real(-3)}) {
        World world;
        BodyDef def = boxDef({2, 0}, 1, 1, support::slippery(1));
        def.velocity = {kept, 0};
        const BodyId box = world.add(def);
        world.setRegion(Aabb{{-10, -10}, {Real(1.4), 10}});
        ASSERT_TRUE(isOutside(world, box));
        def = ballDef({0, 0}, Real(0.3), support::slippery(1));
        def.velocity = {5, 0};
        const BodyId ball = world.add(def);
        std::vector<Real> approaches;
        for (int i = 0; i < 30; ++i) {
            world.step(kDt);
            if (const CollisionRecord* hit = support::recordOf(world, box, ball);
                hit != nullptr && hit->maxImpulse > 0) {
                approaches.push_back(hit->approachSpeed);
            }
        }
        EXPECT_EQ(approaches, std::vector<Real>{5});
        EXPECT_EQ(world[ball].velocity(), (Vec2{-5, 0}));
        EXPECT_EQ(world[box].velocity(), (Vec2{kept, 0}));
    }
}

/// Number of records of each phase in the last step.
struct Phases {
    int begin = 0;
    int persist = 0;
    int end = 0;
    friend bool operator==(const Phases&, const Phases&) = default;
};
Phases phasesOf(const World& world) {
    Phases count;
    for (const CollisionRecord& record : world.collisions()) {
        count.begin += record.phase == TouchPhase::Begin ? 1 : 0;
        count.persist += record.phase == TouchPhase::Persist ? 1 : 0;
        count.end += record.phase == TouchPhase::End ? 1 : 0;
    }
    return count;
}

/// A stack of five boxes on the floor, with a region around it.
struct Tower {
    World world{{.gravity = support::kEarth}};
    std::vector<BodyId> boxes;

    Tower() {
        addFloor(world);
        boxes = support::addStack(world, 5);
        for (const BodyId box : boxes) {
            world[box].setFlags(kNeverSleep);
        }
        world.setRegion(kAll);
        run(world, 60);
    }
    static constexpr Aabb kAll{{-10, -10}, {10, 10}};
    static constexpr Aabb kNone{{100, -10}, {120, 10}};
};

// F3: contacts of bodies outside are parked: they neither end nor begin. Their impulses then warm
// start the tower.
TEST(OutsideRegion, ContactsNeitherEndNorBegin) {
    Tower tower;
    ASSERT_EQ(phasesOf(tower.world), (Phases{0, 5, 0}));
    for (int round = 0; round < 3; ++round) {
        tower.world.setRegion(Tower::kNone);
        for (int i = 0; i < 20; ++i) {
            tower.world.step(kDt);
            ASSERT_EQ(phasesOf(tower.world), Phases{}) << i;
        }
        tower.world.setRegion(Tower::kAll);
        tower.world.step(kDt);
        ASSERT_EQ(phasesOf(tower.world), (Phases{0, 5, 0})) << round;
        // Without a warm start it would fall at 0.17 m/s.
        EXPECT_LT(length(tower.world[tower.boxes[4]].velocity()), Real(0.01));
    }
}

TEST(OutsideRegion, ContactsEndWhenABodyIsRemovedOrTeleported) {
    Tower tower;
    tower.world.setRegion(Tower::kNone);
    run(tower.world, 10);
    tower.world.remove(tower.boxes[4]);
    tower.world.step(kDt);
    EXPECT_EQ(phasesOf(tower.world), (Phases{0, 0, 1}));
    tower.world[tower.boxes[3]].setPosition({5, 5});
    tower.world.step(kDt);
    EXPECT_EQ(phasesOf(tower.world), (Phases{0, 0, 1}));
    tower.world.setRegion(Tower::kAll);
    tower.world.step(kDt);
    EXPECT_EQ(phasesOf(tower.world), (Phases{0, 3, 0}));
}

// A sensor leaves the region while a body sleeps in it. Regression: once that body woke, their
// contact began again.
TEST(OutsideRegion, AParkedContactGoesOnWhenItsSleepingBodyWakes) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const BodyId sleeper = world.add(boxDef({0, Real(0.5)}, 1, 1));
    support::PhaseBook book;
    const auto step = [&] {
        world.step(kDt);
        book.read(world);
    };
    for (int i = 0; i < 60; ++i) {
        step();
    }
    ASSERT_TRUE(support::isAsleep(world, sleeper));
    const BodyId sensor = world.add({.shape = Box{20, Real(0.2)},
                                     .position = {-10, Real(0.5)},
                                     .velocity = {Real(0.1), 0},
                                     .type = BodyType::Kinematic,
                                     .flags = kSensor});
    step();
    ASSERT_NE(support::recordOf(world, sleeper, sensor), nullptr);
    ASSERT_TRUE(support::isAsleep(world, sleeper));
    world.setRegion(Aabb{{Real(0.2), -5}, {10, 10}}); // overlaps the sleeper alone
    ASSERT_TRUE(isOutside(world, sensor));
    step();
    world[sleeper].wake();
    World restored = fromBytes(toBytes(world));
    for (int i = 0; i < 10; ++i) {
        step();
        restored.step(kDt);
        EXPECT_EQ(restored.stateHash(), world.stateHash()) << i;
    }
}

// A restored World with parked contacts continues with the same bits.
TEST(OutsideRegion, ASnapshotKeepsParkedContacts) {
    Tower tower;
    tower.world.setRegion(Tower::kNone);
    run(tower.world, 10);
    World restored = fromBytes(toBytes(tower.world));
    EXPECT_EQ(restored.stateHash(), tower.world.stateHash());
    for (World* world : {&restored, &tower.world}) {
        world->setRegion(Tower::kAll);
        world->step(kDt);
        EXPECT_EQ(phasesOf(*world), (Phases{0, 5, 0}));
    }
    EXPECT_EQ(restored.stateHash(), tower.world.stateHash());
}

// Parked contacts take over changes of their bodies: a box that becomes a sensor falls, also if
// another body is added later.
TEST(OutsideRegion, ABoxThatBecameASensorFalls) {
    for (const bool another : {false, true}) {
        World world(support::withoutSleep());
        addFloor(world);
        const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
        run(world, 20);
        world.setRegion(Aabb{{100, 100}, {101, 101}});
        world[box].setFlags(kSensor);
        world.setRegion(Aabb{{100, 100}, {102, 102}});
        world.step(kDt);
        world.setRegion(std::nullopt);
        run(world, 10);
        if (another) {
            world.add(boxDef({5, Real(0.5)}, 1, 1));
        }
        run(world, 50);
        EXPECT_LT(world[box].position().y, Real(-4)); // 5 m in a second
    }
}

// While the region moves over a heap, each Begin has one End, and no body falls through bodies
// outside.
TEST(OutsideRegion, PhasesStayPairedWhileTheRegionMoves) {
    for (std::uint64_t seed = 191; seed < 195; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        support::RandomNumbers random(seed);
        World world({.gravity = support::kEarth});
        support::addHeap(world, seed, 40);
        support::PhaseBook book;
        for (int step = 0; step < 600; ++step) {
            if (step % 20 == 0) {
                const Vec2 corner{random.between(-6, 4), random.between(-1, 6)};
                world.setRegion(Aabb{corner, corner + Vec2{4, 4}});
            }
            world.step(kDt);
            book.read(world);
            ASSERT_FALSE(HasFailure()) << "step " << step;
        }
        world.setRegion(std::nullopt);
        for (int step = 0; step < 600; ++step) {
            world.step(kDt);
            book.read(world);
            ASSERT_FALSE(HasFailure()) << "step " << step << " of the rest";
        }
        for (const BodyId id : world.bodies()) {
            ASSERT_GT(world[id].position().y, Real(-0.51)); // the position of the floor
        }
    }
}

// Approach speeds are recalculated for contacts of the stopped bodies alone. A recalculation of all
// changed the last bits of the others.
TEST(OutsideRegion, ABodyThatHoldsOneInsideChangesNoRecordElsewhere) {
    const auto addPile = [](World& world) {
        support::addHeap(world, 7, 30);
        world.setRegion(Aabb{{-50, -10}, {50, 40}});
        return world.bodies().size();
    };
    World alone({.gravity = support::kEarth});
    World beside({.gravity = support::kEarth});
    addPile(alone);
    const std::size_t count = addPile(beside);
    BodyDef def = boxDef({Real(-50.55), 20}, 1, 1); // outside, and stopped with its velocity
    def.velocity = {-3, 0};
    const BodyId outside = beside.add(def);
    beside.add(ballDef({Real(-50.2), Real(20.8)}, Real(0.3))); // on it, and inside
    const auto speedsOf = [&](const World& world) {
        std::vector<Real> speeds;
        for (const CollisionRecord& record : world.collisions()) {
            if (record.b.index < count) {
                speeds.push_back(record.approachSpeed);
            }
        }
        return speeds;
    };
    for (int step = 0; step < 60; ++step) {
        alone.step(kDt);
        beside.step(kDt);
        ASSERT_EQ(speedsOf(alone), speedsOf(beside)) << "step " << step;
    }
    EXPECT_TRUE(isOutside(beside, outside));
}

} // namespace
} // namespace kodo
