// SPDX-License-Identifier: MIT
#include <kodo/contacts/seams.hpp>

#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

/// A contact between a body that can be pushed and a locked one, seen from the first.
struct Ground {
    std::uint32_t body; // the locked one
    std::uint16_t part;
    Vec2 normal;           // out of the ground
    Vec2 arm;              // m, from the locked body's centre to the contact
    std::uint16_t carried; // the part of the first
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

/// Does no point of the outline rise above the surface through `point` by more than `tolerance`?
bool liesUnder(const Convex& outline, const Transform& pose, Vec2 normal, Vec2 point,
               Real tolerance) {
    if (outline.isPlane()) {
        return false;
    }
    const Vec2 n = unrotate(pose.rotation, normal);
    const Real height = dot(normal, point - pose.position) + tolerance - outline.radius;
    for (const Vec2 vertex : outline.vertices) {
        if (dot(n, vertex) > height) {
            return false;
        }
    }
    return true;
}

} // namespace

void Seams::link(const Bodies& bodies, std::span<const ContactHead> heads,
                 std::span<const std::uint32_t> onGround) {
    first_.assign(bodies.size(), kEnd);
    next_.resize(heads.size());
    onPieces_.clear();
    for (auto i = onGround.rbegin(); i != onGround.rend(); ++i) {
        const ContactHead& head = heads[*i];
        const std::uint32_t body = bodies.locked(head.bodyA) ? head.bodyB : head.bodyA;
        if (first_[body] != kEnd && next_[first_[body]] == kEnd) {
            onPieces_.push_back(body);
        }
        next_[*i] = std::exchange(first_[body], *i);
    }
}

void Seams::hide(const Bodies& bodies, std::span<Contact> contacts, std::span<ContactHead> heads,
                 const Tolerances& tolerances) const {
    for (const std::uint32_t body : onPieces_) {
        for (std::uint32_t i = first_[body]; i != kEnd; i = next_[i]) {
            const Contact& carrier = contacts[i];
            if (carrier.hidden || !carrier.responds() || heads[i].separation[0] > tolerances.slop) {
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
                    liesUnder(bodies.outline(ground.body, ground.part), bodies.pose[ground.body],
                              carrying.normal, point, tolerances.slop)) {
                    other.hidden = true;
                    heads[k].idle = false;
                    heads[k].kept = false;
                }
            }
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
