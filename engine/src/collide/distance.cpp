// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "collide/core_gap.hpp"
#include "collide/round.hpp"
#include "collide/sat.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A vertex of the Minkowski difference B - A and its two source vertices, in A's frame.
struct Support {
    std::size_t a = 0;
    std::size_t b = 0;
    Vec2 onA;
    Vec2 onB;
    Real fraction = 1; // barycentric coordinate of the simplex point nearest to the origin

    Vec2 gap() const { return onB - onA; }
};

/// A simplex of GJK: one to three vertices; their fractions add up to 1.
struct Simplex {
    Support corners[3];
    std::size_t count = 0;

    Vec2 mixed(Vec2 Support::*point) const {
        Vec2 sum;
        for (std::size_t i = 0; i < count; ++i) {
            sum += corners[i].fraction * corners[i].*point;
        }
        return sum;
    }
    /// Vector from the origin to the nearest point of the simplex.
    Vec2 gap() const { return mixed(&Support::onB) - mixed(&Support::onA); }
    bool has(const Support& s) const {
        for (std::size_t i = 0; i < count; ++i) {
            if (corners[i].a == s.a && corners[i].b == s.b) {
                return true;
            }
        }
        return false;
    }
    void keep(const Support& s) {
        corners[0] = s;
        corners[0].fraction = 1;
        count = 1;
    }
    void keep(Support s, Support t, Real shareOfT) {
        s.fraction = 1 - shareOfT;
        t.fraction = shareOfT;
        corners[0] = s;
        corners[1] = t;
        count = 2;
    }
};

/// Parameter of the point on the line from s to t that is nearest to the origin; 0 at s, 1 at t.
Real nearestFraction(const Support& s, const Support& t) {
    const Vec2 way = t.gap() - s.gap();
    const Real size = lengthSquared(way);
    return size > 0 ? -dot(s.gap(), way) / size : 0;
}

// Sine of the angle at a corner below which a triangle counts as a line.
constexpr Real kFlat = 64 * std::numeric_limits<Real>::epsilon();

void reduceLine(Simplex& simplex, const Support& s, const Support& t) {
    const Real fraction = nearestFraction(s, t);
    if (fraction <= 0) {
        simplex.keep(s);
    } else if (fraction >= 1) {
        simplex.keep(t);
    } else {
        simplex.keep(s, t, fraction);
    }
}

/// Precondition: the newest corner is the last, and the origin is not beyond the opposite side.
void reduceTriangle(Simplex& simplex) {
    const Support s = simplex.corners[0];
    const Support t = simplex.corners[1];
    const Support top = simplex.corners[2];
    const Vec2 base = t.gap() - s.gap();
    const Vec2 side = top.gap() - s.gap();
    const Real area = cross(base, side);
    // In a flatter triangle the fractions below consist of rounding errors.
    const bool flat = area * area <= kFlat * kFlat * lengthSquared(base) * lengthSquared(side);
    // Twice the signed areas of the origin with each side; negative beyond that side.
    const Real sign = area < 0 ? Real(-1) : Real(1);
    const Real beyondT = sign * cross(t.gap(), top.gap());
    const Real beyondS = sign * cross(top.gap(), s.gap());
    const Real beyondTop = sign * cross(s.gap(), t.gap());
    if (!flat && beyondT >= 0 && beyondS >= 0 && beyondTop >= 0) {
        simplex.corners[0].fraction = 1;
        simplex.corners[1].fraction = 0;
        simplex.corners[2].fraction = 0;
        // The first round computes the fractions; in a thin triangle the others correct rounding.
        for (int round = 0; round < 3; ++round) {
            const Vec2 left = -simplex.gap();
            const Real shareOfT = cross(left, side) / area;
            const Real shareOfTop = cross(base, left) / area;
            simplex.corners[0].fraction -= shareOfT + shareOfTop;
            simplex.corners[1].fraction += shareOfT;
            simplex.corners[2].fraction += shareOfTop;
        }
        return;
    }
    Simplex other = simplex;
    reduceLine(simplex, s, top);
    reduceLine(other, t, top);
    if (lengthSquared(other.gap()) < lengthSquared(simplex.gap())) {
        simplex = other;
    }
}

Support supportAgainst(const ConvexShape& shapeA, const ConvexShape& shapeB, const Transform& ab,
                       Vec2 direction, const Support& start) {
    Support s;
    s.a = supportVertex(shapeA, direction, start.a);
    s.b = supportVertex(shapeB, unrotate(ab.rotation, -direction), start.b);
    s.onA = shapeA.vertices[s.a];
    s.onB = ab * shapeB.vertices[s.b];
    return s;
}

