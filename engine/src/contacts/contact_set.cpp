// SPDX-License-Identifier: MIT
#include "contacts/contact_set.hpp"

#include "contacts/contact_update.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void ContactSet::noteEnd(const Contact& contact) {
    if (contact.wasTouching) {
        records_.noteEnd(contact);
        touchCounts_.count(contact, false);
    }
}

void ContactSet::forgetUnsound(const Bodies& bodies, const Tolerances& tolerances, Real dt) {
    visitAll();
    for (std::size_t slot = 0; slot < store_.size(); ++slot) {
        Contact& contact = contacts()[slot];
        if (!isSound(contact)) {
            clearContact(contact);
            followContact(contact, bodies, tolerances, false);
            findContact(contact, bodies, tolerances, dt);
            kodo::measureApproach(contact, bodies);
            noteManifold(slot);
        }
    }
}

/// Contacts were added, removed or moved to other slots.
void ContactSet::changed() {
    contactsChanged_ = true;
    liveStale_ = true;
}

void ContactSet::updatePairs(Bodies& bodies, const JointLists& joints, const Tolerances& tolerances,
                             Real dt, WorkerTeam& team) {
    records_.begin();
    applyChanges(bodies, tolerances);
    if (store_.countStep() && store_.sort()) {
        changed();
    }
    candidates_.bounds().coverPrediction(bodies, tolerances, dt, team);
    refreshPairs(bodies, joints, team);
}

void ContactSet::coverDisplacements(Bodies& bodies, const JointLists& joints,
                                    const Tolerances& tolerances, WorkerTeam& team) {
    candidates_.bounds().coverDisplacements(bodies, tolerances, team);
    refreshPairs(bodies, joints, team);
}

/// Adds and removes contacts so that the list matches the candidate pairs.
void ContactSet::refreshPairs(Bodies& bodies, const JointLists& joints, WorkerTeam& team) {
    if (!candidates_.search(bodies, joints, team)) {
        return;
    }
    if (store_.findChanges(candidates_, team)) {
        store_.forEachRemoved([&](std::uint32_t slot) {
            Contact& contact = contacts()[slot];
            if (contact.row.resident) {
                contact.centerA = bodies.start[contact.key.bodyA];
            }
            noteEnd(contact);
        });
        store_.merge(candidates_, bodies, team);
        changed();
    }
    candidates_.bounds().clearChanged();
}

} // namespace KODO_PRECISION
} // namespace kodo
