// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

// Queries: where are the bodies of a World now? They change nothing. Each visits the bodies whose
// user flags `which` accepts, without disabled ones, at the cost of a look at all bounds. Points
// and displacements are in the world (m). A query with values that are not finite finds nothing.
// The rotation of a Transform must have length 1, as Rot::fromAngle() gives; that is not checked.

/// Where a ray or a moving shape meets a part of a body.
struct QueryHit {
    BodyId body;
    std::uint16_t part = 0;
    Real fraction = 0; // 0 to 1 of the ray or displacement
    Vec2 point;        // m
    Vec2 normal;       // unit, out of the body; zero for overlap at the start
};

/// The first part on a ray. Ties go to the lower id, then to the lower part.
KODO_API std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to,
                                         CollisionFilter which = {});
/// All parts on a ray, ordered by fraction, then id, then part.
KODO_API std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to,
                                          CollisionFilter which = {});

/// The first part that a shape meets when it moves by `displacement` without rotation. Throws
/// BadDefinition for a shape that check() refuses.
KODO_API std::optional<QueryHit> shapeCast(const World& world, const Shape& shape,
                                           const Transform& start, Vec2 displacement,
                                           CollisionFilter which = {});

/// Bodies with a part that overlaps or touches a box, in the order of their ids.
KODO_API std::vector<BodyId> overlap(const World& world, const Aabb& box,
                                     CollisionFilter which = {});
/// The same for a shape at a pose. Throws BadDefinition for one that check() refuses.
KODO_API std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                                     CollisionFilter which = {});

/// The point of a body closest to a query point.
struct QueryPoint {
    BodyId body;
    std::uint16_t part = 0;
    Vec2 point;        // m; the query point itself if it is inside
    Vec2 normal;       // unit, from the body to the query point; zero inside
    Real distance = 0; // m; 0 inside
};

/// The closest body within maxDistance (m). Ties go to the lower id, then to the lower part.
KODO_API std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                                CollisionFilter which = {});

} // namespace KODO_PRECISION
} // namespace kodo
