// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::byPrecision;
using support::kDt;
using support::near;
using support::slippery;

BodyDef paddleDef() {
    BodyDef def = support::boxDef({0, 0}, 3, Real(0.5), slippery(1));
    def.type = BodyType::Kinematic;
    return def;
}

// A kinematic body reaches the target to rounding, also through an obstacle.
TEST(MoveTo, ReachesTheTargetInOneStep) {
    World world({.gravity = support::kEarth});
    const BodyId paddle = world.add(paddleDef());
    world.add(ballDef({2, 0}, Real(0.4)));
    const Vec2 target{Real(1.7), Real(-0.3)};
    const Rot turned = Rot::fromAngle(Real(0.4));
    world[paddle].moveTo(target, turned, kDt);
    world.step(kDt);
    EXPECT_TRUE(near(world[paddle].position(), target, 10 * support::kEpsilon));
    EXPECT_TRUE(near(world[paddle].rotation().s, turned.s, 10 * support::kEpsilon));
}

// The shape frame reaches the target, also with the centre of mass elsewhere.
TEST(MoveTo, MovesTheShapeFrameOfACompoundToTheTarget) {
    World world;
    const Compound hammer{{Box{2, Real(0.2), {1, 0}}, Box{Real(0.5), 1, {2, 0}}}};
    const BodyId id = world.add({.shape = hammer, .type = BodyType::Kinematic});
    world[id].moveTo({3, 4}, Rot::fromAngle(Real(1.2)), kDt);
    world.step(kDt);
    EXPECT_TRUE(near(world[id].position(), Vec2{3, 4}, 20 * support::kEpsilon));
    EXPECT_TRUE(near(world[id].rotation().angle(), Real(1.2), 20 * support::kEpsilon));
}

// With e = 1, a ball at rest leaves at twice the speed of the paddle.
TEST(MoveTo, AnElasticBallLeavesAtTwiceItsSpeed) {
    World world;
    const BodyId paddle = world.add(paddleDef());
    const BodyId ball = world.add(ballDef({3, 0}, Real(0.5), slippery(1)));
    for (int i = 1; i <= 60; ++i) {
        world[paddle].moveTo({static_cast<Real>(i) * 3 * kDt, 0}, kDt); // 3 m/s
        world.step(kDt);
    }
    EXPECT_TRUE(near(world[ball].velocity(), Vec2{6, 0}, byPrecision(5e-5, 1e-12)));
}

// An oncoming ball: v' = 2 u - v.
TEST(MoveTo, AnElasticBallIsReflectedRelativeToItsVelocity) {
    World world;
    const BodyId paddle = world.add(paddleDef());
    BodyDef def = ballDef({6, 0}, Real(0.5), slippery(1));
    def.velocity = {-5, 0};
    const BodyId ball = world.add(def);
    for (int i = 1; i <= 60; ++i) {
        world[paddle].moveTo({static_cast<Real>(i) * 2 * kDt, 0}, kDt);
        world.step(kDt);
    }
    EXPECT_TRUE(near(world[ball].velocity(), Vec2{9, 0}, byPrecision(5e-5, 1e-12)));
}

TEST(MoveTo, TheRecordHoldsItsApproachSpeed) {
    World world;
    const BodyId paddle = world.add(paddleDef());
    const BodyId ball = world.add(ballDef({3, 0}, Real(0.5), slippery(1)));
    Real approach = 0;
    for (int i = 1; i <= 60; ++i) {
        world[paddle].moveTo({static_cast<Real>(i) * 3 * kDt, 0}, kDt);
        world.step(kDt);
        if (const CollisionRecord* hit = support::recordOf(world, paddle, ball)) {
            approach = std::max(approach, hit->approachSpeed);
        }
    }
    EXPECT_TRUE(near(approach, 3, byPrecision(5e-5, 1e-12)));
}

TEST(MoveTo, KeepsItsVelocityUntilItIsChanged) {
    World world;
    const BodyId paddle = world.add(paddleDef());
    world[paddle].moveTo({1, 0}, kDt);
    world.step(kDt);
    world.step(kDt);
    EXPECT_TRUE(near(world[paddle].position(), Vec2{2, 0}, 10 * support::kEpsilon));
    world[paddle].setVelocity({});
    world.step(kDt);
    EXPECT_TRUE(near(world[paddle].position(), Vec2{2, 0}, 10 * support::kEpsilon));
}

} // namespace
} // namespace kodo
