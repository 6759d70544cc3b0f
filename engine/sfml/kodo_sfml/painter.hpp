// SPDX-License-Identifier: MIT
#pragma once

#include <SFML/Graphics/Color.hpp>
#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/Graphics/Vertex.hpp>
#include <kodo_draw/mesh.hpp>

#include <memory>
#include <string_view>
#include <vector>

namespace kodo_sfml {

using kodo_draw::Blend;
using kodo_draw::Pixel;
using kodo_draw::Rect;
using kodo_draw::Rgba;
using kodo_draw::Size;

/// A Mesh that SFML draws, with text and textures.
class Painter : public kodo_draw::Mesh {
public:
    void draw(sf::RenderTarget& target) const;

    /// Draws a part (texels) of a texture into a rectangle. The texture must live until draw().
    void image(const sf::Texture& texture, Rect part, Rect where, Rgba tint = {255, 255, 255});
    /// One line of UTF-8 text; `start` lies on the base line. The font must live until draw().
    void text(const sf::Font& font, std::string_view utf8, unsigned heightPixels, Pixel start,
              Rgba color);

private:
    mutable std::unique_ptr<sf::Texture> edges_; // made by the first draw(), which has a display
    mutable std::vector<sf::Vertex> vertices_;   // scratch of draw()
};

/// Advance width of one line of text, in pixels. Loads the glyphs, so it needs a display.
float textWidth(const sf::Font& font, std::string_view utf8, unsigned heightPixels);

} // namespace kodo_sfml
