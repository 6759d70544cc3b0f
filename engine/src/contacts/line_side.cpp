// SPDX-License-Identifier: MIT
#include "contacts/line_side.hpp"

#include "base/vector_reuse.hpp"
#include "collide/chain_line.hpp"
#include "collide/round.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kThin = 64;  // largest reach of a thin shape, in core radii
constexpr Real kDeeper = 2; // times the depth of the last step, up to which a side is kept

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
    const Vec2 ownMiddle =
        between(bodies.pose[line.otherBody], bodies.pose[line.body]) * own.middle;
    const RoundAxis axis = nearestToCenter(other, ownMiddle);
    const Vec2 near = ownMiddle - std::max(axis.distance, Real(0)) * axis.normal;
    return heightOverJoints(own, withinJoints(own, otherToLine * other.middle, otherToLine * near),
                            sinkOf(bodies, line, margin));
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

} // namespace

std::optional<JointedLine> findJointedLine(const Bodies& bodies, const ContactKey& key) {
    const ConvexShape& a = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& b = bodies.convex(key.bodyB, key.partB);
    const auto hasSides = [&](const ConvexShape& line, std::uint32_t body,
                              const ConvexShape& other) {
        const bool isThin = kThin * other.coreRadius <= other.boundingRadius;
        const bool isGround = isThin && (line.oneSided ? isLinked(line) : bodies.locked(body));
        return line.isLine() && (isGround || (!line.oneSided && isLinked(line)));
    };
    const bool isA = hasSides(a, key.bodyA, b);
    const ConvexShape& other = isA ? b : a;
    if (isA == hasSides(b, key.bodyB, a) || other.isPlane() || other.oneSided) {
        return std::nullopt;
    }
    return isA ? JointedLine{true, key.bodyA, key.partA, key.bodyB, key.partB}
               : JointedLine{false, key.bodyB, key.partB, key.bodyA, key.partA};
}

JointedSide jointedSideOf(const Bodies& bodies, const Contact& contact, const JointedLine& line,
                          Real margin) {
    const Real last = isKnown(bodies, contact) ? contact.side : Real(0);
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
    if (shape.oneSided && side.side < 0) {
        Manifold passing;
        passing.fromBehind = true;
        return passing;
    }
    const ConvexShape facing = facingTo(shape, side.side * shape.normals[1]);
    ContactLimits deep = limits; // the side is known, also below the line
    deep.sink = side.sink;
    const Manifold manifold = line.isA ? collideAhead(facing, a, shapeB, b, deep)
                                       : collideAhead(shapeA, a, facing, b, deep);
    // Behind: beyond a free end, which blocks on all sides.
    return manifold.fromBehind && !shape.oneSided ? collideAhead(shapeA, a, shapeB, b, limits)
                                                  : manifold;
}

void LineSides::link(const Spread& step) {
    slots_.clear();
    if (step.bodies.thin == 0) {
        return;
    }
    reserveReusing(slots_, step.store.size());
    step.store.forEachInOrder([&](std::uint32_t slot) {
        if (jointedLineOf(step.bodies, step.store.contacts()[slot].key)) {
            slots_.push_back(slot);
        }
    });
}

/// The side that a contact takes over from another one, if their lines are linked; 0: none.
Real LineSides::sideFrom(const Spread& step, const Contact& carrier, const JointedLine& to) {
    const Bodies& bodies = step.bodies;
    const auto from = carrier.side != 0 && !carrier.passing && isKnown(bodies, carrier)
                          ? jointedLineOf(bodies, carrier.key)
                          : std::nullopt;
    if (!from || from->body != to.body || from->otherPart != to.otherPart) {
        return 0;
    }
    const Real side = carrier.side * directionBetween(bodies.convex(from->body, from->part),
                                                      bodies.convex(to.body, to.part));
    const Real sink = deepestSink(carrier.manifold, step.margin);
    return isBehind(heightOf(bodies, to, sink), side, sinkOf(bodies, to, sink)) ? 0 : side;
}

/// True if the contact takes over another side.
bool LineSides::takeSide(const Spread& step, std::uint32_t slot) {
    const auto& [bodies, store, margin] = step;
    const std::span<Contact> contacts = store.contacts();
    Contact& contact = contacts[slot];
    const std::optional<JointedLine> found = jointedLineOf(bodies, contact.key);
    if (!found) { // its other body was frozen in this step: no line is on the ground beside it
        return false;
    }
    const JointedLine& line = *found;
    const bool known = isKnown(bodies, contact);
    Real side = 0; // a sum does not depend on the order of the contacts
    store.lists().forEach(line.otherBody, [&](std::uint32_t other) {
        const Contact& carrier = contacts[other];
        if (carrier.wasTouching || !known || contact.side == 0) {
            side += sideFrom(step, carrier, line);
        }
    });
    const bool behind =
        isBehind(heightOf(bodies, line, margin), contact.side, sinkOf(bodies, line, margin));
    if (side == 0 && known && !behind) {
        return false;
    }
    const auto sign = static_cast<std::int8_t>((side > 0 ? 1 : 0) - (side < 0 ? 1 : 0));
    if (known && sign == contact.side) {
        return false;
    }
    store.change(slot, bodies).side = sign;
    contact.teleportCounts = {bodies.teleportCount[contact.key.bodyA],
                              bodies.teleportCount[contact.key.bodyB]};
    contact.filled = false; // its manifold is found again
    store.lane(slot).relativeDisplacement() = std::numeric_limits<Real>::max();
    return sign != 0;
}

void LineSides::spread(const Spread& step, bool changed) {
    if (changed) {
        link(step);
    }
    bool again = !slots_.empty();
    for (std::size_t round = 0; again && round < slots_.size(); ++round) {
        again = false;
        for (const std::uint32_t slot : slots_) {
            again |= !step.store.contacts()[slot].wasTouching && takeSide(step, slot);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
