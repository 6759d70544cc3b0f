// SPDX-License-Identifier: MIT
#include <kodo_sfml/circle.hpp>
#include <kodo_sfml/painter.hpp>

#include <SFML/System/String.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo_sfml {

namespace {

constexpr float kLongestMitre = 3; // half widths; mitres of sharper corners are limited to it
constexpr float kFade = 0.5f;      // pixels; an edge fades over this distance on both sides
constexpr float kThin = 1;         // pixels; a stroke of smaller half width has no opaque core

/// Number of corners for which a circle deviates by less than a third of a pixel.
int cornersFor(float radius) {
    return std::clamp(static_cast<int>(4 * std::sqrt(std::max(radius, 0.0f))), 8, 96);
}

float length(sf::Vector2f v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

sf::Vector2f unit(sf::Vector2f v) {
    const float size = length(v);
    return size > 0 ? v / size : sf::Vector2f{};
}

/// Vector from a corner to its mitre for a half width of 1, from the directions of both edges.
sf::Vector2f mitre(sf::Vector2f before, sf::Vector2f after) {
    const sf::Vector2f normalBefore{-before.y, before.x};
    const sf::Vector2f normalAfter{-after.y, after.x};
    const sf::Vector2f middle = unit(normalBefore + normalAfter);
    const float cosine = middle.x * normalAfter.x + middle.y * normalAfter.y;
    return middle * std::min(1 / std::max(cosine, 1e-3f), kLongestMitre);
}

/// For each corner, the outward vector that moves both adjacent edges outwards by 1.
void outwards(std::span<const sf::Vector2f> corners, std::vector<sf::Vector2f>& sides) {
    const std::size_t count = corners.size();
    float twiceArea = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const sf::Vector2f a = corners[i];
        const sf::Vector2f b = corners[(i + 1) % count];
        twiceArea += a.x * b.y - a.y * b.x;
    }
    const float sign = twiceArea > 0 ? -1.0f : 1.0f;
    sides.clear();
    sf::Vector2f before = unit(corners[0] - corners[count - 1]);
    for (std::size_t i = 0; i < count; ++i) {
        const sf::Vector2f after = unit(corners[(i + 1) % count] - corners[i]);
        sides.push_back(sign * mitre(before, after));
        before = after;
    }
}

sf::Color transparent(sf::Color color) {
    return {color.r, color.g, color.b, 0};
}

/// Alpha compositing of `above` over `below`.
sf::Color over(sf::Color below, sf::Color above) {
    const float aboveShare = static_cast<float>(above.a) / 255;
    const float belowShare = static_cast<float>(below.a) / 255 * (1 - aboveShare);
    const float all = aboveShare + belowShare;
    if (all <= 0) {
        return transparent(above);
    }
    const auto mixed = [&](sf::Uint8 a, sf::Uint8 b) {
        return static_cast<sf::Uint8>(
            (aboveShare * static_cast<float>(a) + belowShare * static_cast<float>(b)) / all + 0.5f);
    };
    return {mixed(above.r, below.r), mixed(above.g, below.g), mixed(above.b, below.b),
            static_cast<sf::Uint8>(255 * all + 0.5f)};
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

sf::BlendMode modeOf(Blend blend) {
    switch (blend) {
    case Blend::Over:
        return sf::BlendAlpha;
    case Blend::Add:
        return sf::BlendAdd;
    case Blend::Replace:
        break;
    }
    return sf::BlendNone;
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
        sf::RenderStates states(modeOf(runs_[i].blend));
        states.texture = runs_[i].texture;
        target.draw(&vertices_[runs_[i].first], end - runs_[i].first, sf::Triangles, states);
    }
}

void Painter::use(const sf::Texture* texture, Blend blend) {
    if (!runs_.empty() && runs_.back().blend == blend && runs_.back().texture == texture) {
        return;
    }
    if (!runs_.empty() && runs_.back().first == vertices_.size()) {
        runs_.pop_back(); // empty run
    }
    runs_.push_back({vertices_.size(), blend, texture});
}

void Painter::triangle(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c) {
    vertices_.push_back(a);
    vertices_.push_back(b);
    vertices_.push_back(c);
}

void Painter::quad(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c,
                   const sf::Vertex& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void Painter::rectangle(sf::FloatRect where, std::span<const sf::Color, 4> colors) {
    const bool opaque = std::all_of(colors.begin(), colors.end(),
                                    [](const sf::Color& color) { return color.a == 255; });
    // In software rendering it is cheaper not to read the destination.
    use(nullptr, opaque && blend_ == Blend::Over ? Blend::Replace : blend_);
    const float right = where.left + where.width;
    const float bottom = where.top + where.height;
    quad({{where.left, where.top}, colors[0]}, {{right, where.top}, colors[1]},
         {{right, bottom}, colors[2]}, {{where.left, bottom}, colors[3]});
}

void Painter::polygon(std::span<const sf::Vector2f> corners, sf::Color color) {
    oneColor_.assign(corners.size(), color);
    fan(corners, oneColor_);
}

void Painter::polygon(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors) {
    fan(corners, colors);
}

void Painter::fan(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors) {
    const std::size_t count = corners.size();
    if (count < 3 || colors.size() < count) {
        return;
    }
    use(nullptr, blend_);
    outwards(corners, sides_);
    const auto inner = [&](std::size_t i) {
        return sf::Vertex{corners[i] - kFade * sides_[i], colors[i]};
    };
    const auto outer = [&](std::size_t i) {
        return sf::Vertex{corners[i] + kFade * sides_[i], transparent(colors[i])};
    };
    for (std::size_t i = 2; i < count; ++i) {
        triangle(inner(0), inner(i - 1), inner(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        quad(inner(i), inner(next), outer(next), outer(i));
    }
}

void Painter::facet(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors) {
    use(nullptr, blend_);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangle({corners[0], colors[0]}, {corners[i - 1], colors[i - 1]}, {corners[i], colors[i]});
    }
}

void Painter::rimmed(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors,
                     float width, sf::Color rim) {
    const std::size_t count = corners.size();
    if (count < 3 || colors.size() < count) {
        return;
    }
    use(nullptr, blend_);
    outwards(corners, sides_);
    const float depth = std::max(1.5f * width, 2 * kFade); // total rim opacity as without a fade
    const auto inner = [&](std::size_t i) {
        return sf::Vertex{corners[i] - depth * sides_[i], colors[i]};
    };
    for (std::size_t i = 2; i < count; ++i) {
        triangle(inner(0), inner(i - 1), inner(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const auto edge = [&](std::size_t corner, float out, sf::Color color) {
            return sf::Vertex{corners[corner] + out * sides_[corner], color};
        };
        const sf::Color from = over(colors[i], rim);
        const sf::Color to = over(colors[next], rim);
        const sf::Vertex rimFrom = edge(i, -kFade, from);
        const sf::Vertex rimTo = edge(next, -kFade, to);
        quad(inner(i), inner(next), rimTo, rimFrom);
        quad(rimFrom, rimTo, edge(next, kFade, transparent(to)), edge(i, kFade, transparent(from)));
    }
}

void Painter::band(const Band& band, sf::Color color) {
    if (band.halfWidth < kFade) { // thinner than a pixel: lower opacity instead
        color.a = static_cast<sf::Uint8>(static_cast<float>(color.a) * band.halfWidth / kFade);
    }
    // A narrow core would cost as many triangles as a wide one and be hardly visible.
    const float core = band.halfWidth < kThin ? 0 : band.halfWidth - kFade;
    const float rim =
        band.halfWidth < kThin ? std::max(2 * band.halfWidth, 2 * kFade) : band.halfWidth + kFade;
    const sf::Color none = transparent(color);
    const auto from = [&](float side, sf::Color c) {
        return sf::Vertex{band.from + side * band.fromSide, c};
    };
    const auto to = [&](float side, sf::Color c) {
        return sf::Vertex{band.to + side * band.toSide, c};
    };
    quad(from(-rim, none), to(-rim, none), to(-core, color), from(-core, color));
    if (core > 0) {
        quad(from(-core, color), to(-core, color), to(core, color), from(core, color));
    }
    quad(from(core, color), to(core, color), to(rim, none), from(rim, none));
}

void Painter::strip(const Knot& from, const Knot& to) {
    const auto at = [](const Knot& knot, float side, sf::Color color) {
        return sf::Vertex{knot.place + side * knot.side, color};
    };
    const auto core = [](const Knot& knot) { return std::max(knot.halfWidth - kFade, 0.0f); };
    const auto rim = [](const Knot& knot) { return std::max(knot.halfWidth, kFade) + kFade; };
    const auto color = [](const Knot& knot) { // thinner than a pixel: lower opacity instead
        sf::Color faint = knot.color;
        const float share = std::min(knot.halfWidth / kFade, 1.0f);
        faint.a = static_cast<sf::Uint8>(share * static_cast<float>(faint.a));
        return faint;
    };
    const sf::Color first = color(from);
    const sf::Color last = color(to);
    quad(at(from, -rim(from), transparent(first)), at(to, -rim(to), transparent(last)),
         at(to, -core(to), last), at(from, -core(from), first));
    quad(at(from, -core(from), first), at(to, -core(to), last), at(to, core(to), last),
         at(from, core(from), first));
    quad(at(from, core(from), first), at(to, core(to), last), at(to, rim(to), transparent(last)),
         at(from, rim(from), transparent(first)));
}

void Painter::ribbon(std::span<const sf::Vector2f> points, std::span<const float> widths,
                     std::span<const sf::Color> colors) {
    constexpr float kShortest = 0.05f; // pixels; shorter segments have no direction
    use(nullptr, blend_);
    std::optional<Knot> before;
    sf::Vector2f along; // direction of the segment before
    for (std::size_t i = 0; i < points.size();) {
        std::size_t next = i + 1;
        while (next < points.size() && length(points[next] - points[i]) < kShortest) {
            ++next;
        }
        const sf::Vector2f after = next < points.size() ? unit(points[next] - points[i]) : along;
        const sf::Vector2f in = before ? along : after;
        Knot knot{points[i], {}, 0.5f * widths[i], colors[i]};
        if (in.x * after.x + in.y * after.y < 0) { // a sharp bend: turn on the spot
            knot.side = {-in.y, in.x};
            strip(*before, knot);
            before = knot;
            knot.side = {-after.y, after.x};
        } else {
            knot.side = mitre(in, after);
        }
        if (before) {
            strip(*before, knot);
        }
        before = knot;
        along = after;
        i = next;
    }
}

void Painter::outline(std::span<const sf::Vector2f> corners, float width, sf::Color color) {
    use(nullptr, blend_);
    outwards(corners, sides_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        band({corners[i], sides_[i], corners[next], sides_[next], 0.5f * width}, color);
    }
}

void Painter::line(sf::Vector2f from, sf::Vector2f to, float width, sf::Color color) {
    use(nullptr, blend_);
    const sf::Vector2f along = unit(to - from);
    const sf::Vector2f side{-along.y, along.x};
    band({from, side, to, side, 0.5f * width}, color);
}

void Painter::disc(sf::Vector2f center, float radius, sf::Color middle, sf::Color rim) {
    use(nullptr, blend_);
    const int corners = cornersFor(radius);
    const bool hard = rim.a > 0;
    const float inside = hard ? std::max(radius - kFade, 0.0f) : radius;
    sf::Vector2f before = onCircle({}, 1, 0, corners);
    for (int i = 1; i <= corners; ++i) {
        const sf::Vector2f here = onCircle({}, 1, i, corners);
        const sf::Vertex a{center + inside * before, rim};
        const sf::Vertex b{center + inside * here, rim};
        if (middle != rim) {
            triangle({center, middle}, a, b);
        } else if (i > 1 && i < corners) { // fan from the first corner
            triangle({center + inside * onCircle({}, 1, 0, corners), rim}, a, b);
        }
        if (hard) {
            quad(a, b, {center + (radius + kFade) * here, transparent(rim)},
                 {center + (radius + kFade) * before, transparent(rim)});
        }
        before = here;
    }
}

void Painter::ring(sf::Vector2f center, float radius, float width, sf::Color color) {
    use(nullptr, blend_);
    const int corners = cornersFor(radius);
    sf::Vector2f before = onCircle({}, 1, 0, corners);
    for (int i = 1; i <= corners; ++i) {
        const sf::Vector2f here = onCircle({}, 1, i, corners);
        band({center + radius * before, before, center + radius * here, here, 0.5f * width}, color);
        before = here;
    }
}

void Painter::image(const sf::Texture& texture, sf::FloatRect part, sf::FloatRect where,
                    sf::Color tint) {
    use(&texture, blend_);
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
