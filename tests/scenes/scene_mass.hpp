// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <numbers>

namespace scenes {

/// Mass (kg), centre (m) and inertia (kg m^2) by closed forms and the parallel axis theorem. It
/// serves as oracle for Kodo and as mass of bodies in Box2D.
struct Mass {
    double mass = 0;
    Vec2 center;
    double inertia = 0; // about the centre of mass
};

// Mass of a part with density 1.
inline Mass massOfPart(const Circle& circle) {
    const double mass = std::numbers::pi * circle.radius * circle.radius;
    return {mass, circle.center, mass * circle.radius * circle.radius / 2};
}

inline Mass massOfPart(const Box& box) {
    const double mass = box.width * box.height;
    return {mass, box.center, mass * (box.width * box.width + box.height * box.height) / 12};
}

/// The rectangle and the two half discs, whose centres lie 4 r / (3 pi) beyond it.
inline Mass massOfPart(const Capsule& capsule) {
    const double r = capsule.radius;
    const Vec2 way = capsule.to - capsule.from;
    const double length = std::sqrt(dot(way, way));
    const double middle = 2 * r * length;
    const double discs = std::numbers::pi * r * r;
    const double far = length / 2 + 4 * r / (3 * std::numbers::pi);
    const double own = 4 * r / (3 * std::numbers::pi); // of a half disc, from the disc's centre
    return {middle + discs, 0.5 * (capsule.from + capsule.to),
            middle * (length * length + 4 * r * r) / 12 +
                discs * (r * r / 2 - own * own + far * far)};
}

/// Sum over the triangles (origin, p, q). The inertia about the origin is shifted to the centre at
/// the end.
inline Mass massOfPart(const Polygon& polygon) {
    Mass sum;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Vec2 p = polygon.corners[i];
        const Vec2 q = polygon.corners[(i + 1) % polygon.corners.size()];
        const double area = cross(p, q) / 2;
        sum.mass += area;
        sum.center = sum.center + (area / 3) * (p + q);
        sum.inertia += area / 6 * (dot(p, p) + dot(p, q) + dot(q, q));
    }
    sum.center = (1 / sum.mass) * sum.center;
    sum.inertia -= sum.mass * dot(sum.center, sum.center);
    return sum;
}

inline Mass massOf(const BodyDef& body) {
    std::vector<Mass> parts;
    Mass sum;
    for (const Part& part : body.parts) {
        Mass mass = std::visit([](const auto& shape) { return massOfPart(shape); }, part);
        mass.mass *= body.density;
        mass.inertia *= body.density;
        parts.push_back(mass);
        sum.mass += mass.mass;
        sum.center = sum.center + mass.mass * mass.center;
    }
    sum.center = (1 / sum.mass) * sum.center;
    for (const Mass& part : parts) {
        const Vec2 arm = part.center - sum.center;
        sum.inertia += part.inertia + part.mass * dot(arm, arm);
    }
    return sum;
}

} // namespace scenes
