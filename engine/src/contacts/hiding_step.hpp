// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "contacts/contact_store.hpp"
#include "contacts/contact_update.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// What hides contacts of a step reads and writes: GhostCollisions, OneWayBodies.
struct HidingStep {
    const Bodies& bodies;
    ContactStore& store;
    const Tolerances& tolerances;
    Real dt; // s

    const Contact& contact(std::uint32_t slot) const { return store.contacts()[slot]; }
    /// Hides a contact in this step.
    void hide(std::uint32_t slot) const {
        store.change(slot, bodies).hidden = true;
        store.summaries()[slot].idle = false;
    }
    /// Replaces the manifold of a contact.
    void replace(std::uint32_t slot, const Manifold& manifold) const {
        Contact& contact = store.change(slot, bodies);
        const ContactLane lane = store.lane(slot);
        contact.manifold = manifold;
        contact.filled = false;
        lane.setSeparations(manifold);
        measureApproach(contact, lane, bodies);
        store.summaries()[slot].idle = false;
        store.summaries()[slot].mayTouch = manifold.count > 0;
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
