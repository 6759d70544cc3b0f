// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/shape.hpp>

#include <numbers>
#include <span>

namespace kodo::inline KODO_PRECISION {

/// Mass, centre of mass and moment of inertia of something flat with a density of so many kg/m^2;
/// of a segment kg/m, and of a point kg.
template <std::floating_point T>
struct BasicMass {
    T mass{};              // kg
    BasicVec2<T> center{}; // m, in the frame of the shape
    T inertia{};           // kg m^2, about the centre of mass
};

using Mass = BasicMass<Real>;

///   m = d pi r^2,   I = m r^2 / 2
template <std::floating_point T>
BasicMass<T> massOf(const BasicCircle<T>& circle, T density) {
    const T mass = density * std::numbers::pi_v<T> * circle.radius * circle.radius;
    return {mass, circle.center, mass * circle.radius * circle.radius / 2};
}

///   m = d w h,   I = m (w^2 + h^2) / 12
template <std::floating_point T>
BasicMass<T> massOf(const BasicBox<T>& box, T density) {
    const T mass = density * box.width * box.height;
    return {mass, box.center, mass * (box.width * box.width + box.height * box.height) / 12};
}

/// The exact integral over the triangles (0, e1, e2) of a fan from the first corner; the thesis
/// samples particles instead (4.1.5). Starting from a corner, not from the origin, keeps the digits
/// of a polygon that lies far away.
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

template <std::floating_point T>
BasicMass<T> massOf(const BasicPolygon<T>& polygon, T density) {
    return massOf(std::span<const BasicVec2<T>>(polygon.corners), density);
}

///   m = d,   I = 0
template <std::floating_point T>
BasicMass<T> massOf(const BasicPoint<T>& point, T density) {
    return {density, point.position, 0};
}

///   m = d L,   I = m L^2 / 12
template <std::floating_point T>
BasicMass<T> massOf(const BasicSegment<T>& segment, T density) {
    const T squared = lengthSquared(segment.to - segment.from);
    const T mass = density * std::sqrt(squared);
    return {mass, (segment.from + segment.to) / T(2), mass * squared / 12};
}

/// None: a plane moves only as it is told to. Its centre is the point of it next to the origin.
template <std::floating_point T>
BasicMass<T> massOf(const BasicPlane<T>& plane, T) {
    return {0, plane.offset * plane.normal, 0};
}

/// Both together, by the parallel axis theorem.
template <std::floating_point T>
BasicMass<T> combine(const BasicMass<T>& a, const BasicMass<T>& b) {
    const T mass = a.mass + b.mass;
    const T share = mass > 0 ? b.mass / mass : T(0.5); // two planes have no mass to weigh by
    const BasicVec2<T> d = b.center - a.center;
    return {mass, a.center + share * d, a.inertia + b.inertia + a.mass * share * dot(d, d)};
}

} // namespace kodo::inline KODO_PRECISION
