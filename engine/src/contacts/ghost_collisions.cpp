// SPDX-License-Identifier: MIT
#include "contacts/ghost_collisions.hpp"

#include "collide/rising_face.hpp"
#include "contacts/contact_update.hpp"

#include <optional>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kFlushRise = Real(0.01);     // rise of flush ground, in slops
constexpr Real kSimilarNormals = Real(0.9); // least cosine between which impulses are kept

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

/// True for two lines of a body, which follow their links instead. Lines of a fine valley rise by
/// less than the tolerance, but must not be hidden.
bool areChain(const Bodies& bodies, const Ground& carrying, const Ground& ground) {
    return carrying.body == ground.body && bodies.convex(carrying.body, carrying.part).isLine() &&
           bodies.convex(ground.body, ground.part).isLine();
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

/// Replaces a contact at the vertex where its ground rises from the carrying face; see
/// contactWithRisingFace(). False if it stays.
bool replaceByRisingFace(const HidingStep& step, std::uint32_t slot, const CarryingFace& carrying) {
    const Bodies& bodies = step.bodies;
    const Contact& contact = step.contact(slot);
    const ContactKey& key = contact.key;
    const ConvexShape& a = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& b = bodies.convex(key.bodyB, key.partB);
    const Transform& poseA = bodies.pose[key.bodyA];
    const Transform& poseB = bodies.pose[key.bodyB];
    const bool groundIsA = bodies.locked(key.bodyA);
    std::optional<Manifold> ahead =
        groundIsA ? contactWithRisingFace(a, poseA, b, poseB, contact.manifold, carrying)
                  : contactWithRisingFace(b, poseB, a, poseA, swapped(contact.manifold), carrying);
    if (!ahead) {
        return false;
    }
    if (!groundIsA) {
        ahead = swapped(*ahead);
    }
    const ContactLane lane = step.store.lane(slot);
    if (ahead->count == 0 || dot(ahead->normal, contact.manifold.normal) < kSimilarNormals) {
        lane.clearImpulses();
    }
    lane.impulse(1) = 0;
    step.replace(slot, *ahead);
    return true;
}

} // namespace

void GhostCollisions::link(const Bodies& bodies, std::span<const ContactSummary> summaries,
                           std::span<const std::uint32_t> onGround) {
    for (const std::uint32_t body : linked_) {
        first_[body] = kEnd;
    }
    linked_.clear();
    next_.resize(summaries.size());
    onPieces_.clear();
    onPieces_.reserve(bodies.record.capacity());
    linked_.reserve(bodies.record.capacity());
    for (auto i = onGround.rbegin(); i != onGround.rend(); ++i) {
        const ContactSummary& summary = summaries[*i];
        const std::uint32_t body = bodies.locked(summary.bodyA) ? summary.bodyB : summary.bodyA;
        if (first_[body] == kEnd) {
            linked_.push_back(body);
        } else if (next_[first_[body]] == kEnd) {
            onPieces_.push_back(body);
        }
        next_[*i] = std::exchange(first_[body], *i);
    }
}

/// Hides or replaces one contact if it is a ghost beside that of the carrier.
void GhostCollisions::hideBehind(const HidingStep& step, std::uint32_t carrier,
                                 std::uint32_t slot) {
    const Bodies& bodies = step.bodies;
    const Tolerances& tolerances = step.tolerances;
    const Ground carrying = groundOf(bodies, step.contact(carrier));
    const Vec2 point = bodies.pose[carrying.body].position + carrying.arm;
    const Contact& contact = step.contact(slot);
    const Ground ground = groundOf(bodies, contact);
    const bool sameWay = contact.manifold.count > 0 && isSameWay(ground.normal, carrying.normal);
    if (sameWay || ground.carried != carrying.carried || areChain(bodies, carrying, ground)) {
        return;
    }
    const ConvexShape& convex = bodies.convex(ground.body, ground.part);
    const Transform& pose = bodies.pose[ground.body];
    const auto isUnder = [&](Real tolerance) {
        return liesUnder(convex, pose, carrying.normal, point, tolerance);
    };
    const bool isFlush = isUnder(kFlushRise * tolerances.slop);
    if (!isFlush && !contact.hidden &&
        replaceByRisingFace(step, slot,
                            {carrying.normal, point, tolerances.slop, tolerances.margin})) {
        return;
    }
    if (isFlush || isUnder(tolerances.slop)) {
        step.hide(slot, bodies.locked(contact.key.bodyA) ? carrying.normal : -carrying.normal);
    }
}

void GhostCollisions::hide(const HidingStep& step) const {
    for (const std::uint32_t body : onPieces_) {
        for (std::uint32_t i = first_[body]; i != kEnd; i = next_[i]) {
            for (std::uint32_t k = first_[body]; k != kEnd; k = next_[k]) {
                const Contact& carrier = step.contact(i);
                if (k != i && !carrier.hidden && carrier.responds() &&
                    step.store.separation(i) <= step.tolerances.slop) {
                    hideBehind(step, i, k);
                }
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
