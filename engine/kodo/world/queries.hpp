// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world/world.hpp>

#include <optional>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Questions to a World, or to a copy of one, about where its bodies are now. They change nothing.
///
/// Each looks at the bodies whose user flags `which` accepts and leaves out disabled ones; the cost
/// is that of a look at the bounds of every body. Points and ways are in the world (m); whoever
/// asks from a place that is not finite gets no answer. The rotation of a Transform must have
/// length 1, as every Rot from an angle has: that is not checked.

/// Where a ray or a moving shape meets a part of a body.
struct QueryHit {
    BodyId body;
    std::uint16_t part = 0;
    Real fraction = 0; // 0..1 of the way
    Vec2 point;        // m
    Vec2 normal;       // unit, out of the body; zero if they overlap from the start
};

/// The first part that a ray meets. Ties go to the lower id, then to the lower part.
std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to, CollisionFilter which = {});
/// All parts that it meets, ordered by fraction, then id, then part.
std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to,
                                 CollisionFilter which = {});

/// The first part that a shape meets which moves straight on from `start`, without turning. Throws
/// BadDefinition for a shape that check() refuses.
std::optional<QueryHit> shapeCast(const World& world, const Shape& shape, const Transform& start,
                                  Vec2 move, CollisionFilter which = {});

/// The bodies of which some part overlaps or touches a box, in the order of their ids.
std::vector<BodyId> overlap(const World& world, const Aabb& box, CollisionFilter which = {});
/// The same for a shape. Throws BadDefinition for one that check() refuses.
std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                            CollisionFilter which = {});

/// The point of a body that is nearest to another point.
struct QueryPoint {
    BodyId body;
    std::uint16_t part = 0;
    Vec2 point;        // m; where the question was if that lies inside
    Vec2 normal;       // unit, from the body to where the question was; zero inside
    Real distance = 0; // m; 0 inside
};

/// The nearest of all bodies that are not farther than maxDistance (m). Ties go to the lower id,
/// then to the lower part.
std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                       CollisionFilter which = {});

} // namespace kodo::inline KODO_PRECISION
