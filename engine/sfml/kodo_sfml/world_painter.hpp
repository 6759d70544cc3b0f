// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/debug_draw.hpp>
#include <kodo_sfml/painter.hpp>

#include <kodo_draw/camera.hpp>

namespace kodo_sfml {

using kodo_draw::Camera;

/// The picture that kodo::draw() fills, as triangles of a Painter:
///     kodo_sfml::WorldPainter picture(painter, camera);
///     kodo::draw(world, picture, {.contacts = true});
class WorldPainter : public kodo::DebugDraw {
public:
    /// Painter and font must live as long. Without a font no text is drawn.
    WorldPainter(Painter& painter, const Camera& camera, const sf::Font* font = nullptr)
        : painter_(painter), camera_(camera), font_(font) {}

    kodo::Aabb view() const override { return camera_.picture(); }
    kodo::Real pixel() const override { return 1 / camera_.toPixels(kodo::Real(1)); }
    void line(kodo::Vec2 from, kodo::Vec2 to, const kodo::DrawStyle& style) override;
    void circle(kodo::Vec2 center, kodo::Real radius, const kodo::DrawStyle& style) override;
    void polygon(std::span<const kodo::Vec2> corners, const kodo::DrawStyle& style) override;
    void text(kodo::Vec2 middle, std::string_view utf8, const kodo::DrawStyle& style) override;

private:
    Painter& painter_;
    Camera camera_;
    const sf::Font* font_;
    std::vector<Pixel> corners_; // scratch of polygon()
};

} // namespace kodo_sfml
