// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Mass, centre of mass and moment of inertia of a shape. The density is in kg/m^2; of a segment
/// without a radius in kg/m, and of a particle in kg.
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

/// Mass of two rigid parts together, by the parallel axis theorem.
template <std::floating_point T>
BasicMass<T> combine(const BasicMass<T>& a, const BasicMass<T>& b) {
    const T mass = a.mass + b.mass;
    const T fraction = mass > 0 ? b.mass / mass : T(0.5); // two planes: no mass
    const BasicVec2<T> d = b.center - a.center;
    return {mass, a.center + fraction * d, a.inertia + b.inertia + a.mass * fraction * dot(d, d)};
}

/// Mass of a box:
///
///   m = d w h,   I = m (w^2 + h^2) / 12
///
/// With a radius r, in addition a strip of width r along each side and a quarter of a disc at each
/// corner, whose centroid is 4 r / (3 pi) beyond the corner in x and in y:
///
///   m = 2 d r w,     I = m ((w^2 + r^2) / 12 + (h + r)^2 / 4),   likewise for h
///   m = d pi r^2,    I = m (r^2 / 2 + (w^2 + h^2) / 4 + 4 r (w + h) / (3 pi))
template <std::floating_point T>
BasicMass<T> massOf(const BasicBox<T>& box, T density) {
    const auto [w, h, center, rotation, r] = box;
    const T mass = density * w * h;
    BasicMass<T> sum{mass, center, mass * (w * w + h * h) / 12};
    if (r > 0) {
        const T flat = 2 * density * r * w;
        const T steep = 2 * density * r * h;
        const T disc = density * std::numbers::pi_v<T> * r * r;
        sum.mass += flat + steep + disc;
        sum.inertia += flat * ((w * w + r * r) / 12 + (h + r) * (h + r) / 4) +
                       steep * ((h * h + r * r) / 12 + (w + r) * (w + r) / 4) +
                       disc * (r * r / 2 + (w * w + h * h) / 4) +
                       density * r * r * r * (w + h) * 4 / 3;
    }
    return sum;
}

/// Mass of a capsule: that of a box of height 0 with its radius.
template <std::floating_point T>
BasicMass<T> massOf(const BasicCapsule<T>& capsule, T density) {
    const T size = length(capsule.to - capsule.from);
    return massOf(BasicBox<T>{size, 0, (capsule.from + capsule.to) / T(2), {}, capsule.radius},
                  density);
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

/// Mass of the circular sector of radius r between the unit vectors u and v, counter-clockwise at
/// most pi apart, about its corner at the origin. With the angle t between them:
///
///   m = d r^2 t / 2,   m c = d r^3 / 3 (v.y - u.y, u.x - v.x),   I of the corner = m r^2 / 2
template <std::floating_point T>
BasicMass<T> massOfSector(BasicVec2<T> u, BasicVec2<T> v, T r, T density) {
    const T angle = atan2((std::max)(cross(u, v), T(0)), dot(u, v));
    if (!(angle > 0)) {
        return {};
    }
    const T mass = density * r * r * angle / 2;
    const BasicVec2<T> center = (-2 * r / (3 * angle)) * perp(v - u);
    return {mass, center, mass * (r * r / 2 - dot(center, center))};
}

/// Mass of a polygon. With a radius, in addition a strip along each edge and a circular sector at
/// each corner.
template <std::floating_point T>
BasicMass<T> massOf(const BasicPolygon<T>& polygon, T density) {
    BasicMass<T> sum = massOf(std::span<const BasicVec2<T>>(polygon.corners), density);
    const std::size_t n = polygon.corners.size();
    const T r = polygon.radius;
    const auto edge = [&](std::size_t i) {
        return polygon.corners[(i + 1) % n] - polygon.corners[i];
    };
    for (std::size_t i = 0; r > 0 && i < n; ++i) {
        const BasicVec2<T> out = -perp(normalize(edge(i)));
        const BasicVec2<T> middle = polygon.corners[i] + (edge(i) + r * out) / T(2);
        sum = combine(sum, massOf(BasicBox<T>{length(edge(i)), r, middle, {}, {}}, density));
        const BasicVec2<T> before = -perp(normalize(edge((i + n - 1) % n)));
        BasicMass<T> sector = massOfSector(before, out, r, density);
        sector.center += polygon.corners[i];
        sum = combine(sum, sector);
    }
    return sum;
}

/// Mass of a particle: m = d,   I = 0
template <std::floating_point T>
BasicMass<T> massOf(const BasicPoint<T>& point, T density) {
    return {density, point.position, 0};
}

/// Mass of a segment of length L, without a radius; with one, it is that of a capsule:
///
///   m = d L,   I = m L^2 / 12
template <std::floating_point T>
BasicMass<T> massOf(const BasicSegment<T>& segment, T density) {
    if (segment.radius > 0) {
        return massOf(BasicCapsule<T>{segment.from, segment.to, segment.radius}, density);
    }
    const T squared = lengthSquared(segment.to - segment.from);
    const T mass = density * std::sqrt(squared);
    return {mass, (segment.from + segment.to) / T(2), mass * squared / 12};
}

/// A plane has mass 0. Its centre is the point of its surface closest to the origin.
template <std::floating_point T>
BasicMass<T> massOf(const BasicPlane<T>& plane, T) {
    return {0, plane.offset * plane.normal, 0};
}

} // namespace KODO_PRECISION
} // namespace kodo
