// SPDX-License-Identifier: MIT
#include "contacts/contact_store.hpp"

#include "base/vector_reuse.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kNewPerPiece = 32; // contacts

/// True if two movable parts overlap, so that the middle of one lies in the core of the other.
bool isDeep(const Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    if (contact.sensor || bodies.locked(bodyA) || bodies.locked(bodyB)) {
        return false;
    }
    const ConvexShape& a = bodies.convex(bodyA, partA);
    const ConvexShape& b = bodies.convex(bodyB, partB);
    const Vec2 between = bodies.pose[bodyB] * b.middle - bodies.pose[bodyA] * a.middle;
    const Real core = std::max(a.coreRadius, b.coreRadius);
    return lengthSquared(between) < core * core;
}

} // namespace

void ContactStore::sortByKey(std::span<std::uint32_t> slots) const {
    // Indices of bounds are in the order of parts within one body alone.
    const auto before = [&](std::uint32_t slotA, std::uint32_t slotB) {
        const ContactSummary& a = summaries_[slotA];
        const ContactSummary& b = summaries_[slotB];
        if (a.bodyA != b.bodyA) {
            return a.bodyA < b.bodyA;
        }
        if (a.proxies.first != b.proxies.first) {
            return a.proxies.first < b.proxies.first;
        }
        return a.bodyB != b.bodyB ? a.bodyB < b.bodyB : a.proxies.second < b.proxies.second;
    };
    if (!std::is_sorted(slots.begin(), slots.end(), before)) {
        std::sort(slots.begin(), slots.end(), before); // total order: pairs are unique
    }
}

/// After many contacts have moved, none of which is detached.
void ContactStore::listAll() {
    lists_.clear(contacts_.size());
    for (const Place& place : order_) {
        lists_.add(place.slot, summaries_[place.slot].bodyA, summaries_[place.slot].bodyB);
    }
}

void ContactStore::detach(std::uint32_t slot) {
    ContactSummary& summary = summaries_[slot];
    lists_.remove(slot, summary.bodyA, summary.bodyB);
    summary.gone = true;
    contacts_[slot].phase.reset(); // no record
    gone_.push_back(slot);
}

bool ContactStore::freeDetached() {
    if (gone_.empty()) {
        return false;
    }
    std::erase_if(order_, [&](const Place& place) { return summaries_[place.slot].gone; });
    holes_.clear();
    std::swap(holes_, gone_);
    fillHoles();
    return true;
}

/// Moves the last contacts into the free slots.
void ContactStore::fillHoles() {
    if (holes_.empty()) {
        return;
    }
    const std::size_t kept = contacts_.size() - holes_.size();
    std::sort(holes_.begin(), holes_.end()); // total order: slots are unique
    // The contacts in slots beyond the new end move down, the lowest first.
    assignReusing(movedTo_, holes_.size(), 0u);
    std::size_t hole = 0;
    std::size_t beyond = static_cast<std::size_t>(
        std::lower_bound(holes_.begin(), holes_.end(), kept) - holes_.begin());
    for (std::size_t slot = kept; slot < contacts_.size(); ++slot) {
        if (beyond < holes_.size() && holes_[beyond] == slot) {
            ++beyond;
            continue;
        }
        movedTo_[slot - kept] = holes_[hole];
        const ContactSummary& moved = summaries_[slot];
        lists_.move(static_cast<std::uint32_t>(slot), holes_[hole], moved.bodyA, moved.bodyB);
        moveContact(static_cast<std::uint32_t>(slot), holes_[hole++]);
    }
    reorderPolicy_.strayed += hole;
    for (Place& place : order_) {
        if (place.slot >= kept) {
            place.slot = movedTo_[place.slot - kept];
        }
    }
    contacts_.resize(kept);
    summaries_.resize(kept);
    lanes_.resize(kept);
}

void ContactStore::renumber(std::vector<std::uint32_t>& slots) const {
    std::erase_if(slots, [&](std::uint32_t slot) {
        return std::binary_search(holes_.begin(), holes_.end(), slot);
    });
    for (std::uint32_t& slot : slots) {
        slot = slot < contacts_.size() ? slot : movedTo_[slot - contacts_.size()];
    }
}