/// GJK without the radii of the shapes, in A's frame.
Simplex nearestSimplex(const ConvexShape& shapeA, const ConvexShape& shapeB, const Transform& ab) {
    Simplex simplex;
    Support start;
    start.onA = shapeA.vertices[0];
    start.onB = ab * shapeB.vertices[0];
    simplex.keep(start);
    const std::size_t most = 2 * (shapeA.vertices.size() + shapeB.vertices.size());
    for (std::size_t round = 0; round < most; ++round) {
        const Vec2 gap = simplex.gap();
        const Support next =
            supportAgainst(shapeA, shapeB, ab, gap, simplex.corners[simplex.count - 1]);
        // Terminates: no vertex is nearer to the origin along the gap.
        if (simplex.has(next) || !(dot(gap, next.gap()) < dot(gap, gap))) {
            break;
        }
        const Simplex before = simplex;
        simplex.corners[simplex.count++] = next;
        if (simplex.count == 2) {
            reduceLine(simplex, simplex.corners[0], simplex.corners[1]);
        } else {
            reduceTriangle(simplex);
        }
        if (simplex.count == 3) {
            break;
        }
        // Terminates: the rest of the gap is rounding error.
        if (!(lengthSquared(simplex.gap()) < lengthSquared(gap))) {
            return before;
        }
    }
    return simplex;
}

/// Unit direction of the gap. A simplex of two vertices gives the normal of its edge, since a very
/// short gap has no reliable direction.
Vec2 directionOf(const Simplex& simplex, Vec2 gap) {
    if (simplex.count == 2) {
        const Vec2 side = perp(normalize(simplex.corners[1].gap() - simplex.corners[0].gap()));
        return dot(side, gap) < 0 ? -side : side;
    }
    return normalize(gap);
}

ClosestPoints closestCores(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                           const Transform& b) {
    const CoreGap gap = gapOfCores(shapeA, shapeB, between(a, b));
    const auto& [onA, normal, core, ofVertices, vertexA, vertexB] = gap;
    const Real between = core - shapeA.radius - shapeB.radius;
    if (between <= 0) {
        const Real depth = std::min(std::max(shapeA.radius + between / 2, Real(0)), core);
        const Vec2 common = a * (onA + depth * normal);
        return {common, common, {}, 0};
    }
    const Vec2 start = onA + shapeA.radius * normal;
    return {a * start, a * (start + between * normal), a.rotation * normal, between};
}

ClosestPoints closestToPlane(const ConvexShape& plane, const Transform& a, const ConvexShape& other,
                             const Transform& b) {
    if (other.isPlane()) {
        const Vec2 common = a * plane.vertices[0];
        return {common, common, {}, 0};
    }
    const Transform ab = between(a, b);
    const Vec2 normal = plane.normals[0];
    const std::size_t lowest = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    const Vec2 core = ab * other.vertices[lowest];
    const Real height = dot(normal, core - plane.vertices[0]) - other.radius;
    const Vec2 onOther = core - other.radius * normal;
    if (height <= 0) {
        return {a * onOther, a * onOther, {}, 0};
    }
    return {a * (onOther - height * normal), a * onOther, a.rotation * normal, height};
}

ClosestPoints reversed(ClosestPoints n) {
    std::swap(n.onA, n.onB);
    n.normal = -n.normal;
    return n;
}

} // namespace

CoreGap gapOfCores(const ConvexShape& shapeA, const ConvexShape& shapeB, const Transform& ab) {
    const Simplex simplex = nearestSimplex(shapeA, shapeB, ab);
    CoreGap result{simplex.mixed(&Support::onA), {}, 0, false, 0, 0};
    const Vec2 gap = simplex.gap();
    if (simplex.count < 3 && gap != Vec2{}) {
        result.normal = directionOf(simplex, gap);
        result.distance = dot(result.normal, gap);
        result.ofVertices = simplex.count == 1;
        result.vertexA = simplex.corners[0].a;
        result.vertexB = simplex.corners[0].b;
    }
    return result;
}

ClosestPoints distance(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                       const Transform& b) {
    if (shapeA.isPlane()) {
        return closestToPlane(shapeA, a, shapeB, b);
    }
    if (shapeB.isPlane()) {
        return reversed(closestToPlane(shapeB, b, shapeA, a));
    }
    return closestCores(shapeA, a, shapeB, b);
}

ClosestPoints distance(const ConvexShape& shape, const Transform& t, Vec2 point) {
    const Vec2 p = toLocal(t, point);
    Vec2 normal;
    Real gap = 0;
    if (shape.isPlane()) {
        normal = shape.normals[0];
        gap = dot(normal, p - shape.vertices[0]);
    } else {
        const RoundAxis axis = nearestToCenter(shape, p);
        normal = axis.normal;
        gap = axis.distance;
    }
    if (gap <= 0) {
        return {point, point, {}, 0};
    }
    return {t * (p - gap * normal), point, t.rotation * normal, gap};
}

} // namespace KODO_PRECISION
} // namespace kodo
