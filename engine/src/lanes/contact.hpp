// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>
#include <kodo/collision_record.hpp>

#include "base/state_stream.hpp"
#include "bodies/body_checks.hpp"
#include "broad/bounds_pair.hpp"
#include "collide/manifold.hpp"

#include <array>
#include <compare>
#include <optional>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Two parts of two bodies; bodyA < bodyB.
struct ContactKey {
    std::uint32_t bodyA = 0;
    std::uint16_t partA = 0;
    std::uint32_t bodyB = 0;
    std::uint16_t partB = 0;
    std::uint32_t other(std::uint32_t body) const { return body == bodyA ? bodyB : bodyA; }
    friend constexpr auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// Impulses along the normal at one contact point.
struct PointImpulse {
    Real normal = 0;  // N s, of one substep, >= 0; warm start of the next step
    Real impact = 0;  // N s, in the impact group of this step
    Real largest = 0; // N s, largest of one impulse group of this step
};

/// All of a contact that changes from step to step. Its home is the lane of the contact, see
/// ContactBlocks; as a struct it is what leaves the lists of a step: with a sleeping island, a
/// record, a snapshot.
struct ContactNumbers {
    std::array<Real, 2> separation{}; // m, at the start of the step, of the points in use
    Real approachSpeed = 0;           // m/s, before the solver
    /// m, upper bound of the motion of the bodies against each other since the manifold was found.
    Real relativeDisplacement = 0;
    std::array<PointImpulse, 2> impulse{};
    Real friction = 0; // N s, along perp(normal), of both points, of one substep
    Real rolling = 0;  // N m s, of one substep
    /// N s, over the step, of all points: along the normal, and of friction along perp(normal).
    std::array<Real, 2> total{};
    bool sliding = false; // with the kinetic coefficient, if that is below the static one
};

/// Impulse (N s) of the sums along a normal and along perp(normal).
constexpr Vec2 impulseOf(Vec2 sums, Vec2 normal) {
    return sums.x * normal + sums.y * perp(normal);
}

/// The lane of a contact in the passes. Lanes are numbered through all blocks.
struct ContactRow {
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    static constexpr std::uint8_t kNoColour = 255;

    std::uint32_t index = kNone;     // block * 8 + lane; kNone: not in the passes
    std::uint8_t colour = kNoColour; // contacts of one colour never push the same body
    bool fixedA = false;             // body a was immovable when the colour was assigned
    bool fixedB = false;

    void visitState(StateStream& stream);
};

/// Two parts whose grown bounds overlap, from then until these bounds separate. Separations in the
/// manifold are those at the time when it was found.
struct alignas(64) Contact {
    ContactKey key;
    /// Bodies::teleportCount of both bodies, when the manifold was found.
    std::array<std::uint32_t, 2> teleportCounts{};
    bool near = false;     // the bounds of the parts, grown by the margin, overlap
    bool filled = false;   // the lane has the coefficients of this manifold
    bool bounces = false;  // restitution > 0
    bool sensor = false;   // without response
    bool passing = false;  // through a one-sided line from behind; see letPass
    std::int8_t side = 0;  // of a chain: 1 in front of it, -1 behind; 0: unknown; see LineSides
    bool hidden = false;   // ghost collision of this step; see GhostCollisions
    bool touching = false; // at the last finishStepOfContacts; false once not near; of sensors: in
                           // this step
    bool wasTouching = false;        // in the last step; equal to touching between steps
    std::optional<TouchPhase> phase; // of the last step; empty: no touch

    Manifold manifold;
    Vec2 centerA; // m, world: origin of armA of the manifold; see ContactStore::copyOf
    BodyId a;
    BodyId b;
    Material material; // of the pair

    /// True if the solver applies impulses to the bodies.
    bool responds() const { return manifold.count > 0 && !sensor && !hidden; }
    /// True if it may do so once the bodies touch.
    bool mayRespond() const { return !sensor && !hidden && !passing; }
};

/// A contact outside the lists of a step, with its numbers.
struct StoredContact : Contact {
    ContactNumbers numbers;
    ContactRow row;

    void visitState(StateStream& stream);
};

/// Place and state of a contact. From it alone, most stages decide to skip the contact.
struct ContactSummary {
    BoundsPair proxies; // indices of the bounds of both parts
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    ContactRow row;
    bool sensor = false;
    bool bounces = false;
    bool idle = false;        // no sensor, not near, and without a record in the last step
    bool mayTouch = false;    // has a manifold, or is a sensor, which may find one on its path
    bool wasTouching = false; // at the last finishStepOfContacts
    bool settled = false;     // the contact does not change if it touches again, or again does not
    bool kept = false;        // as long as its manifold is valid, the passes need only the lane
    bool gone = false;        // removed; its slot is still in use, see ContactStore::freeDetached

    /// Of a new or changed definition. The rest is state of its own.
    void describe(const Contact& contact, BoundsPair bounds) {
        proxies = bounds;
        bodyA = contact.key.bodyA;
        bodyB = contact.key.bodyB;
        sensor = contact.sensor;
        bounces = contact.bounces;
        mayTouch = contact.manifold.count > 0 || sensor;
    }
    std::uint32_t other(std::uint32_t body) const { return body == bodyA ? bodyB : bodyA; }
    bool inPasses() const { return row.index != ContactRow::kNone; }
};

/// A contact of the list.
struct ContactEntry {
    Contact& contact;
    ContactSummary& summary;
    std::uint32_t slot;
};

/// All contacts of the list, by slot.
struct ContactList {
    std::span<Contact> contacts;
    std::span<ContactSummary> summaries;

    ContactEntry operator[](std::uint32_t slot) const {
        return {contacts[slot], summaries[slot], slot};
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(contacts.size()); }
};

} // namespace KODO_PRECISION
} // namespace kodo
