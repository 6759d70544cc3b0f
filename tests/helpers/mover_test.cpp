// SPDX-License-Identifier: MIT
#include <helpers/mover_scenes.hpp>

#include <cmath>
#include <limits>

namespace kodo {
namespace {

using support::addStatic;
using support::ground;
using support::kGravity;
using support::kShapes;
using support::kStep;
using support::standing;
using support::tick;

TEST(Mover, WalksOnSlopesWithTheWishedSpeedAndStaysGrounded) {
    for (const Primitive& shape : kShapes) {
        for (const Real angle : {Real(-0.8), Real(-0.4), Real(0), Real(0.3), Real(0.8)}) {
            World world;
            addStatic(world, Box{100, 1}, {}, angle);
            Mover mover = standing(world, shape, {0, 4});
            const Vec2 from = mover.position;
            for (int i = 0; i < 60; ++i) {
                tick(world, mover, 4);
                ASSERT_TRUE(mover.grounded) << angle << " tick " << i;
                ASSERT_EQ(mover.velocity.y, 0);
            }
            const Vec2 way = mover.position - from;
            EXPECT_NEAR(length(way), 4, 0.02) << angle; // 1 s; the gap varies by a part of skin
            EXPECT_NEAR(way.y / way.x, std::tan(angle), 0.005);
            EXPECT_EQ(mover.velocity.x, 4);
        }
    }
}

// godotengine/godot#25074 and #50732: bodies that slide down a slope on which they should stand.
TEST(Mover, StandsOnASlopeWithoutAnyMotion) {
    for (const Primitive& shape : kShapes) {
        for (const Real angle : {Real(0), Real(0.2), Real(0.5), Real(0.85)}) {
            World world;
            addStatic(world, Box{100, 1}, {}, angle);
            Mover mover = standing(world, shape, {0, 4});
            const Vec2 from = mover.position;
            for (int i = 0; i < 600; ++i) {
                tick(world, mover, 0);
            }
            EXPECT_EQ(mover.position, from) << angle;
        }
    }
}

TEST(Mover, SlidesDownASlopeAboveTheLimitByGravityAlone) {
    for (const Primitive& shape : kShapes) {
        World world;
        const Real angle = Real(1.1);
        addStatic(world, Box{200, 1}, {}, angle);
        Mover mover{.shape = shape, .position = {0, 2}};
        for (int i = 0; i < 30; ++i) {
            tick(world, mover, mover.velocity.x);
        }
        const Vec2 before = mover.velocity;
        for (int i = 0; i < 30; ++i) {
            tick(world, mover, mover.velocity.x);
            ASSERT_FALSE(mover.grounded);
        }
        // g sin(angle) along the slope
        EXPECT_NEAR(length(mover.velocity - before), kGravity * std::sin(angle) / 2, 0.02);
    }
}

// dimforge/rapier.js#274: a controller that climbs slopes of any angle.
TEST(Mover, DoesNotClimbASlopeAboveTheLimit) {
    for (const Primitive& shape : kShapes) {
        World world;
        addStatic(world, ground({{-10, 0}, {0, 0}, {5, Real(9)}}));
        Mover mover = standing(world, shape, {-3, 1});
        const Real floor = mover.position.y;
        for (int i = 0; i < 240; ++i) {
            tick(world, mover, 6, i % 60 == 0 ? Real(4) : Real(0)); // it hops, too
        }
        EXPECT_LT(mover.position.y, floor + Real(0.7)); // v^2 / 2g = 0.4 m of the hop
        EXPECT_LT(mover.position.x, 1);
    }
}

TEST(Mover, JumpsByTheSquareOfSpeedOverTwiceGravity) {
    World world;
    addStatic(world, Plane{});
    Mover mover = standing(world, kShapes[1], {0, 2});
    const Real from = mover.position.y;
    Real top = from;
    tick(world, mover, 0, 8);
    EXPECT_FALSE(mover.grounded);
    for (int i = 0; i < 60; ++i) {
        top = std::max(top, mover.position.y);
        tick(world, mover, 0);
    }
    // A sum of steps exceeds the integral by half a step of the first speed.
    EXPECT_NEAR(top - from, 8 * 8 / (2 * kGravity) + 8 * kStep / 2, 0.01);
    EXPECT_TRUE(mover.grounded);
    EXPECT_NEAR(mover.position.y, from, 0.002);
}

// godotengine/godot#50732: is_on_floor() that flickers over crests, and a launch at the top.
TEST(Mover, StaysOnTheGroundOverCrestsAndValleysAtAnySpeed) {
    for (const Primitive& shape : kShapes) {
        for (const Real speed : {Real(2), Real(10), Real(30)}) {
            World world;
            std::vector<Vec2> points;
            for (int i = 0; i < 60; ++i) {
                points.push_back(
                    {Real(2) * static_cast<Real>(i), i % 2 == 0 ? Real(0) : Real(1.5)});
            }
            addStatic(world, ground(points));
            Mover mover = standing(world, shape, {3, 3});
            while (mover.position.x < 110) {
                const Real before = mover.position.x;
                tick(world, mover, speed);
                ASSERT_TRUE(mover.grounded) << speed << " at " << mover.position.x;
                ASSERT_GT(mover.position.x, before);
            }
        }
    }
}

// godotengine/godot#87477: bodies that get stuck below a ceiling of tiles.
TEST(Mover, GlidesOverAndUnderSeamsOfTiles) {
    for (const Primitive& shape : kShapes) {
        World world;
        for (int i = 0; i < 40; ++i) {
            addStatic(world, Box{1, 1}, {static_cast<Real>(i), Real(-0.5)});
            addStatic(world, Box{1, 1}, {static_cast<Real>(i), 3});
        }
        Mover mover = standing(world, shape, {1, 1});
        for (int i = 0; i < 120; ++i) {
            tick(world, mover, 5);
            ASSERT_TRUE(mover.grounded);
            ASSERT_EQ(mover.velocity.x, 5);
        }
        EXPECT_NEAR(mover.position.x, 11, 0.01);
        const Real from = mover.position.x;
        for (int i = 0; i < 120; ++i) { // pressed to the ceiling
            world.step(kStep);
            mover.move(world, {5, 6}, kStep);
            ASSERT_EQ(mover.velocity.x, 5);
        }
        EXPECT_NEAR(mover.position.x - from, 10, 0.01);
        EXPECT_FALSE(mover.grounded);
    }
}

// pmndrs/react-three-rapier#702 and godotengine/godot#50732: stairs that stop or shake characters.
TEST(Mover, ClimbsAndDescendsStairsOnTheGround) {
    for (const Primitive& shape : kShapes) {
        for (const Real speed : {Real(0.5), Real(3), Real(8)}) {
            World world;
            std::vector<Vec2> points{{-10, 0}};
            for (int i = 0; i < 10; ++i) {
                const Real height = Real(0.25) * static_cast<Real>(i);
                points.push_back({static_cast<Real>(i), height});
                points.push_back({static_cast<Real>(i), height + Real(0.25)});
            }
            points.push_back({20, Real(2.5)});
            addStatic(world, ground(points));
            Mover mover = standing(world, shape, {-2, 1});
            const Real floor = mover.position.y;
            const auto walkTo = [&](Real x, Real direction) {
                for (int i = 0; i < 4000 && direction * (x - mover.position.x) > 0; ++i) {
                    tick(world, mover, direction * speed);
                    ASSERT_TRUE(mover.grounded) << speed << " at " << mover.position.x;
                }
                ASSERT_LE(direction * (x - mover.position.x), 0)
                    << "shape " << shape.index() << " speed " << speed << " stuck at "
                    << mover.position.x;
            };
            walkTo(11, 1);
            EXPECT_NEAR(mover.position.y, floor + Real(2.5), 0.02);
            walkTo(-2, -1);
            EXPECT_NEAR(mover.position.y, floor, 0.02);
        }
    }
}

TEST(Mover, DoesNotClimbWhatIsHigherThanAStep) {
    // Not the polygon: its sides are flat enough to slide over the corner.
    for (const Primitive& shape : {kShapes[0], kShapes[1], kShapes[2]}) {
        World world;
        addStatic(world, ground({{-10, 0}, {0, 0}, {0, Real(0.4)}, {10, Real(0.4)}}));
        Mover mover = standing(world, shape, {-2, 1});
        const Real floor = mover.position.y;
        for (int i = 0; i < 200; ++i) {
            tick(world, mover, 4);
        }
        EXPECT_NEAR(mover.position.y, floor, 0.01);
        EXPECT_LT(mover.position.x, 0);
        EXPECT_LT(mover.wallNormal.x, 0);
        EXPECT_TRUE(mover.grounded);
        mover.stepHeight = Real(0.45);
        for (int i = 0; i < 60; ++i) {
            tick(world, mover, 4);
        }
        EXPECT_GT(mover.position.x, 1);
    }
}

// erincatto/box2d#1032: the round end of a capsule climbs corners with enough speed.
TEST(Mover, DoesNotRiseAtACornerThatItMeetsInTheAir) {
    World world;
    addStatic(world, Box{10, 4}, {5, 0}); // its corner at (0, 2)
    for (int i = 0; i < 20; ++i) {
        Mover mover{.shape = kShapes[1],
                    .position = {-2, Real(2.02) + Real(0.02) * static_cast<Real>(i)}};
        const Real from = mover.position.y;
        for (int k = 0; k < 20; ++k) {
            tick(world, mover, 30);
            ASSERT_LE(mover.position.y, from + Real(1e-4));
            if (mover.grounded) {
                break;
            }
        }
    }
}

TEST(Mover, WedgedBetweenSteepSlopesCanJump) {
    World world;
    addStatic(world, ground({{-3, 9}, {0, 0}, {3, 9}}));
    Mover mover{.position = {Real(0.1), 5}};
    for (int i = 0; i < 120; ++i) {
        tick(world, mover, 0);
    }
    EXPECT_TRUE(mover.grounded);
    const Real from = mover.position.y;
    tick(world, mover, 0, 8);
    EXPECT_GT(mover.position.y, from + Real(0.1));
}

TEST(Mover, PassesALedgeFromBelowAndLandsOnIt) {
    for (const Primitive& shape : kShapes) {
        World world;
        addStatic(world, Plane{});
        addStatic(world, Segment{{-3, 2}, {3, 2}, true});
        Mover mover = standing(world, shape, {0, 1});
        tick(world, mover, 1, 12);
        for (int i = 0; i < 120; ++i) {
            tick(world, mover, Real(0.1));
        }
        EXPECT_TRUE(mover.grounded);
        EXPECT_GT(mover.position.y, 2);
        EXPECT_LT(mover.position.y, Real(2.95));
    }
}

TEST(Mover, PassesPartsThatAreSensorsAndStopsAtTheRestOfTheirBody) {
    World world;
    addStatic(world, Plane{});
    const BodyId gate = world.add(
        {.shape = Compound{{Box{1, 6, {0, 0}}, Box{1, 6, {4, 0}}}}, .type = BodyType::Static});
    Part open = world[gate].part(0);
    open.filter = CollisionFilter{kSensor};
    world[gate].setPart(0, open);
    Mover mover = standing(world, kShapes[0], {-3, 1});
    for (int i = 0; i < 180; ++i) {
        tick(world, mover, 4);
    }
    EXPECT_NEAR(mover.position.x, 3.1, 0.02); // side of the second part, less radius and skin
    EXPECT_LT(mover.wallNormal.x, 0);
}

TEST(Mover, RefusesBadNumbersAndChangesNothing) {
    World world;
    const auto refused = [&](Mover mover) {
        const Vec2 from = mover.position;
        EXPECT_THROW(mover.move(world, {1, 0}, kStep), BadDefinition);
        EXPECT_EQ(mover.position, from);
    };
    refused({.shape = Plane{}});
    refused({.shape = Circle{0}});
    refused({.up = {0, 2}});
    refused({.slopeLimit = Real(1.6)});
    refused({.stepHeight = -1});
    refused({.skin = 0});
    refused({.pushForce = -1});
    Mover mover;
    EXPECT_THROW(mover.move(world, {std::numeric_limits<Real>::quiet_NaN(), 0}, kStep),
                 BadDefinition);
    EXPECT_THROW(mover.move(world, {}, 0), BadDefinition);
}

} // namespace
} // namespace kodo
