// SPDX-License-Identifier: MIT
#include "contacts/line_side.hpp"

#include "base/vector_reuse.hpp"
#include "collide/jointed_line.hpp"
#include "collide/round.hpp"
#include "contacts/contact_update.hpp"
#include "contacts/hilltops.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kDeeper = 2;         // times the depth of the last step, up to which a side is kept
constexpr Real kAcross = Real(0.1); // a side is clear from this cosine to the line's normal on

/// Normal by which the sides of a line differ at a point of it: near a vertex between that of the
/// line and that of its neighbour, since contacts there may have either.
Vec2 normalAt(const ConvexShape& line, Vec2 p, Real margin) {
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 next = end == 0 ? line.before : line.after;
        if (next != Vec2{} && lengthSquared(p - line.vertices[end]) < margin * margin) {
            const Vec2 sum = line.normals[1] + perp(next);
            const Real size = length(sum);
            return size > kAcross ? sum / size : line.normals[1];
        }
    }
    return line.normals[1];
}

/// The side of the manifold of the last step; 0: none.
Real storedSide(const Bodies& bodies, const Contact& contact, const JointedLine& line,
                Real margin) {
    const Manifold& manifold = contact.manifold;
    const ContactKey& key = contact.key;
    if ((manifold.count == 0 && !(manifold.points[0].separation > 0)) ||
        contact.teleportCounts[0] != bodies.teleportCount[key.bodyA] ||
        contact.teleportCounts[1] != bodies.teleportCount[key.bodyB]) {
        return 0;
    }
    const ConvexShape& shape = bodies.convex(line.body, line.part);
    const Rot& rotation = bodies.pose[line.body].rotation;
    const ManifoldPoint& point = manifold.points[0];
    const Vec2 across =
        manifold.count == 0
            ? shape.normals[1]
            : normalAt(shape, unrotate(rotation, line.isA ? point.armA : point.armB), margin);
    const Real cosine = dot(line.isA ? manifold.normal : -manifold.normal, rotation * across);
    return std::abs(cosine) < kAcross ? Real(0) : std::copysign(Real(1), cosine);
}

/// The point of a shape that is closest to p; p itself if it is inside.
Vec2 nearestPoint(const ConvexShape& shape, Vec2 p) {
    if (shape.isRound()) {
        const Vec2 arm = p - shape.vertices[0];
        const Real distance = length(arm);
        return distance > shape.radius ? shape.vertices[0] + shape.radius / distance * arm : p;
    }
    const RoundAxis axis = nearestToCenter(shape, p);
    return axis.distance > 0 ? p - axis.distance * axis.normal : p;
}

/// Heights (m) up to this one on the wrong side are those of a soft contact.
Real sinkOf(const Bodies& bodies, const JointedLine& line, Real margin) {
    return std::max(margin - bodies.convex(line.otherBody, line.otherPart).coreRadius, Real(0));
}

/// Height (m) of the other shape over the line and its neighbours: that of its middle. If this is
/// farther along the chain, that of the nearest point on the way from there to the line.
Real heightOf(const Bodies& bodies, const JointedLine& line, Real margin) {
    const Transform otherToLine = between(bodies.pose[line.body], bodies.pose[line.otherBody]);
    const ConvexShape& other = bodies.convex(line.otherBody, line.otherPart);
    const ConvexShape& own = bodies.convex(line.body, line.part);
    const Vec2 middle = otherToLine * other.middle;
    const Vec2 near =
        otherToLine *
        nearestPoint(other,
                     between(bodies.pose[line.otherBody], bodies.pose[line.body]) * own.middle);
    return heightOverJoints(own, withinJoints(own, middle, near), sinkOf(bodies, line, margin));
}

/// Depth (m) up to which the middle of a shape stays on its side: the margin, or what a contact
/// that is deeper than usual may reach in a step.
Real deepestSink(const Manifold& last, Real margin) {
    return last.count > 0 ? std::max(margin, -kDeeper * last.points[0].separation) : margin;
}

/// True if a shape is farther than `sink` (m) behind that side of a line.
bool isBehind(Real height, Real side, Real sink) {
    return side * height < -sink;
}

/// Replaces the manifold of a near contact, without impulses of the old one.
void replace(const HidingStep& step, std::uint32_t slot, const Manifold& manifold) {
    const ContactLane lane = step.store.lane(slot);
    lane.clearStep();
    lane.clearImpulses();
    step.replace(slot, manifold);
}

} // namespace

std::optional<JointedLine> findJointedLine(const Bodies& bodies, const ContactKey& key) {
    const ConvexShape& a = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& b = bodies.convex(key.bodyB, key.partB);
    const bool isA = isJointed(a);
    const ConvexShape& other = isA ? b : a;
    if (isA == isJointed(b) || other.isPlane() || other.oneSided) {
        return std::nullopt;
    }
    return isA ? JointedLine{true, key.bodyA, key.partA, key.bodyB, key.partB}
               : JointedLine{false, key.bodyB, key.partB, key.bodyA, key.partA};
}

JointedSide jointedSideOf(const Bodies& bodies, const Contact& contact, const JointedLine& line,
                          Real margin) {
    const Real last = storedSide(bodies, contact, line, margin);
    const Real sink = last == 0 ? margin : deepestSink(contact.manifold, margin);
    const Real height = heightOf(bodies, line, sink);
    if (last != 0 && !isBehind(height, last, sinkOf(bodies, line, sink))) {
        return {last, sink};
    }
    return {std::copysign(Real(1), height), margin};
}

