// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <kodo_sfml/camera.hpp>
#include <kodo_sfml/painter.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace apart {

/// Canvas that collects the triangles of a picture in one Painter, to need few draw calls.
class SfmlCanvas : public Canvas {
public:
    /// Throws std::runtime_error if a font of the folder cannot be read. Needs a display.
    SfmlCanvas(const std::filesystem::path& fonts, sf::Vector2u pixels);

    /// Size of the picture, from the next begin() on.
    void setSize(sf::Vector2u pixels) { pixels_ = pixels; }
    const kodo_sfml::Painter& picture() const { return painter_; }
    kodo_sfml::Painter& painter() { return painter_; }
    /// Camera of the last picture, without shake.
    const kodo_sfml::Camera& camera() const { return steady_; }
    /// Camera of what is drawn next, with shake and zoom.
    const kodo_sfml::Camera& drawingCamera() const { return camera_; }

    void begin(const Aabb& shown, Vec2 shake) override;
    Aabb visible() const override;
    void zoom(Vec2 focus, Real scale) override;
    void setGlow(bool on) override;
    void setDisjoint(bool on) override { painter_.setMiddlesFirst(on); }
    void rectangle(const Aabb& box, Color below, Color above) override;
    void polygon(std::span<const Vec2> corners, Color color) override;
    void polygon(std::span<const Vec2> corners, std::span<const Color> colors) override;
    void facet(std::span<const Vec2> corners, std::span<const Color> colors) override;
    void rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                Color rim) override;
    void outline(std::span<const Vec2> corners, Real width, Color color) override;
    void line(Vec2 from, Vec2 to, Real width, Color color) override;
    using Canvas::ribbon;
    void ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                std::span<const Color> colors) override;
    void disc(Vec2 center, Real radius, Color middle, Color rim) override;
    void ring(Vec2 center, Real radius, Real width, Color color) override;
    void text(std::string_view utf8, Vec2 place, const TextStyle& style) override;

private:
    std::span<const sf::Vector2f> toPixels(std::span<const Vec2> corners);
    std::span<const sf::Color> toSfml(std::span<const Color> colors);
    bool display(std::string_view text, Vec2 place, const TextStyle& style);

    sf::Vector2u pixels_;
    kodo_sfml::Painter painter_;
    kodo_sfml::Camera steady_;
    kodo_sfml::Camera shaken_;          // with shake
    kodo_sfml::Camera camera_;          // with shake and zoom
    std::array<sf::Font, 2> fonts_;     // Plain and Bold
    std::vector<sf::Vector2f> corners_; // reused, to avoid allocations
    std::vector<sf::Color> colors_;
    std::vector<float> widths_;
};

} // namespace apart
