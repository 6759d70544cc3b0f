// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

#include <cmath>
#include <numbers>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Mass, centre of mass and moment of inertia of a shape. The density is in kg/m^2; of a segment in
/// kg/m, and of a particle in kg.
template <std::floating_point T>
struct BasicMass {
    T mass{};              // kg
    BasicVec2<T> center{}; // m, in the frame of the shape; the centre of mass
    T inertia{};           // kg m^2, about the centre of mass
};

using Mass = BasicMass<Real>;

/// Mass of a circle, d being the density:
///
///   m = d pi r^2,   I = m r^2 / 2
template <std::floating_point T>
BasicMass<T> massOf(const BasicCircle<T>& circle, T density) {
    const T mass = density * std::numbers::pi_v<T> * circle.radius * circle.radius;
    return {mass, circle.center, mass * circle.radius * circle.radius / 2};
}

/// Mass of a box:
///
///   m = d w h,   I = m (w^2 + h^2) / 12
template <std::floating_point T>
BasicMass<T> massOf(const BasicBox<T>& box, T density) {
    const T mass = density * box.width * box.height;
    return {mass, box.center, mass * (box.width * box.width + box.height * box.height) / 12};
}

/// Mass of a polygon: the exact integral over a fan of triangles (0, e1, e2) from the first corner,
/// where the thesis sums particles (4.1.5). Arms from a corner instead of the origin keep precision
/// far from the origin.
///
///   area = cross(e1, e2) / 2,   centroid = (e1 + e2) / 3
///   integral of r^2 = cross(e1, e2) (e1.e1 + e1.e2 + e2.e2) / 12                    [Mirtich96]
template <std::floating_point T>
BasicMass<T> massOf(std::span<const BasicVec2<T>> corners, T density) {
    T twiceArea = 0;
    BasicVec2<T> moment;
    T second = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const BasicVec2<T> e1 = corners[i] - corners[0];
        const BasicVec2<T> e2 = corners[i + 1] - corners[0];
        const T d = cross(e1, e2);
        twiceArea += d;
        moment += d * (e1 + e2);
        second += d * (dot(e1, e1) + dot(e1, e2) + dot(e2, e2));
    }
    const BasicVec2<T> arm = moment / (3 * twiceArea);
    const T mass = density * twiceArea / 2;
    return {mass, corners[0] + arm, density * second / 12 - mass * dot(arm, arm)};
}

/// Mass of a polygon.
template <std::floating_point T>
BasicMass<T> massOf(const BasicPolygon<T>& polygon, T density) {
    return massOf(std::span<const BasicVec2<T>>(polygon.corners), density);
}

/// Mass of a particle: m = d,   I = 0
template <std::floating_point T>
BasicMass<T> massOf(const BasicPoint<T>& point, T density) {
    return {density, point.position, 0};
}

/// Mass of a segment of length L:
///
///   m = d L,   I = m L^2 / 12
template <std::floating_point T>
BasicMass<T> massOf(const BasicSegment<T>& segment, T density) {
    const T squared = lengthSquared(segment.to - segment.from);
    const T mass = density * std::sqrt(squared);
    return {mass, (segment.from + segment.to) / T(2), mass * squared / 12};
}

/// A plane has mass 0. Its centre is the point of its surface closest to the origin.
template <std::floating_point T>
BasicMass<T> massOf(const BasicPlane<T>& plane, T) {
    return {0, plane.offset * plane.normal, 0};
}

/// Mass of two rigid parts together, by the parallel axis theorem.
template <std::floating_point T>
BasicMass<T> combine(const BasicMass<T>& a, const BasicMass<T>& b) {
    const T mass = a.mass + b.mass;
    const T fraction = mass > 0 ? b.mass / mass : T(0.5); // two planes: no mass
    const BasicVec2<T> d = b.center - a.center;
    return {mass, a.center + fraction * d, a.inertia + b.inertia + a.mass * fraction * dot(d, d)};
}

// Measures of primitives [Thesis06, 3.1], each in the frame of the primitive.

