// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>
#include <kodo/collision_record.hpp>

#include "base/state_stream.hpp"
#include "bodies/body_checks.hpp"
#include "broad/broad_phase.hpp"
#include "collide/manifold.hpp"

#include <array>
#include <compare>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Two parts of two bodies; bodyA < bodyB.
struct ContactKey {
    std::uint32_t bodyA = 0;
    std::uint16_t partA = 0;
    std::uint32_t bodyB = 0;
    std::uint16_t partB = 0;
    friend constexpr auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// Impulses along the normal at one contact point.
struct PointImpulse {
    Real normal = 0;  // N s, of one substep, >= 0; warm start of the next step
    Real impact = 0;  // N s, in the impact group of this step
    Real largest = 0; // N s, largest of one impulse group of this step
};

/// Solver storage of a contact that persists across steps; see ContactBlocks.
struct ContactRow {
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    static constexpr std::uint8_t kNoColour = 255;

    std::uint32_t index = kNone;     // block * 8 + lane
    std::uint8_t colour = kNoColour; // contacts of one colour never push the same body
    bool fixedA = false;             // body a was immovable when the colour was assigned
    bool fixedB = false;
    bool resident = false; // the state is in the lane, and the Contact is out of date

    void visitState(StateStream& stream);
};

/// State of a contact whose manifold is kept across steps.
struct Carried {
    std::array<Real, 2> separation{}; // m, at the start of the step, of the points in use
    Real approachSpeed = 0;           // m/s, before the solver
    /// m, upper bound of the motion of the bodies against each other since the manifold was found.
    Real relativeDisplacement = 0;
};

/// Two parts whose grown bounds overlap, from then until these bounds separate.
/// A step visits all contacts several times. The fields that every visit needs come first, within
/// 64 bytes (float). While a contact is resident, these visits do not access the fields after
/// centerA.
struct alignas(128) Contact {
    ContactKey key;
    /// Bodies::teleportCount of both bodies, when the manifold was found.
    std::array<std::uint32_t, 2> teleportCounts{};
    Real relativeDisplacement = 0; // m; see Carried
    ContactRow row;
    Real approachSpeed = 0; // m/s, before the solver
    bool near = false;      // the bounds of the parts, grown by the margin, overlap
    bool carried = false;   // the solver stores the contact with this manifold
    bool bounces = false;   // restitution > 0
    bool sensor = false;    // without response
    bool sliding = false;   // with the kinetic coefficient, if that is below the static one
    bool passing = false;   // through a one-sided line from behind; see letPass
    bool hidden = false;    // ghost collision of this step; see GhostCollisions
    bool touching =
        false; // at the last finishStepOfContacts; false once not near; of sensors: in this step
    bool wasTouching = false;        // in the last step; equal to touching between steps
    bool hasStepImpulses = false;    // the impulses that are reset each step are not 0
    std::optional<TouchPhase> phase; // of the last step; empty: no touch

    Manifold manifold;
    Vec2 centerA; // m, world: origin of armA of the manifold

    std::array<PointImpulse, 2> impulse;
    Real friction = 0; // N s, along perp(normal), of both points, of one substep
    Real rolling = 0;  // N m s, of one substep
    Real total = 0;    // N s, normal impulses of all points over the step
    BodyId a;
    BodyId b;
    Material material; // of the pair

    /// True if the solver applies impulses to the bodies.
    bool responds() const { return manifold.count > 0 && !sensor && !hidden; }
    /// True if the lane holds the whole state and stays the same in the next step, without a reset.
    bool isKept() const {
        return row.resident && carried && responds() && !hasStepImpulses &&
               row.colour != ContactRow::kNoColour;
    }
    void visitState(StateStream& stream);
};

/// Small copy of the state of a contact. From it alone, most stages decide to skip the contact.
struct ContactSummary {
    BoundsPair proxies; // indices of the bounds of both parts
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    std::uint32_t row = ContactRow::kNone; // ContactRow::index
    Real approachSpeed = 0;                // m/s, before the solver
    std::array<Real, 2> separation{};      // m, of the points of the manifold
    bool sensor = false;
    bool bounces = false;
    bool idle = false;        // no sensor, not near, and without a record in the last step
    bool meets = false;       // has a manifold, or is a sensor, which may find one on its path
    bool wasTouching = false; // at the last finishStepOfContacts
    bool steady = false;      // the contact does not change if it touches again, or again does not
    bool kept = false;        // see Contact::isKept
    bool gone = false;        // removed; its slot is still in use, see ContactStore::freeDetached

    /// For a contact that is new or may have changed in every field.
    static ContactSummary of(const Contact& contact, BoundsPair proxies) {
        ContactSummary summary{.proxies = proxies,
                               .bodyA = contact.key.bodyA,
                               .bodyB = contact.key.bodyB,
                               .sensor = contact.sensor,
                               .bounces = contact.bounces};
        summary.note(contact);
        return summary;
    }
    /// Must be called after a change of row, manifold, approachSpeed, carried or hidden, except for
    /// sensors.
    void note(const Contact& contact) {
        approachSpeed = contact.approachSpeed;
        separation = separationsOf(contact.manifold);
        meets = contact.manifold.count > 0 || contact.sensor;
        noteRow(contact);
    }
    void noteRow(const Contact& contact) {
        row = contact.row.index;
        kept = contact.isKept();
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
