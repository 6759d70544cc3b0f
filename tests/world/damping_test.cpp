// SPDX-License-Identifier: MIT
// Damping and gravity scale of single bodies.
#include <kodo/snapshot.hpp>
#include <kodo/world.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <cmath>
#include <string>

namespace kodo {
namespace {

using support::kDt;
using support::near;

BodyDef moving(Real linearDamping, Real angularDamping = 0) {
    BodyDef def = support::ballDef({0, 0}, Real(0.5));
    def.velocity = {3, -4};
    def.angularVelocity = 2;
    def.linearDamping = linearDamping;
    def.angularDamping = angularDamping;
    return def;
}

// v = v0 exp(-c t), whatever the step, its substeps and the solver. 1000 products round by an
// epsilon each.
TEST(Damping, IsTheExponentialForAnyStep) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int substeps : {1, 8}) {
            for (const int rate : {30, 60, 1000}) {
                World world(
                    {.settings = support::withSubsteps(support::settingsOf(solver), substeps)});
                const BodyId body = world.add(moving(Real(0.75), Real(2.5)));
                support::run(world, rate, Real(1) / static_cast<Real>(rate));
                const BodyView view = world[body];
                const double rounding = 1000 * static_cast<double>(support::kEpsilon);
                EXPECT_NEAR(double(view.velocity().x), 3 * std::exp(-0.75), rounding) << rate;
                EXPECT_NEAR(double(view.velocity().y), -4 * std::exp(-0.75), rounding) << rate;
                EXPECT_NEAR(double(view.angularVelocity()), 2 * std::exp(-2.5), rounding) << rate;
            }
        }
    }
}

// In a fall the step adds g dt after the decay: v = g dt / (1 - exp(-c dt)), near g / c.
TEST(Damping, LimitsTheSpeedOfAFall) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        BodyDef def = moving(2);
        def.velocity = {};
        const BodyId body = world.add(def);
        support::run(world, 600);
        const double exact = -10 * double(kDt) / (1 - std::exp(-2 * double(kDt)));
        EXPECT_NEAR(double(world[body].velocity().y), exact, 1e-4);
        EXPECT_NEAR(exact, -5, 0.1);
    }
}

// A crate at rest presses with its whole weight, so damping changes no friction: it slides down a
// slope of tan 0.5 only with a coefficient below that.
TEST(Damping, LeavesTheWeightOfABodyAtRest) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        const BodyId floor = support::addFloor(world);
        BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1);
        def.linearDamping = 20;
        const BodyId box = world.add(def);
        support::run(world, 20);
        const CollisionRecord* const record = support::recordOf(world, floor, box);
        ASSERT_NE(record, nullptr);
        EXPECT_TRUE(near(record->totalImpulse, 10 * world[box].mass() * kDt, 1e-3));
    }
}

TEST(Damping, LeavesKinematicAndLockedMotionAlone) {
    World world;
    BodyDef def = moving(5, 5);
    def.type = BodyType::Kinematic;
    const BodyId platform = world.add(def);
    def = moving(5, 5);
    def.flags = kLockMove;
    def.velocity = {};
    const BodyId wheel = world.add(def);
    support::run(world, 60);
    EXPECT_EQ(world[platform].velocity(), (Vec2{3, -4}));
    EXPECT_EQ(world[platform].angularVelocity(), 2);
    EXPECT_TRUE(near(world[wheel].angularVelocity(), 2 * std::exp(-5.0), 1e-4));
}

// Two gravities, scaled; a force of the user is not.
TEST(GravityScale, ScalesAllGravityAndNothingElse) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        world.addField({std::make_shared<Gravity>(Vec2{2, 0})});
        for (const Real scale : {Real(-1), Real(0), Real(0.5), Real(3)}) {
            BodyDef def = support::ballDef({20 * scale, 0}, Real(0.5));
            def.gravityScale = scale;
            const BodyId body = world.add(def);
            support::run(world, 30);
            EXPECT_TRUE(near(world[body].velocity().y, -5 * scale, 1e-4)) << scale;
            EXPECT_TRUE(near(world[body].velocity().x, scale, 1e-4)) << scale;
        }
        const BodyId pushed = world.add(support::ballDef({-50, 0}, Real(0.5)));
        world[pushed].setGravityScale(0);
        world[pushed].applyForce({world[pushed].mass() * 60, 0});
        world.step(kDt);
        EXPECT_TRUE(near(world[pushed].velocity().x, 1, 1e-5));
        EXPECT_EQ(world[pushed].velocity().y, 0);
    }
}

