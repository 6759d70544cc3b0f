// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include "collide/chain_line.hpp"
#include "collide/one_sided.hpp"
#include "collide/time_of_impact.hpp"

#include <algorithm>

namespace kodo::one_sided_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;

constexpr Real kMargin = Real(1) / 64;
constexpr Real kTolerance = byPrecision(5e-6, 1e-14);

Segment platform() {
    return {{-2, 0}, {2, 0}, true};
}

// F2, C1: in random poses, a platform has the contact of a two-sided line with a normal towards its
// front, or none. A shape whose middle is behind passes. For a thin shape the limit is some way
// behind, since it may lie on the line and overlap it.
TEST(OneSided, HasNormalsTowardsItsFrontOrNoContact) {
    support::RandomNumbers random(121);
    int pushed = 0;
    int passed = 0;
    for (int i = 0; i < 40000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "pose " << i);
        Segment segment = support::randomSegment(random);
        const ConvexShape twoSided = convexShapeOf(segment, {});
        segment.oneSided = true;
        const ConvexShape line = convexShapeOf(segment, {});
        constexpr AnyKind kOthers[] = {AnyKind::Circle, AnyKind::Box, AnyKind::Polygon,
                                       AnyKind::Segment};
        const ConvexShape other =
            convexShapeOf(support::randomPrimitive(random, kOthers[i % 4]), {});
        const Transform a = random.pose(4);
        const Transform b{a.position + random.point(2), random.rotation()};
        const Manifold both = collide(twoSided, a, other, b, kMargin, 0);
        const Manifold front = collide(line, a, other, b, kMargin, 0);
        const Vec2 normal = a.rotation * line.normals[1];
        const Real height = dot(normal, b * other.middle - a * line.vertices[0]);
        const Real sink = std::max(kMargin / 4 - other.coreRadius, Real(0)); // of thin shapes
        if (height < -kTolerance - sink) {
            ASSERT_EQ(front.count, 0);
            ASSERT_TRUE(front.fromBehind);
            ++passed;
        } else if (front.count > 0) {
            ASSERT_GT(dot(front.normal, normal), 0);
            ASSERT_GT(both.count, 0);
            ASSERT_LE(front.points[0].separation, both.points[0].separation + kTolerance);
            ++pushed;
        }
        if (height > kTolerance && both.count > 0 && dot(both.normal, normal) > kTolerance) {
            ASSERT_EQ(front.count, both.count);
            ASSERT_TRUE(near(front.normal, both.normal, kTolerance));
        }
    }
    EXPECT_GT(pushed, 4000);
    EXPECT_GT(passed, 10000);
}

TEST(OneSided, LetsShapesBehindItPass) {
    const ConvexShape line = convexShapeOf(platform(), {});
    const ConvexShape ball = convexShapeOf(Circle{1}, {});
    for (const Real y : {Real(-3), Real(-1), Real(-0.25)}) {
        const Manifold manifold = collide(line, {}, ball, {{0, y}, {}}, kMargin, 0);
        EXPECT_EQ(manifold.count, 0);
        EXPECT_TRUE(manifold.fromBehind) << "also when it is far away";
    }
    const Manifold over = collide(line, {}, ball, {{0, Real(0.75)}, {}}, kMargin, 0);
    EXPECT_EQ(over.count, 1);
    EXPECT_EQ(over.normal, (Vec2{0, 1}));
    EXPECT_EQ(over.points[0].separation, Real(-0.25));
}

// A box that hits the end of a platform from the side does not come from its front.
TEST(OneSided, LetsShapesFromBeyondAnEndPass) {
    const ConvexShape line = convexShapeOf(platform(), {});
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const Manifold beside = collide(line, {}, box, {{Real(2.875), Real(0.5)}, {}}, kMargin, 0);
    EXPECT_EQ(beside.count, 0);
    EXPECT_TRUE(beside.fromBehind);
    // A box that slides on from flush ground counts as above.
    const Manifold onto = collide(line, {}, box, {{Real(2.999), Real(0.995)}, {}}, kMargin, 0);
    EXPECT_FALSE(onto.fromBehind);
    EXPECT_EQ(onto.normal, (Vec2{0, 1}));
}

// A shape from behind stays free until it no longer overlaps, although its middle is in front by
// then.
TEST(OneSided, LetsAPassingShapePassUntilItIsOut) {
    const ConvexShape line = convexShapeOf(platform(), {});
    const ConvexShape ball = convexShapeOf(Circle{1}, {});
    bool passing = false;
    const auto at = [&](Real y) {
        Manifold manifold = collide(line, {}, ball, {{0, y}, {}}, kMargin, 0);
        passing = letPass(passing, manifold);
        return manifold.count;
    };
    EXPECT_EQ(at(Real(-0.5)), 0);
    EXPECT_TRUE(passing);
    EXPECT_EQ(at(Real(0.5)), 0) << "half out";
    EXPECT_TRUE(passing);
    EXPECT_EQ(at(Real(0.25)), 0) << "falling back";
    EXPECT_EQ(at(Real(1.005)), 1) << "out, and near";
    EXPECT_FALSE(passing);
    EXPECT_EQ(at(Real(0.75)), 1) << "landed";
    EXPECT_FALSE(passing);
}

