// SPDX-License-Identifier: MIT
#include <support/depth.hpp>
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::deepest;

/// So many bodies, all with their centre at the origin, without gravity.
World crowd(int count, const Shape& shape, Strategy strategy) {
    StepSettings settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{};
    World world({.settings = settings});
    for (int i = 0; i < count; ++i) {
        world.add({.shape = shape});
    }
    return world;
}

Real fastest(const World& world) {
    Real speed = 0;
    for (const BodyId id : world.bodies()) {
        const Real own = length(world[id].velocity());
        if (!std::isfinite(own) || !isFinite(world[id].position())) {
            return std::numeric_limits<Real>::infinity();
        }
        speed = std::max(speed, own);
    }
    return speed;
}

/// The most that anybody was fast in so many steps (m/s).
Real mostSpeedIn(World& world, int steps) {
    Real most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(support::kDt);
        most = std::max(most, fastest(world));
    }
    return most;
}

/// What two bodies part with at most (m/s).
Real mostSpeed(const World& world) {
    return world.settings().pushSpeed * world.tolerances().unit();
}

struct Kind {
    const char* name;
    Shape shape;
};
const Kind kKinds[] = {
    {"circle", Circle{Real(0.5)}},
    {"box", Box{1, 1}},
    {"triangle", Polygon{{{Real(-0.5), Real(-0.5)}, {Real(0.5), Real(-0.5)}, {0, Real(0.5)}}}},
};

// Centres on one point have no direction to part in, and part all the same; nothing is shot out:
// the outermost of twenty stand on what is pushed that way itself, and are no faster than one.
TEST(Overlap, AFewBodiesOnOnePointPart) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        for (const Kind& kind : kKinds) {
            for (const int count : {2, 20}) {
                SCOPED_TRACE(testing::Message() << kind.name << " x " << count << ", strategy "
                                                << static_cast<int>(strategy));
                World world = crowd(count, kind.shape, strategy);
                EXPECT_LT(mostSpeedIn(world, 600), mostSpeed(world));
                EXPECT_LT(deepest(world), Real(0.02));
                EXPECT_TRUE(world.frozenBodies().empty());
            }
        }
    }
}

// S4: How a heap parts changes by no bit, whatever parts far off.
TEST(Overlap, WhatPartsDoesNotDependOnWhatPartsElsewhere) {
    const auto heapBeside = [](int others) {
        World world(support::wakeful());
        support::addFloor(world);
        std::vector<BodyId> own;
        for (int i = 0; i < 5; ++i) {
            own.push_back(world.add(support::boxDef({Real(0.2) * Real(i), Real(0.6)}, 1, 1)));
        }
        for (int i = 0; i < others; ++i) {
            world.add(support::boxDef({100, 5}, 1, 1));
        }
        support::run(world, 120);
        std::vector<Vec2> states;
        for (const BodyId id : own) {
            states.push_back(world[id].position());
            states.push_back(world[id].velocity());
        }
        return states;
    };
    const std::vector<Vec2> alone = heapBeside(0);
    EXPECT_EQ(heapBeside(30), alone);
    EXPECT_EQ(heapBeside(100), alone);
}

// Circles on one point get directions by their numbers, so that they part to all sides, and not
// along a line on which each would push the next.
TEST(Overlap, CirclesOnOnePointPartToAllSides) {
    World world = crowd(20, Circle{Real(0.5)}, Strategy::SoftStep);
    support::run(world, 600);
    Real wide = 0;
    Real high = 0;
    for (const BodyId id : world.bodies()) {
        wide = std::max(wide, std::abs(world[id].position().x));
        high = std::max(high, std::abs(world[id].position().y));
    }
    EXPECT_GT(wide, 2);
    EXPECT_GT(high, 2);
}

