// SPDX-License-Identifier: MIT
#include <kodo_sfml/world_painter.hpp>

namespace kodo_sfml {

namespace {

constexpr unsigned kTextHeight = 13; // pixels

Rgba toRgba(kodo::DrawColor color) {
    return {color.r, color.g, color.b, color.a};
}

} // namespace

void WorldPainter::line(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle& style) {
    painter_.line(camera_.toPixels(from), camera_.toPixels(to), style.width, toRgba(style.line));
}

void WorldPainter::circle(kodo::Vec2 center, kodo::Real radius, const kodo::DrawStyle& style) {
    const Pixel middle = camera_.toPixels(center);
    const float size = camera_.toPixels(radius);
    if (style.fill.a > 0) {
        painter_.disc(middle, size, toRgba(style.fill), toRgba(style.fill));
    }
    painter_.ring(middle, size, style.width, toRgba(style.line));
}

void WorldPainter::polygon(std::span<const kodo::Vec2> corners, const kodo::DrawStyle& style) {
    corners_.clear();
    for (const kodo::Vec2 corner : corners) {
        corners_.push_back(camera_.toPixels(corner));
    }
    if (style.fill.a > 0) {
        painter_.polygon(corners_, toRgba(style.fill));
    }
    painter_.outline(corners_, style.width, toRgba(style.line));
}

void WorldPainter::text(kodo::Vec2 middle, std::string_view utf8, const kodo::DrawStyle& style) {
    if (font_ != nullptr) {
        const float width = textWidth(*font_, utf8, kTextHeight);
        const Pixel start = camera_.toPixels(middle) + Pixel{-width / 2, kTextHeight / 3.0f};
        painter_.text(*font_, utf8, kTextHeight, start, toRgba(style.line));
    }
}

} // namespace kodo_sfml