/// The four corners of a box, counter-clockwise from the lower left one of its own frame.
template <std::floating_point T>
BasicPolygon<T> polygonOf(const BasicBox<T>& box) {
    const T x = box.width / 2;
    const T y = box.height / 2;
    BasicPolygon<T> polygon{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    for (BasicVec2<T>& corner : polygon.corners) {
        corner = box.center + box.rotation * corner;
    }
    return polygon;
}

/// The box with the corners of a bounding box.
template <std::floating_point T>
BasicBox<T> boxOf(const BasicAabb<T>& aabb) {
    return {aabb.extent().x, aabb.extent().y, aabb.center(), {}};
}

/// Area (m^2). It is 0 for a particle, a segment and a plane.
template <std::floating_point T>
T areaOf(const BasicCircle<T>& circle) {
    return massOf(circle, T(1)).mass;
}
template <std::floating_point T>
T areaOf(const BasicBox<T>& box) {
    return massOf(box, T(1)).mass;
}
template <std::floating_point T>
T areaOf(const BasicAabb<T>& aabb) {
    return areaOf(boxOf(aabb));
}
template <std::floating_point T>
T areaOf(const BasicPolygon<T>& polygon) {
    return massOf(polygon, T(1)).mass;
}
template <std::floating_point T>
constexpr T areaOf(const BasicPoint<T>&) {
    return 0;
}
template <std::floating_point T>
constexpr T areaOf(const BasicSegment<T>&) {
    return 0;
}
template <std::floating_point T>
constexpr T areaOf(const BasicPlane<T>&) {
    return 0;
}

/// Centroid (m).
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicCircle<T>& circle) {
    return massOf(circle, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicBox<T>& box) {
    return massOf(box, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicPolygon<T>& polygon) {
    return massOf(polygon, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicPoint<T>& point) {
    return massOf(point, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicSegment<T>& segment) {
    return massOf(segment, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicPlane<T>& plane) {
    return massOf(plane, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicAabb<T>& aabb) {
    return aabb.center();
}

/// Second moment of area (m^4) about the centroid: the moment of inertia for 1 kg/m^2.
template <std::floating_point T>
T secondMomentOf(const BasicCircle<T>& circle) {
    return massOf(circle, T(1)).inertia;
}
template <std::floating_point T>
T secondMomentOf(const BasicBox<T>& box) {
    return massOf(box, T(1)).inertia;
}
template <std::floating_point T>
T secondMomentOf(const BasicAabb<T>& aabb) {
    return secondMomentOf(boxOf(aabb));
}
template <std::floating_point T>
T secondMomentOf(const BasicPolygon<T>& polygon) {
    return massOf(polygon, T(1)).inertia;
}

/// Smallest bounding box (m). A plane has none.
template <std::floating_point T>
BasicAabb<T> boundsOf(const BasicPoint<T>& point) {
    return {point.position, point.position};
}
template <std::floating_point T>
BasicAabb<T> boundsOf(const BasicCircle<T>& circle) {
    return BasicAabb<T>{circle.center, circle.center}.grown(circle.radius);
}
template <std::floating_point T>
BasicAabb<T> boundsOf(const BasicPolygon<T>& polygon) {
    return aabbOf(std::span<const BasicVec2<T>>(polygon.corners));
}
template <std::floating_point T>
BasicAabb<T> boundsOf(const BasicBox<T>& box) {
    return boundsOf(polygonOf(box));
}
template <std::floating_point T>
BasicAabb<T> boundsOf(const BasicSegment<T>& segment) {
    return unite(BasicAabb<T>{segment.from, segment.from}, {segment.to, segment.to});
}

/// True if a point (m) is inside or on the edge.
template <std::floating_point T>
bool contains(const BasicPoint<T>& point, BasicVec2<T> p) {
    return point.position == p;
}
template <std::floating_point T>
bool contains(const BasicCircle<T>& circle, BasicVec2<T> p) {
    return lengthSquared(p - circle.center) <= circle.radius * circle.radius;
}
template <std::floating_point T>
bool contains(const BasicBox<T>& box, BasicVec2<T> p) {
    const BasicVec2<T> local = unrotate(box.rotation, p - box.center);
    return std::abs(local.x) <= box.width / 2 && std::abs(local.y) <= box.height / 2;
}
template <std::floating_point T>
bool contains(const BasicPolygon<T>& polygon, BasicVec2<T> p) {
    BasicVec2<T> from = polygon.corners.back();
    for (const BasicVec2<T> to : polygon.corners) {
        if (cross(to - from, p - from) < 0) {
            return false;
        }
        from = to;
    }
    return true;
}
/// True if a point (m) is exactly on the segment.
template <std::floating_point T>
bool contains(const BasicSegment<T>& segment, BasicVec2<T> p) {
    const BasicVec2<T> from = p - segment.from;
    const BasicVec2<T> to = p - segment.to;
    return cross(from, to) == 0 && dot(from, to) <= 0;
}
template <std::floating_point T>
bool contains(const BasicPlane<T>& plane, BasicVec2<T> p) {
    return dot(plane.normal, p) <= plane.offset;
}

/// Support point: the point (m) of a shape farthest along a direction of any length. Ties go to the
/// corner with the lower index. A plane has none.
template <std::floating_point T>
BasicVec2<T> supportOf(std::span<const BasicVec2<T>> points, BasicVec2<T> direction) {
    BasicVec2<T> best = points[0];
    for (const BasicVec2<T> p : points) {
        if (dot(direction, p) > dot(direction, best)) {
            best = p;
        }
    }
    return best;
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicPoint<T>& point, BasicVec2<T>) {
    return point.position;
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicCircle<T>& circle, BasicVec2<T> direction) {
    return circle.center + circle.radius * normalize(direction);
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicPolygon<T>& polygon, BasicVec2<T> direction) {
    return supportOf(std::span<const BasicVec2<T>>(polygon.corners), direction);
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicBox<T>& box, BasicVec2<T> direction) {
    const BasicVec2<T> local = unrotate(box.rotation, direction);
    const T x = local.x < 0 ? -box.width / 2 : box.width / 2;
    const T y = local.y < 0 ? -box.height / 2 : box.height / 2;
    return box.center + box.rotation * BasicVec2<T>{x, y};
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicAabb<T>& aabb, BasicVec2<T> direction) {
    return supportOf(boxOf(aabb), direction);
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicSegment<T>& segment, BasicVec2<T> direction) {
    return dot(direction, segment.to - segment.from) > 0 ? segment.to : segment.from;
}
} // namespace KODO_PRECISION
} // namespace kodo
