// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "contacts/contact_store.hpp"
#include "contacts/contact_update.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// What hides contacts of a step reads and writes: GhostCollisions, OneWayBodies.
struct HidingStep {
    const Bodies& bodies;
    ContactStore& store;
    const Tolerances& tolerances;
    Real dt;         // s; 0: manifolds ahead of the poses
    bool& liveStale; // set where a contact ceases to be idle

    const Contact& contact(std::uint32_t slot) const { return store.contacts()[slot]; }
    /// Hides a contact in this step. `normal`: of the surface above the ground of the contact, as
    /// in its manifold; zero if there is none.
    void hide(std::uint32_t slot, Vec2 normal) const {
        replace(slot, {.normal = normal, .points = {}});
        store.contacts()[slot].hidden = true;
        store.lane(slot).clearImpulses();
    }
    /// Replaces the manifold of a contact.
    void replace(std::uint32_t slot, const Manifold& manifold) const {
        Contact& contact = store.change(slot, bodies);
        const ContactLane lane = store.lane(slot);
        contact.manifold = manifold;
        contact.centerA = bodies.pose[contact.key.bodyA].position;
        contact.filled = false;
        lane.setSeparations(manifold);
        measureApproach(contact, lane, bodies);
        liveStale = std::exchange(store.summaries()[slot].idle, false) || liveStale;
        store.summaries()[slot].mayTouch = manifold.count > 0;
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
