// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "shapes/outline.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

using Corners = std::vector<Vec2>;

bool isGood(const Corners& corners) {
    return !check(Primitive(Polygon{corners}));
}

/// What is at a corner of the outline that is left.
enum class Corner : std::uint8_t { Flat, Ear, Other };

/// Ear: the triangle with both neighbours lies inside the outline.
Corner cornerAt(const Corners& outline, std::size_t i) {
    const std::size_t n = outline.size();
    const Vec2 a = outline[(i + n - 1) % n];
    const Vec2 p = outline[i];
    const Vec2 b = outline[(i + 1) % n];
    if (isFlat(a, p, b)) {
        return Corner::Flat;
    }
    if (cross(p - a, b - p) <= 0) {
        return Corner::Other;
    }
    for (const Vec2 q : outline) {
        const bool isOwn = q == a || q == p || q == b;
        if (!isOwn && cross(p - a, q - a) >= 0 && cross(b - p, q - p) >= 0 &&
            cross(a - b, q - b) >= 0) {
            return Corner::Other;
        }
    }
    return isGood({a, p, b}) ? Corner::Ear : Corner::Flat; // a needle is as good as nothing
}

/// Cuts off one ear after the other [Meisters75]. Flat corners are left out. Empty if rounding
/// leaves no ear.
std::vector<Corners> triangulate(Corners outline) {
    std::vector<Corners> triangles;
    std::size_t at = 0;
    for (std::size_t tried = 0; outline.size() >= 3;) {
        const std::size_t n = outline.size();
        const std::size_t i = at % n;
        const Corner kind = cornerAt(outline, i);
        at = i + 1; // the next ear beside this one would be the tip of a fan
        if (kind == Corner::Other) {
            if (++tried == n) {
                return {};
            }
            continue;
        }
        if (kind == Corner::Ear) {
            triangles.push_back({outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]});
        }
        outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
        tried = 0;
    }
    return triangles;
}

/// Two pieces without a common edge between corners i and k of the first and the second.
Corners joined(const Corners& a, std::size_t i, const Corners& b, std::size_t k) {
    Corners all; // from the end of the edge around a to its start, and on around b
    for (std::size_t step = 1; step <= a.size(); ++step) {
        all.push_back(a[(i + step) % a.size()]);
    }
    for (std::size_t step = 2; step < b.size(); ++step) {
        all.push_back(b[(k + step) % b.size()]);
    }
    return all;
}

/// Replaces piece a by its union with b, if they have a common edge and the union is convex.
bool join(Corners& a, const Corners& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            if (a[i] != b[(k + 1) % b.size()] || a[(i + 1) % a.size()] != b[k]) {
                continue;
            }
            Corners all = joined(a, i, b, k);
            dropFlatCorners(all);
            if (isGood(all)) {
                a = std::move(all);
                return true;
            }
            return false;
        }
    }
    return false;
}

/// Removes each edge between two pieces whose union is convex [Hertel83]: at most four times as
/// many pieces are left as the fewest possible.
void joinAll(std::vector<Corners>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = i + 1; k < pieces.size();) {
            if (join(pieces[i], pieces[k])) {
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
                k = i + 1; // the larger piece may have an edge with those before
            } else {
                ++k;
            }
        }
    }
}

std::optional<Problem> checkPoints(std::span<const Vec2> outline) {
    const std::size_t n = outline.size();
    if (n < 3 || n > kMaxCorners) {
        return Problem{"outline", "must be from 3 to " + std::to_string(kMaxCorners) +
                                      " points, but there are " + std::to_string(n)};
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::string field = "outline[" + std::to_string(i) + "]";
        if (const auto problem = check(Primitive(Point{outline[i]}))) {
            return Problem{field, problem->reason};
        }
        if (outline[i] == outline[(i + 1) % n]) {
            return Problem{field, "is the same point as the next one: leave one out"};
        }
    }
    if (const auto pair = edgesThatMeet(outline)) {
        return Problem{"outline[" + std::to_string(pair->second) + "]",
                       "begins an edge that crosses or touches the one from outline[" +
                           std::to_string(pair->first) +
                           "]: an outline must not meet itself, and has no holes"};
    }
    return std::nullopt;
}

} // namespace

std::variant<Compound, Problem> decompose(std::span<const Vec2> outline) {
    if (auto problem = checkPoints(outline)) {
        return *std::move(problem);
    }
    Corners corners(outline.begin(), outline.end());
    if (areaWithin(corners) < 0) {
        std::reverse(corners.begin(), corners.end());
    }
    std::vector<Corners> pieces = triangulate(std::move(corners));
    if (pieces.empty()) {
        return Problem{"outline", "is too thin to be divided, as far as numbers resolve"};
    }
    joinAll(pieces);
    Compound compound;
    for (Corners& piece : pieces) {
        compound.parts.emplace_back(Polygon{std::move(piece)});
    }
    return compound;
}

} // namespace KODO_PRECISION
} // namespace kodo
