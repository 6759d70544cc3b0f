// SPDX-License-Identifier: MIT
#include <kodo_sfml/painter.hpp>

#include <SFML/System/String.hpp>

#include <cmath>

namespace kodo_sfml {

namespace {

/// Calls take(glyph, x of the pen) for each character. Returns the advance width.
template <typename Take>
float walk(const sf::Font& font, std::string_view utf8, unsigned height, Take take) {
    const sf::String text = sf::String::fromUtf8(utf8.begin(), utf8.end());
    float pen = 0;
    sf::Uint32 before = 0;
    for (const sf::Uint32 letter : text) {
        pen += font.getKerning(before, letter, height);
        const sf::Glyph& glyph = font.getGlyph(letter, height, false);
        take(glyph, pen);
        pen += glyph.advance;
        before = letter;
    }
    return pen;
}

} // namespace

void Painter::image(const sf::Texture& texture, sf::FloatRect part, sf::FloatRect where,
                    sf::Color tint) {
    use(Fill::Image, blend_, &texture);
    const auto corner = [&](float u, float v) {
        return sf::Vertex{{where.left + u * where.width, where.top + v * where.height},
                          tint,
                          {part.left + u * part.width, part.top + v * part.height}};
    };
    quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
}

void Painter::text(const sf::Font& font, std::string_view utf8, unsigned heightPixels,
                   sf::Vector2f start, sf::Color color) {
    // Glyphs are rasterised for whole pixels.
    const sf::Vector2f pen{std::round(start.x), std::round(start.y)};
    walk(font, utf8, heightPixels, [&](const sf::Glyph& glyph, float x) {
        if (glyph.textureRect.width > 0) {
            image(font.getTexture(heightPixels), sf::FloatRect(glyph.textureRect),
                  {pen.x + x + glyph.bounds.left, pen.y + glyph.bounds.top, glyph.bounds.width,
                   glyph.bounds.height},
                  color);
        }
    });
}

float textWidth(const sf::Font& font, std::string_view utf8, unsigned heightPixels) {
    return walk(font, utf8, heightPixels, [](const sf::Glyph&, float) {});
}

} // namespace kodo_sfml
