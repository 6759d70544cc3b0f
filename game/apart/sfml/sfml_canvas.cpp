// SPDX-License-Identifier: MIT
#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/layout.hpp>

#include <cmath>
#include <stdexcept>

namespace apart {

namespace {

sf::Color sfmlOf(Color color) {
    return {color.r, color.g, color.b, color.a};
}

} // namespace

SfmlCanvas::SfmlCanvas(const std::filesystem::path& fonts, sf::Vector2u pixels)
    : pixels_(pixels), steady_(layout::kShown, pixels), camera_(steady_) {
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
    camera_ = kodo_sfml::Camera({shown.lower - shake, shown.upper - shake}, pixels_);
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

void SfmlCanvas::disc(Vec2 center, Real radius, Color middle, Color rim) {
    painter_.disc(camera_.toPixels(center), camera_.toPixels(radius), sfmlOf(middle), sfmlOf(rim));
}

void SfmlCanvas::ring(Vec2 center, Real radius, Real width, Color color) {
    painter_.ring(camera_.toPixels(center), camera_.toPixels(radius), camera_.toPixels(width),
                  sfmlOf(color));
}

void SfmlCanvas::text(std::string_view utf8, Vec2 place, const TextStyle& style) {
    const float pixels = std::round(camera_.toPixels(style.height));
    if (pixels < 4 || style.color.a == 0) {
        return; // unreadable
    }
    const sf::Font& font = fonts_[static_cast<std::size_t>(style.face)];
    const auto height = static_cast<unsigned>(pixels);
    sf::Vector2f start = camera_.toPixels(place);
    if (style.align != Align::Left) {
        const float width = kodo_sfml::textWidth(font, utf8, height);
        start.x -= style.align == Align::Middle ? 0.5f * width : width;
    }
    painter_.text(font, utf8, height, start, sfmlOf(style.color));
}

} // namespace apart
