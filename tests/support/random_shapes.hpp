// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>
#include <support/random_numbers.hpp>

#include <cmath>

namespace support {

/// Corners on an ellipse of about 1 m, unevenly spaced, with a minimum spacing that avoids
/// degenerate polygons.
inline kodo::Polygon randomPolygon(RandomNumbers& random, std::size_t corners) {
    const double width = static_cast<double>(random.between(0.5, 1.5));
    const double height = static_cast<double>(random.between(0.5, 1.5));
    const double start = static_cast<double>(random.between(0, 6));
    kodo::Polygon polygon;
    for (std::size_t i = 0; i < corners; ++i) {
        const double share = static_cast<double>(i) + static_cast<double>(random.between(0, 0.6));
        const double angle = start + share * 6.283185307 / static_cast<double>(corners);
        polygon.corners.push_back({static_cast<kodo::Real>(width * std::cos(angle)),
                                   static_cast<kodo::Real>(height * std::sin(angle))});
    }
    return polygon;
}

enum class Kind { Circle, Box, Polygon };
inline constexpr Kind kAllKinds[] = {Kind::Circle, Kind::Box, Kind::Polygon};

inline const char* nameOf(Kind kind) {
    return kind == Kind::Circle ? "circle" : kind == Kind::Box ? "box" : "polygon";
}

/// A primitive of about 1 m at or near its own origin.
inline kodo::Primitive randomPrimitive(RandomNumbers& random, Kind kind) {
    switch (kind) {
    case Kind::Circle: {
        const kodo::Real radius = random.between(0.2, 1.5);
        return kodo::Circle{radius, random.point(0.5)};
    }
    case Kind::Box: {
        const kodo::Real width = random.between(0.2, 3);
        const kodo::Real height = random.between(0.2, 3);
        const kodo::Vec2 center = random.point(0.5);
        return kodo::Box{width, height, center, random.rotation()};
    }
    default:
        return randomPolygon(random, 3 + random.below(14));
    }
}

} // namespace support
