// SPDX-License-Identifier: MIT
// The edges of drawn shapes, from their triangles alone: needs no display.
#include <gtest/gtest.h>
#include <kodo_draw/edge_texture.hpp>
#include <kodo_draw/mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace kodo_draw {
namespace {

using Point = std::pair<int, int>; // 1/64 pixel

Point pointOf(const MeshVertex& vertex) {
    return {static_cast<int>(std::lround(64 * vertex.place.x)),
            static_cast<int>(std::lround(64 * vertex.place.y))};
}

/// Opacity, 0..255, of a vertex with its texel.
int opacityOf(const MeshVertex& vertex) {
    return static_cast<int>(vertex.color.a * opacityAt(vertex.texel));
}

/// Number of edges of the silhouette that are not transparent: edges of one triangle only.
int hardEdges(const Mesh& mesh) {
    struct Edge {
        int triangles = 0;
        int opacity = 0; // of both ends
    };
    std::map<std::pair<Point, Point>, Edge> edges;
    const auto vertices = mesh.vertices();
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshVertex& a = vertices[i + k];
            const MeshVertex& b = vertices[i + (k + 1) % 3];
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

const Rgba kWhite{255, 255, 255, 255};
const std::array<Pixel, 4> kSkewed = {
    Pixel{10.3f, 12.1f}, {90.7f, 20.2f}, {80.4f, 71.9f}, {17.2f, 66.6f}};
const std::array<Rgba, 4> kFour = {kWhite, kWhite, kWhite, kWhite};

TEST(Mesh, FilledShapesFadeAtTheirEdges) {
    Mesh polygon;
    polygon.polygon(kSkewed, kWhite);
    EXPECT_EQ(hardEdges(polygon), 0);
    Mesh rimmed;
    rimmed.rimmed(kSkewed, kFour, 3, kWhite);
    EXPECT_EQ(hardEdges(rimmed), 0);
    Mesh disc;
    disc.disc({50.2f, 40.7f}, 20, kWhite, kWhite);
    EXPECT_EQ(hardEdges(disc), 0);
    Mesh facet; // the check is not vacuous
    facet.facet(kSkewed, kFour);
    EXPECT_EQ(hardEdges(facet), 4);
}

TEST(Mesh, StrokesFadeAtTheirSides) {
    for (const float width : {0.6f, 1.5f, 2.5f, 9.0f}) {
        SCOPED_TRACE(width);
        Mesh outline;
        outline.outline(kSkewed, width, kWhite);
        EXPECT_EQ(hardEdges(outline), 0);
        Mesh ring;
        ring.ring({50, 40}, 20, width, kWhite);
        EXPECT_EQ(hardEdges(ring), 0);
        Mesh ribbon;
        ribbon.ribbon(kSkewed, std::array{width, width, width, width}, kFour);
        EXPECT_LE(hardEdges(ribbon), 4); // its two ends are cut, in two pieces each
    }
}

/// Sum of the opacities of all triangles over a point, 0..255 each.
float opacityOver(const Mesh& mesh, Pixel p) {
    float sum = 0;
    const auto vertices = mesh.vertices();
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const Pixel a = vertices[i].place;
        const Pixel u = vertices[i + 1].place - a;
        const Pixel v = vertices[i + 2].place - a;
        const Pixel w = p - a;
        const float area = u.x * v.y - u.y * v.x;
        const float s = (w.x * v.y - w.y * v.x) / area;
        const float t = (u.x * w.y - u.y * w.x) / area;
        if (s > 0 && t > 0 && s + t < 1) {
            const auto alpha = [&](std::size_t k) {
                return static_cast<float>(vertices[i + k].color.a);
            };
            const Pixel texel = (1 - s - t) * vertices[i].texel + s * vertices[i + 1].texel +
                                t * vertices[i + 2].texel;
            sum += opacityAt(texel) * ((1 - s - t) * alpha(0) + s * alpha(1) + t * alpha(2));
        }
    }
    return sum;
}

// The fade of an edge: half opaque on the edge itself, opaque half a pixel inside, and nothing half
// a pixel outside.
TEST(Mesh, AnEdgeFadesOverOnePixel) {
    const std::array<Pixel, 4> square = {Pixel{10, 10}, {50, 10}, {50, 50}, {10, 50}};
    const std::array<Rgba, 4> colors = {kWhite, kWhite, kWhite, kWhite};
    Mesh polygon;
    polygon.polygon(square, kWhite);
    Mesh rimmed;
    rimmed.rimmed(square, colors, 3, kWhite);
    Mesh thin;
    thin.line({10, 11}, {50, 11}, 2, kWhite);
    Mesh wide;
    wide.line({10, 40}, {50, 40}, 60, kWhite); // wider than any row of the texture
    for (const Mesh* mesh : {&polygon, &rimmed, &thin, &wide}) {
        SCOPED_TRACE(mesh->vertexCount());
        EXPECT_NEAR(opacityOver(*mesh, {30.7f, 10}), 127, 20);
        EXPECT_NEAR(opacityOver(*mesh, {30.7f, 9.6f}), 25, 20);
        EXPECT_NEAR(opacityOver(*mesh, {30.7f, 9.3f}), 0, 1);
        EXPECT_NEAR(opacityOver(*mesh, {30.7f, 10.9f}), 255, 20);
    }
    Mesh disc;
    disc.disc({30, 30}, 20, kWhite, kWhite); // its first corner is on the right
    EXPECT_NEAR(opacityOver(disc, {49.97f, 30.01f}), 127, 20);
    EXPECT_NEAR(opacityOver(disc, {50.6f, 30.01f}), 0, 1);
    EXPECT_NEAR(opacityOver(disc, {49, 30.01f}), 255, 20);
}

TEST(Mesh, AStrokeThinnerThanAPixelIsFainterInstead) {
    Mesh hair;
    hair.line({10, 10}, {50, 10}, 0.4f, kWhite);
    EXPECT_NEAR(opacityOver(hair, {31.3f, 10}), 0.4f * 255, 4);
    EXPECT_NEAR(opacityOver(hair, {31.3f, 10.5f}), 0.2f * 255, 4);
}

// Software rendering takes most of its time for the number of triangles.
TEST(Mesh, ShapesNeedFewTriangles) {
    const auto triangles = [](const Mesh& mesh) { return mesh.vertexCount() / 3; };
    Mesh rimmed;
    rimmed.rimmed(kSkewed, kFour, 3, kWhite);
    EXPECT_EQ(triangles(rimmed), 10u);
    Mesh line;
    line.line({10, 10}, {50, 20}, 3, kWhite);
    EXPECT_EQ(triangles(line), 2u);
    Mesh disc;
    disc.disc({20, 20}, 4, kWhite, kWhite);
    EXPECT_EQ(triangles(disc), 8u);
}

TEST(Mesh, MiddlesFirstChangesTheOrderAlone) {
    const Rgba red{255, 0, 0};
    const std::array<Rgba, 4> reds = {red, red, red, red};
    const auto paint = [&](Mesh& mesh, bool first) {
        mesh.line({0, 0}, {9, 9}, 3, kWhite);
        mesh.setMiddlesFirst(first);
        mesh.rimmed(kSkewed, kFour, 3, kWhite);
        mesh.line({10, 10}, {50, 20}, 3, kWhite);
        mesh.rimmed(kSkewed, reds, 3, kWhite);
        mesh.setMiddlesFirst(false);
        mesh.line({0, 0}, {9, 9}, 3, kWhite);
    };
    Mesh usual;
    paint(usual, false);
    Mesh middles;
    paint(middles, true);
    ASSERT_EQ(usual.vertexCount(), middles.vertexCount());
    EXPECT_EQ(middles.vertices()[6].color, kWhite); // after the first line: two middles
    EXPECT_EQ(middles.vertices()[12].color, red);
    const auto count = [](const Mesh& mesh, Rgba color) {
        return std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                             [&](const MeshVertex& vertex) { return vertex.color == color; });
    };
    EXPECT_EQ(count(usual, red), count(middles, red));
}

