// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/geometry.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// m, of both points; the value of a missing point is meaningless.
inline std::array<Real, 2> separationsOf(const Manifold& manifold) {
    return {manifold.points[0].separation, manifold.points[1].separation};
}
/// The least of the separations of `count` points.
inline Real leastOf(const std::array<Real, 2>& separations, int count) {
    return separations[count == 2 && separations[1] < separations[0] ? 1 : 0];
}

/// Lever arm (m) of an impulse along a unit normal at the end of an arm. > 0: the impulse rotates
/// counter-clockwise. A lever within rounding of the arm is 0, so that an impulse through the
/// centre of a circle never rotates it.
inline Real leverOf(Vec2 arm, Vec2 normal) {
    const Real lever = cross(arm, normal);
    const Real rounding =
        4 * std::numeric_limits<Real>::epsilon() * (std::abs(arm.x) + std::abs(arm.y));
    return std::abs(lever) > rounding ? lever : 0;
}

/// A contact point in A's frame, relative to A's centre; rotated to world axes at the end. This
/// keeps precision far from the origin.
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

/// An empty manifold with a lower bound of the separation (m).
inline Manifold apart(Real gap) {
    Manifold manifold;
    manifold.points[0].separation = gap;
    return manifold;
}

/// Manifold of the swapped pair: swaps the arms and negates the normal.
inline Manifold swapped(Manifold manifold) {
    manifold.normal = -manifold.normal;
    for (ManifoldPoint& point : manifold.points) {
        std::swap(point.armA, point.armB);
    }
    return manifold;
}

} // namespace KODO_PRECISION
} // namespace kodo
