// SPDX-License-Identifier: MIT
#include <kodo/convex_shape.hpp>

#include "bodies/body_geometry.hpp"
#include "collide/chain_line.hpp"

#include <algorithm>
#include <vector>

namespace kodo {
namespace {

std::vector<ConvexShape> linesOf(const Shape& shape) {
    std::vector<Part> parts;
    for (const Primitive& primitive : primitivesOf(shape)) {
        parts.push_back({.primitive = primitive});
    }
    std::vector<ConvexShape> lines;
    const auto geometry = makeGeometry(std::move(parts));
    for (const Part& part : geometry->parts) {
        lines.push_back(part.convex);
    }
    return lines;
}

TEST(LineLinks, OneSidedSegmentsOfABodyAreLinkedInAnyOrder) {
    const Segment left{{-2, Real(0.3)}, {0, 0}, true};
    const Segment right{{0, 0}, {3, Real(0.7)}, true};
    for (const bool turned : {false, true}) {
        const auto lines = linesOf(turned ? Compound{{right, left}} : Compound{{left, right}});
        const ConvexShape& first = lines[turned ? 1 : 0];
        const ConvexShape& second = lines[turned ? 0 : 1];
        EXPECT_EQ(first.after, alongOf(second)) << "to the bit";
        EXPECT_EQ(second.before, alongOf(first));
        EXPECT_TRUE(isFree(first, 0) && isFree(second, 1));
        EXPECT_GT(first.valleyAfter, 3);
        EXPECT_GT(second.valleyBefore, 2);
    }
}

TEST(LineLinks, SegmentsThatFaceEachOtherAtAnEndAreNotLinked) {
    const auto lines = linesOf(Compound{
        {Segment{{-2, 0}, {0, 0}, true}, Segment{{2, 0}, {0, 0}, true}, Segment{{0, 0}, {0, 1}}}});
    EXPECT_TRUE(isFree(lines[0], 1));
    EXPECT_TRUE(isFree(lines[1], 1));
    EXPECT_TRUE(isFree(lines[2], 0));
}

TEST(LineLinks, WhereSeveralSegmentsBeginTheOneThatBendsMostToTheFrontIsNext) {
    const auto lines =
        linesOf(Compound{{Segment{{-1, 0}, {0, 0}, true}, Segment{{0, 0}, {1, -1}, true},
                          Segment{{0, 0}, {-1, 0}, true}, Segment{{0, 0}, {1, 1}, true}}});
    EXPECT_EQ(lines[0].after, alongOf(lines[3]));
    EXPECT_GT(turnAt(lines[0], 1), 0);
}

TEST(LineLinks, TheBackOfASegmentIsHalfATurnClockwise) {
    const auto lines =
        linesOf(Compound{{Segment{{0, 0}, {3, 1}, true}, Segment{{3, 1}, {0, 0}, true}}});
    for (const ConvexShape& line : lines) {
        EXPECT_EQ(turnAt(line, 0), -2);
        EXPECT_EQ(turnAt(line, 1), -2);
        EXPECT_EQ(line.valleyAfter, 0);
    }
}

TEST(LineLinks, TwoSidedSegmentsAreLinkedInPairs) {
    const auto two =
        linesOf(Compound{{Segment{{0, 0}, {2, 0}}, Segment{{3, 1}, {2, 0}}}}); // opposite ways
    EXPECT_EQ(two[0].after, -alongOf(two[1]));
    EXPECT_EQ(two[1].after, -alongOf(two[0]));
    const auto three = linesOf(
        Compound{{Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {4, 0}}, Segment{{2, 0}, {2, -1}}}});
    EXPECT_TRUE(isFree(three[0], 1) && isFree(three[1], 0) && isFree(three[2], 0));
}

TEST(LineLinks, AChainIsLinkedFromEndToEnd) {
    Chain chain{.points = {{0, 0}, {2, 0}, {3, 1}, {5, -1}}};
    for (const bool closed : {false, true}) {
        for (const bool oneSided : {false, true}) {
            chain.closed = closed;
            chain.oneSided = oneSided;
            const auto lines = linesOf(chain);
            EXPECT_EQ(lines.size(), closed ? 4u : 3u);
            const auto free = [](const ConvexShape& line) {
                return (isFree(line, 0) ? 1 : 0) + (isFree(line, 1) ? 1 : 0);
            };
            int ends = 0;
            for (const ConvexShape& line : lines) {
                ends += free(line);
            }
            EXPECT_EQ(ends, closed ? 0 : 2);
        }
    }
}

TEST(LineLinks, AClosedOneSidedChainHasItsFrontOutsideInEitherDirection) {
    Chain chain{.points = {{-1, -1}, {2, -1}, {1, 1}, {-1, 1}}, .closed = true, .oneSided = true};
    for (int i = 0; i < 2; ++i) {
        for (const ConvexShape& line : linesOf(chain)) {
            EXPECT_GT(dot(line.normals[1], line.middle), 0) << "the centre is inside";
            EXPECT_LT(turnAt(line, 0), 0);
        }
        std::reverse(chain.points.begin(), chain.points.end());
    }
}

// A valley of many lines, each of which must know how far it goes on: to both ends.
TEST(LineLinks, AValleyIsAsLongAsItsLinesInAnyOrder) {
    Compound bowl;
    for (const int i : {3, 0, 2, 1}) {
        const auto at = [](int k) { return Vec2{Real(k), Real(k * k) / 8}; };
        bowl.parts.push_back(Segment{at(i), at(i + 1), true});
    }
    Real whole = 0;
    const auto lines = linesOf(bowl);
    for (const ConvexShape& line : lines) {
        whole += length(line.vertices[1] - line.vertices[0]);
    }
    for (const ConvexShape& line : lines) {
        const Real own = length(line.vertices[1] - line.vertices[0]);
        EXPECT_NEAR(line.valleyBefore + own + line.valleyAfter, whole, whole * Real(1e-5));
    }
}

} // namespace
} // namespace kodo
