// SPDX-License-Identifier: MIT
#include <kodo_sfml/circle.hpp>
#include <kodo_sfml/painter.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo_sfml {

namespace {

constexpr float kLongestMitre = 3; // half widths; mitres of sharper corners are limited to it

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

/// Of images, whose colours are not premultiplied.
sf::BlendMode modeOfImage(Blend blend) {
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

sf::BlendMode modeOfShape(Blend blend) {
    const sf::BlendMode premultiplied(sf::BlendMode::One, sf::BlendMode::OneMinusSrcAlpha);
    return blend == Blend::Replace ? sf::BlendNone : premultiplied;
}

} // namespace

void Painter::clear() {
    vertices_.clear();
    runs_.clear();
    middles_.clear();
    middlesFirst_ = false;
    blend_ = Blend::Over;
}

void Painter::setMiddlesFirst(bool on) {
    if (on == middlesFirst_) {
        return;
    }
    middlesFirst_ = on;
    if (on) {
        use(Fill::Plain, Blend::Replace); // the run of the middles, empty as yet
        firstRun_ = runs_.size();
        firstVertex_ = vertices_.size();
        return;
    }
    vertices_.insert(vertices_.begin() + static_cast<std::ptrdiff_t>(firstVertex_),
                     middles_.begin(), middles_.end());
    for (std::size_t i = firstRun_; i < runs_.size(); ++i) {
        runs_[i].first += middles_.size();
    }
    middles_.clear();
}

void Painter::draw(sf::RenderTarget& target) const {
    if (!edges_) {
        edges_ = std::make_unique<sf::Texture>();
        edges_->loadFromImage(edgeImage());
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const std::size_t end = i + 1 < runs_.size() ? runs_[i + 1].first : vertices_.size();
        if (end == runs_[i].first) {
            continue;
        }
        const bool image = runs_[i].fill == Fill::Image;
        sf::RenderStates states(image ? modeOfImage(runs_[i].blend) : modeOfShape(runs_[i].blend));
        states.texture = runs_[i].fill == Fill::Edges ? edges_.get() : runs_[i].texture;
        target.draw(&vertices_[runs_[i].first], end - runs_[i].first, sf::Triangles, states);
    }
}

void Painter::use(Fill fill, Blend blend, const sf::Texture* texture) {
    if (fill != Fill::Image && blend == Blend::Add) {
        blend = Blend::Over; // see blended()
    }
    if (!runs_.empty() && runs_.back().blend == blend && runs_.back().fill == fill &&
        runs_.back().texture == texture) {
        return;
    }
    const bool ofMiddles = middlesFirst_ && runs_.size() == firstRun_;
    if (!runs_.empty() && runs_.back().first == vertices_.size() && !ofMiddles) {
        runs_.pop_back(); // empty run
    }
    runs_.push_back({vertices_.size(), blend, fill, texture});
}

/// For shapes without a fade: they continue a run of shapes with one.
void Painter::useAnyFill() {
    const bool edges = !runs_.empty() && runs_.back().fill == Fill::Edges;
    use(edges ? Fill::Edges : Fill::Plain, blend_);
}

/// Premultiplied by the opacity; the opacity of an added colour is 0. So one blend mode serves
/// both.
sf::Color Painter::blended(sf::Color color) const {
    const auto share = [&](sf::Uint8 part) {
        return static_cast<sf::Uint8>((part * color.a + 127) / 255);
    };
    return {share(color.r), share(color.g), share(color.b),
            blend_ == Blend::Add ? sf::Uint8{0} : color.a};
}

sf::Vertex Painter::opaque(sf::Vector2f place, sf::Color color) const {
    return {place, blended(color), opaqueTexel()};
}

sf::Vertex Painter::inside(sf::Vector2f place, sf::Color color, float pixels) const {
    return {place, blended(color), rampTexel(pixels)};
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
    const bool whole = std::all_of(colors.begin(), colors.end(),
                                   [](const sf::Color& color) { return color.a == 255; });
    // In software rendering it is cheaper not to read the destination.
    if (whole && blend_ == Blend::Over) {
        use(Fill::Plain, Blend::Replace);
    } else {
        useAnyFill();
    }
    const float right = where.left + where.width;
    const float bottom = where.top + where.height;
    quad(opaque({where.left, where.top}, colors[0]), opaque({right, where.top}, colors[1]),
         opaque({right, bottom}, colors[2]), opaque({where.left, bottom}, colors[3]));
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
    use(Fill::Edges, blend_);
    outwards(corners, sides_);
    const auto inner = [&](std::size_t i) {
        return inside(corners[i] - kFade * sides_[i], colors[i], 2 * kFade);
    };
    const auto outer = [&](std::size_t i) {
        return inside(corners[i] + kFade * sides_[i], colors[i], 0);
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
    useAnyFill();
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangle(opaque(corners[0], colors[0]), opaque(corners[i - 1], colors[i - 1]),
                 opaque(corners[i], colors[i]));
    }
}

void Painter::rimmed(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors,
                     float width, sf::Color rim) {
    const std::size_t count = corners.size();
    if (count < 3 || colors.size() < count) {
        return;
    }
    use(Fill::Edges, blend_);
    outwards(corners, sides_);
    const float depth = std::max(1.5f * width, 2 * kFade); // total rim opacity as without a fade
    const auto inner = [&](std::size_t i) {
        return inside(corners[i] - depth * sides_[i], colors[i], depth + kFade);
    };
    const auto outer = [&](std::size_t i) {
        return inside(corners[i] + kFade * sides_[i], over(colors[i], rim), 0);
    };
    innerCorners_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        innerCorners_.push_back(inner(i));
    }
    middle(innerCorners_);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        quad(innerCorners_[i], innerCorners_[next], outer(next), outer(i));
    }
}

