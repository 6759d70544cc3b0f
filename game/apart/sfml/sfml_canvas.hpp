// SPDX-License-Identifier: MIT
#pragma once

#include <apart/front/mesh_canvas.hpp>
#include <kodo_sfml/painter.hpp>

#include <array>
#include <filesystem>

namespace apart {

/// Canvas whose picture SFML draws.
class SfmlCanvas final : public MeshCanvas {
public:
    /// Throws std::runtime_error if a font of the folder cannot be read. Needs a display.
    SfmlCanvas(const std::filesystem::path& fonts, kodo_draw::Size pixels);

    const kodo_sfml::Painter& picture() const { return painter_; }
    kodo_sfml::Painter& painter() { return painter_; }

private:
    kodo_draw::Mesh& mesh() override { return painter_; }
    float textWidth(Typeface face, std::string_view utf8, unsigned heightPixels) override;
    void addText(Typeface face, std::string_view utf8, unsigned heightPixels,
                 kodo_draw::Pixel start, kodo_draw::Rgba color) override;
    const sf::Font& fontOf(Typeface face) const { return fonts_[face == Typeface::Plain ? 0 : 1]; }

    kodo_sfml::Painter painter_;
    std::array<sf::Font, 2> fonts_; // Plain and Bold
};

} // namespace apart
