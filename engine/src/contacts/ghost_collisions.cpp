// SPDX-License-Identifier: MIT
#include "contacts/ghost_collisions.hpp"

#include "collide/rising_face.hpp"
#include "collide/sat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kFlushRise = Real(0.01);     // rise of flush ground, in slops
constexpr Real kSimilarNormals = Real(0.9); // least cosine between which impulses are kept

/// Contact of a movable body with an immovable one, as seen from the movable one.
struct Ground {
    std::uint32_t body; // the immovable one
    std::uint16_t part;
    std::uint32_t movable; // body
    std::uint16_t carried; // part of it
    Manifold manifold;     // with the immovable body as body a
};

Ground groundOf(const Bodies& bodies, const Contact& contact) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    return bodies.locked(bodyA) ? Ground{bodyA, partA, bodyB, partB, contact.manifold}
                                : Ground{bodyB, partB, bodyA, partA, swapped(contact.manifold)};
}

/// A point (m, world) of the surface above which the carrier keeps the body. That of the ground,
/// but far from the carrier a deep overlap leaves the body below: there it is halfway into the
/// overlap.
Vec2 surfaceOf(const Bodies& bodies, const Ground& carrying, const Ground& ground) {
    const Real core = std::min(bodies.convex(ground.body, ground.part).coreRadius,
                               bodies.convex(ground.movable, ground.carried).coreRadius);
    const ManifoldPoint& p = carrying.manifold.points[0]; // halfway between the surfaces
    bool beside = p.separation > 0;
    const auto n = static_cast<std::size_t>(carrying.manifold.count);
    for (std::size_t i = 0; i < n * static_cast<std::size_t>(ground.manifold.count); ++i) {
        const Vec2 way = carrying.manifold.points[i % n].armB - ground.manifold.points[i / n].armB;
        beside = beside || length(way) <= core;
    }
    const Real gap = beside ? p.separation : Real(0);
    return bodies.pose[carrying.body].position + p.armA - gap / 2 * carrying.manifold.normal;
}

/// True if a face of the ground carries: on a corner alone a body may turn.
bool isOfFace(const Bodies& bodies, const Ground& carrying) {
    const Vec2 n = unrotate(bodies.pose[carrying.body].rotation, carrying.manifold.normal);
    const auto& normals = bodies.convex(carrying.body, carrying.part).normals;
    return std::any_of(normals.begin(), normals.end(), [&](Vec2 m) { return isSameWay(m, n); });
}

/// True for two lines of a body, which follow their links instead. Lines of a fine valley rise by
/// less than the tolerance, but must not be hidden.
bool areChain(const Bodies& bodies, const Ground& carrying, const Ground& ground) {
    return carrying.body == ground.body && bodies.convex(carrying.body, carrying.part).isLine() &&
           bodies.convex(ground.body, ground.part).isLine();
}

/// Height (m) of the highest point of a shape above the surface through `point`.
Real riseOf(const ConvexShape& convex, const Transform& pose, Vec2 normal, Vec2 point) {
    const Vec2 n = unrotate(pose.rotation, normal);
    return dot(n, convex.vertices[supportVertex(convex, n, 0)]) + convex.radius -
           dot(normal, point - pose.position);
}

/// Replaces a contact at the vertex where its ground rises from the carrying face; see
/// contactWithRisingFace(). False if it stays.
bool replaceByRisingFace(const HidingStep& step, std::uint32_t slot, const Ground& ground,
                         const CarryingFace& carrying) {
    const Bodies& bodies = step.bodies;
    const auto ahead =
        contactWithRisingFace(bodies.convex(ground.body, ground.part), bodies.pose[ground.body],
                              bodies.convex(ground.movable, ground.carried),
                              bodies.pose[ground.movable], ground.manifold, carrying);
    if (!ahead) {
        return false;
    }
    const ContactLane lane = step.store.lane(slot);
    if (ahead->count == 0 || dot(ahead->normal, ground.manifold.normal) < kSimilarNormals) {
        lane.clearImpulses();
    }
    lane.impulse(1) = 0;
    step.replace(slot, ground.body == step.contact(slot).key.bodyA ? *ahead : swapped(*ahead));
    return true;
}

/// Hides or replaces one contact if it is a ghost beside that of the carrier.
void hideBehind(const HidingStep& step, std::uint32_t carrier, std::uint32_t slot) {
    const Bodies& bodies = step.bodies;
    const Real slop = step.tolerances.slop;
    const Contact& contact = step.contact(slot);
    const Ground carrying = groundOf(bodies, step.contact(carrier));
    const Ground ground = groundOf(bodies, contact);
    const Vec2 normal = carrying.manifold.normal;
    const ConvexShape& piece = bodies.convex(ground.body, ground.part);
    const bool sameWay = contact.manifold.count > 0 && isSameWay(ground.manifold.normal, normal);
    if (sameWay || piece.isPlane() || ground.carried != carrying.carried ||
        !isOfFace(bodies, carrying) || areChain(bodies, carrying, ground)) {
        return;
    }
    const Vec2 point = surfaceOf(bodies, carrying, ground);
    const Real rise = riseOf(piece, bodies.pose[ground.body], normal, point);
    const bool isFlush = rise <= kFlushRise * slop;
    const bool touches = step.store.separation(carrier) <= slop;
    const Vec2 speed = bodies.motion[ground.movable].velocity - bodies.motion[ground.body].velocity;
    const Real way = step.dt * std::abs(cross(normal, speed));
    if (!isFlush && touches && !contact.hidden && step.dt > 0 &&
        replaceByRisingFace(step, slot, ground,
                            {normal, point, slop, step.tolerances.margin, way})) {
        return;
    }
    if (touches ? rise <= slop : isFlush && contact.manifold.count > 0) {
        step.hide(slot, ground.body == contact.key.bodyA ? normal : -normal);
    }
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

void GhostCollisions::hide(const HidingStep& step) const {
    for (const std::uint32_t body : onPieces_) {
        for (std::uint32_t i = first_[body]; i != kEnd; i = next_[i]) {
            for (std::uint32_t k = first_[body]; k != kEnd; k = next_[k]) {
                if (k != i && step.contact(i).near && step.contact(i).responds()) {
                    hideBehind(step, i, k);
                }
            }
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
