// SPDX-License-Identifier: MIT
#include <kodo/debug_draw.hpp>

#include <array>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

constexpr Real kTextHeight = 13;   // pixels
constexpr Real kFarthest = 100000; // pixels; larger coordinates are cut off

/// A length (pixels) in the unit of the picture: tenths of a pixel, as whole numbers.
std::string number(Real pixels) {
    return std::to_string(std::lround(10 * (std::max)(-kFarthest, (std::min)(kFarthest, pixels))));
}

/// An attribute of a colour, and one of its opacity.
std::string paint(const std::string& name, DrawColor color) {
    return " " + name + "=\"rgb(" + std::to_string(color.r) + "," + std::to_string(color.g) + "," +
           std::to_string(color.b) + ")\" " + name + "-opacity=\"" + std::to_string(color.a / 255) +
           "." + std::to_string(100 + 100 * color.a / 255).substr(1) + "\"";
}

/// Without what XML reserves, and without control characters.
std::string escaped(std::string_view utf8) {
    std::string text;
    for (const char letter : utf8) {
        if (letter == '&' || letter == '<' || letter == '>') {
            text += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : "&gt;";
        } else if (static_cast<unsigned char>(letter) >= 0x20) {
            text += letter;
        }
    }
    return text;
}

/// Pixels per metre, of a checked view and width.
Real scaleOf(const Aabb& view, int width) {
    const Vec2 extent = view.extent();
    const bool hasArea = extent.x > 0 && extent.y > 0; // false for NaN
    if (!hasArea || !isFinite(extent) || width < 16 || width > 16384) {
        throw BadDefinition({"view", "must have an area, and be 16 to 16384 pixels wide"});
    }
    return static_cast<Real>(width) / extent.x;
}

} // namespace

SvgDraw::SvgDraw(const Aabb& view, int width, DrawColor background)
    : view_(view), scale_(scaleOf(view, width)) {
    const std::string size =
        number(static_cast<Real>(width)) + " " + number(scale_ * view.extent().y);
    figures_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) +
               "\" viewBox=\"0 0 " + size + "\" font-family=\"sans-serif\" font-size=\"" +
               number(kTextHeight) +
               "\" text-anchor=\"middle\">\n<rect width=\"100%\" height=\"100%\"" +
               paint("fill", background) + "/>\n<g>\n";
}

void SvgDraw::line(Vec2 from, Vec2 to, const DrawStyle& style) {
    figure("polyline", std::array{from, to}, style);
}

void SvgDraw::polygon(std::span<const Vec2> corners, const DrawStyle& style) {
    figure("polygon", corners, style);
}

void SvgDraw::circle(Vec2 center, Real radius, const DrawStyle& style) {
    use(style);
    figures_ += "<circle transform=\"translate(" + place(center) + ")\" r=\"" +
                number(scale_ * radius) + "\"/>\n";
}

void SvgDraw::text(Vec2 middle, std::string_view utf8, const DrawStyle& style) {
    use({{0, 0, 0, 0}, style.line, style.width});
    const Vec2 base = middle - Vec2{0, kTextHeight / 3 * pixel()};
    figures_ += "<text transform=\"translate(" + place(base) + ")\">" + escaped(utf8) + "</text>\n";
}

std::string SvgDraw::place(Vec2 point) const {
    return number(scale_ * (point.x - view_.lower.x)) + "," +
           number(scale_ * (view_.upper.y - point.y));
}

void SvgDraw::figure(const std::string& tag, std::span<const Vec2> corners,
                     const DrawStyle& style) {
    use(style);
    figures_ += "<" + tag + " points=\"";
    for (const Vec2 corner : corners) {
        figures_ += place(corner) + " ";
    }
    figures_.back() = '"';
    figures_ += "/>\n";
}

/// Begins a group of figures with a style, unless the last one has it.
void SvgDraw::use(const DrawStyle& style) {
    std::string group = "</g>\n<g" + paint("stroke", style.line) + " stroke-width=\"" +
                        number(style.width) + "\"" + paint("fill", style.fill) + ">\n";
    if (group != group_) {
        figures_ += group;
        group_ = std::move(group);
    }
}

std::string svg(const World& world, const DrawOptions& options, const std::optional<Aabb>& view) {
    SvgDraw picture(view ? *view : viewOf(world));
    draw(world, picture, options);
    return picture.document();
}

} // namespace KODO_PRECISION
} // namespace kodo
