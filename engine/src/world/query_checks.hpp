// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/query.hpp>

#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

// Checks of the arguments of queries. Each throws BadDefinition that names the given field.

/// Coordinates must lie within kMaxQueryCoordinate times the length unit of the World.
void requirePoint(const World& world, const char* field, Vec2 point);
void requireRay(const World& world, Vec2 from, Vec2 to);
void requireBox(const World& world, const Aabb& box);
/// Also if it is infinite.
void requireDistance(Real maxDistance);
/// The convex shapes of a valid shape, relative to its own origin; `field` names the pose.
std::vector<ConvexShape> requireShape(const World& world, const Shape& shape, const char* field,
                                      const Transform& at);
void requireDisplacement(const World& world, std::span<const ConvexShape> convexes,
                         const Transform& start, Vec2 displacement);

/// A std::function must hold something to call.
template <typename Visit>
void requireVisitor(const Visit& visit) {
    if (!visit) {
        throw BadDefinition({"visit", "must not be empty: give a function that returns true to "
                                      "continue"});
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
