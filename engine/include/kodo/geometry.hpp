// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>
#include <kodo/ray.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// Convex hull of points (m) in any order [Andrew79], or the reason why there is none: fewer than
/// three distinct points, all on one line, a coordinate not finite or above kMaxLength, more than
/// kMaxCorners corners.
///
/// Points inside, repeated points and points on an edge are left out, and so is a corner that
/// check() would refuse as flat. The first corner is the leftmost one; ties go to the lowest.
KODO_API std::variant<Polygon, Problem> convexHull(std::span<const Vec2> points);

/// The area within a closed outline (m), as convex polygons of one body. A clockwise outline is
/// turned around; points on one line are left out. At most kMaxCorners points. Ears are cut off
/// [Meisters75], then pieces joined [Hertel83].
///
/// The reason why not: edges that cross or touch, as those of a hole that is joined to the outline
/// by a cut would. Ground that only blocks has fewer parts as a Chain.
KODO_API std::variant<Compound, Problem> decompose(std::span<const Vec2> outline);

/// Box of the smallest area around points (m) in any order, or the reason why they have no hull.
///
/// One side of the box contains an edge of the hull [Freeman75], so each edge is tried. The cost
/// grows with the square of the corners of the hull. Ties go to the first edge.
KODO_API std::variant<Box, Problem> fitBox(std::span<const Vec2> points);

/// A polygon in the frame of its smallest box, with its sharpest corner first [Thesis06, 3.2.3].
/// Its bounds are tight there, and searches for an extreme corner start at the likeliest one.
struct Arranged {
    Polygon polygon;
    Rot back; // rotates the corners back to the given frame
};

/// Arranges a valid polygon.
KODO_API Arranged arrange(const Polygon& polygon);

/// One contact point of two convex shapes, halfway between their surfaces.
struct ManifoldPoint {
    Vec2 armA;                 // m, world axes; from the origin of frame a to the point
    Vec2 armB;                 // m, world axes; from the origin of frame b to the same point
    Real separation = 0;       // m, along the normal; < 0 in overlap
    std::uint32_t feature = 0; // equal while the same edges and corners are in contact
};

/// Contact manifold of two convex shapes [Thesis06, 3.3]. The deepest point is the first. Without
/// points, points[0].separation is a lower bound of the separation, or 0 if none is known, and the
/// normal has no meaning.
struct Manifold {
    Vec2 normal; // unit, world axes, from A to B; the axis of least overlap
    std::array<ManifoldPoint, 2> points;
    int count = 0;           // 0 to 2
    bool fromBehind = false; // one shape is behind a one-sided segment; then count is 0
};

/// Contact manifold of shapes at poses a and b, if their separation is below `margin` (m). Between
/// two polygons an edge of A is the reference, unless an edge of B has a separation larger by more
/// than `preference` (m). A one-sided segment has no contact with a shape behind it.
KODO_API Manifold collide(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                          const Transform& b, Real margin = 0, Real preference = 0);

/// Separation of two convex shapes along one axis.
struct Separation {
    Vec2 axis;         // unit, world, from A to B
    Real distance = 0; // m; < 0 in overlap
};
/// The axis that separates two convex shapes best. Between two polygons the distance is a lower
/// bound of the true one, and positive exactly if they are apart. Segments have both sides here.
/// Two planes are always apart.
KODO_API Separation separation(const ConvexShape& shapeA, const Transform& a,
                               const ConvexShape& shapeB, const Transform& b);

/// The closest points of two convex shapes.
struct ClosestPoints {
    Vec2 onA;          // m, world
    Vec2 onB;          // m, world; equal to onA in overlap
    Vec2 normal;       // unit, from a to b; zero in overlap
    Real distance = 0; // m; 0 in overlap
};

/// Euclidean distance of two convex shapes, also between corners: the distance of the origin from
/// the set of all b - a, by the simplex search of [Ericson05, 9.5]. Segments have both sides. Two
/// planes have distance 0.
KODO_API ClosestPoints distance(const ConvexShape& shapeA, const Transform& a,
                                const ConvexShape& shapeB, const Transform& b);

