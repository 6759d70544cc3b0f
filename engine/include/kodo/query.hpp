// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

// Queries: where are the bodies of a World now? They change nothing. Each visits the bodies whose
// user flags `which` accepts, without disabled ones and those in `except`; ids in `except` that
// name no body are ignored. The cost grows with the logarithm of the number of bodies, and with
// what is found; the first query after a step also updates the bounds of what moved. Several
// threads may query one World at once. Points and displacements are in the world (m).
//
// Queries throw BadDefinition for a coordinate that is not finite or beyond kMaxQueryCoordinate,
// and for a filter with two match modes, or with `required` and no mode. The comment of a query
// names what else it refuses. A visitor that changes the World gets std::logic_error.

/// Largest coordinate of a query (m, times the length unit of the World): far beyond
/// kMaxCoordinate, for bodies that have moved there.
inline constexpr Real kMaxQueryCoordinate = 1000 * kMaxCoordinate;

/// Where a ray or a moving shape meets a part of a body.
struct QueryHit {
    BodyId body{};
    std::uint16_t part = 0;
    Real fraction = 0; // 0 to 1 of the ray or displacement
    Vec2 point{};      // m
    Vec2 normal{};     // unit, out of the body; zero for overlap at the start
};

/// The first part on a ray. Ties go to the lower id, then to the lower part. Throws for a ray
/// without length.
KODO_API std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to,
                                         CollisionFilter which = {},
                                         std::span<const BodyId> except = {});
/// All parts on a ray, ordered by fraction, then id, then part. Throws for a ray without length.
KODO_API std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to,
                                          CollisionFilter which = {},
                                          std::span<const BodyId> except = {});
/// Visits the parts on a ray in the same order, until visit(hit) returns false. Parts behind are
/// not tested then. Throws also for an empty std::function.
KODO_API void visitRay(const World& world, Vec2 from, Vec2 to,
                       const std::function<bool(const QueryHit&)>& visit,
                       CollisionFilter which = {}, std::span<const BodyId> except = {});

/// The first part that a shape meets when it moves by `displacement` without rotation; {0, 0} is
/// permitted. Throws for a shape that check() refuses and for a rotation that is not of length 1.
KODO_API std::optional<QueryHit> shapeCast(const World& world, const Shape& shape,
                                           const Transform& start, Vec2 displacement,
                                           CollisionFilter which = {},
                                           std::span<const BodyId> except = {});

/// Bodies with a part that overlaps or touches a box, in the order of their ids. Throws unless
/// lower <= upper on both axes.
KODO_API std::vector<BodyId> overlap(const World& world, const Aabb& box,
                                     CollisionFilter which = {},
                                     std::span<const BodyId> except = {});
/// The same for a shape at a pose. Throws for a shape that check() refuses and for a rotation that
/// is not of length 1.
KODO_API std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                                     CollisionFilter which = {},
                                     std::span<const BodyId> except = {});
/// Visits the same bodies in the same order, until visit(id) returns false. Later bodies are not
/// tested then. Throws also for an empty std::function.
KODO_API void visitOverlaps(const World& world, const Shape& shape, const Transform& at,
                            const std::function<bool(BodyId)>& visit, CollisionFilter which = {},
                            std::span<const BodyId> except = {});

/// The point of a body closest to a query point.
struct QueryPoint {
    BodyId body{};
    std::uint16_t part = 0;
    Vec2 point{};      // m; the query point itself if it is inside
    Vec2 normal{};     // unit, from the body to the query point; zero inside
    Real distance = 0; // m; 0 inside
};

/// The closest body within maxDistance (m, >= 0; infinite: the whole World). Ties go to the lower
/// id, then to the lower part. The cost grows with the number of closer bodies that the filter
/// refuses or `except` contains: where few bodies pass, a small maxDistance bounds it.
KODO_API std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                                CollisionFilter which = {},
                                                std::span<const BodyId> except = {});

} // namespace KODO_PRECISION
} // namespace kodo
