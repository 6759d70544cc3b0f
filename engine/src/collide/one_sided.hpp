// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include "collide/manifold.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Which contacts collideAhead() finds.
struct ContactLimits {
    Real margin;            // m, largest separation
    Real preference;        // m, see collide()
    Real reach = 0;         // m, along one-sided lines, see collideOneSided()
    Real sink = margin / 4; // m, by which a middle without thickness may be behind its line
};

/// One-sided lines and chains of them (platforms, ground), without ghost collisions.
///
/// The middle of the other shape decides whether it is in front of the line or behind it. Shapes
/// behind pass through. Each direction belongs to one line of a chain. A line owns its normal. At a
/// convex vertex (hilltop), the line that starts there also owns the directions between the two
/// normals. A contact therefore never has a normal that the ground lacks, and a shape slides
/// smoothly over a flush vertex.
///
/// Reach: a circle or corner that comes along a valley within it already has a contact with the
/// lines ahead. So it follows their slope within the step. Without these contacts it moves
/// straight, enters the rising ground, and is lifted out of it at no cost of velocity: it gains
/// energy.
Manifold collideOneSided(const ConvexShape& line, const Transform& a, const ConvexShape& other,
                         const Transform& b, const ContactLimits& limits);

/// A one-sided copy of a two-sided line. Its front is on the side of `direction` (line's frame).
/// Lines that share a vertex with it become its chain.
ConvexShape facingTo(const ConvexShape& line, Vec2 direction);

/// collide(), with a reach along one-sided lines.
Manifold collideAhead(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                      const Transform& b, const ContactLimits& limits);

/// True if the line is responsible for contacts at vertex `end`, 0 or 1. False at a flush or
/// concave vertex, where only faces touch, and at a hilltop owned by the next line.
bool ownsVertex(const ConvexShape& line, std::size_t end);

/// True if the line accepts a contact normal at vertex `end` (unit, in the line's frame, away from
/// the line). A free end accepts all directions towards the front.
bool ownsDirection(const ConvexShape& line, std::size_t end, Vec2 direction);

/// A point of a shape near a line, in the line's frame.
struct PointOverLine {
    Vec2 position;
    Vec2 displacement; // m, in the step, against the line
    Real gap;          // m, over the line
};

/// True if a point moves along the line beyond a hilltop rather than along this one, and is less
/// than `tolerance` (m) deep until it has passed the hilltop. It would touch only the straight
/// extension of the line. False if it comes nearer to the next line by more than that in a step,
/// and for a point at the hilltop, where a face of the shape may lie.
bool missesLine(const ConvexShape& line, const PointOverLine& point, Real tolerance);

/// State of a contact with a one-sided line. A shape that comes from behind stays free until it no
/// longer overlaps, even when its middle is already in front. `passing`: the result for this
/// contact in the last step, false for a new one. Call in every step in which the pair exists, even
/// if the shapes are not near. If true, the contact is passing and the manifold is cleared.
bool letPass(bool passing, Manifold& manifold);

} // namespace KODO_PRECISION
} // namespace kodo
