// SPDX-License-Identifier: MIT
// The edges of drawn shapes, from their triangles alone: needs no display.
#include <kodo_sfml/painter.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace kodo_sfml {
namespace {

using Point = std::pair<int, int>; // 1/64 pixel

Point pointOf(const sf::Vertex& vertex) {
    return {static_cast<int>(std::lround(64 * vertex.position.x)),
            static_cast<int>(std::lround(64 * vertex.position.y))};
}

/// Opacity, 0..255, of a vertex with its texel.
int opacityOf(const sf::Vertex& vertex) {
    return static_cast<int>(vertex.color.a * opacityAt(vertex.texCoords));
}

/// Number of edges of the silhouette that are not transparent: edges of one triangle only.
int hardEdges(const Painter& painter) {
    struct Edge {
        int triangles = 0;
        int opacity = 0; // of both ends
    };
    std::map<std::pair<Point, Point>, Edge> edges;
    const auto vertices = painter.vertices();
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const sf::Vertex& a = vertices[i + k];
            const sf::Vertex& b = vertices[i + (k + 1) % 3];
            const auto ends = std::minmax(pointOf(a), pointOf(b));
            Edge& edge = edges[{ends.first, ends.second}];
            ++edge.triangles;
            edge.opacity = opacityOf(a) + opacityOf(b);
        }
    }
    int hard = 0;
    for (const auto& [ends, edge] : edges) {
        hard += edge.triangles == 1 && edge.opacity > 0 && ends.first != ends.second ? 1 : 0;
    }
    return hard;
}

const sf::Color kWhite{255, 255, 255, 255};
const std::array<sf::Vector2f, 4> kSkewed = {
    sf::Vector2f{10.3f, 12.1f}, {90.7f, 20.2f}, {80.4f, 71.9f}, {17.2f, 66.6f}};
const std::array<sf::Color, 4> kFour = {kWhite, kWhite, kWhite, kWhite};

TEST(Painter, FilledShapesFadeAtTheirEdges) {
    Painter polygon;
    polygon.polygon(kSkewed, kWhite);
    EXPECT_EQ(hardEdges(polygon), 0);
    Painter rimmed;
    rimmed.rimmed(kSkewed, kFour, 3, kWhite);
    EXPECT_EQ(hardEdges(rimmed), 0);
    Painter disc;
    disc.disc({50.2f, 40.7f}, 20, kWhite, kWhite);
    EXPECT_EQ(hardEdges(disc), 0);
    Painter facet; // the check is not vacuous
    facet.facet(kSkewed, kFour);
    EXPECT_EQ(hardEdges(facet), 4);
}

TEST(Painter, StrokesFadeAtTheirSides) {
    for (const float width : {0.6f, 1.5f, 2.5f, 9.0f}) {
        SCOPED_TRACE(width);
        Painter outline;
        outline.outline(kSkewed, width, kWhite);
        EXPECT_EQ(hardEdges(outline), 0);
        Painter ring;
        ring.ring({50, 40}, 20, width, kWhite);
        EXPECT_EQ(hardEdges(ring), 0);
        Painter ribbon;
        ribbon.ribbon(kSkewed, std::array{width, width, width, width}, kFour);
        EXPECT_LE(hardEdges(ribbon), 4); // its two ends are cut, in two pieces each
    }
}

/// Sum of the opacities of all triangles over a point, 0..255 each.
float opacityOver(const Painter& painter, sf::Vector2f p) {
    float sum = 0;
    const auto vertices = painter.vertices();
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const sf::Vector2f a = vertices[i].position;
        const sf::Vector2f u = vertices[i + 1].position - a;
        const sf::Vector2f v = vertices[i + 2].position - a;
        const sf::Vector2f w = p - a;
        const float area = u.x * v.y - u.y * v.x;
        const float s = (w.x * v.y - w.y * v.x) / area;
        const float t = (u.x * w.y - u.y * w.x) / area;
        if (s > 0 && t > 0 && s + t < 1) {
            const auto alpha = [&](std::size_t k) {
                return static_cast<float>(vertices[i + k].color.a);
            };
            const sf::Vector2f texel = (1 - s - t) * vertices[i].texCoords +
                                       s * vertices[i + 1].texCoords +
                                       t * vertices[i + 2].texCoords;
            sum += opacityAt(texel) * ((1 - s - t) * alpha(0) + s * alpha(1) + t * alpha(2));
        }
    }
    return sum;
}

// The fade of an edge: half opaque on the edge itself, opaque half a pixel inside, and nothing half
// a pixel outside.
TEST(Painter, AnEdgeFadesOverOnePixel) {
    const std::array<sf::Vector2f, 4> square = {sf::Vector2f{10, 10}, {50, 10}, {50, 50}, {10, 50}};
    const std::array<sf::Color, 4> colors = {kWhite, kWhite, kWhite, kWhite};
    Painter polygon;
    polygon.polygon(square, kWhite);
    Painter rimmed;
    rimmed.rimmed(square, colors, 3, kWhite);
    Painter thin;
    thin.line({10, 11}, {50, 11}, 2, kWhite);
    Painter wide;
    wide.line({10, 40}, {50, 40}, 60, kWhite); // wider than any row of the texture
    for (const Painter* painter : {&polygon, &rimmed, &thin, &wide}) {
        SCOPED_TRACE(painter->vertexCount());
        EXPECT_NEAR(opacityOver(*painter, {30.7f, 10}), 127, 20);
        EXPECT_NEAR(opacityOver(*painter, {30.7f, 9.6f}), 25, 20);
        EXPECT_NEAR(opacityOver(*painter, {30.7f, 9.3f}), 0, 1);
        EXPECT_NEAR(opacityOver(*painter, {30.7f, 10.9f}), 255, 20);
    }
    Painter disc;
    disc.disc({30, 30}, 20, kWhite, kWhite); // its first corner is on the right
    EXPECT_NEAR(opacityOver(disc, {49.97f, 30.01f}), 127, 20);
    EXPECT_NEAR(opacityOver(disc, {50.6f, 30.01f}), 0, 1);
    EXPECT_NEAR(opacityOver(disc, {49, 30.01f}), 255, 20);
}

