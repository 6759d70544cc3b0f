// SPDX-License-Identifier: MIT
#include <kodo/shape.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

const Real kTooLarge = std::numeric_limits<Real>::max() / 2;

struct BadShape {
    const char* name;
    Shape shape;
    const char* field;
    const char* says; // part of the reason
};

std::ostream& operator<<(std::ostream& out, const BadShape& bad) {
    return out << bad.name;
}

class RefusedShape : public testing::TestWithParam<BadShape> {};

// P3: a named error for every polygon that is not strictly convex and counter-clockwise.
TEST_P(RefusedShape, NamesTheFieldAndTheReason) {
    const auto problem = check(GetParam().shape);
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(problem->field, GetParam().field);
    EXPECT_NE(problem->reason.find(GetParam().says), std::string::npos) << problem->reason;
}

Polygon withManyCorners(std::size_t n) {
    support::RandomNumbers random(1);
    return support::randomPolygon(random, n);
}

const BadShape kBadShapes[] = {
    {"ZeroRadius", Circle{0}, "radius", "greater than 0"},
    {"NegativeRadius", Circle{-1}, "radius", "-1"},
    {"NanRadius", Circle{kNan}, "radius", "nan"},
    {"InfiniteRadius", Circle{kInf}, "radius", "inf"},
    {"NanCircleCenter", Circle{1, {kNan, 0}}, "center", "nan"},
    {"ZeroWidth", Box{0, 1}, "width", "greater than 0"},
    {"NegativeWidth", Box{-2, 1}, "width", "-2"},
    {"NanHeight", Box{1, kNan}, "height", "nan"},
    {"InfiniteHeight", Box{1, kInf}, "height", "inf"},
    {"NanBoxCenter", Box{1, 1, {0, kNan}}, "center", "nan"},
    // Values whose products would overflow.
    {"RadiusBeyondSquares", Circle{kTooLarge}, "radius", "at most 1e"},
    {"WidthBeyondSquares", Box{kTooLarge, 1}, "width", "at most 1e"},
    {"CircleTooFarOff", Circle{1, {0, -kTooLarge}}, "center", "to 1e"},
    {"CornerTooFarOff", Polygon{{{0, 0}, {kTooLarge, 0}, {0, 1}}}, "corners[1]", "to 1e"},
    {"PointTooFarOff", Point{{kTooLarge, 0}}, "position", "to 1e"},
    {"EndTooFarOff", Segment{{0, 0}, {kTooLarge, 0}}, "to", "to 1e"},
    {"PlaneTooFarOff", Plane{{0, 1}, kTooLarge}, "offset", "to 1e"},
    {"HeightTooFarOff", Heightmap{{}, 1, {0, kTooLarge}}, "heights[1]", "to 1e"},
    {"BoxRotationNotUnit", Box{1, 1, {}, {1, 1}}, "rotation", "{cosine, sine}"},
    {"BoxRotationNan", Box{1, 1, {}, {kNan, 0}}, "rotation", "{cosine, sine}"},
    {"NoCorners", Polygon{}, "corners", "from 3 to 1024 points, but there are 0"},
    {"TwoCorners", Polygon{{{0, 0}, {1, 0}}}, "corners", "but there are 2"},
    {"TooManyCorners", withManyCorners(1025), "corners", "but there are 1025"},
    {"NanCorner", Polygon{{{0, 0}, {1, 0}, {0, kNan}}}, "corners[2]", "nan"},
    {"Clockwise", Polygon{{{0, 0}, {0, 1}, {1, 0}}}, "corners", "go clockwise"},
    {"Duplicate", Polygon{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}, "corners[2]", "same point"},
    {"DuplicateOfTheFirst", Polygon{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}, "corners[3]", "same point"},
    {"Collinear", Polygon{{{0, 0}, {1, 0}, {2, 0}}}, "corners[2]", "line from"},
    {"OneCornerOnAnEdge", Polygon{{{0, 0}, {1, 0}, {2, 0}, {2, 2}}}, "corners[2]", "line from"},
    {"Concave", Polygon{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, "corners[2]", "inwards"},
    {"ConcaveClockwise", Polygon{{{0, 4}, {1, 1}, {4, 0}, {0, 0}}}, "corners", "go clockwise"},
    {"Crossing", Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, "corners[2]",
     "crosses the edge from corner 0"},
    {"TwiceAround",
     Polygon{{{1, 0},
              {Real(-0.8), Real(0.6)},
              {Real(0.3), -1},
              {Real(0.3), 1},
              {Real(-0.8), Real(-0.6)}}},
     "corners[2]", "crosses the edge from corner 0"},
    {"EmptyCompound", Compound{}, "parts", "from 1 to 65535 primitives, but there are 0"},
    {"BadPart", Compound{{Circle{1}, Box{1, 0}}}, "parts[1].height", "greater than 0"},
    {"BadCornerOfAPart", Compound{{Polygon{{{0, 0}, {1, 0}, {kInf, 1}}}}}, "parts[0].corners[2]",
     "inf"},
};

INSTANTIATE_TEST_SUITE_P(Shapes, RefusedShape, testing::ValuesIn(kBadShapes),
                         [](const testing::TestParamInfo<BadShape>& row) {
                             return std::string(row.param.name);
                         });

TEST(CheckShape, AcceptsValidShapes) {
    EXPECT_FALSE(check(Shape(Circle{1})).has_value());
    EXPECT_FALSE(check(Shape(Box{1, 2, {3, 4}, {0, 1}})).has_value());
    EXPECT_FALSE(check(Shape(Polygon{{{0, 0}, {1, 0}, {0, 1}}})).has_value());
    EXPECT_FALSE(check(Shape(Compound{{Circle{1}, Box{1, 1}}})).has_value());
    EXPECT_FALSE(check(Shape(Circle{kMaxLength, {kMaxLength, -kMaxLength}})).has_value());
}

TEST(CheckShape, AcceptsRandomConvexPolygons) {
    support::RandomNumbers random(41);
    for (int i = 0; i < 500; ++i) {
        const Shape shape = support::randomPolygon(random, 3 + random.below(62));
        const auto problem = check(shape);
        ASSERT_FALSE(problem.has_value()) << problem->text();
    }
}

// P3: the result does not depend on the corner at which the list starts.
TEST(CheckShape, DoesNotDependOnTheFirstCorner) {
    const std::vector<Vec2> concave{{0, 0}, {4, 0}, {1, 1}, {0, 4}};
    const std::vector<Vec2> convex{{0, 0}, {4, 0}, {3, 3}, {0, 4}};
    for (std::size_t first = 0; first < 4; ++first) {
        Polygon bad;
        Polygon good;
        for (std::size_t i = 0; i < 4; ++i) {
            bad.corners.push_back(concave[(first + i) % 4]);
            good.corners.push_back(convex[(first + i) % 4]);
        }
        EXPECT_TRUE(check(Shape(bad)).has_value());
        EXPECT_FALSE(check(Shape(good)).has_value());
    }
}

} // namespace
} // namespace kodo
