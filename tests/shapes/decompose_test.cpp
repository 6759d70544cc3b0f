// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/random_numbers.hpp>

#include "shapes/outline.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kodo {
namespace {

using Outline = std::vector<Vec2>;

Compound partsOf(const Outline& outline) {
    auto result = decompose(outline);
    if (const auto* problem = std::get_if<Problem>(&result)) {
        ADD_FAILURE() << problem->field << " " << problem->reason;
        return {};
    }
    return std::get<Compound>(result);
}

std::string refusalOf(const Outline& outline) {
    const auto result = decompose(outline);
    const auto* problem = std::get_if<Problem>(&result);
    return problem != nullptr ? problem->field + " " + problem->reason : "";
}

/// Even-odd rule.
bool isInside(const Outline& outline, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    return inside;
}

/// Judges valid parts, equal area, and each of many points: in one part, or outside all.
void expectDivided(const Outline& outline, support::RandomNumbers& random) {
    const Compound compound = partsOf(outline);
    ASSERT_FALSE(check(Shape(compound)));
    Real area = 0;
    std::vector<ConvexShape> parts;
    for (const Primitive& part : compound.parts) {
        area += areaWithin(std::get<Polygon>(part).corners);
        parts.push_back(convexShapeOf(part, {}));
    }
    const Real whole = std::abs(areaWithin(outline));
    EXPECT_NEAR(area, whole, whole * Real(2e-4));
    int wrong = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec2 p = random.point(4);
        const auto in = std::count_if(parts.begin(), parts.end(),
                                      [&](const ConvexShape& s) { return contains(s, {}, p); });
        wrong += in != (isInside(outline, p) ? 1 : 0) ? 1 : 0;
    }
    EXPECT_LE(wrong, 1) << "a point on an edge is in two parts";
}

Outline comb(int teeth) {
    Outline points{{0, 0}};
    points.push_back({static_cast<Real>(teeth) - Real(0.5), 0});
    for (int i = teeth; i-- > 0;) {
        const auto x = static_cast<Real>(i);
        points.push_back({x + Real(0.5), 2});
        points.push_back({x, 2});
        if (i > 0) {
            points.push_back({x, 1});
            points.push_back({x - Real(0.5), 1});
        }
    }
    return points;
}

TEST(Decompose, AConvexOutlineIsOnePart) {
    const Outline square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    const Compound compound = partsOf(square);
    ASSERT_EQ(compound.parts.size(), 1u) << "points on an edge are left out";
    EXPECT_EQ(std::get<Polygon>(compound.parts[0]).corners.size(), 4u);
}

TEST(Decompose, AnLIsTwoPartsInEitherDirection) {
    Outline shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_EQ(partsOf(shape).parts.size(), 2u);
    std::reverse(shape.begin(), shape.end());
    EXPECT_EQ(partsOf(shape).parts.size(), 2u);
}

TEST(Decompose, CombsAndSpiralsKeepTheirAreaAndEachPoint) {
    support::RandomNumbers random(21);
    for (const int teeth : {2, 5, 20}) {
        expectDivided(comb(teeth), random);
        // the fewest are one for each tooth and one for the back
        EXPECT_LE(partsOf(comb(teeth)).parts.size(), 4 * static_cast<std::size_t>(teeth + 1));
    }
    Outline spiral;
    for (int i = 0; i <= 60; ++i) {
        const Real angle = Real(0.25) * static_cast<Real>(i);
        spiral.push_back((Real(0.5) + Real(0.05) * static_cast<Real>(i)) *
                         Vec2{std::cos(angle), std::sin(angle)});
    }
    for (int i = 60; i >= 0; --i) {
        const Real angle = Real(0.25) * static_cast<Real>(i);
        spiral.push_back((Real(0.4) + Real(0.05) * static_cast<Real>(i)) *
                         Vec2{std::cos(angle), std::sin(angle)});
    }
    expectDivided(spiral, random);
}

TEST(Decompose, RandomStarsKeepTheirAreaAndEachPoint) {
    support::RandomNumbers random(22);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "star " << i);
        const std::size_t n = 3 + random.below(40);
        Outline star;
        for (std::size_t k = 0; k < n; ++k) {
            const Real angle = Real(6.2831853) * static_cast<Real>(k) / static_cast<Real>(n);
            const Real radius = random.between(0.5, 3);
            star.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
        }
        if (i % 2 == 0) {
            std::reverse(star.begin(), star.end());
        }
        expectDivided(star, random);
    }
}

TEST(Decompose, RefusesWhatHasNoSingleInside) {
    EXPECT_EQ(refusalOf({{0, 0}, {1, 0}}),
              "outline must be from 3 to 1024 points, but there are 2");
    EXPECT_EQ(refusalOf({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
              "outline[1] is the same point as the next one: leave one out");
    const std::string meets = ": an outline must not meet itself, and has no holes";
    EXPECT_EQ(refusalOf({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
              "outline[2] begins an edge that crosses or touches the one from outline[0]" + meets);
    // A square hole, joined to the outline by an edge that is walked twice.
    EXPECT_NE(
        refusalOf({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}})
            .find("no holes"),
        std::string::npos);
    EXPECT_EQ(refusalOf({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), // it goes back along its own edge
              "outline[1] begins an edge that crosses or touches the one from outline[0]" + meets);
    EXPECT_NE(refusalOf({{0, 0}, {1, 0}, {2, 0}}), "");
}

} // namespace
} // namespace kodo