TEST(OneSided, TouchesAnotherOnlyFrontToFront) {
    const ConvexShape up = convexShapeOf(platform(), {});
    const ConvexShape down = convexShapeOf(Segment{{2, 0}, {-2, 0}, true}, {});
    const Transform above{{0, kMargin / 2}, {}};
    EXPECT_GT(collide(up, {}, down, above, kMargin, 0).count, 0);
    EXPECT_EQ(collide(up, {}, up, above, kMargin, 0).count, 0);
    EXPECT_TRUE(collide(up, {}, up, above, kMargin, 0).fromBehind);
}

TEST(OneSided, TouchesAPlaneOnlyWithItsFront) {
    const ConvexShape plane = convexShapeOf(Plane{}, {});
    const ConvexShape down = convexShapeOf(Segment{{2, 0}, {-2, 0}, true}, {});
    EXPECT_EQ(collide(plane, {}, down, {}, kMargin, 0).count, 2);
    const ConvexShape up = convexShapeOf(platform(), {});
    EXPECT_EQ(collide(plane, {}, up, {}, kMargin, 0).count, 0);
    EXPECT_TRUE(collide(up, {}, plane, {}, kMargin, 0).fromBehind);
}

// Only a shape from the front has a time of impact, which is the closed form.
TEST(OneSided, HasATimeOfImpactOnlyFromItsFront) {
    const ConvexShape line = convexShapeOf(platform(), {});
    const ConvexShape shapes[] = {convexShapeOf(Circle{1}, {}), convexShapeOf(Box{2, 2}, {})};
    constexpr Real kTarget = Real(1) / 1024;
    const MotionPath still{};
    for (const ConvexShape& shape : shapes) {
        const MotionPath falling{{{0, 3}, {}}, {0, -8}};
        const Real t = timeOfImpact(line, still, shape, falling, kTarget);
        EXPECT_TRUE(near(t, (2 - kTarget) / 8, kTarget / 8));
        EXPECT_EQ(timeOfImpact(shape, falling, line, still, kTarget), t);
        const MotionPath rising{{{0, -3}, {}}, {0, 8}};
        EXPECT_GT(timeOfImpact(line, still, shape, rising, kTarget), 1);
        const MotionPath beside{{{-6, Real(-0.5)}, {}}, {8, 0}};
        EXPECT_GT(timeOfImpact(line, still, shape, beside, kTarget), 1);
    }
    // At a free end the normal points from the end to the centre.
    const MotionPath atEnd{{{Real(2.6), 3}, {}}, {0, -8}};
    const Real t = timeOfImpact(line, still, shapes[0], atEnd, kTarget);
    EXPECT_TRUE(near(t, (3 - 0.8L) / 8, kTarget));
}

// A shape on the tread of a step is beside the riser too, once it has sunk a little.
TEST(OneSided, WhatSinksOnTheNeighbourOfAHilltopIsNotBehindTheLine) {
    ConvexShape riser = convexShapeOf(Segment{{0, 0}, {0, 1}}, {});
    riser.after = {1, 0};
    riser.valleyAfter = 2;
    const Vec2 sunk{Real(0.75), Real(0.9375)};
    EXPECT_EQ(heightOverJoints(riser, sunk, Real(0.125)), Real(-0.0625));
    EXPECT_EQ(heightOverJoints(riser, sunk, 0), Real(-0.0625)); // the tread is nearer
    EXPECT_EQ(heightOverJoints(riser, {Real(0.75), Real(1.25)}, 0), Real(0.25));
    ConvexShape reversed = convexShapeOf(Segment{{0, 1}, {0, 0}}, {});
    reversed.before = {-1, 0};
    reversed.valleyBefore = 2;
    EXPECT_EQ(heightOverJoints(reversed, sunk, Real(0.125)), Real(0.0625));
}

// Regression: beside one side of a sharp hilltop, a point counted as behind the other side.
TEST(OneSided, APointBesideASharpHilltopIsInFrontOfBothOfItsSides) {
    ConvexShape left = convexShapeOf(Segment{{-1, -4}, {0, 0}}, {});
    left.after = Vec2{1, -4} / std::sqrt(Real(17));
    left.valleyAfter = std::sqrt(Real(17));
    const Vec2 outside{Real(0.75), -2};
    EXPECT_TRUE(near(heightOverJoints(left, outside, 0), 1 / std::sqrt(17.0L), 1e-6L));
    EXPECT_LT(heightOverJoints(left, {Real(0.25), -2}, 0), 0); // below both
    EXPECT_LT(heightOverJoints(left, {Real(1.75), Real(-6)}, 0),
              0); // farther than the neighbour
    ConvexShape swapped = convexShapeOf(Segment{{0, 0}, {-1, -4}}, {}); // a valley from its front
    swapped.before = -left.after;
    swapped.valleyBefore = left.valleyAfter;
    EXPECT_TRUE(near(heightOverJoints(swapped, outside, 0), -1 / std::sqrt(17.0L), 1e-6L));
}

TEST(OneSided, APointFartherThanTheNeighboursIsMovedAlongTheWayToTheLine) {
    ConvexShape line = convexShapeOf(Segment{{0, 0}, {1, 0}}, {});
    line.after = {1, 0};
    line.valleyAfter = 2;
    EXPECT_EQ(withinJoints(line, {2, 1}, {0, 1}), (Vec2{2, 1}));
    EXPECT_EQ(withinJoints(line, {5, 1}, {1, 1}), (Vec2{3, 1}));
    EXPECT_EQ(withinJoints(line, {5, 1}, {4, 1}), (Vec2{4, 1}));
    EXPECT_EQ(withinJoints(line, {-5, 1}, {0, 1}), (Vec2{-5, 1})); // beyond a free end
}

} // namespace
} // namespace kodo::one_sided_test
