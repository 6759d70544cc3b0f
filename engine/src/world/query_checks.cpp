// SPDX-License-Identifier: MIT
#include "world/query_checks.hpp"

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Real reachOf(const World& world) {
    return kMaxQueryCoordinate * world.tolerances().unit();
}

/// The corners of bounds, for a shape at its start or at the end of its way.
std::optional<Problem> checkBounds(const char* field, const Aabb& box, Real reach,
                                   const char* what) {
    for (const Vec2 corner : {box.lower, box.upper}) {
        if (auto problem = checkCoordinates(field, corner, reach, "m")) {
            problem->reason = what + problem->reason;
            return problem;
        }
    }
    return std::nullopt;
}

} // namespace

void requirePoint(const World& world, const char* field, Vec2 point) {
    refuse(checkCoordinates(field, point, reachOf(world), "m"));
}

void requireRay(const World& world, Vec2 from, Vec2 to) {
    requirePoint(world, "from", from);
    requirePoint(world, "to", to);
    if (from == to) {
        refuse(Problem{"to", "must differ from `from`, but both are " + textOf(from) +
                                 ": overlap() with a Point finds what contains a point"});
    }
}

void requireBox(const World& world, const Aabb& box) {
    refuse(checkBox("box", box));
    refuse(checkBounds("box", box, reachOf(world), ""));
}

void requireDistance(Real maxDistance) {
    if (!(maxDistance >= 0)) { // also for NaN
        refuse(Problem{"maxDistance", "must be at least 0 m, or infinite for the whole World, "
                                      "but is " +
                                          textOf(maxDistance)});
    }
}

std::vector<ConvexShape> requireShape(const World& world, const Shape& shape, const char* field,
                                      const Transform& at) {
    refuse(check(shape));
    requirePoint(world, field, at.position);
    refuse(checkRotation(field, at.rotation));
    std::vector<ConvexShape> convexes;
    for (const Primitive& primitive : primitivesOf(shape)) {
        convexes.push_back(convexShapeOf(primitive, {}));
        if (!convexes.back().isPlane()) {
            refuse(checkBounds("shape", boundsOf(convexes.back(), at), reachOf(world),
                               "reaches too far: "));
        }
    }
    return convexes;
}

void requireDisplacement(const World& world, std::span<const ConvexShape> convexes,
                         const Transform& start, Vec2 displacement) {
    refuse(checkFinite("displacement", displacement));
    for (const ConvexShape& convex : convexes) {
        const Aabb box = boundsOf(convex, start);
        const Aabb end{box.lower + displacement, box.upper + displacement};
        if (!convex.isPlane()) {
            refuse(checkBounds("displacement", end, reachOf(world), "leads too far: "));
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
