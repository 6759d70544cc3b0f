// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/measure.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// The directed line segment from one point to another (m).
template <std::floating_point T>
struct BasicRay {
    BasicVec2<T> from{};
    BasicVec2<T> to{};

    constexpr BasicVec2<T> way() const { return to - from; }
    constexpr BasicVec2<T> at(T fraction) const { return from + fraction * (to - from); }
};

/// First intersection of a ray with a primitive. A start inside or on it gives fraction 0 and a
/// zero normal.
template <std::floating_point T>
struct BasicRayHit {
    T fraction{};          // 0 to 1 of the ray
    BasicVec2<T> normal{}; // unit, out of the surface
};

using Ray = BasicRay<Real>;
using RayHit = BasicRayHit<Real>;

/// Ray against circle. With m = from - center and d = to - from:
///
///   |m + t d| = r:   t = (m.m - r^2) / (-m.d + sqrt(r^2 d.d - (m x d)^2))
///
/// This form of the root has no cancellation [Ericson05, 5.3.2]. Touching counts, here and in all
/// overloads: a tangent, a ray along an edge and a ray through a corner hit.
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

/// Ray against particle: it hits only exactly.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicPoint<T>& point, const BasicRay<T>& ray) {
    return rayCast(BasicCircle<T>{0, point.position}, ray);
}

/// Ray against half-plane.
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

/// Clips a ray by the edges of a convex polygon, one by one [Ericson05, 5.3.8]. The ray enters at
/// the last edge that it crosses inwards.
template <std::floating_point T>
class BasicRayClip {
public:
    /// Clips by the half-plane behind an edge. `height` is the height of the start above the edge,
    /// `climb` the gain of height over the whole ray. Both are scaled by the length of `normal`.
    void cut(T height, T climb, BasicVec2<T> normal) {
        startsInside_ = startsInside_ && height <= 0;
        if (climb < 0) {
            const T fraction = height / -climb;
            if (fraction > enter_) {
                enter_ = fraction;
                normal_ = normal;
            }
        } else if (climb > 0) {
            leave_ = (std::min)(leave_, -height / climb);
        } else if (height > 0) {
            leave_ = -1; // parallel and outside
        }
    }

    /// The intersection with the half-planes so far.
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

/// Ray against a convex polygon.
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

/// The earlier of two hits; ties keep the first.
template <std::floating_point T>
std::optional<BasicRayHit<T>> earlierOf(const std::optional<BasicRayHit<T>>& first,
                                        const std::optional<BasicRayHit<T>>& second) {
    return second && (!first || second->fraction < first->fraction) ? second : first;
}

/// Ray against a convex outline with a radius > 0, from outside of it: the edges, moved outwards,
/// and a circle around each corner.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCastOutline(std::span<const BasicVec2<T>> corners, T radius,
                                             const BasicRay<T>& ray) {
    std::optional<BasicRayHit<T>> best;
    BasicVec2<T> from = corners.back();
    for (const BasicVec2<T> to : corners) {
        const BasicVec2<T> out = -radius * perp(normalize(to - from));
        best = earlierOf(best, rayCast(BasicSegment<T>{to + out, from + out, true, {}}, ray));
        best = earlierOf(best, rayCast(BasicCircle<T>{radius, to}, ray));
        from = to;
    }
    return best;
}

/// Ray against a shape with a radius > 0 around its core.
template <template <typename> typename Shape, std::floating_point T>
std::optional<BasicRayHit<T>> rayCastRounded(const Shape<T>& shape, const BasicRay<T>& ray) {
    const auto core = coreOf(shape);
    const std::span<const BasicVec2<T>> corners(core.corners);
    return contains(corners, core.radius, ray.from) ? BasicRayHit<T>{}
                                                    : rayCastOutline(corners, core.radius, ray);
}

/// Ray against capsule.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicCapsule<T>& capsule, const BasicRay<T>& ray) {
    return rayCastRounded(capsule, ray);
}

/// Ray against a convex polygon.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicPolygon<T>& polygon, const BasicRay<T>& ray) {
    return polygon.radius > 0 ? rayCastRounded(polygon, ray)
                              : rayCast(std::span<const BasicVec2<T>>(polygon.corners), ray);
}

/// Ray against box.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicBox<T>& box, const BasicRay<T>& ray) {
    const auto core = coreOf(box);
    return box.radius > 0 ? rayCastRounded(box, ray)
                          : rayCast(std::span<const BasicVec2<T>>(core.corners), ray);
}

/// Ray against bounding box.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicAabb<T>& aabb, const BasicRay<T>& ray) {
    return rayCast(boxOf(aabb), ray);
}

/// Ray against segment, with the directions d and e and the gap g between the starts:
///
///   fraction of the ray (g x e) / (d x e),   of the segment (g x d) / (d x e)
///
/// A one-sided segment is hit from its front alone, and not by a ray along it. One with a radius is
/// a capsule.
template <std::floating_point T>
std::optional<BasicRayHit<T>> rayCast(const BasicSegment<T>& segment, const BasicRay<T>& ray) {
    if (segment.radius > 0) {
        return rayCastRounded(segment, ray);
    }
    const BasicVec2<T> along = segment.to - segment.from;
    const BasicVec2<T> d = ray.way();
    const BasicVec2<T> gap = segment.from - ray.from;
    const T turn = cross(d, along); // > 0: from the left, the front
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
        // Collinear: the ray hits the closer end.
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

} // namespace KODO_PRECISION
} // namespace kodo
