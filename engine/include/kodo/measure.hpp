// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/mass.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

// Measures of primitives [Thesis06, 3.1], each in the frame of the primitive.

/// A box as a polygon. Its four corners go counter-clockwise from the lower left one of its frame.
template <std::floating_point T>
BasicPolygon<T> polygonOf(const BasicBox<T>& box) {
    const auto core = coreOf(box);
    return {{core.corners.begin(), core.corners.end()}, core.radius};
}

/// The box with the corners of a bounding box.
template <std::floating_point T>
BasicBox<T> boxOf(const BasicAabb<T>& aabb) {
    return {aabb.extent().x, aabb.extent().y, aabb.center(), {}, {}};
}

/// A shape as all points within a radius of the hull of its corners (m). A plane has no corners.
template <typename Corners, std::floating_point T>
struct BasicCore {
    Corners corners;
    T radius;
};
template <std::floating_point T>
auto coreOf(const BasicPoint<T>& point) {
    return BasicCore<std::array<BasicVec2<T>, 1>, T>{{point.position}, 0};
}
template <std::floating_point T>
auto coreOf(const BasicCircle<T>& circle) {
    return BasicCore<std::array<BasicVec2<T>, 1>, T>{{circle.center}, circle.radius};
}
template <std::floating_point T>
auto coreOf(const BasicSegment<T>& segment) {
    return BasicCore<std::array<BasicVec2<T>, 2>, T>{{segment.from, segment.to}, segment.radius};
}
template <std::floating_point T>
auto coreOf(const BasicCapsule<T>& capsule) {
    return BasicCore<std::array<BasicVec2<T>, 2>, T>{{capsule.from, capsule.to}, capsule.radius};
}
template <std::floating_point T>
auto coreOf(const BasicPolygon<T>& polygon) {
    return BasicCore<std::span<const BasicVec2<T>>, T>{polygon.corners, polygon.radius};
}
template <std::floating_point T>
auto coreOf(const BasicBox<T>& box) {
    const T x = box.width / 2;
    const T y = box.height / 2;
    BasicCore<std::array<BasicVec2<T>, 4>, T> core{{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}},
                                                   box.radius};
    for (BasicVec2<T>& corner : core.corners) {
        corner = box.center + box.rotation * corner;
    }
    return core;
}

/// Area (m^2). It is 0 for a particle, for a segment without a radius, and for a plane.
template <template <typename> typename Shape, std::floating_point T>
T areaOf(const Shape<T>& shape) {
    return massOf(shape, T(1)).mass;
}
template <std::floating_point T>
T areaOf(const BasicAabb<T>& aabb) {
    return areaOf(boxOf(aabb));
}
template <std::floating_point T>
constexpr T areaOf(const BasicPoint<T>&) {
    return 0;
}
template <std::floating_point T>
T areaOf(const BasicSegment<T>& segment) {
    return segment.radius > 0 ? massOf(segment, T(1)).mass : T(0);
}

/// Centroid (m).
template <template <typename> typename Shape, std::floating_point T>
BasicVec2<T> centroidOf(const Shape<T>& shape) {
    return massOf(shape, T(1)).center;
}
template <std::floating_point T>
BasicVec2<T> centroidOf(const BasicAabb<T>& aabb) {
    return aabb.center();
}

/// Second moment of area (m^4) about the centroid: the moment of inertia for 1 kg/m^2.
template <template <typename> typename Shape, std::floating_point T>
T secondMomentOf(const Shape<T>& shape) {
    return massOf(shape, T(1)).inertia;
}
template <std::floating_point T>
T secondMomentOf(const BasicAabb<T>& aabb) {
    return secondMomentOf(boxOf(aabb));
}

/// Smallest bounding box (m). A plane has none.
template <template <typename> typename Shape, std::floating_point T>
BasicAabb<T> boundsOf(const Shape<T>& shape) {
    const auto core = coreOf(shape);
    return aabbOf(std::span<const BasicVec2<T>>(core.corners)).grown(core.radius);
}

/// True if a point (m) is inside or on the edge of all points within a radius of a hull of corners.
template <std::floating_point T>
bool contains(std::span<const BasicVec2<T>> corners, T radius, BasicVec2<T> p) {
    bool inside = corners.size() > 2;
    bool near = false;
    BasicVec2<T> from = corners.back();
    for (const BasicVec2<T> to : corners) {
        const BasicVec2<T> edge = to - from;
        const T size = lengthSquared(edge);
        const T share = size > 0 ? std::clamp(dot(p - from, edge) / size, T(0), T(1)) : T(0);
        inside = inside && cross(edge, p - from) >= 0;
        near = near || lengthSquared(p - from - share * edge) <= radius * radius;
        from = to;
    }
    return inside || (near && (radius > 0 || corners.size() == 1));
}

/// True if a point (m) is inside or on the edge.
template <template <typename> typename Shape, std::floating_point T>
bool contains(const Shape<T>& shape, BasicVec2<T> p) {
    const auto core = coreOf(shape);
    return contains(std::span<const BasicVec2<T>>(core.corners), core.radius, p);
}
/// Without a radius, true if a point (m) is exactly on the segment.
template <std::floating_point T>
bool contains(const BasicSegment<T>& segment, BasicVec2<T> p) {
    const BasicVec2<T> from = p - segment.from;
    const BasicVec2<T> to = p - segment.to;
    return segment.radius > 0
               ? contains(BasicCapsule<T>{segment.from, segment.to, segment.radius}, p)
               : cross(from, to) == 0 && dot(from, to) <= 0;
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
template <template <typename> typename Shape, std::floating_point T>
BasicVec2<T> supportOf(const Shape<T>& shape, BasicVec2<T> direction) {
    const auto core = coreOf(shape);
    const BasicVec2<T> corner = supportOf(std::span<const BasicVec2<T>>(core.corners), direction);
    return core.radius > 0 ? corner + core.radius * normalize(direction) : corner;
}
template <std::floating_point T>
BasicVec2<T> supportOf(const BasicAabb<T>& aabb, BasicVec2<T> direction) {
    return supportOf(boxOf(aabb), direction);
}
} // namespace KODO_PRECISION
} // namespace kodo
