// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/transform.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace kodo::inline KODO_PRECISION {

/// One place where two convex outlines meet, halfway between their surfaces.
struct ManifoldPoint {
    Vec2 armA;                 // m, world axes; from A's frame (its centre of mass) to the point
    Vec2 armB;                 // m, the same point from B's
    Real separation = 0;       // m, along the normal; < 0 in overlap
    std::uint32_t feature = 0; // the same as long as the same edges and corners meet
};

/// How two convex outlines touch, or nearly do [Thesis06, 3.3]. The deepest point comes first.
/// Without a point they are farther apart than was asked for; then the separation of the first
/// tells how far at least, or 0 if that is not known, and nothing else is written.
struct Manifold {
    Vec2 normal; // unit, world axes, from A towards B; the direction that parts them soonest
    std::array<ManifoldPoint, 2> points;
    int count = 0;
    bool fromBehind = false; // of a one-sided line; then count is 0. See letPass
};

/// m, of both points; that of one that the manifold does not have means nothing.
inline std::array<Real, 2> separationsOf(const Manifold& manifold) {
    return {manifold.points[0].separation, manifold.points[1].separation};
}

/// How far the line through the end of an arm along a unit normal passes by where the arm starts
/// (m; > 0: a push along the normal turns counter-clockwise). What is but a rounding of the arm is
/// none, so that a push through the centre of a circle never turns it.
inline Real leverOf(Vec2 arm, Vec2 normal) {
    const Real lever = cross(arm, normal);
    const Real rounding =
        4 * std::numeric_limits<Real>::epsilon() * (std::abs(arm.x) + std::abs(arm.y));
    return std::abs(lever) > rounding ? lever : 0;
}

/// A contact point found in A's frame, around A's centre; the last step turns it to world axes. So
/// nothing is lost far from the origin.
struct LocalPoint {
    Vec2 point; // m, halfway between the surfaces
    Real separation;
    std::uint32_t feature;
};

inline void add(Manifold& manifold, const LocalPoint& local, const Transform& a,
                const Transform& b) {
    const Vec2 armA = a.rotation * local.point;
    manifold.points[static_cast<std::size_t>(manifold.count)] = {
        armA, armA + (a.position - b.position), local.separation, local.feature};
    ++manifold.count;
}

/// Of two that are so far apart, at least.
inline Manifold apart(Real gap) {
    Manifold manifold;
    manifold.points[0].separation = gap;
    return manifold;
}

/// The other way round: swaps the arms and turns the normal.
inline Manifold swapped(Manifold manifold) {
    manifold.normal = -manifold.normal;
    for (ManifoldPoint& point : manifold.points) {
        std::swap(point.armA, point.armB);
    }
    return manifold;
}

} // namespace kodo::inline KODO_PRECISION
