// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/layout.hpp>
#include <apart/stage/letterforms.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace apart {

namespace {

constexpr Real kCapitalShare = Real(0.72); // height of a capital relative to that of the text
constexpr float kFinestJoint = 0.7f;       // units of the display face
constexpr float kWidestJoint = 1.6f;

sf::Color sfmlOf(Color color) {
    return {color.r, color.g, color.b, color.a};
}

} // namespace

SfmlCanvas::SfmlCanvas(const std::filesystem::path& fonts, sf::Vector2u pixels)
    : pixels_(pixels), steady_(layout::kShown, pixels), shaken_(steady_), camera_(steady_) {
    const std::array<const char*, 2> files = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string path = (fonts / files[i]).string();
        if (!fonts_[i].loadFromFile(path)) {
            throw std::runtime_error("The font " + path + " cannot be read.");
        }
    }
}

void SfmlCanvas::begin(const Aabb& shown, Vec2 shake) {
    painter_.clear();
    steady_ = kodo_sfml::Camera(shown, pixels_);
    shaken_ = kodo_sfml::Camera({shown.lower - shake, shown.upper - shake}, pixels_);
    camera_ = shaken_;
}

void SfmlCanvas::zoom(Vec2 focus, Real scale) {
    const Aabb all = shaken_.shown();
    const auto nearer = [&](Vec2 corner) { return focus + (corner - focus) / scale; };
    camera_ =
        scale == 1 ? shaken_ : kodo_sfml::Camera({nearer(all.lower), nearer(all.upper)}, pixels_);
}

Aabb SfmlCanvas::visible() const {
    const auto width = static_cast<float>(pixels_.x);
    const auto height = static_cast<float>(pixels_.y);
    return {steady_.toWorld({0, height}), steady_.toWorld({width, 0})};
}

void SfmlCanvas::setGlow(bool on) {
    painter_.setBlend(on ? kodo_sfml::Blend::Add : kodo_sfml::Blend::Over);
}

std::span<const sf::Vector2f> SfmlCanvas::toPixels(std::span<const Vec2> corners) {
    corners_.clear();
    for (const Vec2 corner : corners) {
        corners_.push_back(camera_.toPixels(corner));
    }
    return corners_;
}

std::span<const sf::Color> SfmlCanvas::toSfml(std::span<const Color> colors) {
    colors_.clear();
    for (const Color color : colors) {
        colors_.push_back(sfmlOf(color));
    }
    return colors_;
}

void SfmlCanvas::rectangle(const Aabb& box, Color below, Color above) {
    const sf::Vector2f upperLeft = camera_.toPixels(Vec2{box.lower.x, box.upper.y});
    const sf::Vector2f lowerRight = camera_.toPixels(Vec2{box.upper.x, box.lower.y});
    const std::array<sf::Color, 4> colors = {sfmlOf(above), sfmlOf(above), sfmlOf(below),
                                             sfmlOf(below)};
    painter_.rectangle({upperLeft, lowerRight - upperLeft}, colors);
}

void SfmlCanvas::polygon(std::span<const Vec2> corners, Color color) {
    painter_.polygon(toPixels(corners), sfmlOf(color));
}

void SfmlCanvas::polygon(std::span<const Vec2> corners, std::span<const Color> colors) {
    painter_.polygon(toPixels(corners), toSfml(colors));
}

void SfmlCanvas::facet(std::span<const Vec2> corners, std::span<const Color> colors) {
    painter_.facet(toPixels(corners), toSfml(colors));
}

void SfmlCanvas::rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                        Color rim) {
    painter_.rimmed(toPixels(corners), toSfml(colors), camera_.toPixels(width), sfmlOf(rim));
}

void SfmlCanvas::outline(std::span<const Vec2> corners, Real width, Color color) {
    painter_.outline(toPixels(corners), camera_.toPixels(width), sfmlOf(color));
}

void SfmlCanvas::line(Vec2 from, Vec2 to, Real width, Color color) {
    painter_.line(camera_.toPixels(from), camera_.toPixels(to), camera_.toPixels(width),
                  sfmlOf(color));
}

void SfmlCanvas::ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                        std::span<const Color> colors) {
    widths_.clear();
    for (const Real width : widths) {
        widths_.push_back(camera_.toPixels(width));
    }
    painter_.ribbon(toPixels(points), widths_, toSfml(colors));
}

void SfmlCanvas::disc(Vec2 center, Real radius, Color middle, Color rim) {
    painter_.disc(camera_.toPixels(center), camera_.toPixels(radius), sfmlOf(middle), sfmlOf(rim));
}

void SfmlCanvas::ring(Vec2 center, Real radius, Real width, Color color) {
    painter_.ring(camera_.toPixels(center), camera_.toPixels(radius), camera_.toPixels(width),
                  sfmlOf(color));
}

/// False if the display face lacks a sign of the text.
bool SfmlCanvas::display(std::string_view text, Vec2 place, const TextStyle& style) {
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
            painter_.polygon(corners_, toSfml(colors));
        } else {
            painter_.rimmed(corners_, toSfml(colors), unitPixels * Real(0.8), sfmlOf(rim));
        }
    }
    return true;
}

void SfmlCanvas::text(std::string_view utf8, Vec2 place, const TextStyle& style) {
    if (style.color.a == 0) {
        return;
    }
    const bool stones = style.face == Typeface::Display;
    if (stones && display(utf8, place, style)) {
        return;
    }
    const sf::Font& font = fonts_[style.face == Typeface::Plain ? 0 : 1];
    const Real scale = stones ? Real(1) : textScale();
    float pixels = std::round(camera_.toPixels(scale * style.height));
    if (pixels < 4) {
        return; // unreadable
    }
    float width = kodo_sfml::textWidth(font, utf8, static_cast<unsigned>(pixels));
    if (const float room = camera_.toPixels(style.room); room > 0 && width > room) {
        pixels = std::max(std::floor(pixels * room / width), 4.0f);
        width = kodo_sfml::textWidth(font, utf8, static_cast<unsigned>(pixels));
        while (width > room && pixels > 4) { // letters have widths of whole pixels
            --pixels;
            width = kodo_sfml::textWidth(font, utf8, static_cast<unsigned>(pixels));
        }
    }
    const auto height = static_cast<unsigned>(pixels);
    sf::Vector2f start = camera_.toPixels(place);
    start.x -= style.align == Align::Left ? 0 : style.align == Align::Middle ? 0.5f * width : width;
    painter_.text(font, utf8, height, start, sfmlOf(style.color));
}

} // namespace apart