/// Compares the pairs with order_: both are in the order of keys. A pair can only be added or
/// removed if the bounds of one of its parts have changed.
bool ContactStore::findChanges(const CandidatePairs& candidates, WorkerTeam& team) {
    changes_.clear();
    const auto isBefore = [&](BoundsPair a, BoundsPair b) {
        return candidates.bounds().isBefore(a, b);
    };
    const std::span<const BoundsPair> pairs = candidates.pairs();
    const std::uint8_t* const isChanged = candidates.bounds().isChanged().data();
    changesFound_.gather(
        team, order_.size(), kContactsPerPiece, changes_,
        [&](std::size_t first, std::size_t last, std::vector<Change>& found) {
            const Place* const order = order_.data();
            const auto from = [&](std::size_t at) {
                return std::lower_bound(pairs.begin(), pairs.end(), order_[at].pair, isBefore);
            };
            auto pair = first == 0 ? pairs.begin() : from(first);
            const auto end = last == order_.size() ? pairs.end() : from(last);
            for (std::size_t at = first; at < last; ++at) {
                const BoundsPair own = order[at].pair;
                for (; pair != end && isBefore(*pair, own); ++pair) {
                    found.push_back({*pair, static_cast<std::uint32_t>(at), true});
                }
                const bool stays = pair != end && *pair == own;
                const bool affected = (isChanged[own.first] | isChanged[own.second]) != 0;
                pair += stays ? 1 : 0;
                if (affected & !stays) { // rare; branchless `&`, since `affected` alone mispredicts
                    found.push_back({own, static_cast<std::uint32_t>(at), false});
                }
            }
            for (; pair != end; ++pair) {
                found.push_back({*pair, static_cast<std::uint32_t>(last), true});
            }
        });
    return !changes_.empty();
}

void ContactStore::merge(const CandidatePairs& candidates, Bodies& bodies, WorkerTeam& team) {
    newOrder_.clear();
    newOrder_.reserve(order_.capacity()); // the two vectors alternate
    holes_.clear();
    added_.clear();
    std::size_t next = 0;
    const auto keepUpTo = [&](std::size_t end) {
        newOrder_.insert(newOrder_.end(), order_.begin() + static_cast<std::ptrdiff_t>(next),
                         order_.begin() + static_cast<std::ptrdiff_t>(end));
        next = end;
    };
    for (const Change& change : changes_) {
        keepUpTo(change.at);
        if (change.isNew) {
            added_.push_back(static_cast<std::uint32_t>(newOrder_.size()));
            newOrder_.push_back({change.pair, 0});
            continue;
        }
        holes_.push_back(order_[next++].slot);
        const ContactSummary& removed = summaries_[holes_.back()];
        lists_.remove(holes_.back(), removed.bodyA, removed.bodyB);
    }
    keepUpTo(order_.size());
    std::swap(order_, newOrder_);
    addContacts(candidates, bodies, team);
    fillHoles();
}

/// Creates the contacts of new pairs, in the last free slots first.
void ContactStore::addContacts(const CandidatePairs& candidates, Bodies& bodies, WorkerTeam& team) {
    reorderPolicy_.strayed += added_.size();
    auto slots = static_cast<std::uint32_t>(contacts_.size());
    for (const std::uint32_t at : added_) {
        if (holes_.empty()) {
            order_[at].slot = slots++;
        } else {
            order_[at].slot = holes_.back();
            contacts_[holes_.back()] = {};
            holes_.pop_back();
        }
    }
    contacts_.resize(slots);
    summaries_.resize(slots);
    lanes_.resize(slots);
    const PartBounds& bounds = candidates.bounds();
    addedIsDeep_.reserve(added_.capacity());
    addedIsDeep_.resize(added_.size());
    team.forEach(added_.size(), kNewPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto& [pair, slot] = order_[added_[i]];
            const PartBounds::Part& a = bounds.part(pair.first);
            const PartBounds::Part& b = bounds.part(pair.second);
            contacts_[slot].key = {a.body, a.part, b.body, b.part};
            describeContact(contacts_[slot], bodies);
            summaries_[slot] = {};
            summaries_[slot].describe(contacts_[slot], pair);
            lanes_.waiting(slot) = ContactNumbers{};
            addedIsDeep_[i] = isDeep(contacts_[slot], bodies) ? 1 : 0;
        }
    });
    for (std::size_t i = 0; i < added_.size(); ++i) { // in the order of keys
        if (addedIsDeep_[i] != 0) {
            const ContactSummary& pair = summaries_[order_[added_[i]].slot];
            std::uint32_t& rank = bodies.record[pair.bodyB].crowdRank;
            rank = std::max(rank, bodies.record[pair.bodyA].crowdRank + 1);
        }
    }
    for (const std::uint32_t at : added_) {
        const ContactSummary& summary = summaries_[order_[at].slot];
        lists_.add(order_[at].slot, summary.bodyA, summary.bodyB);
    }
}

