// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/measure.hpp>

#include <algorithm>
#include <optional>
#include <span>

namespace kodo::inline KODO_PRECISION {

/// The straight way from one point to another (m).
template <std::floating_point T>
struct BasicRay {
    BasicVec2<T> from;
    BasicVec2<T> to;

    constexpr BasicVec2<T> way() const { return to - from; }
    constexpr BasicVec2<T> at(T fraction) const { return from + fraction * (to - from); }
};

/// Where a ray first meets a primitive. One that starts inside or on it is there already: fraction
/// 0, and no normal (zero).
template <std::floating_point T>
struct BasicRayHit {
    T fraction{};          // 0..1 of the way
    BasicVec2<T> normal{}; // unit, out of the surface, against the ray
};

using Ray = BasicRay<Real>;
using RayHit = BasicRayHit<Real>;

/// Touching counts: a ray along a side or past a corner of a polygon, or tangent to a circle, hits.
/// All are closed forms.
///
///   |m + t d| = r  with m = from - center:   t = (m.m - r^2) / (-m.d + sqrt(r^2 d.d - (m x d)^2))
///
/// This form of the root does not cancel, neither near nor far [Ericson05, 5.3.2].
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicCircle<T>& circle, const BasicRay<T>& ray) {
    const BasicVec2<T> m = ray.from - circle.center;
    const BasicVec2<T> d = ray.way();
    const T outside = lengthSquared(m) - circle.radius * circle.radius;
    if (outside <= 0) {
        return BasicRayHit<T>{};
    }
    const T side = cross(m, d);
    const T inRoot = circle.radius * circle.radius * lengthSquared(d) - side * side;
    const T approach = -dot(m, d);
    if (approach <= 0 || inRoot < 0) {
        return std::nullopt;
    }
    const T fraction = outside / (approach + std::sqrt(inRoot));
    if (!(fraction <= 1)) {
        return std::nullopt;
    }
    const BasicVec2<T> arm = m + fraction * d;
    return BasicRayHit<T>{fraction, normalize(circle.radius > 0 ? arm : -d)};
}

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicPoint<T>& point, const BasicRay<T>& ray) {
    return rayCast(BasicCircle<T>{0, point.position}, ray);
}

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicPlane<T>& plane, const BasicRay<T>& ray) {
    const T height = dot(plane.normal, ray.from) - plane.offset;
    if (height <= 0) {
        return BasicRayHit<T>{};
    }
    const T fall = -dot(plane.normal, ray.way());
    if (!(fall >= height)) {
        return std::nullopt;
    }
    return BasicRayHit<T>{height / fall, plane.normal};
}

/// A convex outline, as what is left of the ray when each side has cut it [Ericson05, 5.3.8]. The
/// ray enters through the last side that it passes inwards.
template <std::floating_point T>
class BasicRayClip {
public:
    /// The half-plane behind a line: `height` is that of the start above it, `climb` by how much
    /// the whole way leads up; both times the length of `normal`, which need not be 1.
    void cut(T height, T climb, BasicVec2<T> normal) {
        startsInside_ = startsInside_ && height <= 0;
        if (climb < 0) {
            const T fraction = height / -climb;
            if (fraction > enter_) {
                enter_ = fraction;
                normal_ = normal;
            }
        } else if (climb > 0) {
            leave_ = std::min(leave_, -height / climb);
        } else if (height > 0) {
            leave_ = -1; // beside it all the way
        }
    }

    std::optional<BasicRayHit<T>> hit() const {
        if (startsInside_) {
            return BasicRayHit<T>{};
        }
        if (enter_ < 0 || !(enter_ <= leave_)) {
            return std::nullopt;
        }
        return BasicRayHit<T>{enter_, normalize(normal_)};
    }

private:
    T enter_ = -1;
    T leave_ = 1;
    bool startsInside_ = true;
    BasicVec2<T> normal_{};
};

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(std::span<const BasicVec2<T>> corners,
                                      const BasicRay<T>& ray) {
    BasicRayClip<T> clip;
    BasicVec2<T> from = corners.back();
    for (const BasicVec2<T> to : corners) {
        const BasicVec2<T> normal = -perp(to - from);
        clip.cut(dot(normal, ray.from - from), dot(normal, ray.way()), normal);
        from = to;
    }
    return clip.hit();
}

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicPolygon<T>& polygon, const BasicRay<T>& ray) {
    return rayCast(std::span<const BasicVec2<T>>(polygon.corners), ray);
}

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicBox<T>& box, const BasicRay<T>& ray) {
    const BasicVec2<T> from = unrotate(box.rotation, ray.from - box.center);
    const BasicVec2<T> way = unrotate(box.rotation, ray.way());
    BasicRayClip<T> clip;
    clip.cut(from.x - box.width / 2, way.x, box.rotation.xAxis());
    clip.cut(-from.x - box.width / 2, -way.x, -box.rotation.xAxis());
    clip.cut(from.y - box.height / 2, way.y, box.rotation.yAxis());
    clip.cut(-from.y - box.height / 2, -way.y, -box.rotation.yAxis());
    return clip.hit();
}

template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicAabb<T>& aabb, const BasicRay<T>& ray) {
    return rayCast(boxOf(aabb), ray);
}

/// Lines that cross where the products of their ways with the gap between their starts say. A
/// one-sided segment is hit from its front alone, and not along itself.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicSegment<T>& segment, const BasicRay<T>& ray) {
    const BasicVec2<T> along = segment.to - segment.from;
    const BasicVec2<T> d = ray.way();
    const BasicVec2<T> gap = segment.from - ray.from;
    const T turn = cross(d, along); // > 0: comes from the left, the front
    if (segment.oneSided && turn <= 0) {
        return std::nullopt;
    }
    if (contains(segment, ray.from)) {
        return BasicRayHit<T>{};
    }
    if (turn == 0) {
        if (cross(gap, along) != 0 || cross(gap, d) != 0) {
            return std::nullopt;
        }
        // On one line: the ray meets the nearer end.
        const BasicVec2<T> end = dot(d, along) > 0 ? segment.from : segment.to;
        return rayCast(BasicPoint<T>{end}, ray);
    }
    const T fraction = cross(gap, along) / turn;
    const T place = cross(gap, d) / turn;
    if (!(fraction >= 0 && fraction <= 1 && place >= 0 && place <= 1)) {
        return std::nullopt;
    }
    return BasicRayHit<T>{fraction, normalize(turn > 0 ? perp(along) : -perp(along))};
}

} // namespace kodo::inline KODO_PRECISION