Manifold collideOnSide(const Bodies& bodies, const ContactKey& key, const JointedLine& line,
                       JointedSide side, const ContactLimits& limits) {
    const ConvexShape& shapeA = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& shapeB = bodies.convex(key.bodyB, key.partB);
    const Transform& a = bodies.pose[key.bodyA];
    const Transform& b = bodies.pose[key.bodyB];
    const ConvexShape& shape = line.isA ? shapeA : shapeB;
    const Vec2 front = side.side * shape.normals[1];
    const ConvexShape facing = facingTo(shape, front);
    ContactLimits deep = limits; // the side is known, also below the line
    deep.sink = side.sink;
    Manifold manifold = line.isA ? collideAhead(facing, a, shapeB, b, deep)
                                 : collideAhead(shapeA, a, facing, b, deep);
    if (manifold.fromBehind) { // beyond a free end, which blocks on all sides
        return collideAhead(shapeA, a, shapeB, b, limits);
    }
    if (manifold.count == 0) {
        const Vec2 normal = bodies.pose[line.body].rotation * front;
        manifold.normal = line.isA ? normal : -normal;
        Real& gap = manifold.points[0].separation; // > 0: the normal gives the side
        gap = std::max(gap, limits.margin);
    }
    return manifold;
}

void LineSides::link(const Bodies& bodies, std::span<const Contact> contacts,
                     std::span<const ContactSummary> summaries) {
    groups_.clear();
    for (std::uint32_t slot = 0; slot < summaries.size(); ++slot) {
        const ContactSummary& summary = summaries[slot];
        const auto mayBeJointed = [&](std::uint32_t body) {
            return !(bodies.extent[body].coreRadius > 0) && bodies.geometry(body).parts.size() > 1;
        };
        if (summary.gone || !(mayBeJointed(summary.bodyA) || mayBeJointed(summary.bodyB))) {
            continue;
        }
        if (const auto line = jointedLineOf(bodies, contacts[slot].key)) {
            reserveReusing(groups_, summaries.size());
            groups_.push_back({*line, slot});
        }
    }
    const auto order = [](const Member& m) {
        return std::tuple(m.line.body, m.line.otherBody, m.line.otherPart, m.line.part);
    };
    std::sort(groups_.begin(), groups_.end(), // total order: keys of contacts are unique
              [&](const Member& m, const Member& n) { return order(m) < order(n); });
}

/// `from` touched in the last step, `to` did not.
void LineSides::copySide(const HidingStep& step, const Member& from, const Member& to) const {
    const Bodies& bodies = step.bodies;
    const Contact& carrier = step.contact(from.slot);
    Contact& contact = step.store.contacts()[to.slot];
    const ConvexShape& line = bodies.convex(from.line.body, from.line.part);
    const ConvexShape& next = bodies.convex(to.line.body, to.line.part);
    const Real margin = step.tolerances.margin;
    const Real side = directionBetween(line, next) * storedSide(bodies, carrier, from.line, margin);
    const Real sink = deepestSink(carrier.manifold, margin);
    if (side == 0 || storedSide(bodies, contact, to.line, margin) == side ||
        isBehind(heightOf(bodies, to.line, sink), side, sinkOf(bodies, to.line, sink))) {
        return;
    }
    if (contact.near) {
        Manifold manifold = collideOnSide(bodies, contact.key, to.line, {side, sink},
                                          {margin, step.tolerances.slop / 8, Real(0)});
        removePassingPoints(manifold, contact, bodies, step.tolerances, step.dt);
        replace(step, to.slot, manifold);
        return;
    }
    // for continuous collision
    const Vec2 normal = bodies.pose[to.line.body].rotation * (side * next.normals[1]);
    contact.manifold.normal = to.line.isA ? normal : -normal;
    contact.manifold.points[0].separation = margin;
    step.store.lane(to.slot).separation(0) = margin;
    contact.teleportCounts = {bodies.teleportCount[contact.key.bodyA],
                              bodies.teleportCount[contact.key.bodyB]};
}

void LineSides::spread(const HidingStep& step) const {
    const auto sameGroup = [](const Member& m, const Member& n) {
        return m.line.body == n.line.body && m.line.otherBody == n.line.otherBody &&
               m.line.otherPart == n.line.otherPart;
    };
    for (auto first = groups_.begin(); first != groups_.end();) {
        const auto end = std::find_if(first, groups_.end(),
                                      [&](const Member& m) { return !sameGroup(m, *first); });
        for (auto to = first; to != end; ++to) {
            // Its separations, which give the side, are brought up to date.
            Contact& contact = step.store.change(to->slot, step.bodies);
            if (!contact.near && contact.manifold.count == 0) {
                contact.manifold.points[0].separation = 0; // no side is stored any more
                step.store.lane(to->slot).separation(0) = 0;
            }
        }
        for (auto from = first; from != end; ++from) {
            if (!step.contact(from->slot).wasTouching) {
                continue;
            }
            for (auto to = first; to != end; ++to) {
                const Contact& contact = step.contact(to->slot);
                if (to != from && !contact.wasTouching) {
                    copySide(step, *from, *to);
                }
            }
        }
        first = end;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
