// SPDX-License-Identifier: MIT
// ContinuousCollision: shapes that turn through a line which they touch.
#include "collide/one_sided.hpp"
#include "collide/time_of_impact.hpp"
#include "contacts/line_side.hpp"

#include <cmath>

#include "continuous/allowed_approach.hpp"
#include "continuous/continuous_collision.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A line and the shape in front of it.
struct Front {
    const ConvexShape& line;
    Transform lineAt;
    const ConvexShape& other;
    Transform otherAt;
};

/// Normal (world) of a two-sided line on the side of the other shape: that of the contact, if the
/// line has one, else that of the middle.
Vec2 sideOf(const Front& pair, const Manifold& manifold, bool lineIsA) {
    const Vec2 normal = pair.lineAt.rotation * pair.line.normals[1];
    const Vec2 middle = pair.otherAt * pair.other.middle - pair.lineAt * pair.line.vertices[1];
    const Real cosine = dot(lineIsA ? manifold.normal : -manifold.normal, normal);
    const bool touches = manifold.count > 0 && std::abs(cosine) > Real(0.99);
    return (touches ? cosine : dot(normal, middle)) < 0 ? -normal : normal;
}

} // namespace

/// Lists a contact of two stopped bodies if one shape is a line.
void ContinuousCollision::noteLine(const Step& step, std::uint32_t contact) {
    const auto& [bodyA, partA, bodyB, partB] = step.contacts[contact].key;
    if (step.bodies.convex(bodyA, partA).isLine() || step.bodies.convex(bodyB, partB).isLine()) {
        stoppedAtLines_.push_back(contact);
    }
}

/// Fraction of the step at which a shape would be behind a line that it may touch: an impact can
/// turn a body by a radian in a step, and a contact point holds one corner alone. Lines are the
/// one-sided ones, and the two-sided ones of locked bodies.
Real ContinuousCollision::timeThroughLine(const Step& step, const Contact& contact,
                                          Real motion) const {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const Bodies& bodies = step.bodies;
    const ConvexShape& shapeA = bodies.convex(bodyA, partA);
    const ConvexShape& shapeB = bodies.convex(bodyB, partB);
    if (contact.hidden || contact.passing || shapeA.isPlane() || shapeB.isPlane()) {
        return 1;
    }
    const bool aIsLine = shapeA.oneSided || (shapeA.isLine() && bodies.locked(bodyA));
    const bool bIsLine = shapeB.oneSided || (shapeB.isLine() && bodies.locked(bodyB));
    if (aIsLine == bIsLine) {
        return 1;
    }
    const ConvexShape& line = aIsLine ? shapeA : shapeB;
    const ConvexShape& other = aIsLine ? shapeB : shapeA;
    const bool corners =
        !looksAgain(step.settings) && motion > other.coreRadius / 2; // as against solid ground
    const MotionPath path = pathOf(bodies, aIsLine ? bodyA : bodyB);
    const MotionPath otherPath = pathOf(bodies, aIsLine ? bodyB : bodyA);
    if (line.oneSided) {
        return timeBehind(line, path, other, otherPath, step.tolerances.slop, corners);
    }
    if (const auto jointed = jointedLineOf(bodies, contact.key)) {
        const Real side = jointedSideOf(bodies, contact, *jointed, step.tolerances.margin).side;
        const ConvexShape facing = facingTo(line, side * line.normals[1]);
        return timeBehind(facing, path, other, otherPath, step.tolerances.slop, corners);
    }
    const Vec2 side = sideOf({line, path.start, other, otherPath.start}, contact.manifold, aIsLine);
    const ConvexShape facing = facingTo(line, unrotate(path.start.rotation, side));
    return timeBehind(facing, path, other, otherPath, step.tolerances.slop, corners);
}

/// Time of impact with a two-sided line that shares a vertex with another, as with a chain: a point
/// that lies a little below the last line would pass below the vertex. 1 for other contacts.
Real ContinuousCollision::timeToJointedLine(const Step& step, const Contact& contact, Real gap,
                                            Real from) const {
    const Bodies& bodies = step.bodies;
    const auto line = jointedLineOf(bodies, contact.key);
    if (!line) {
        return 1;
    }
    const ConvexShape& shape = bodies.convex(line->body, line->part);
    const Real side = jointedSideOf(bodies, contact, *line, step.tolerances.margin).side;
    return timeOfImpact(facingTo(shape, side * shape.normals[1]), pathOf(bodies, line->body),
                        bodies.convex(line->otherBody, line->otherPart),
                        pathOf(bodies, line->otherBody), gap, from);
}

} // namespace KODO_PRECISION
} // namespace kodo