TEST(Painter, AStrokeThinnerThanAPixelIsFainterInstead) {
    Painter hair;
    hair.line({10, 10}, {50, 10}, 0.4f, kWhite);
    EXPECT_NEAR(opacityOver(hair, {31.3f, 10}), 0.4f * 255, 4);
    EXPECT_NEAR(opacityOver(hair, {31.3f, 10.5f}), 0.2f * 255, 4);
}

// Software rendering takes most of its time for the number of triangles.
TEST(Painter, ShapesNeedFewTriangles) {
    const auto triangles = [](const Painter& painter) { return painter.vertexCount() / 3; };
    Painter rimmed;
    rimmed.rimmed(kSkewed, kFour, 3, kWhite);
    EXPECT_EQ(triangles(rimmed), 10u);
    Painter line;
    line.line({10, 10}, {50, 20}, 3, kWhite);
    EXPECT_EQ(triangles(line), 2u);
    Painter disc;
    disc.disc({20, 20}, 4, kWhite, kWhite);
    EXPECT_EQ(triangles(disc), 8u);
}

TEST(Painter, MiddlesFirstChangesTheOrderAlone) {
    const sf::Color red{255, 0, 0};
    const std::array<sf::Color, 4> reds = {red, red, red, red};
    const auto paint = [&](Painter& painter, bool first) {
        painter.line({0, 0}, {9, 9}, 3, kWhite);
        painter.setMiddlesFirst(first);
        painter.rimmed(kSkewed, kFour, 3, kWhite);
        painter.line({10, 10}, {50, 20}, 3, kWhite);
        painter.rimmed(kSkewed, reds, 3, kWhite);
        painter.setMiddlesFirst(false);
        painter.line({0, 0}, {9, 9}, 3, kWhite);
    };
    Painter usual;
    paint(usual, false);
    Painter middles;
    paint(middles, true);
    ASSERT_EQ(usual.vertexCount(), middles.vertexCount());
    EXPECT_EQ(middles.vertices()[6].color, kWhite); // after the first line: two middles
    EXPECT_EQ(middles.vertices()[12].color, red);
    const auto count = [](const Painter& painter, sf::Color color) {
        return std::count_if(painter.vertices().begin(), painter.vertices().end(),
                             [&](const sf::Vertex& vertex) { return vertex.color == color; });
    };
    EXPECT_EQ(count(usual, red), count(middles, red));
}

// A trail is a translucent stroke: a gap or an overlap at a bend shows as a dark or bright spot.
TEST(Painter, ATranslucentRibbonHasOneOpacityAlongItsBends) {
    const sf::Color kFaint{255, 255, 255, 100};
    std::vector<sf::Vector2f> points;
    for (int i = 0; i <= 40; ++i) {
        const float angle = 0.31f * static_cast<float>(i);
        points.push_back({100 + 60 * std::cos(angle) * (1 + 0.3f * std::sin(2.3f * angle)),
                          100 + 60 * std::sin(angle)});
    }
    points.resize(20); // less than a full turn: it does not cross itself
    const std::vector<float> widths(points.size(), 8);
    const std::vector<sf::Color> colors(points.size(), kFaint);
    Painter ribbon;
    ribbon.ribbon(points, widths, colors);
    Painter lines;
    for (std::size_t i = 1; i < points.size(); ++i) {
        lines.line(points[i - 1], points[i], 8, kFaint);
    }
    int uneven = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const sf::Vector2f along = points[i + 1] - points[i - 1];
        const float size = std::sqrt(along.x * along.x + along.y * along.y);
        const sf::Vector2f side = sf::Vector2f{-along.y, along.x} / size;
        for (const float off : {-2.7f, -1.3f, 0.13f, 1.4f, 2.6f}) {
            const sf::Vector2f spot = points[i] + off * side + 0.02f * along / size;
            EXPECT_NEAR(opacityOver(ribbon, spot), 100, 2) << "point " << i << ", " << off;
            uneven += std::abs(opacityOver(lines, spot) - 100) > 5 ? 1 : 0;
        }
    }
    EXPECT_GT(uneven, 10); // single lines have gaps and overlaps there
}

// A bounce: the stroke turns back on itself and stays closed.
TEST(Painter, ARibbonStaysClosedAtASharpBend) {
    const std::array<sf::Vector2f, 3> points = {sf::Vector2f{10, 10}, {60, 60}, {80, 5}};
    const std::array<sf::Color, 3> colors = {kWhite, kWhite, kWhite};
    Painter ribbon;
    ribbon.ribbon(points, std::array{8.0f, 8.0f, 8.0f}, colors);
    for (int i = 1; i < 50; ++i) {
        const float t = static_cast<float>(i) / 50;
        const sf::Vector2f off{0.11f, 0.07f}; // not on the edge between two triangles
        EXPECT_GE(opacityOver(ribbon, points[0] + t * (points[1] - points[0]) + off), 200) << t;
        EXPECT_GE(opacityOver(ribbon, points[1] + t * (points[2] - points[1]) + off), 200) << t;
    }
}

} // namespace
} // namespace kodo_sfml