void Painter::middle(std::span<const sf::Vertex> corners) {
    const bool first = middlesFirst_ && blend_ == Blend::Over &&
                       std::all_of(corners.begin(), corners.end(),
                                   [](const sf::Vertex& corner) { return corner.color.a == 255; });
    std::vector<sf::Vertex>& vertices = first ? middles_ : vertices_;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        vertices.insert(vertices.end(), {corners[0], corners[i - 1], corners[i]});
    }
}

/// A stroke of one width.
void Painter::band(const Knot& from, const Knot& to) {
    const StrokeProfile profile = strokeProfile(from.halfWidth);
    const auto at = [&](const Knot& knot, float side, sf::Vector2f texel) {
        sf::Color color = knot.color;
        color.a = static_cast<sf::Uint8>(static_cast<float>(color.a) * profile.opacity);
        return sf::Vertex{knot.place + side * profile.halfPixels * knot.side, blended(color),
                          texel};
    };
    if (!profile.halves) {
        return quad(at(from, -1, profile.left), at(to, -1, profile.left), at(to, 1, profile.right),
                    at(from, 1, profile.right));
    }
    quad(at(from, -1, profile.left), at(to, -1, profile.left), at(to, 0, profile.middle),
         at(from, 0, profile.middle));
    quad(at(from, 0, profile.middle), at(to, 0, profile.middle), at(to, 1, profile.right),
         at(from, 1, profile.right));
}

/// A stroke whose width changes.
void Painter::strip(const Knot& from, const Knot& to) {
    const auto at = [this](const Knot& knot, float side) {
        const float half = std::max(knot.halfWidth, kFade) + kFade;
        sf::Color color = knot.color; // thinner than a pixel: lower opacity instead
        const float share = std::min(knot.halfWidth / kFade, 1.0f);
        color.a = static_cast<sf::Uint8>(share * static_cast<float>(color.a));
        return inside(knot.place + side * half * knot.side, color, side == 0 ? half : 0);
    };
    quad(at(from, -1), at(to, -1), at(to, 0), at(from, 0));
    quad(at(from, 0), at(to, 0), at(to, 1), at(from, 1));
}

void Painter::ribbon(std::span<const sf::Vector2f> points, std::span<const float> widths,
                     std::span<const sf::Color> colors) {
    constexpr float kShortest = 0.05f; // pixels; shorter segments have no direction
    use(Fill::Edges, blend_);
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
    use(Fill::Edges, blend_);
    outwards(corners, sides_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        band({corners[i], sides_[i], 0.5f * width, color},
             {corners[next], sides_[next], 0.5f * width, color});
    }
}

void Painter::line(sf::Vector2f from, sf::Vector2f to, float width, sf::Color color) {
    use(Fill::Edges, blend_);
    const sf::Vector2f along = unit(to - from);
    const sf::Vector2f side{-along.y, along.x};
    band({from, side, 0.5f * width, color}, {to, side, 0.5f * width, color});
}

void Painter::disc(sf::Vector2f center, float radius, sf::Color middle, sf::Color rim) {
    const bool hard = rim.a > 0;
    if (hard) {
        use(Fill::Edges, blend_);
    } else {
        useAnyFill();
    }
    const int corners = cornersFor(radius);
    const float all = hard ? radius + kFade : radius;
    const sf::Vertex hub = hard ? inside(center, middle, all) : opaque(center, middle);
    const auto corner = [&](int i) {
        const sf::Vector2f place = onCircle(center, all, i, corners);
        return hard ? inside(place, rim, 0) : opaque(place, rim);
    };
    sf::Vertex before = corner(0);
    for (int i = 1; i <= corners; ++i) {
        const sf::Vertex here = corner(i);
        triangle(hub, before, here);
        before = here;
    }
}

void Painter::ring(sf::Vector2f center, float radius, float width, sf::Color color) {
    use(Fill::Edges, blend_);
    const int corners = cornersFor(radius);
    sf::Vector2f before = onCircle({}, 1, 0, corners);
    for (int i = 1; i <= corners; ++i) {
        const sf::Vector2f here = onCircle({}, 1, i, corners);
        band({center + radius * before, before, 0.5f * width, color},
             {center + radius * here, here, 0.5f * width, color});
        before = here;
    }
}

} // namespace kodo_sfml
