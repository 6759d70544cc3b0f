// SPDX-License-Identifier: MIT
#include <kodo_draw/circle.hpp>
#include <kodo_draw/edge_texture.hpp>
#include <kodo_draw/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo_draw {

namespace {

constexpr float kLongestMitre = 3; // half widths; mitres of sharper corners are limited to it

/// Number of corners for which a circle deviates by less than a third of a pixel.
int cornersFor(float radius) {
    return std::clamp(static_cast<int>(4 * std::sqrt(std::max(radius, 0.0f))), 8, 96);
}

float length(Pixel v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

Pixel unit(Pixel v) {
    const float size = length(v);
    return size > 0 ? v / size : Pixel{};
}

/// Vector from a corner to its mitre for a half width of 1, from the directions of both edges.
Pixel mitre(Pixel before, Pixel after) {
    const Pixel normalBefore{-before.y, before.x};
    const Pixel normalAfter{-after.y, after.x};
    const Pixel middle = unit(normalBefore + normalAfter);
    const float cosine = middle.x * normalAfter.x + middle.y * normalAfter.y;
    return std::min(1 / std::max(cosine, 1e-3f), kLongestMitre) * middle;
}

/// For each corner, the outward vector that moves both adjacent edges outwards by 1.
void outwards(std::span<const Pixel> corners, std::vector<Pixel>& sides) {
    const std::size_t count = corners.size();
    float twiceArea = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Pixel a = corners[i];
        const Pixel b = corners[(i + 1) % count];
        twiceArea += a.x * b.y - a.y * b.x;
    }
    const float sign = twiceArea > 0 ? -1.0f : 1.0f;
    sides.clear();
    Pixel before = unit(corners[0] - corners[count - 1]);
    for (std::size_t i = 0; i < count; ++i) {
        const Pixel after = unit(corners[(i + 1) % count] - corners[i]);
        sides.push_back(sign * mitre(before, after));
        before = after;
    }
}

Rgba transparent(Rgba color) {
    return {color.r, color.g, color.b, 0};
}

/// Alpha compositing of `above` over `below`.
Rgba over(Rgba below, Rgba above) {
    const float aboveShare = static_cast<float>(above.a) / 255;
    const float belowShare = static_cast<float>(below.a) / 255 * (1 - aboveShare);
    const float all = aboveShare + belowShare;
    if (all <= 0) {
        return transparent(above);
    }
    const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(
            (aboveShare * static_cast<float>(a) + belowShare * static_cast<float>(b)) / all + 0.5f);
    };
    return {mixed(above.r, below.r), mixed(above.g, below.g), mixed(above.b, below.b),
            static_cast<std::uint8_t>(255 * all + 0.5f)};
}

} // namespace

void Mesh::clear() {
    vertices_.clear();
    runs_.clear();
    middles_.clear();
    middlesFirst_ = false;
    blend_ = Blend::Over;
}

