// SPDX-License-Identifier: MIT
#include <kodo_sfml/painter.hpp>

#include <SFML/System/String.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace kodo_sfml {

namespace {

constexpr float kTwoPi = 6.2831853f;
constexpr float kLongestMitre = 3; // half widths; sharper corners are cut there

/// Enough corners for a circle whose outline stays within a quarter of a pixel.
int cornersFor(float radius) {
    return std::clamp(static_cast<int>(5 * std::sqrt(std::max(radius, 0.0f))), 10, 96);
}

sf::Vector2f onCircle(sf::Vector2f center, float radius, int corner, int corners) {
    const float angle = kTwoPi * static_cast<float>(corner) / static_cast<float>(corners);
    return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
}

sf::Vector2f unit(sf::Vector2f v) {
    const float size = std::sqrt(v.x * v.x + v.y * v.y);
    return size > 0 ? v / size : sf::Vector2f{};
}

/// Half the mitre at a corner between two edge directions, for an outline of half width 1.
sf::Vector2f mitre(sf::Vector2f before, sf::Vector2f after) {
    const sf::Vector2f normalBefore{-before.y, before.x};
    const sf::Vector2f normalAfter{-after.y, after.x};
    const sf::Vector2f middle = unit(normalBefore + normalAfter);
    const float cosine = middle.x * normalAfter.x + middle.y * normalAfter.y;
    return middle * std::min(1 / std::max(cosine, 1e-3f), kLongestMitre);
}

/// Calls take(glyph, x of the pen) for each visible character and returns the pen's way.
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

void Painter::clear() {
    vertices_.clear();
    runs_.clear();
    blend_ = Blend::Over;
}

void Painter::draw(sf::RenderTarget& target) const {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const std::size_t end = i + 1 < runs_.size() ? runs_[i + 1].first : vertices_.size();
        sf::RenderStates states(runs_[i].blend == Blend::Add ? sf::BlendAdd : sf::BlendAlpha);
        states.texture = runs_[i].texture;
        target.draw(&vertices_[runs_[i].first], end - runs_[i].first, sf::Triangles, states);
    }
}

void Painter::use(const sf::Texture* texture) {
    if (!runs_.empty() && runs_.back().blend == blend_ && runs_.back().texture == texture) {
        return;
    }
    if (!runs_.empty() && runs_.back().first == vertices_.size()) {
        runs_.pop_back(); // nothing was added to it
    }
    runs_.push_back({vertices_.size(), blend_, texture});
}

void Painter::triangle(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c) {
    vertices_.push_back(a);
    vertices_.push_back(b);
    vertices_.push_back(c);
}

void Painter::quad(std::span<const sf::Vertex, 4> corners) {
    triangle(corners[0], corners[1], corners[2]);
    triangle(corners[0], corners[2], corners[3]);
}

void Painter::polygon(std::span<const sf::Vector2f> corners, sf::Color color) {
    use(nullptr);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangle({corners[0], color}, {corners[i - 1], color}, {corners[i], color});
    }
}

void Painter::polygon(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors) {
    use(nullptr);
    for (std::size_t i = 2; i < std::min(corners.size(), colors.size()); ++i) {
        triangle({corners[0], colors[0]}, {corners[i - 1], colors[i - 1]}, {corners[i], colors[i]});
    }
}

void Painter::outline(std::span<const sf::Vector2f> corners, float width, sf::Color color) {
    use(nullptr);
    const std::size_t count = corners.size();
    const auto mitreAt = [&](std::size_t i) {
        const sf::Vector2f before = unit(corners[i] - corners[(i + count - 1) % count]);
        const sf::Vector2f after = unit(corners[(i + 1) % count] - corners[i]);
        return mitre(before, after) * (0.5f * width);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const sf::Vector2f here = mitreAt(i);
        const sf::Vector2f there = mitreAt(next);
        quad(std::array<sf::Vertex, 4>{
            sf::Vertex{corners[i] - here, color}, sf::Vertex{corners[next] - there, color},
            sf::Vertex{corners[next] + there, color}, sf::Vertex{corners[i] + here, color}});
    }
}

void Painter::line(sf::Vector2f from, sf::Vector2f to, float width, sf::Color color) {
    use(nullptr);
    const sf::Vector2f along = unit(to - from);
    const sf::Vector2f side = sf::Vector2f{-along.y, along.x} * (0.5f * width);
    quad(std::array<sf::Vertex, 4>{sf::Vertex{from - side, color}, sf::Vertex{to - side, color},
                                   sf::Vertex{to + side, color}, sf::Vertex{from + side, color}});
}

void Painter::disc(sf::Vector2f center, float radius, sf::Color middle, sf::Color rim) {
    use(nullptr);
    const int corners = cornersFor(radius);
    sf::Vector2f before = onCircle(center, radius, 0, corners);
    for (int i = 1; i <= corners; ++i) {
        const sf::Vector2f here = onCircle(center, radius, i, corners);
        triangle({center, middle}, {before, rim}, {here, rim});
        before = here;
    }
}

void Painter::ring(sf::Vector2f center, float radius, float width, sf::Color color) {
    use(nullptr);
    const int corners = cornersFor(radius);
    const float inner = radius - 0.5f * width;
    const float outer = radius + 0.5f * width;
    for (int i = 0; i < corners; ++i) {
        quad(std::array<sf::Vertex, 4>{sf::Vertex{onCircle(center, inner, i, corners), color},
                                       sf::Vertex{onCircle(center, outer, i, corners), color},
                                       sf::Vertex{onCircle(center, outer, i + 1, corners), color},
                                       sf::Vertex{onCircle(center, inner, i + 1, corners), color}});
    }
}

void Painter::image(const sf::Texture& texture, sf::FloatRect part, sf::FloatRect where,
                    sf::Color tint) {
    use(&texture);
    const auto corner = [&](float u, float v) {
        return sf::Vertex{{where.left + u * where.width, where.top + v * where.height},
                          tint,
                          {part.left + u * part.width, part.top + v * part.height}};
    };
    quad(std::array<sf::Vertex, 4>{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
}

void Painter::text(const sf::Font& font, std::string_view utf8, unsigned heightPixels,
                   sf::Vector2f start, sf::Color color) {
    // Whole pixels: the glyphs are drawn for them.
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
