// SPDX-License-Identifier: MIT
#include <apart/front/mesh_canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/letterforms.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace apart {

using kodo_draw::Camera;
using kodo_draw::Pixel;
using kodo_draw::Rgba;

namespace {

constexpr Real kCapitalShare = Real(0.72); // height of a capital relative to that of the text
constexpr float kFinestJoint = 0.7f;       // units of the display face
constexpr float kWidestJoint = 1.6f;

Rgba rgbaOf(Color color) {
    return {color.r, color.g, color.b, color.a};
}

} // namespace

MeshCanvas::MeshCanvas(kodo_draw::Size pixels)
    : pixels_(pixels), steady_(layout::kShown, pixels), shaken_(steady_), camera_(steady_) {}

void MeshCanvas::begin(const Aabb& shown, Vec2 shake) {
    mesh().clear();
    steady_ = Camera(shown, pixels_);
    shaken_ = Camera({shown.lower - shake, shown.upper - shake}, pixels_);
    camera_ = shaken_;
}

void MeshCanvas::zoom(Vec2 focus, Real scale) {
    const Aabb all = shaken_.shown();
    const auto nearer = [&](Vec2 corner) { return focus + (corner - focus) / scale; };
    camera_ = scale == 1 ? shaken_ : Camera({nearer(all.lower), nearer(all.upper)}, pixels_);
}

Aabb MeshCanvas::visible() const {
    const auto width = static_cast<float>(pixels_.x);
    const auto height = static_cast<float>(pixels_.y);
    return {steady_.toWorld({0, height}), steady_.toWorld({width, 0})};
}

void MeshCanvas::setGlow(bool on) {
    mesh().setBlend(on ? kodo_draw::Blend::Add : kodo_draw::Blend::Over);
}

std::span<const Pixel> MeshCanvas::toPixels(std::span<const Vec2> corners) {
    corners_.clear();
    for (const Vec2 corner : corners) {
        corners_.push_back(camera_.toPixels(corner));
    }
    return corners_;
}

std::span<const Rgba> MeshCanvas::toRgba(std::span<const Color> colors) {
    colors_.clear();
    for (const Color color : colors) {
        colors_.push_back(rgbaOf(color));
    }
    return colors_;
}

void MeshCanvas::rectangle(const Aabb& box, Color below, Color above) {
    const Pixel upperLeft = camera_.toPixels(Vec2{box.lower.x, box.upper.y});
    const Pixel size = camera_.toPixels(Vec2{box.upper.x, box.lower.y}) - upperLeft;
    const std::array<Rgba, 4> colors = {rgbaOf(above), rgbaOf(above), rgbaOf(below), rgbaOf(below)};
    mesh().rectangle({upperLeft.x, upperLeft.y, size.x, size.y}, colors);
}

void MeshCanvas::polygon(std::span<const Vec2> corners, Color color) {
    mesh().polygon(toPixels(corners), rgbaOf(color));
}

void MeshCanvas::polygon(std::span<const Vec2> corners, std::span<const Color> colors) {
    mesh().polygon(toPixels(corners), toRgba(colors));
}

void MeshCanvas::facet(std::span<const Vec2> corners, std::span<const Color> colors) {
    mesh().facet(toPixels(corners), toRgba(colors));
}

void MeshCanvas::rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                        Color rim) {
    mesh().rimmed(toPixels(corners), toRgba(colors), camera_.toPixels(width), rgbaOf(rim));
}

void MeshCanvas::outline(std::span<const Vec2> corners, Real width, Color color) {
    mesh().outline(toPixels(corners), camera_.toPixels(width), rgbaOf(color));
}

void MeshCanvas::line(Vec2 from, Vec2 to, Real width, Color color) {
    mesh().line(camera_.toPixels(from), camera_.toPixels(to), camera_.toPixels(width),
                rgbaOf(color));
}

void MeshCanvas::ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                        std::span<const Color> colors) {
    widths_.clear();
    for (const Real width : widths) {
        widths_.push_back(camera_.toPixels(width));
    }
    mesh().ribbon(toPixels(points), widths_, toRgba(colors));
}

void MeshCanvas::disc(Vec2 center, Real radius, Color middle, Color rim) {
    mesh().disc(camera_.toPixels(center), camera_.toPixels(radius), rgbaOf(middle), rgbaOf(rim));
}

void MeshCanvas::ring(Vec2 center, Real radius, Real width, Color color) {
    mesh().ring(camera_.toPixels(center), camera_.toPixels(radius), camera_.toPixels(width),
                rgbaOf(color));
}

/// False if the display face lacks a sign of the text.
bool MeshCanvas::display(std::string_view text, Vec2 place, const TextStyle& style) {
    Real unit = kCapitalShare * style.height / kCapital;
    if (style.room > 0) {
        const std::optional<LaidText> widest = layStones(text, kWidestJoint);
        unit = widest ? std::min(unit, style.room / widest->width) : unit;
    }
    const float unitPixels = camera_.toPixels(unit);
    // Joints of at least a pixel, but never wide ones.
    const std::optional<LaidText> laid =
        layStones(text, std::clamp(1.1f / unitPixels, kFinestJoint, kWidestJoint));
    if (!laid) {
        return false;
    }
    const Real shift = style.align == Align::Left     ? 0
                       : style.align == Align::Middle ? Real(0.5) * laid->width
                                                      : laid->width;
    const Color rim = faded(lighter(style.color, 0.5f), 0.5f);
    std::vector<Color> colors;
    for (const LaidStone& stone : laid->stones) {
        corners_.clear();
        colors.clear();
        for (const Vec2 corner : stone.corners) {
            corners_.push_back(camera_.toPixels(place + unit * (corner - Vec2{shift, 0})));
            const float up = std::clamp(corner.y / kCapital, Real(0), Real(1));
            colors.push_back(mix(darker(style.color, 0.16f), lighter(style.color, 0.12f), up));
        }
        if (unitPixels < 2) { // too small for rims
            mesh().polygon(corners_, toRgba(colors));
        } else {
            mesh().rimmed(corners_, toRgba(colors), unitPixels * Real(0.8), rgbaOf(rim));
        }
    }
    return true;
}

void MeshCanvas::text(std::string_view utf8, Vec2 place, const TextStyle& style) {
    if (style.color.a == 0) {
        return;
    }
    const bool stones = style.face == Typeface::Display;
    if (stones && display(utf8, place, style)) {
        return;
    }
    const Typeface face = stones ? Typeface::Bold : style.face;
    const Real scale = stones ? Real(1) : textScale();
    float pixels = std::round(camera_.toPixels(scale * style.height));
    if (pixels < 4) {
        return; // unreadable
    }
    const auto widthAt = [&](float height) {
        return textWidth(face, utf8, static_cast<unsigned>(height));
    };
    float width = widthAt(pixels);
    if (const float room = camera_.toPixels(style.room); room > 0 && width > room) {
        pixels = std::max(std::floor(pixels * room / width), 4.0f);
        width = widthAt(pixels);
        while (width > room && pixels > 4) { // letters have widths of whole pixels
            width = widthAt(--pixels);
        }
    }
    Pixel start = camera_.toPixels(place);
    start.x -= style.align == Align::Left ? 0 : style.align == Align::Middle ? 0.5f * width : width;
    addText(face, utf8, static_cast<unsigned>(pixels), start, rgbaOf(style.color));
}

} // namespace apart
