// SPDX-License-Identifier: MIT
#include "contacts/contact_set.hpp"

#include "contacts/contact_update.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void ContactSet::addEnd(const StoredContact& contact) {
    if (contact.wasTouching) {
        records_.addEnd(contact);
        touchCounts_.count(contact, false);
    }
}

void ContactSet::forgetUnsound(const Bodies& bodies, const Tolerances& tolerances, Real dt) {
    visitAll();
    for (std::uint32_t slot = 0; slot < store_.size(); ++slot) {
        Contact& contact = contacts()[slot];
        if (!isSound(contact, store_.numbers(slot))) {
            store_.leavePasses(slot, bodies);
            const ContactLane lane = store_.lane(slot);
            clearContact(contact, lane);
            followContact(contact, lane, bodies, tolerances, dt, false);
            findContact(contact, lane, bodies, tolerances, dt);
            kodo::measureApproach(contact, lane, bodies);
            manifoldChanged(slot);
        }
    }
}

void ContactSet::updatePairs(Bodies& bodies, const JointLists& joints, const Tolerances& tolerances,
                             Real dt, WorkerTeam& team) {
    records_.begin();
    applyChanges(bodies, tolerances);
    if (store_.countStep() && store_.sort()) {
        changed();
    }
    if (!bodies.leftOut.has(Feature::Collision)) {
        candidates_.bounds().coverPrediction(bodies, tolerances, dt, team);
    } else if (store_.size() > 0) {
        candidates_.bounds().listAll(); // all contacts end
    }
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
        store_.forEachRemoved([&](std::uint32_t slot) { addEnd(store_.copyOf(slot, bodies)); });
        store_.merge(candidates_, bodies, team);
        changed();
    }
    candidates_.bounds().clearChanged();
}

} // namespace KODO_PRECISION
} // namespace kodo
