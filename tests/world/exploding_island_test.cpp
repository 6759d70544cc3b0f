// SPDX-License-Identifier: MIT
// Islands whose motion becomes infinite, beside others on the same static body.
#include <kodo/kodo.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace kodo {
namespace {

using support::RandomNumbers;
using support::Solver;

/// 10 to a random power.
Real anyPower(RandomNumbers& random, double low, double high) {
    return std::pow(Real(10), random.between(low, high));
}

JointDef anyJoint(RandomNumbers& random, BodyId a, BodyId b) {
    const auto anchor = [&] { return Vec2{anyPower(random, -2, 4.9), anyPower(random, -2, 4.9)}; };
    const JointEnds ends{.a = a, .b = b, .anchorA = anchor(), .anchorB = anchor()};
    switch (random.below(5)) {
    case 0:
        return RevoluteJoint{.ends = ends,
                             .motorSpeed = anyPower(random, -2, 6.9),
                             .motorTorque = anyPower(random, 0, 37)};
    case 1:
        return FixedJoint{.ends = ends};
    case 2:
        return DistanceJoint{
            .ends = ends, .length = anyPower(random, -2, 4), .hertz = anyPower(random, -2, 4)};
    case 3:
        return PrismaticJoint{.ends = ends,
                              .motorSpeed = anyPower(random, -2, 6.9),
                              .motorForce = anyPower(random, 0, 37)};
    default:
        return DistanceJoint{.ends = ends, .limits = Range{0, anyPower(random, -2, 4)}};
    }
}

constexpr Flags kExploding = 1;
constexpr Flags kBystander = 2; // does not collide with what explodes

/// Ground, and at x = 20 km a box on it and one that hangs from it. Returns the three bodies.
std::vector<BodyId> addBystanders(World& world) {
    const BodyId ground =
        world.add({.shape = Plane{}, .type = BodyType::Static, .flags = kExploding | kBystander});
    const auto add = [&](Vec2 position, Vec2 velocity) {
        return world.add({.position = position,
                          .velocity = velocity,
                          .flags = kBystander | kMatchAny,
                          .required = kBystander});
    };
    const BodyId box = add({20000, Real(0.6)}, {1, 0});
    const BodyId swing = add({20100, 5}, {});
    world.add(
        RevoluteJoint{.ends = {.a = ground, .b = swing, .anchorA = {20102, 5}, .anchorB = {2, 0}}});
    return {ground, box, swing};
}

void addExploding(World& world, RandomNumbers& random, BodyId ground) {
    std::vector<BodyId> ids{ground};
    const std::size_t count = 1 + random.below(20);
    for (std::size_t i = 0; i < count; ++i) {
        ids.push_back(world.add({.position = random.point(5) + Vec2{0, 6},
                                 .mass = MassDef{.mass = anyPower(random, -17, 17)},
                                 .flags = kExploding | kMatchAny,
                                 .required = kExploding}));
    }
    for (std::size_t i = 1 + random.below(60); i > 0; --i) {
        const BodyId a = ids[random.below(ids.size())];
        const BodyId b = ids[1 + random.below(count)];
        const JointDef joint = anyJoint(random, a, b);
        if (a != b && !check(joint)) {
            world.add(joint);
        }
    }
}

// An infinite impulse times the inverse mass 0 of a static body is NaN: it froze all islands on
// that body, in 1117 of 3000 such worlds.
TEST(ExplodingIsland, ChangesNoOtherIslandOnTheSameGround) {
    int exploded = 0;
    const int worlds = support::draws(100);
    for (int seed = 1; seed <= worlds; ++seed) {
        for (const Solver solver : support::kSolvers) {
            RandomNumbers random(static_cast<std::uint64_t>(seed));
            World beside({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
            World alone = beside;
            const std::vector<BodyId> here = addBystanders(beside);
            const std::vector<BodyId> there = addBystanders(alone);
            addExploding(beside, random, here[0]);
            bool frozen = false;
            for (int step = 0; step < 20; ++step) {
                beside.step(support::kDt);
                alone.step(support::kDt);
                frozen = frozen || !beside.frozenBodies().empty();
                for (std::size_t i = 0; i < here.size(); ++i) {
                    ASSERT_EQ(beside[here[i]].position(), alone[there[i]].position())
                        << "seed " << seed << ", body " << i << ", step " << step;
                    ASSERT_EQ(beside[here[i]].velocity(), alone[there[i]].velocity())
                        << "seed " << seed << ", body " << i << ", step " << step;
                }
            }
            exploded += frozen ? 1 : 0;
        }
    }
    EXPECT_GT(exploded, worlds) << "too few worlds explode";
}

// A rod on a line becomes immovable when it is frozen: two lines, and neither is the ground of the
// other.
TEST(ExplodingIsland, ARodThatIsFrozenOnALineLeavesIt) {
    for (const double rate : {30.0, 60.0, 240.0}) {
        World world;
        const Real dt = static_cast<Real>(1 / rate);
        world.add({.shape = Segment{{-2, 0}, {2, 0}}, .type = BodyType::Static});
        const BodyId rod = world.add({.shape = Segment{{-1, 0}, {1, 0}},
                                      .position = {0, Real(0.012)},
                                      .flags = kNeverSleep});
        world.step(dt);
        world.step(dt);
        world[rod].applyForce({0, std::numeric_limits<Real>::max() / 16});
        world.step(dt);
        ASSERT_EQ(world.frozenBodies().size(), 1u) << rate;
        EXPECT_EQ(world.frozenBodies()[0], rod) << rate;
        world.step(dt);
    }
}

} // namespace
} // namespace kodo
