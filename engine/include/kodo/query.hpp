// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/geometry.hpp>
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

/// The span of a ray within a part.
struct RaySpan {
    QueryHit entry{};      // as of rayCastAll()
    Real exitFraction = 1; // 0 to 1 of the ray; 1 if it ends within the part
    Vec2 exitPoint{};      // m
    Vec2 exitNormal{};     // unit, out of the body; zero if the ray ends within the part
};
/// The same parts with the points where the ray leaves them. A one-sided segment is left where it
/// is entered.
KODO_API std::vector<RaySpan> raySpans(const World& world, Vec2 from, Vec2 to,
                                       CollisionFilter which = {},
                                       std::span<const BodyId> except = {});

/// The first part that a shape meets when it moves by `displacement` without rotation; {0, 0} is
/// permitted. The point of a flat contact is its middle. Throws for a shape that check() refuses
/// and for a rotation that is not of length 1.
KODO_API std::optional<QueryHit> shapeCast(const World& world, const Shape& shape,
                                           const Transform& start, Vec2 displacement,
                                           CollisionFilter which = {},
                                           std::span<const BodyId> except = {});

/// What a cast does with a part that its shape overlaps or touches at the start.
enum class StartOverlap : std::uint8_t {
    Report, // a hit with fraction 0 and a zero normal
    Normal, // the same with the normal of least overlap; no hit if the displacement leads outwards
    Ignore, // no hit: the shape passes
};
/// Largest angle of a cast (rad).
inline constexpr Real kMaxCastAngle = 100;
/// A shape that moves and turns at constant rates.
struct ShapeCast {
    Shape shape = Circle{Real(0.5)};
    Transform start{};
    Vec2 displacement{}; // m, of the origin of the shape's frame
    Real angle = 0;      // rad, about this origin, counter-clockwise; size up to kMaxCastAngle
    StartOverlap atStart = StartOverlap::Report;
};
/// The first part that this shape meets. Without an angle the fraction is that of the closed form.
/// With one it is found by conservative advancement [Mirtich96]: the shape stops less than
/// Tolerances::slop / 4 before the part, and a gap below slop / 512 at the start counts as overlap.
KODO_API std::optional<QueryHit> shapeCast(const World& world, const ShapeCast& cast,
                                           CollisionFilter which = {},
                                           std::span<const BodyId> except = {});

/// Where a shape touches or nearly touches a part.
struct QueryContact {
    BodyId body{};
    std::uint16_t part = 0;
    Vec2 point{};        // m; halfway between the surfaces
    Vec2 normal{};       // unit, out of the body
    Real separation = 0; // m, along the normal; < 0 in overlap
};
/// The deepest contact of a shape at a pose with each part nearer than `margin` (m, >= 0), ordered
/// by id and part. One-sided segments have none with a shape behind them.
KODO_API std::vector<QueryContact> collide(const World& world, const Shape& shape,
                                           const Transform& at, Real margin,
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
/// The point of one body closest to a query point, however far. Throws BadDefinition for a
/// coordinate that is not finite.
KODO_API QueryPoint closestPoint(const BodyView& body, Vec2 point);
/// The closest points of two bodies: onA and onB are equal if they overlap. The cost is the product
/// of their numbers of parts, less what bounds rule out.
KODO_API ClosestPoints distance(const BodyView& a, const BodyView& b);

/// The bodies that touched a body in the last step, awake or asleep, in the order of ids. Of a
/// sensor: what it holds. Unlike a query, it must not run on two threads at once.
KODO_API std::vector<BodyId> touching(const World& world, BodyId id);

} // namespace KODO_PRECISION
} // namespace kodo
