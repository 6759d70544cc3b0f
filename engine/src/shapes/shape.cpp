// SPDX-License-Identifier: MIT
#include <kodo/math.hpp>
#include <kodo/shape.hpp>

#include "base/checks.hpp"
#include "math/vec2_checks.hpp"
#include "shapes/outline.hpp"

#include <algorithm>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

std::string corner(std::size_t i) {
    return "corners[" + std::to_string(i) + "]";
}

std::optional<Problem> checkPoint(const std::string& field, Vec2 point) {
    return checkCoordinates(field.c_str(), point, kMaxLength, "m");
}

std::optional<Problem> checkSize(const char* field, Real length) {
    return checkPositive(field, length, kMaxLength, "m");
}

std::optional<Problem> checkRadius(Real radius) {
    return checkRange("radius", radius, 0, kMaxLength, "m");
}

std::optional<Problem> check(const Circle& circle) {
    return firstOf({checkPoint("center", circle.center), checkSize("radius", circle.radius)});
}

std::optional<Problem> check(const Capsule& capsule) {
    return firstOf({checkPoint("from", capsule.from), checkPoint("to", capsule.to),
                    checkSize("radius", capsule.radius)});
}

std::optional<Problem> check(const Box& box) {
    return firstOf({checkSize("width", box.width), checkSize("height", box.height),
                    checkRotation("rotation", box.rotation), checkRadius(box.radius),
                    checkPoint("center", box.center)});
}

std::optional<Problem> checkDistinct(const std::vector<Vec2>& corners) {
    for (std::size_t k = 1; k < corners.size(); ++k) {
        for (std::size_t i = 0; i < k; ++i) {
            if (corners[i] == corners[k]) {
                return Problem{corner(k), "is the same point as corner " + std::to_string(i) +
                                              ": leave it out, or use convexHull()"};
            }
        }
    }
    return std::nullopt;
}

/// Corner k is not left of the edge from corner i: names the reason.
Problem whyNotConvex(const std::vector<Vec2>& corners, std::size_t i, std::size_t k) {
    const std::size_t n = corners.size();
    if (const auto pair = n > 3 ? edgesThatMeet(corners) : std::nullopt) {
        return {corner(pair->second), "begins an edge that crosses the edge from corner " +
                                          std::to_string(pair->first) + " to corner " +
                                          std::to_string((pair->first + 1) % n) +
                                          ": convexHull() gives an outline around all corners"};
    }
    const auto turnAt = [&](std::size_t at) { // > 0 to the left
        const Vec2 before = corners[(at + n - 1) % n];
        return cross(corners[at] - before, corners[(at + 1) % n] - corners[at]);
    };
    std::size_t reflex = n;
    for (std::size_t at = n; at-- > 0;) {
        reflex = turnAt(at) < 0 ? at : reflex;
    }
    if (areaWithin(corners) < 0) {
        return {"corners", "go clockwise: give them counter-clockwise, or use convexHull()"};
    }
    if (reflex < n) {
        return {corner(reflex), "points inwards, so the outline is not convex: split it into "
                                "polygons of a Compound, or use convexHull()"};
    }
    const char* const remedy =
        n == 3 ? "a triangle needs an area" : "leave out the corner between, or use convexHull()";
    return {corner(k), "lies on the line from corner " + std::to_string(i) + " to corner " +
                           std::to_string((i + 1) % n) + ", as far as numbers resolve: " + remedy};
}

/// Reports the first corner at which the polygon is not strictly convex and counter-clockwise.
std::optional<Problem> checkConvex(const std::vector<Vec2>& corners, Real flatness) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const Vec2 edge = corners[j] - corners[i];
        const Real size = length(edge);
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i || k == j) {
                continue;
            }
            const Vec2 arm = corners[k] - corners[i];
            const Real height = cross(edge, arm) / size;
            if (!(height > flatness * std::max(size, length(arm)))) {
                return whyNotConvex(corners, i, k);
            }
        }
    }
    return std::nullopt;
}

std::optional<Problem> check(const Polygon& polygon, Real flatness = kFlatness) {
    const std::size_t n = polygon.corners.size();
    if (n < 3 || n > kMaxCorners) {
        return Problem{"corners", "must be from 3 to " + std::to_string(kMaxCorners) +
                                      " points, but there are " + std::to_string(n)};
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (auto problem = checkPoint(corner(i), polygon.corners[i])) {
            return problem;
        }
    }
    if (auto problem = firstOf({checkRadius(polygon.radius), checkDistinct(polygon.corners)})) {
        return problem;
    }
    return checkConvex(polygon.corners, flatness);
}

