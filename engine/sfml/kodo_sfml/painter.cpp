// SPDX-License-Identifier: MIT
#include <kodo_sfml/painter.hpp>

#include <SFML/Graphics/BlendMode.hpp>
#include <SFML/Graphics/Image.hpp>
#include <SFML/System/String.hpp>
#include <kodo_draw/edge_texture.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace kodo_sfml {

using kodo_draw::Fill;
using kodo_draw::MeshRun;
using kodo_draw::MeshVertex;

namespace {

// Vertices are copied as bytes.
static_assert(std::is_trivially_copyable_v<sf::Vertex> &&
              sizeof(sf::Vertex) == sizeof(MeshVertex) &&
              offsetof(sf::Vertex, position) == offsetof(MeshVertex, place) &&
              offsetof(sf::Vertex, color) == offsetof(MeshVertex, color) &&
              offsetof(sf::Vertex, texCoords) == offsetof(MeshVertex, texel));

sf::BlendMode modeOf(const MeshRun& run) {
    if (run.blend == Blend::Replace) {
        return sf::BlendNone;
    }
    if (run.fill != Fill::Image) {
        return sf::BlendMode(sf::BlendMode::One, sf::BlendMode::OneMinusSrcAlpha);
    }
    return run.blend == Blend::Add ? sf::BlendAdd : sf::BlendAlpha;
}

sf::Image edgeImage() {
    const Size size = kodo_draw::edgeTextureSize();
    std::vector<sf::Uint8> texels;
    for (const std::uint8_t opacity : kodo_draw::edgeOpacities()) {
        texels.insert(texels.end(), 4, opacity);
    }
    sf::Image image;
    image.create(size.x, size.y, texels.data());
    return image;
}

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

void Painter::draw(sf::RenderTarget& target) const {
    if (!edges_) {
        edges_ = std::make_unique<sf::Texture>();
        edges_->loadFromImage(edgeImage());
    }
    vertices_.resize(vertices().size());
    if (!vertices_.empty()) {
        std::memcpy(static_cast<void*>(vertices_.data()), vertices().data(),
                    vertices().size_bytes());
    }
    for (std::size_t i = 0; i < runs().size(); ++i) {
        const MeshRun& run = runs()[i];
        const std::size_t end = i + 1 < runs().size() ? runs()[i + 1].first : vertices_.size();
        if (end > run.first) {
            sf::RenderStates states(modeOf(run));
            states.texture =
                run.fill == Fill::Edges ? edges_.get() : static_cast<const sf::Texture*>(run.image);
            target.draw(&vertices_[run.first], end - run.first, sf::Triangles, states);
        }
    }
}

void Painter::image(const sf::Texture& texture, Rect part, Rect where, Rgba tint) {
    Mesh::image(&texture, part, where, tint);
}

void Painter::text(const sf::Font& font, std::string_view utf8, unsigned heightPixels, Pixel start,
                   Rgba color) {
    // Glyphs are rasterised for whole pixels.
    const Pixel pen{std::round(start.x), std::round(start.y)};
    walk(font, utf8, heightPixels, [&](const sf::Glyph& glyph, float x) {
        const sf::IntRect& part = glyph.textureRect;
        if (part.width > 0) {
            image(font.getTexture(heightPixels),
                  {static_cast<float>(part.left), static_cast<float>(part.top),
                   static_cast<float>(part.width), static_cast<float>(part.height)},
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
