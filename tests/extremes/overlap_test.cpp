// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
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

/// Five times what two bodies part with at most (m/s): the outermost of a heap stands on what is
/// pushed that way itself. A heap of twenty is three deep on each side.
Real mostSpeed(const World& world) {
    return 5 * world.settings().pushSpeed * world.tolerances().unit();
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

// Centres on one point have no direction to part in, and part all the same; nothing is shot out.
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
    for (const Kind& kind : {kKinds[0], kKinds[1]}) {
        SCOPED_TRACE(kind.name);
        World world = crowd(1000, kind.shape, Strategy::SoftStep);
        Real most = 0;
        for (int i = 0; i < 12; ++i) {
            world.step(support::kDt);
            most = std::max(most, fastest(world));
        }
        EXPECT_LT(most, mostSpeed(world));
        Real farthest = 0;
        for (const BodyId id : world.bodies()) {
            farthest = std::max(farthest, length(world[id].position()));
        }
        EXPECT_GT(farthest, Real(0.01));
        EXPECT_EQ(world.bodyCount(), 1000u);
    }
}

} // namespace
} // namespace kodo