// A trail is a translucent stroke: a gap or an overlap at a bend shows as a dark or bright spot.
TEST(Mesh, ATranslucentRibbonHasOneOpacityAlongItsBends) {
    const Rgba kFaint{255, 255, 255, 100};
    std::vector<Pixel> points;
    for (int i = 0; i <= 40; ++i) {
        const float angle = 0.31f * static_cast<float>(i);
        points.push_back({100 + 60 * std::cos(angle) * (1 + 0.3f * std::sin(2.3f * angle)),
                          100 + 60 * std::sin(angle)});
    }
    points.resize(20); // less than a full turn: it does not cross itself
    const std::vector<float> widths(points.size(), 8);
    const std::vector<Rgba> colors(points.size(), kFaint);
    Mesh ribbon;
    ribbon.ribbon(points, widths, colors);
    Mesh lines;
    for (std::size_t i = 1; i < points.size(); ++i) {
        lines.line(points[i - 1], points[i], 8, kFaint);
    }
    int uneven = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Pixel along = points[i + 1] - points[i - 1];
        const float size = std::sqrt(along.x * along.x + along.y * along.y);
        const Pixel side = Pixel{-along.y, along.x} / size;
        for (const float off : {-2.7f, -1.3f, 0.13f, 1.4f, 2.6f}) {
            const Pixel spot = points[i] + off * side + 0.02f * along / size;
            EXPECT_NEAR(opacityOver(ribbon, spot), 100, 2) << "point " << i << ", " << off;
            uneven += std::abs(opacityOver(lines, spot) - 100) > 5 ? 1 : 0;
        }
    }
    EXPECT_GT(uneven, 10); // single lines have gaps and overlaps there
}

// A bounce: the stroke turns back on itself and stays closed.
TEST(Mesh, ARibbonStaysClosedAtASharpBend) {
    const std::array<Pixel, 3> points = {Pixel{10, 10}, {60, 60}, {80, 5}};
    const std::array<Rgba, 3> colors = {kWhite, kWhite, kWhite};
    Mesh ribbon;
    ribbon.ribbon(points, std::array{8.0f, 8.0f, 8.0f}, colors);
    for (int i = 1; i < 50; ++i) {
        const float t = static_cast<float>(i) / 50;
        const Pixel off{0.11f, 0.07f}; // not on the edge between two triangles
        EXPECT_GE(opacityOver(ribbon, points[0] + t * (points[1] - points[0]) + off), 200) << t;
        EXPECT_GE(opacityOver(ribbon, points[1] + t * (points[2] - points[1]) + off), 200) << t;
    }
}

} // namespace
} // namespace kodo_draw
