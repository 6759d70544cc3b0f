// SPDX-License-Identifier: MIT
#include "contacts/ghost_collisions.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Contact of a movable body with an immovable one, as seen from the movable one.
struct Ground {
    std::uint32_t body;    // the immovable one
    std::uint16_t part;    // of the immovable body
    Vec2 normal;           // out of the ground
    Vec2 arm;              // m, from the centre of the immovable body to the contact
    std::uint16_t carried; // part of the movable body
};

Ground groundOf(const Bodies& bodies, const Contact& contact) {
    const ManifoldPoint& p = contact.manifold.points[0];
    if (bodies.locked(contact.key.bodyA)) {
        return {contact.key.bodyA, contact.key.partA, contact.manifold.normal, p.armA,
                contact.key.partB};
    }
    return {contact.key.bodyB, contact.key.partB, -contact.manifold.normal, p.armB,
            contact.key.partA};
}

/// True for two one-sided lines of a body: they need no help against ghost collisions. Lines of a
/// fine valley rise by less than the tolerance, but must not be hidden.
bool areChain(const Bodies& bodies, const Ground& a, const Ground& b) {
    return a.body == b.body && bodies.convex(a.body, a.part).oneSided &&
           bodies.convex(b.body, b.part).oneSided;
}

/// True if no point of the shape is more than `tolerance` (m) above the surface through `point`.
bool liesUnder(const ConvexShape& convex, const Transform& pose, Vec2 normal, Vec2 point,
               Real tolerance) {
    if (convex.isPlane()) {
        return false;
    }
    const Vec2 n = unrotate(pose.rotation, normal);
    const Real height = dot(normal, point - pose.position) + tolerance - convex.radius;
    for (const Vec2 vertex : convex.vertices) {
        if (dot(n, vertex) > height) {
            return false;
        }
    }
    return true;
}

} // namespace

void GhostCollisions::link(const Bodies& bodies, std::span<const ContactSummary> summaries,
                           std::span<const std::uint32_t> onGround) {
    first_.assign(bodies.size(), kEnd);
    next_.resize(summaries.size());
    onPieces_.clear();
    for (auto i = onGround.rbegin(); i != onGround.rend(); ++i) {
        const ContactSummary& summary = summaries[*i];
        const std::uint32_t body = bodies.locked(summary.bodyA) ? summary.bodyB : summary.bodyA;
        if (first_[body] != kEnd && next_[first_[body]] == kEnd) {
            onPieces_.push_back(body);
        }
        next_[*i] = std::exchange(first_[body], *i);
    }
}

void GhostCollisions::hide(const Bodies& bodies, std::span<Contact> contacts,
                           std::span<ContactSummary> summaries,
                           const Tolerances& tolerances) const {
    for (const std::uint32_t body : onPieces_) {
        for (std::uint32_t i = first_[body]; i != kEnd; i = next_[i]) {
            const Contact& carrier = contacts[i];
            if (carrier.hidden || !carrier.responds() ||
                summaries[i].separation[0] > tolerances.slop) {
                continue;
            }
            const Ground carrying = groundOf(bodies, carrier);
            const Vec2 point = bodies.pose[carrying.body].position + carrying.arm;
            for (std::uint32_t k = first_[body]; k != kEnd; k = next_[k]) {
                Contact& other = contacts[k];
                const Ground ground = groundOf(bodies, other);
                const bool sameWay =
                    other.manifold.count > 0 && dot(ground.normal, carrying.normal) > Real(0.99999);
                if (k != i && !sameWay && ground.carried == carrying.carried &&
                    !areChain(bodies, carrying, ground) &&
                    liesUnder(bodies.convex(ground.body, ground.part), bodies.pose[ground.body],
                              carrying.normal, point, tolerances.slop)) {
                    other.hidden = true;
                    summaries[k].idle = false;
                    summaries[k].kept = false;
                }
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