// Sixty part too, and take their time: seventeen seconds. Nobody is pushed faster than one of two
// is. What they give each other stays in balance: rounding aside, and each of the 1770 contacts
// rounds in every substep.
TEST(Overlap, SixtyBodiesOnOnePointPartWithinTwentySeconds) {
    for (const Kind& kind : kKinds) {
        SCOPED_TRACE(kind.name);
        World world = crowd(60, kind.shape, Strategy::SoftStep);
        EXPECT_LT(mostSpeedIn(world, 1200), mostSpeed(world));
        EXPECT_LT(deepest(world), Real(0.02));
        EXPECT_TRUE(support::near(support::totalsOf(world).momentum, Vec2{},
                                  support::byPrecision(0.01, 1e-9)));
        EXPECT_EQ(world.bodyCount(), 60u);
    }
}

// A thousand at one point: half a million contacts. Nothing becomes NaN and nothing is shot out;
// they part further than where they began. Few steps, for each is dear.
TEST(Overlap, AThousandBodiesOnOnePointDoNotBurst) {
    constexpr int kCount = support::kSanitized ? 300 : 1000;
    for (const Kind& kind : {kKinds[0], kKinds[1]}) {
        SCOPED_TRACE(kind.name);
        World world = crowd(kCount, kind.shape, Strategy::SoftStep);
        EXPECT_LT(mostSpeedIn(world, 12), mostSpeed(world));
        Real farthest = 0;
        for (const BodyId id : world.bodies()) {
            farthest = std::max(farthest, length(world[id].position()));
        }
        EXPECT_GT(farthest, Real(0.01)); // m; all began at 0
        EXPECT_EQ(world.bodyCount(), std::size_t{kCount});
    }
}

/// Two unit boxes, the right one three times as heavy, so deep in each other (m).
struct Parting {
    World world;
    BodyId light;
    BodyId heavy;
    Real depth;

    Parting(Real deep, Strategy strategy)
        : world({.settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{}}),
          depth(deep) {
        BodyDef def = support::boxDef({}, 1, 1);
        light = world.add(def);
        def.position = {1 - deep, 0};
        def.density = 3;
        heavy = world.add(def);
        support::run(world, 60);
    }
    /// How far the common centre of mass has moved (m).
    Real drift() const {
        return (world[light].position().x + 3 * (world[heavy].position().x - 1 + depth)) / 4;
    }
    Real apart() const { return length(world[heavy].velocity() - world[light].velocity()); }
};

// S4, F4: what overlaps is pushed apart by impulses that are taken out again: boxes that lay two
// centimetres in each other part and stand still, to a fiftieth of the push of 3 m/s, and their
// common centre stays. The last slop, 4 mm, may be left as it was.
TEST(Overlap, PartingGivesNoEnergy) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        SCOPED_TRACE(static_cast<int>(strategy));
        const Parting boxes(Real(0.02), strategy);
        EXPECT_LT(boxes.apart(), boxes.world.settings().pushSpeed / 50);
        EXPECT_TRUE(support::near(boxes.drift(), 0, Real(1e-5)));
        EXPECT_LT(deepest(boxes.world), boxes.world.tolerances().slop);
    }
}

// S4: the same out of 20 cm, as deep as contacts never are by themselves: more passes take the push
// out again.
TEST(Overlap, PartingFromDeepWithinGivesNoMore) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        SCOPED_TRACE(static_cast<int>(strategy));
        const Parting boxes(Real(0.2), strategy);
        EXPECT_LT(boxes.apart(), boxes.world.settings().pushSpeed / 50);
        EXPECT_TRUE(support::near(boxes.drift(), 0, Real(1e-5)));
        EXPECT_LT(deepest(boxes.world), boxes.world.tolerances().slop);
    }
}

