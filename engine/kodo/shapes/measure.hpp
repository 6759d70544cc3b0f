// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/aabb.hpp>
#include <kodo/shapes/mass.hpp>

#include <span>

namespace kodo::inline KODO_PRECISION {

/// What geometry says about the primitives [Thesis06, 3.1], each in its own frame:
///
///   areaOf          m^2; 0 for a point, a segment and a plane
///   centroidOf      m
///   secondMomentOf  m^4, about the centroid: the moment of inertia for 1 kg/m^2
///   boundsOf        the smallest box with sides along the axes; a plane has none
///   contains        inside or on the edge
///   supportOf       the point farthest along a direction (of any length); a plane has none. Ties
///                   go to the corner named first

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

template <std::floating_point T>
BasicBox<T> boxOf(const BasicAabb<T>& aabb) {
    return {aabb.extent().x, aabb.extent().y, aabb.center(), {}};
}

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

template <template <std::floating_point> class Shape, std::floating_point T>
BasicVec2<T> centroidOf(const Shape<T>& shape) {
    return massOf(shape, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicAabb<T>& aabb) {
    return aabb.center();
}

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
/// Only what lies exactly on it.
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

} // namespace kodo::inline KODO_PRECISION
