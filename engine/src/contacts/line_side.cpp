// SPDX-License-Identifier: MIT
#include "contacts/line_side.hpp"

#include "base/vector_reuse.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kAcross = Real(0.1); // least cosine to the line's normal that tells a side

/// The side that the manifold of the last step tells; 0: none.
Real remembered(const Bodies& bodies, const Contact& contact, const JointedLine& line) {
    const Manifold& manifold = contact.manifold;
    const ContactKey& key = contact.key;
    if ((manifold.count == 0 && !(manifold.points[0].separation > 0)) ||
        contact.teleportCounts[0] != bodies.teleportCount[key.bodyA] ||
        contact.teleportCounts[1] != bodies.teleportCount[key.bodyB]) {
        return 0;
    }
    const Vec2 normal =
        bodies.pose[line.body].rotation * bodies.convex(line.body, line.part).normals[1];
    const Real cosine = dot(line.isA ? manifold.normal : -manifold.normal, normal);
    return std::abs(cosine) < kAcross ? Real(0) : std::copysign(Real(1), cosine);
}

/// Height (m) of the middle of the other shape over the line and its neighbours.
Real heightOf(const Bodies& bodies, const JointedLine& line) {
    const Vec2 middle = between(bodies.pose[line.body], bodies.pose[line.otherBody]) *
                        bodies.convex(line.otherBody, line.otherPart).middle;
    return heightOverJoints(bodies.convex(line.body, line.part), middle);
}

/// Heights (m) up to this one on the wrong side are those of a soft contact.
Real sinkOf(const Bodies& bodies, const JointedLine& line, Real margin) {
    return std::max(margin - bodies.convex(line.otherBody, line.otherPart).coreRadius, Real(0));
}

/// -1 if two lines that share a vertex go in opposite directions there, 1 if in the same one; 0 if
/// they share none.
Real directionBetween(const ConvexShape& a, const ConvexShape& b) {
    if (a.vertices[1] == b.vertices[0] || a.vertices[0] == b.vertices[1]) {
        return 1;
    }
    return a.vertices[0] == b.vertices[0] || a.vertices[1] == b.vertices[1] ? Real(-1) : Real(0);
}

} // namespace

std::optional<JointedLine> jointedLineOf(const Bodies& bodies, const ContactKey& key) {
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

Real sideOf(const Bodies& bodies, const Contact& contact, const JointedLine& line, Real margin) {
    const Real height = heightOf(bodies, line);
    const Real last = remembered(bodies, contact, line);
    return last != 0 && last * height >= -sinkOf(bodies, line, margin)
               ? last
               : std::copysign(Real(1), height);
}

Manifold collideOnSide(const Bodies& bodies, const ContactKey& key, const JointedLine& line,
                       Real side, const ContactLimits& limits) {
    const ConvexShape& shapeA = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& shapeB = bodies.convex(key.bodyB, key.partB);
    const Transform& a = bodies.pose[key.bodyA];
    const Transform& b = bodies.pose[key.bodyB];
    const ConvexShape& shape = line.isA ? shapeA : shapeB;
    const Vec2 front = side * shape.normals[1];
    const ConvexShape facing = facingTo(shape, front);
    Manifold manifold = line.isA ? collideAhead(facing, a, shapeB, b, limits)
                                 : collideAhead(shapeA, a, facing, b, limits);
    if (manifold.fromBehind) { // beyond a free end, which blocks on all sides
        return collideAhead(shapeA, a, shapeB, b, limits);
    }
    if (manifold.count == 0) {
        const Vec2 normal = bodies.pose[line.body].rotation * front;
        manifold.normal = line.isA ? normal : -normal;
        Real& gap = manifold.points[0].separation; // > 0: the side is known
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
void LineSides::handOn(const HidingStep& step, const Member& from, const Member& to) const {
    const Bodies& bodies = step.bodies;
    const Contact& carrier = step.contacts[from.slot];
    Contact& contact = step.contacts[to.slot];
    const ConvexShape& line = bodies.convex(from.line.body, from.line.part);
    const ConvexShape& next = bodies.convex(to.line.body, to.line.part);
    const Real margin = step.tolerances.margin;
    const Real side = directionBetween(line, next) * remembered(bodies, carrier, from.line);
    if (side == 0 || remembered(bodies, contact, to.line) == side ||
        side * heightOf(bodies, to.line) < -sinkOf(bodies, to.line, margin)) {
        return;
    }
    if (!contact.near) { // for continuous collision
        const Vec2 normal = bodies.pose[to.line.body].rotation * (side * next.normals[1]);
        contact.manifold.normal = to.line.isA ? normal : -normal;
        contact.manifold.points[0].separation = margin;
        contact.teleportCounts = {bodies.teleportCount[contact.key.bodyA],
                                  bodies.teleportCount[contact.key.bodyB]};
        return;
    }
    if (contact.row.resident) {
        step.evict(contact);
    }
    contact.manifold = collideOnSide(bodies, contact.key, to.line, side,
                                     {margin, step.tolerances.slop / 8, Real(0)});
    contact.carried = false;
    contact.impulse = {};
    contact.friction = 0;
    contact.rolling = 0;
    measureApproach(contact, bodies);
    step.summaries[to.slot].idle = false;
    step.summaries[to.slot].note(contact);
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
            Contact& contact = step.contacts[to->slot];
            if (!contact.near && contact.manifold.count == 0) {
                contact.manifold.points[0].separation = 0; // the side is not known any more
            }
        }
        for (auto from = first; from != end; ++from) {
            if (!step.contacts[from->slot].wasTouching) {
                continue;
            }
            for (auto to = first; to != end; ++to) {
                const Contact& contact = step.contacts[to->slot];
                if (to != from && !contact.wasTouching) {
                    handOn(step, *from, *to);
                }
            }
        }
        first = end;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