std::optional<Problem> check(const Point& point) {
    return checkPoint("position", point.position);
}

/// Checks a point of a segment: it must be finite and differ from its neighbour, called `other`.
std::optional<Problem> checkEnd(const char* field, Vec2 point, Vec2 neighbour, const char* other) {
    if (auto problem = checkPoint(field, point)) {
        return problem;
    }
    if (!(lengthSquared(point - neighbour) > 0)) {
        return Problem{field, "must differ from `" + std::string(other) + "`, but both are " +
                                  textOf(point) + (point == neighbour ? "" : ", to rounding")};
    }
    return std::nullopt;
}

std::optional<Problem> check(const Segment& segment) {
    if (auto problem = firstOf(
            {checkPoint("from", segment.from), checkEnd("to", segment.to, segment.from, "from")})) {
        return problem;
    }
    if (segment.oneSided && segment.radius > 0) {
        return Problem{"radius", "is only for two-sided segments: a one-sided one has no inside"};
    }
    return checkRadius(segment.radius);
}

std::optional<Problem> check(const Plane& plane) {
    return firstOf({checkUnit("normal", plane.normal),
                    checkRange("offset", plane.offset, -kMaxLength, kMaxLength, "m")});
}

Vec2 pointOf(const Heightmap& map, std::size_t i) {
    return map.origin + Vec2{static_cast<Real>(i) * map.spacing, map.heights[i]};
}

std::optional<Problem> check(const Heightmap& map) {
    if (auto problem =
            firstOf({checkPoint("origin", map.origin), checkSize("spacing", map.spacing)})) {
        return problem;
    }
    const std::size_t n = map.heights.size();
    if (n < 2 || n > kMaxHeights) {
        return Problem{"heights", "must be from 2 to " + std::to_string(kMaxHeights) +
                                      " numbers, but there are " + std::to_string(n)};
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::string field = "heights[" + std::to_string(i) + "]";
        if (auto problem = checkPoint(field, pointOf(map, i))) {
            return problem;
        }
        if (i > 0 && !(pointOf(map, i).x > pointOf(map, i - 1).x)) {
            return Problem{"spacing", "is lost in rounding so far from the origin"};
        }
    }
    return std::nullopt;
}

std::vector<Primitive> piecesOf(const Heightmap& map) {
    std::vector<Primitive> cells;
    cells.reserve(map.heights.size() - 1);
    for (std::size_t i = 0; i + 1 < map.heights.size(); ++i) {
        cells.emplace_back(Segment{pointOf(map, i), pointOf(map, i + 1), true});
    }
    return cells;
}

std::size_t segmentsOf(const Chain& chain) {
    return chain.points.size() - (chain.closed ? 0 : 1);
}

std::optional<Problem> check(const Chain& chain) {
    const std::size_t n = chain.points.size();
    const std::size_t least = chain.closed ? 3 : 2;
    const std::size_t most = kMaxParts + (chain.closed ? 0 : 1);
    if (n < least || n > most) {
        return Problem{"points", "must be from " + std::to_string(least) + " to " +
                                     std::to_string(most) + ", but there are " + std::to_string(n)};
    }
    const auto nameOf = [](std::size_t i) { return "points[" + std::to_string(i) + "]"; };
    if (auto problem = checkPoint(nameOf(0), chain.points[0])) {
        return problem;
    }
    for (std::size_t i = 0; i < segmentsOf(chain); ++i) {
        const std::size_t next = (i + 1) % n;
        if (auto problem = checkEnd(nameOf(next).c_str(), chain.points[next], chain.points[i],
                                    nameOf(i).c_str())) {
            return problem;
        }
    }
    if (!chain.materials.empty() && chain.materials.size() != segmentsOf(chain)) {
        return Problem{"materials", "must be one for each of the " +
                                        std::to_string(segmentsOf(chain)) +
                                        " segments, or none, but there are " +
                                        std::to_string(chain.materials.size())};
    }
    for (std::size_t i = 0; i < chain.materials.size(); ++i) {
        if (auto problem = check(chain.materials[i])) {
            problem->field.replace(0, std::string("material").size(),
                                   "materials[" + std::to_string(i) + "]");
            return problem;
        }
    }
    const bool hasOutside = chain.closed && chain.oneSided;
    if (const auto pair = hasOutside ? edgesThatMeet(chain.points) : std::nullopt) {
        return Problem{nameOf(pair->second),
                       "begins an edge that crosses or touches the one from " +
                           nameOf(pair->first) + ": a one-sided outline must not meet itself"};
    }
    return std::nullopt;
}

