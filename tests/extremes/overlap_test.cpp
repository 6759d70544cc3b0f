// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

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

Real deepest(const World& world) {
    Real depth = 0;
    const std::vector<BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::size_t k = i + 1; k < ids.size(); ++k) {
            const BodyView a = world[ids[i]];
            const BodyView b = world[ids[k]];
            if (overlap(a.bounds(), b.bounds())) {
                depth = std::max(depth, -separation(a.part(0).convex, a.placement(),
                                                    b.part(0).convex, b.placement())
                                             .distance);
            }
        }
    }
    return depth;
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
                Real most = 0;
                for (int i = 0; i < 600; ++i) {
                    world.step(support::kDt);
                    most = std::max(most, fastest(world));
                }
                EXPECT_LT(most, mostSpeed(world));
                EXPECT_LT(deepest(world), Real(0.02));
                EXPECT_TRUE(world.frozenBodies().empty());
            }
        }
    }
}

// A thousand at one point: half a million contacts. Nothing becomes NaN and nothing is shot out;
// they part further than where they began. Few steps, for each is dear.
TEST(Overlap, AThousandBodiesOnOnePointDoNotBurst) {
    constexpr int kCount = support::kSanitized ? 300 : 1000;
    for (const Kind& kind : {kKinds[0], kKinds[1]}) {
        SCOPED_TRACE(kind.name);
        World world = crowd(kCount, kind.shape, Strategy::SoftStep);
        Real most = 0;
        for (int i = 0; i < 4; ++i) {
            world.step(support::kDt);
            most = std::max(most, fastest(world));
        }
        EXPECT_LT(most, mostSpeed(world));
        Real farthest = 0;
        for (const BodyId id : world.bodies()) {
            farthest = std::max(farthest, length(world[id].position()));
        }
        EXPECT_GT(farthest, Real(0.005));
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

} // namespace
} // namespace kodo
