// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include <vector>

/// Slow oracle for any two convex shapes, in long double: position of the origin relative to the
/// hull of all corner differences. It uses no faces, axes or local frames.
namespace support {

using LongPoint = kodo::BasicVec2<long double>;

LongPoint widened(kodo::Vec2 v);
LongPoint placed(const kodo::Transform& t, kodo::Vec2 v);
std::vector<LongPoint> placedCorners(const kodo::ConvexShape& convex, const kodo::Transform& t);

/// Convex hull by gift wrapping: the next corner has all other points on its left.
std::vector<LongPoint> wrapped(const std::vector<LongPoint>& points);

/// Distance from the segment to p.
long double toSegment(LongPoint p, LongPoint from, LongPoint to);

/// Distance from a convex hull to p; negative inside.
long double signedDistance(const std::vector<LongPoint>& hull, LongPoint p);

/// The hull of all differences b - a.
std::vector<LongPoint> differencesOf(const kodo::ConvexShape& shapeA, const kodo::Transform& a,
                                     const kodo::ConvexShape& shapeB, const kodo::Transform& b);

/// The exact signed distance of two convex shapes. If negative, its magnitude is the smallest
/// translation that separates them. Segments are two-sided.
long double signedDistance(const kodo::ConvexShape& shapeA, const kodo::Transform& a,
                           const kodo::ConvexShape& shapeB, const kodo::Transform& b);

/// Result of a straight translation of one convex shape past another.
struct Passage {
    enum class End { Hits, Misses, Grazes } end = End::Grazes; // Grazes: within the tolerance
    long double fraction = 0; // share of the displacement at the hit
    LongPoint normal{}; // unit, from the target to the moving shape; zero if they overlap at the
                        // start
};

Passage passageOf(const kodo::ConvexShape& moving, const kodo::Transform& from, kodo::Vec2 move,
                  const kodo::ConvexShape& target, const kodo::Transform& t);

/// As passageOf(), but one-sided segments are hit only from their front and not if they overlap at
/// the start. All other passages miss.
Passage frontPassageOf(const kodo::ConvexShape& moving, const kodo::Transform& from,
                       kodo::Vec2 move, const kodo::ConvexShape& target, const kodo::Transform& t);

} // namespace support
