// SPDX-License-Identifier: MIT
// What WorldPainter makes of figures, from its triangles alone: needs no display.
#include <kodo_sfml/world_painter.hpp>

#include <gtest/gtest.h>

#include <array>

namespace kodo_sfml {
namespace {

using kodo::Vec2;

// One metre is 10 pixels; the origin is in the middle. The picture is wider than what is asked for.
const Camera kCamera({{-20, -20}, {20, 20}}, {600, 400});
const kodo::DrawStyle kFilled{{255, 255, 255}, {255, 255, 255, 110}, 2};
const kodo::DrawStyle kHollow{{255, 255, 255}, {0, 0, 0, 0}, 2};

/// Largest opacity, 0..255, of the triangles that cover a pixel.
int opacityAtPixel(const Painter& painter, Pixel pixel) {
    const auto vertices = painter.vertices();
    int most = 0;
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const auto side = [&](std::size_t from, std::size_t to) {
            const Pixel edge = vertices[i + to].place - vertices[i + from].place;
            const Pixel way = pixel - vertices[i + from].place;
            return edge.x * way.y - edge.y * way.x;
        };
        const float a = side(0, 1);
        const float b = side(1, 2);
        const float c = side(2, 0);
        const bool covers = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
        for (std::size_t k = 0; covers && a + b + c != 0 && k < 3; ++k) {
            most = std::max(most, static_cast<int>(vertices[i + k].color.a));
        }
    }
    return most;
}

/// Opacity at places (m) of what a function draws.
template <std::size_t kCount, typename Draw>
std::array<int, kCount> opacities(const std::array<Vec2, kCount>& places, Draw draw) {
    Painter painter;
    WorldPainter picture(painter, kCamera);
    draw(picture);
    std::array<int, kCount> found{};
    for (std::size_t i = 0; i < kCount; ++i) {
        found[i] = opacityAtPixel(painter, kCamera.toPixels(places[i]));
    }
    return found;
}

TEST(WorldPainter, AFilledCircleCoversItsDiscAndAHollowOneItsRim) {
    const std::array<Vec2, 3> places = {Vec2{5, 0}, Vec2{7, 0}, Vec2{5, 2.5f}}; // middle, rim, out
    const auto filled = opacities(places, [](auto& to) { to.circle({5, 0}, 2, kFilled); });
    EXPECT_EQ(filled, (std::array{110, 255, 0}));
    const auto hollow = opacities(places, [](auto& to) { to.circle({5, 0}, 2, kHollow); });
    EXPECT_EQ(hollow, (std::array{0, 255, 0}));
}

TEST(WorldPainter, AFilledPolygonCoversItsAreaAndAHollowOneItsEdges) {
    const std::array<Vec2, 3> corners = {Vec2{0, 0}, Vec2{8, 0}, Vec2{0, 8}};
    const std::array<Vec2, 3> places = {Vec2{2, 2}, Vec2{4, 0}, Vec2{5, 5}};
    const auto filled = opacities(places, [&](auto& to) { to.polygon(corners, kFilled); });
    EXPECT_EQ(filled, (std::array{110, 255, 0}));
    const auto hollow = opacities(places, [&](auto& to) { to.polygon(corners, kHollow); });
    EXPECT_EQ(hollow, (std::array{0, 255, 0}));
}

TEST(WorldPainter, ALineIsAsWideAsItsStyleSaysAndTextWithoutAFontIsNothing) {
    const std::array<Vec2, 3> places = {Vec2{0, 0.05f}, Vec2{0, 0.5f}, Vec2{6, 0}};
    const auto found = opacities(places, [](auto& to) {
        to.line({-5, 0}, {5, 0}, kHollow);
        to.text({6, 0}, "text", kHollow);
    });
    EXPECT_GT(found[0], 0);
    EXPECT_EQ(found[1], 0);
    EXPECT_EQ(found[2], 0);
}

TEST(WorldPainter, TheViewIsTheWholePictureAndAPixelItsScale) {
    Painter painter;
    const WorldPainter picture(painter, kCamera);
    EXPECT_EQ(picture.view(), (kodo::Aabb{{-30, -20}, {30, 20}}));
    EXPECT_EQ(picture.pixel(), 0.1f);
}

} // namespace
} // namespace kodo_sfml