/// Distance of a world point (m) from a convex shape. For a point inside, onA is the point itself.
KODO_API ClosestPoints distance(const ConvexShape& shape, const Transform& t, Vec2 point);

/// First intersection of a ray (world) with a convex shape at pose t. A start inside gives fraction
/// 0 and no normal. A one-sided segment is hit from its front alone.
KODO_API std::optional<RayHit> rayCast(const ConvexShape& shape, const Transform& t,
                                       const Ray& ray);

/// Where a moving convex shape first touches another.
struct CastHit {
    Real fraction = 0; // 0 to 1 of the displacement
    Vec2 normal;       // unit, world, out of the target; zero for overlap at start
    Vec2 point;        // m, world
};

/// First contact of a shape that moves by `move` (m, world), without rotation, with a target at
/// pose t. All pairs have a closed form: a ray of the centre against the target grown by the
/// radius, or the largest fraction at which an axis still separates both. Touching counts. A
/// one-sided segment is hit from its front alone, and not by a shape that overlaps it at the start.
KODO_API std::optional<CastHit> shapeCast(const ConvexShape& moving, const Transform& from,
                                          Vec2 move, const ConvexShape& target, const Transform& t);

/// Affine map of the plane, as a 3x2 matrix, with scale and shear [Thesis06, 2.3.2]. It serves to
/// draw and to build shapes; the pose of a body is a Transform.
template <std::floating_point T>
struct BasicAffine {
    BasicVec2<T> x{1, 0};  // image of the x axis
    BasicVec2<T> y{0, 1};  // image of the y axis
    BasicVec2<T> origin{}; // image of the origin

    static constexpr BasicAffine from(const BasicTransform<T>& t) {
        return {t.rotation.xAxis(), t.rotation.yAxis(), t.position};
    }
    static constexpr BasicAffine scale(T sx, T sy) { return {{sx, 0}, {0, sy}, {}}; }

    friend constexpr BasicVec2<T> operator*(const BasicAffine& m, BasicVec2<T> p) {
        return p.x * m.x + p.y * m.y + m.origin;
    }
    /// Map by b, then by a.
    friend constexpr BasicAffine operator*(const BasicAffine& a, const BasicAffine& b) {
        return {b.x.x * a.x + b.x.y * a.y, b.y.x * a.x + b.y.y * a.y, a * b.origin};
    }
    friend constexpr bool operator==(const BasicAffine&, const BasicAffine&) = default;

    /// Factor of areas; negative for a reflection.
    constexpr T determinant() const { return cross(x, y); }

    /// Inverse map, or std::nullopt if the matrix is singular or the inverse is not finite. Each
    /// column is divided by its largest entry first, so large and small scales lose no precision.
    std::optional<BasicAffine> inverse() const {
        const T sizeX = largerOf(x);
        const T sizeY = largerOf(y);
        const BasicVec2<T> u = x / sizeX;
        const BasicVec2<T> v = y / sizeY;
        const T d = cross(u, v);
        if (!(d < 0 || d > 0)) { // also for NaN
            return std::nullopt;
        }
        const BasicAffine linear{
            {v.y / d / sizeX, -u.y / d / sizeY}, {-v.x / d / sizeX, u.x / d / sizeY}, {}};
        const BasicAffine result{linear.x, linear.y, -(linear * origin)};
        const bool finite = isFinite(result.x) && isFinite(result.y) && isFinite(result.origin);
        return finite ? std::optional(result) : std::nullopt;
    }

private:
    static constexpr T largerOf(BasicVec2<T> v) {
        return (std::max)(v.x < 0 ? -v.x : v.x, v.y < 0 ? -v.y : v.y);
    }
};

using Affine = BasicAffine<Real>;

} // namespace KODO_PRECISION
} // namespace kodo