std::vector<Primitive> piecesOf(const Chain& chain) {
    const std::size_t n = chain.points.size();
    // The outside is on the left of the points of a clockwise outline.
    const bool turned = chain.closed && chain.oneSided && areaWithin(chain.points) > 0;
    std::vector<Primitive> segments;
    segments.reserve(segmentsOf(chain));
    for (std::size_t i = 0; i < segmentsOf(chain); ++i) {
        const Vec2 from = chain.points[i];
        const Vec2 to = chain.points[(i + 1) % n];
        segments.emplace_back(turned ? Segment{to, from, true} : Segment{from, to, chain.oneSided});
    }
    return segments;
}

std::vector<Primitive> piecesOf(const Compound& compound) {
    return compound.parts;
}

template <typename Kind>
std::vector<Primitive> piecesOf(const Kind& kind) {
    return {kind};
}

std::optional<Problem> check(const Compound& compound) {
    const std::size_t n = compound.parts.size();
    if (n < 1 || n > kMaxParts) {
        return Problem{"parts", "must be from 1 to " + std::to_string(kMaxParts) +
                                    " primitives, but there are " + std::to_string(n)};
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (auto problem = check(compound.parts[i])) {
            problem->field = "parts[" + std::to_string(i) + "]." + problem->field;
            return problem;
        }
    }
    return std::nullopt;
}

Circle movedShape(const Circle& circle, const Transform& t) {
    return {circle.radius, t * circle.center};
}

Capsule movedShape(const Capsule& capsule, const Transform& t) {
    return {t * capsule.from, t * capsule.to, capsule.radius};
}

Box movedShape(const Box& box, const Transform& t) {
    return {box.width, box.height, t * box.center, normalize(t.rotation * box.rotation),
            box.radius};
}

Polygon movedShape(const Polygon& polygon, const Transform& t) {
    Polygon result = polygon;
    for (Vec2& corner : result.corners) {
        corner = t * corner;
    }
    return result;
}

Point movedShape(const Point& point, const Transform& t) {
    return {t * point.position};
}

Segment movedShape(const Segment& segment, const Transform& t) {
    return {t * segment.from, t * segment.to, segment.oneSided, segment.radius};
}

Plane movedShape(const Plane& plane, const Transform& t) {
    const Vec2 normal = t.rotation * plane.normal;
    return {normal, plane.offset + dot(normal, t.position)};
}

} // namespace

std::optional<Problem> check(const Primitive& primitive) {
    return std::visit([](const auto& shape) { return check(shape); }, primitive);
}

std::optional<Problem> checkMoved(const Primitive& primitive) {
    const auto* polygon = std::get_if<Polygon>(&primitive);
    return polygon != nullptr ? check(*polygon, Real(-1e-3)) : check(primitive);
}

std::optional<Problem> check(const Shape& shape) {
    return std::visit([](const auto& kind) { return check(kind); }, shape);
}

std::vector<Primitive> primitivesOf(const Shape& shape) {
    return std::visit([](const auto& kind) { return piecesOf(kind); }, shape);
}

Shape shapeOf(const Primitive& primitive) {
    return std::visit([](const auto& kind) { return Shape(kind); }, primitive);
}

bool needsLock(const Primitive& primitive) {
    return std::holds_alternative<Plane>(primitive);
}

bool needsLock(const Shape& shape) {
    if (const auto* compound = std::get_if<Compound>(&shape)) {
        return std::any_of(compound->parts.begin(), compound->parts.end(),
                           [](const Primitive& part) { return needsLock(part); });
    }
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<Heightmap>(shape);
}

Primitive moved(const Primitive& primitive, const Transform& transform) {
    const auto visit = [&](const auto& kind) { return Primitive(movedShape(kind, transform)); };
    return std::visit(visit, primitive);
}

} // namespace KODO_PRECISION
} // namespace kodo