void Mesh::setMiddlesFirst(bool on) {
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

void Mesh::use(Fill fill, Blend blend, const void* image) {
    if (fill != Fill::Image && blend == Blend::Add) {
        blend = Blend::Over; // see blended()
    }
    if (!runs_.empty() && runs_.back().blend == blend && runs_.back().fill == fill &&
        runs_.back().image == image) {
        return;
    }
    const bool ofMiddles = middlesFirst_ && runs_.size() == firstRun_;
    if (!runs_.empty() && runs_.back().first == vertices_.size() && !ofMiddles) {
        runs_.pop_back(); // empty run
    }
    runs_.push_back({vertices_.size(), blend, fill, image});
}

/// For shapes without a fade: they continue a run of shapes with one.
void Mesh::useAnyFill() {
    const bool edges = !runs_.empty() && runs_.back().fill == Fill::Edges;
    use(edges ? Fill::Edges : Fill::Plain, blend_);
}

/// Premultiplied by the opacity; the opacity of an added colour is 0. So one blend mode serves
/// both.
Rgba Mesh::blended(Rgba color) const {
    const auto share = [&](std::uint8_t part) {
        return static_cast<std::uint8_t>((part * color.a + 127) / 255);
    };
    return {share(color.r), share(color.g), share(color.b),
            blend_ == Blend::Add ? std::uint8_t{0} : color.a};
}

MeshVertex Mesh::opaque(Pixel place, Rgba color) const {
    return {place, blended(color), opaqueTexel()};
}

MeshVertex Mesh::inside(Pixel place, Rgba color, float pixels) const {
    return {place, blended(color), rampTexel(pixels)};
}

void Mesh::triangle(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c) {
    vertices_.push_back(a);
    vertices_.push_back(b);
    vertices_.push_back(c);
}

void Mesh::quad(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c,
                const MeshVertex& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void Mesh::rectangle(Rect where, std::span<const Rgba, 4> colors) {
    const bool whole =
        std::all_of(colors.begin(), colors.end(), [](const Rgba& color) { return color.a == 255; });
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

void Mesh::polygon(std::span<const Pixel> corners, Rgba color) {
    oneColor_.assign(corners.size(), color);
    fan(corners, oneColor_);
}

void Mesh::polygon(std::span<const Pixel> corners, std::span<const Rgba> colors) {
    fan(corners, colors);
}

void Mesh::fan(std::span<const Pixel> corners, std::span<const Rgba> colors) {
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

void Mesh::image(const void* texture, Rect part, Rect where, Rgba tint) {
    use(Fill::Image, blend_, texture);
    const auto corner = [&](float u, float v) {
        return MeshVertex{{where.left + u * where.width, where.top + v * where.height},
                          tint,
                          {part.left + u * part.width, part.top + v * part.height}};
    };
    quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
}

void Mesh::facet(std::span<const Pixel> corners, std::span<const Rgba> colors) {
    useAnyFill();
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangle(opaque(corners[0], colors[0]), opaque(corners[i - 1], colors[i - 1]),
                 opaque(corners[i], colors[i]));
    }
}

void Mesh::rimmed(std::span<const Pixel> corners, std::span<const Rgba> colors, float width,
                  Rgba rim) {
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

void Mesh::middle(std::span<const MeshVertex> corners) {
    const bool first = middlesFirst_ && blend_ == Blend::Over &&
                       std::all_of(corners.begin(), corners.end(),
                                   [](const MeshVertex& corner) { return corner.color.a == 255; });
    std::vector<MeshVertex>& vertices = first ? middles_ : vertices_;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        vertices.insert(vertices.end(), {corners[0], corners[i - 1], corners[i]});
    }
}

/// A stroke of one width.
void Mesh::band(const Knot& from, const Knot& to) {
    const StrokeProfile profile = strokeProfile(from.halfWidth);
    const auto at = [&](const Knot& knot, float side, Pixel texel) {
        Rgba color = knot.color;
        color.a = static_cast<std::uint8_t>(static_cast<float>(color.a) * profile.opacity);
        return MeshVertex{knot.place + side * profile.halfPixels * knot.side, blended(color),
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
void Mesh::strip(const Knot& from, const Knot& to) {
    const auto at = [this](const Knot& knot, float side) {
        const float half = std::max(knot.halfWidth, kFade) + kFade;
        Rgba color = knot.color; // thinner than a pixel: lower opacity instead
        const float share = std::min(knot.halfWidth / kFade, 1.0f);
        color.a = static_cast<std::uint8_t>(share * static_cast<float>(color.a));
        return inside(knot.place + side * half * knot.side, color, side == 0 ? half : 0);
    };
    quad(at(from, -1), at(to, -1), at(to, 0), at(from, 0));
    quad(at(from, 0), at(to, 0), at(to, 1), at(from, 1));
}

void Mesh::ribbon(std::span<const Pixel> points, std::span<const float> widths,
                  std::span<const Rgba> colors) {
    constexpr float kShortest = 0.05f; // pixels; shorter segments have no direction
    use(Fill::Edges, blend_);
    std::optional<Knot> before;
    Pixel along; // direction of the segment before
    for (std::size_t i = 0; i < points.size();) {
        std::size_t next = i + 1;
        while (next < points.size() && length(points[next] - points[i]) < kShortest) {
            ++next;
        }
        const Pixel after = next < points.size() ? unit(points[next] - points[i]) : along;
        const Pixel in = before ? along : after;
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

void Mesh::outline(std::span<const Pixel> corners, float width, Rgba color) {
    use(Fill::Edges, blend_);
    outwards(corners, sides_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        band({corners[i], sides_[i], 0.5f * width, color},
             {corners[next], sides_[next], 0.5f * width, color});
    }
}

void Mesh::line(Pixel from, Pixel to, float width, Rgba color) {
    use(Fill::Edges, blend_);
    const Pixel along = unit(to - from);
    const Pixel side{-along.y, along.x};
    band({from, side, 0.5f * width, color}, {to, side, 0.5f * width, color});
}

void Mesh::disc(Pixel center, float radius, Rgba middle, Rgba rim) {
    const bool hard = rim.a > 0;
    if (hard) {
        use(Fill::Edges, blend_);
    } else {
        useAnyFill();
    }
    const int corners = cornersFor(radius);
    const float all = hard ? radius + kFade : radius;
    const MeshVertex hub = hard ? inside(center, middle, all) : opaque(center, middle);
    const auto corner = [&](int i) {
        const Pixel place = onCircle(center, all, i, corners);
        return hard ? inside(place, rim, 0) : opaque(place, rim);
    };
    MeshVertex before = corner(0);
    for (int i = 1; i <= corners; ++i) {
        const MeshVertex here = corner(i);
        triangle(hub, before, here);
        before = here;
    }
}

void Mesh::ring(Pixel center, float radius, float width, Rgba color) {
    use(Fill::Edges, blend_);
    const int corners = cornersFor(radius);
    Pixel before = onCircle({}, 1, 0, corners);
    for (int i = 1; i <= corners; ++i) {
        const Pixel here = onCircle({}, 1, i, corners);
        band({center + radius * before, before, 0.5f * width, color},
             {center + radius * here, here, 0.5f * width, color});
        before = here;
    }
}

} // namespace kodo_draw