TEST(GravityScale, OfASleepingBodyWakesItWhenItChanges) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    support::run(world, 120);
    ASSERT_TRUE(world[box].isAsleep());
    world[box].setGravityScale(-1);
    support::run(world, 60);
    EXPECT_GT(world[box].position().y, 4);
}

// Clones, copies, welded parts and snapshots keep all four; a part that never was a body moves on
// as the whole did.
TEST(MotionRules, GoWithTheBody) {
    World world;
    BodyDef def = moving(Real(0.5), Real(0.25));
    def.gravityScale = -2;
    def.continuousMode = ContinuousMode::Static;
    const BodyId body = world.add(def);
    const auto expectSame = [&](const BodyView& other) {
        EXPECT_EQ(other.linearDamping(), Real(0.5));
        EXPECT_EQ(other.angularDamping(), Real(0.25));
        EXPECT_EQ(other.gravityScale(), -2);
        EXPECT_EQ(other.continuousMode(), ContinuousMode::Static);
    };
    expectSame(world[body]);
    expectSame(world[world.clone(body, {5, 5})]);
    const BodyId other = world.add(support::boxDef({20, 20}, 1, 1));
    world[other].copyFrom(world[body]);
    expectSame(world[other]);
    const BodyId into = world.add(support::boxDef({-20, 0}, 1, 1));
    const std::size_t part = world.weld(into, body);
    EXPECT_EQ(world[into].linearDamping(), 0);
    EXPECT_EQ(world[into].continuousMode(), ContinuousMode::All);
    World read = fromBytes(toBytes(world));
    EXPECT_EQ(read.stateHash(), world.stateHash());
    expectSame(std::as_const(read)[other]);
    expectSame(world[world.unweld(into, part)]);
    expectSame(read[read.unweld(into, part)]);
    const std::size_t fresh = world.weld(other, Circle{Real(0.25)}, {}, 1);
    expectSame(world[world.unweld(other, fresh)]);
    support::run(world, 20);
    World again = fromBytes(toBytes(world));
    support::run(world, 20);
    support::run(again, 20);
    EXPECT_EQ(again.stateHash(), world.stateHash());
}

TEST(MotionRules, CountInTheHash) {
    World world;
    const BodyId body = world.add(moving(0));
    world[body].setGravityScale(1); // its load may have changed: counts, too
    const std::uint64_t plain = world.stateHash();
    world[body].setLinearDamping(1);
    EXPECT_NE(world.stateHash(), plain);
    world[body].setLinearDamping(0);
    EXPECT_EQ(world.stateHash(), plain);
    world[body].setAngularDamping(1);
    EXPECT_NE(world.stateHash(), plain);
    world[body].setAngularDamping(0);
    world[body].setGravityScale(0);
    EXPECT_NE(world.stateHash(), plain);
    world[body].setGravityScale(1);
    EXPECT_EQ(world.stateHash(), plain);
    world[body].setContinuousMode(ContinuousMode::Never);
    EXPECT_NE(world.stateHash(), plain);
}

TEST(MotionRules, AreRefusedByNameIfOutOfRange) {
    World world;
    const BodyId body = world.add(moving(0));
    const auto fieldOf = [](auto change) {
        try {
            change();
        } catch (const BadDefinition& error) {
            return error.problem().field;
        }
        return std::string();
    };
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(fieldOf([&] { world[body].setLinearDamping(-1); }), "linearDamping");
    EXPECT_EQ(fieldOf([&] { world[body].setAngularDamping(2 * kMaxDamping); }), "angularDamping");
    EXPECT_EQ(fieldOf([&] { world[body].setGravityScale(nan); }), "gravityScale");
    EXPECT_EQ(fieldOf([&] { world.add(moving(nan)); }), "linearDamping");
    EXPECT_EQ(fieldOf([&] { world.add(moving(0, -1)); }), "angularDamping");
    EXPECT_EQ(world[body].linearDamping(), 0);
    EXPECT_EQ(fieldOf([&] { world[body].setLinearDamping(kMaxDamping); }), "");
    world.step(kDt);
    EXPECT_EQ(world[body].velocity(), Vec2{});
}

} // namespace
} // namespace kodo
