// SPDX-License-Identifier: MIT
#include "world/parked_contacts.hpp"

#include "contacts/contact_update.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void ParkedContacts::add(const StoredContact& contact) {
    lists_.add(static_cast<std::uint32_t>(contacts_.size()), contact.key.bodyA, contact.key.bodyB);
    contacts_.push_back(contact);
}

/// Takes the contacts in slots_, which may contain duplicates.
void ParkedContacts::takeNoted(std::vector<StoredContact>& taken) {
    sortUnique(slots_);
    for (const std::uint32_t slot : slots_) {
        StoredContact& contact = contacts_[slot];
        taken.push_back(contact);
        lists_.remove(slot, contact.key.bodyA, contact.key.bodyB);
        contact = {};
        ++gaps_;
    }
    if (gaps_ > contacts_.size() / 2) { // at most two visits for each removal
        closeGaps();
    }
}

void ParkedContacts::closeGaps() {
    std::uint32_t to = 0;
    for (std::uint32_t from = 0; from < contacts_.size(); ++from) {
        const StoredContact& contact = contacts_[from];
        if (isGap(contact)) {
            continue;
        }
        if (to != from) {
            lists_.move(from, to, contact.key.bodyA, contact.key.bodyB);
            contacts_[to] = contact;
        }
        ++to;
    }
    contacts_.resize(to);
    gaps_ = 0;
}

/// After contacts_ was replaced, without gaps.
void ParkedContacts::listAll() {
    gaps_ = 0;
    lists_.clear(contacts_.size());
    for (std::uint32_t slot = 0; slot < contacts_.size(); ++slot) {
        lists_.add(slot, contacts_[slot].key.bodyA, contacts_[slot].key.bodyB);
    }
}

void ParkedContacts::visitState(StateStream& stream, const Bodies& bodies) {
    auto& [contacts, gaps, lists, slots, visits] = *this;
    if (!stream.reads() && gaps > 0) { // the bytes hold no gaps
        std::vector<StoredContact> all;
        forEach([&](const StoredContact& contact) { all.push_back(contact); });
        stream(all);
        return;
    }
    stream(contacts);
    if (stream.reads()) {
        for (StoredContact& contact : contacts) {
            completeContact(contact, bodies);
            contact.row = {};
        }
        listAll();
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