std::span<const std::uint32_t> ContactStore::putBack(std::span<const StoredContact> contacts,
                                                     const PartBounds& bounds) {
    const auto keyOf = [&](const Place& place) { return contacts_[place.slot].key; };
    slots_.resize(contacts.size());
    std::iota(slots_.begin(), slots_.end(), 0u);
    std::sort(slots_.begin(), slots_.end(), [&](std::uint32_t i, std::uint32_t k) { // total order
        return contacts[i].key != contacts[k].key ? contacts[i].key < contacts[k].key : i < k;
    });
    changes_.clear();
    auto place = order_.begin();
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const StoredContact& contact = contacts[slots_[i]];
        if (i > 0 && contacts[slots_[i - 1]].key == contact.key) {
            continue;
        }
        place = std::lower_bound(
            place, order_.end(), contact.key,
            [&](const Place& at, const ContactKey& key) { return keyOf(at) < key; });
        if (place == order_.end() || keyOf(*place) != contact.key) {
            changes_.push_back({{append(contact, bounds), 0},
                                static_cast<std::uint32_t>(place - order_.begin()),
                                true});
        }
    }
    insertAppended();
    slots_.clear();
    for (const Change& change : changes_) {
        slots_.push_back(change.pair.first);
    }
    return slots_;
}

/// Puts a contact into a new slot, without a place in order_.
std::uint32_t ContactStore::append(const StoredContact& contact, const PartBounds& bounds) {
    const auto slot = static_cast<std::uint32_t>(contacts_.size());
    contacts_.push_back(contact);
    summaries_.emplace_back();
    summaries_.back().wasTouching = contact.wasTouching;
    lanes_.resize(contacts_.size());
    lanes_.waiting(slot) = contact.numbers;
    renewSummary(slot, bounds);
    lists_.add(slot, contact.key.bodyA, contact.key.bodyB);
    ++reorderPolicy_.strayed;
    return slot;
}

/// Inserts the places of appended contacts; the first number of each pair in changes_ is its slot.
void ContactStore::insertAppended() {
    if (changes_.empty()) {
        return;
    }
    newOrder_.clear();
    newOrder_.reserve(std::max(order_.capacity(), order_.size() + changes_.size()));
    auto next = order_.begin();
    for (const Change& change : changes_) {
        const auto at = order_.begin() + static_cast<std::ptrdiff_t>(change.at);
        newOrder_.insert(newOrder_.end(), next, at);
        newOrder_.push_back({summaries_[change.pair.first].proxies, change.pair.first});
        next = at;
    }
    newOrder_.insert(newOrder_.end(), next, order_.end());
    std::swap(order_, newOrder_);
}

void ContactStore::order(const PartBounds& bounds) {
    order_.resize(contacts_.size());
    for (std::uint32_t slot = 0; slot < order_.size(); ++slot) {
        order_[slot].slot = slot;
    }
    std::sort(order_.begin(), order_.end(), // total order: keys are unique
              [&](const Place& a, const Place& b) {
                  return contacts_[a.slot].key < contacts_[b.slot].key;
              });
    renewPlaces(bounds);
    listAll();
}

void ContactStore::describe(const Bodies& bodies, const PartBounds& bounds) {
    for (Contact& contact : contacts_) {
        describeContact(contact, bodies);
    }
    renewPlaces(bounds);
}

void ContactStore::describe(std::uint32_t body, const Bodies& bodies, const PartBounds& bounds) {
    lists().forEach(body, [&](std::uint32_t slot) {
        Contact& contact = contacts_[slot];
        contact.centerA = summaries_[slot].kept ? bodies.start[contact.key.bodyA] : contact.centerA;
        describeContact(contact, bodies);
        renewSummary(slot, bounds);
    });
}

void ContactStore::renewPlaces(const PartBounds& bounds) {
    summaries_.resize(contacts_.size());
    for (Place& place : order_) {
        renewSummary(place.slot, bounds);
        place.pair = summaries_[place.slot].proxies;
    }
}

void ContactStore::renewSummary(std::uint32_t slot, const PartBounds& bounds) {
    const auto& [bodyA, partA, bodyB, partB] = contacts_[slot].key;
    ContactSummary& summary = summaries_[slot];
    summary.describe(contacts_[slot], {bounds.indexOf(bodyA, partA), bounds.indexOf(bodyB, partB)});
    summary.idle = summary.settled = false;
    summary.kept = summary.kept && contacts_[slot].responds();
}

void ContactStore::renumberBounds(const PartBounds& bounds) {
    for (Place& place : order_) {
        ContactSummary& summary = summaries_[place.slot];
        summary.proxies = {bounds.indexNow(summary.proxies.first, summary.bodyA),
                           bounds.indexNow(summary.proxies.second, summary.bodyB)};
        place.pair = summary.proxies;
    }
}

void ContactStore::refreshPlaces() {
    if (std::exchange(placesStale_, false)) {
        for (Place& place : order_) {
            place.pair = summaries_[place.slot].proxies;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