// S4: nor does it matter what else is in the world: beside boxes that lie still, or are awake and
// touch each other in a thousand places, the pair parts as it does alone.
TEST(Overlap, ALargePileBesideADeepPairDoesNotSpeedItUp) {
    for (const int rows : {0, 5, 20}) {
        SCOPED_TRACE(rows);
        World world;
        for (int i = 0; i < rows * rows; ++i) { // with nothing between them
            world.add(support::boxDef(
                {50 + static_cast<Real>(i % rows), static_cast<Real>(i / rows)}, 1, 1));
        }
        const BodyId left = world.add(support::boxDef({}, 1, 1));
        const BodyId right = world.add(support::boxDef({Real(0.8), 0}, 1, 1));
        support::run(world, 60);
        EXPECT_LT(length(world[right].velocity() - world[left].velocity()),
                  world.settings().pushSpeed / 50);
        EXPECT_GT(world[right].position().x - world[left].position().x,
                  1 - world.tolerances().slop);
    }
}

// S4: the rest test sees the separation: what is still being parted, however slowly, does not rest;
// once it is out, it does.
TEST(Overlap, WhatIsBeingPartedDoesNotRest) {
    StepSettings settings;
    settings.pushSpeed = Real(0.05); // m/s, so that it takes 100 steps
    World world({.gravity = support::kEarth, .settings = settings});
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.4)}, 1, 1));
    for (int i = 0; i < 300; ++i) {
        world.step(support::kDt);
        if (world[box].position().y < Real(0.5) - 2 * world.tolerances().slop) {
            ASSERT_EQ(world[box].flags() & kResting, 0u) << "step " << i;
        }
    }
    EXPECT_NE(world[box].flags() & kResting, 0u);
    EXPECT_GT(world[box].position().y, Real(0.5) - world.tolerances().slop);
}

// S4: the same under gravity: a box that began 10 cm in the floor stands on it, and has not jumped:
// it has gained no more energy than that of being lifted out.
TEST(Overlap, PartingUnderGravityDoesNotThrow) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{};
        World world({.gravity = support::kEarth, .settings = settings});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.4)}, 1, 1));
        Real highest = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(support::kDt);
            highest = std::max(highest, world[box].position().y);
        }
        EXPECT_LT(highest, Real(0.502)); // half a slop above the floor
        EXPECT_GT(world[box].position().y, Real(0.495));
        EXPECT_LT(length(world[box].velocity()), Real(1e-3));
    }
}

/// The largest impulse (N s) of the last step.
Real hardest(const World& world) {
    Real most = 0;
    for (const CollisionRecord& record : world.collisions()) {
        most = std::max(most, record.maxImpulse);
    }
    return most;
}

// What is wedged into gaps too small for it has no place to go: two sides press on it, or turn it,
// against each other. Their impulses grow until the softness of a contact takes back as much in a
// substep as the push adds, and no further, however long that lasts. It rocks meanwhile, but never
// by the 0.2 m that would free it from two of the four.
TEST(Overlap, WhatIsPinchedIsPressedWithinBounds) {
    for (const Flags flags : {Flags{0}, kLockMove}) {
        SCOPED_TRACE(flags);
        StepSettings settings;
        settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
        World world({.settings = settings});
        BodyDef def = support::boxDef({}, 2, 1);
        def.flags = flags;
        const BodyId wedged = world.add(def);
        for (const Vec2 place : {Vec2{Real(0.8), Real(0.8)}, Vec2{Real(-0.8), Real(0.8)},
                                 Vec2{Real(0.8), Real(-0.8)}, Vec2{Real(-0.8), Real(-0.8)}}) {
            world.add({.shape = Box{1, 1}, .position = place, .flags = kLocked});
        }
        support::run(world, 1000);
        const Real early = hardest(world);
        EXPECT_GT(early, 0);
        Real farthest = 0;
        for (int step = 0; step < 20000; ++step) {
            support::run(world, 1);
            farthest = std::max(farthest, length(world[wedged].position()));
        }
        EXPECT_LT(hardest(world), Real(1.01) * early);
        EXPECT_LT(farthest, Real(0.2));
    }
}

} // namespace
} // namespace kodo
