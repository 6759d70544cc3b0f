// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/body_def.hpp>
#include <kodo/broad/broad_phase.hpp>
#include <kodo/collide/manifold.hpp>
#include <kodo/contacts/collision_record.hpp>

#include <array>
#include <compare>
#include <optional>

namespace kodo::inline KODO_PRECISION {

/// Two parts of two bodies; a before b by body index.
struct ContactKey {
    std::uint32_t bodyA = 0;
    std::uint16_t partA = 0;
    std::uint32_t bodyB = 0;
    std::uint16_t partB = 0;
    friend constexpr auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// What was pushed at one point of a contact. Kept from step to step, as the solver's first guess.
struct PointImpulse {
    Real normal = 0;  // N s, of one substep, >= 0
    Real impact = 0;  // N s, in the impact group of this step
    Real largest = 0; // N s, in one group of this step
};

/// Where the solver keeps a contact from step to step; see ContactBlocks.
struct ContactRow {
    static constexpr std::uint32_t kNone = ~std::uint32_t{};
    static constexpr std::uint8_t kNoColour = 255;

    std::uint32_t index = kNone;     // block * 8 + lane
    std::uint8_t colour = kNoColour; // no other contact of it pushes the same body
    bool fixedA = false;             // a could not be pushed when it got the colour
    bool fixedB = false;
    bool lent = false; // the lane has all that steps change, and the contact is out of date
};

/// How a contact whose manifold is kept goes on from step to step.
struct Carried {
    std::array<Real, 2> separation{}; // m, at the start of the step, of the points that there are
    Real approachSpeed = 0;           // m/s, before the solver
    /// m, that the bodies went against each other since the manifold was found, at most.
    Real drift = 0;
};

/// Two parts that touch or are near each other, from when their grown bounds meet until they part.
/// In each step all are gone through several times, so what every one of these passes needs comes
/// first, within the first 64 bytes (float). What follows the manifold and its place, after 128, is
/// left alone while the contact is lent.
struct alignas(128) Contact {
    ContactKey key;
    std::uint32_t jumpsA = 0; // of the bodies, when the manifold was found
    std::uint32_t jumpsB = 0;
    Real drift = 0; // m; see Carried
    ContactRow row;
    Real approachSpeed = 0;   // m/s, before the solver
    bool near = false;        // the bounds of the parts, grown by the margin, meet
    bool carried = false;     // the solver has it, with this manifold
    bool bounces = false;     // has restitution
    bool sensor = false;      // is only noticed
    bool passing = false;     // through a one-sided line from behind; see letPass
    bool hidden = false;      // in this step, under the surface that carries the body; see Seams
    bool touching = false;    // as summed up last, but not once it is far apart; of sensors, by now
    bool wasTouching = false; // in the last step; equal to touching between steps
    bool struck = false;      // what was pushed in one step only is not 0
    std::optional<TouchPhase> phase; // of the last step; nothing: it did not touch

    Manifold manifold;
    Vec2 centerA; // m, world: where armA of the manifold starts

    std::array<PointImpulse, 2> impulse;
    Real friction = 0; // N s, along perp(normal), of both points, of one substep
    Real rolling = 0;  // N m s, of one substep
    Real total = 0;    // N s, normal, all points, over the step
    BodyId a;
    BodyId b;
    Material material; // of the pair

    /// Do the bodies push each other?
    bool responds() const { return manifold.count > 0 && !sensor && !hidden; }
    /// Has its lane all of it, and the same one in the next step, with nothing to be forgotten?
    bool isKept() const {
        return row.lent && carried && responds() && !struck && row.colour != ContactRow::kNoColour;
    }
};

/// What tells most stages that there is nothing to do for a contact, without a look at it.
struct ContactHead {
    BoundsPair proxies; // places of the bounds of both parts
    std::uint32_t bodyA = 0;
    std::uint32_t bodyB = 0;
    std::uint32_t row = ContactRow::kNone; // the index of its row
    Real approachSpeed = 0;                // m/s, that of the contact
    std::array<Real, 2> separation{};      // m, of the points that the manifold has
    bool sensor = false;
    bool bounces = false;
    bool idle = false;        // far apart, and nothing came of it in the last step
    bool meets = false;       // has a manifold, or is a sensor, which may find one on its way
    bool wasTouching = false; // as summed up last
    bool steady = false;      // the contact stays as it is if it touches, or not, once more
    bool kept = false;        // see Contact::isKept

    /// Of a contact that is new, or of which all may have changed.
    static ContactHead of(const Contact& contact, BoundsPair proxies) {
        ContactHead head{.proxies = proxies,
                         .bodyA = contact.key.bodyA,
                         .bodyB = contact.key.bodyB,
                         .sensor = contact.sensor,
                         .bounces = contact.bounces};
        head.note(contact);
        return head;
    }
    /// To be called when the row, the manifold, the approach, or whether the contact is carried or
    /// hidden has changed, but of sensors.
    void note(const Contact& contact) {
        row = contact.row.index;
        approachSpeed = contact.approachSpeed;
        separation = separationsOf(contact.manifold);
        meets = contact.manifold.count > 0 || contact.sensor;
        kept = contact.isKept();
    }
};

} // namespace kodo::inline KODO_PRECISION
