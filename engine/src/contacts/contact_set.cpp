// SPDX-License-Identifier: MIT
#include "contacts/contact_set.hpp"

#include "base/vector_reuse.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kNewPerPiece = 32; // contacts

} // namespace

void ContactSet::noteEnd(const Contact& contact) {
    if (contact.wasTouching) {
        records_.nextEnds.push_back(endOf(contact));
        countTouch(contact, false);
    }
}

/// Counts the touching contacts of both bodies one up or down.
void ContactSet::countTouch(const Contact& contact, bool touches) {
    for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
        touches_[body] += touches ? 1u : kOneLess;
        touchChanges_.push_back(body);
    }
    const std::size_t many = 4 * touches_.size();
    if (touchChanges_.size() > many) { // for example, a region that moves often between two steps
        // total order: equal indices are identical
        std::sort(touchChanges_.begin(), touchChanges_.end());
        touchChanges_.erase(std::unique(touchChanges_.begin(), touchChanges_.end()),
                            touchChanges_.end());
    }
}

/// Counts all touching contacts after a snapshot was read. A body whose kColliding disagrees is a
/// touch change.
void ContactSet::countTouches(const Bodies& bodies) {
    touches_.assign(bodies.size(), 0);
    for (const Contact& contact : contacts_) {
        if (contact.wasTouching) {
            ++touches_[contact.key.bodyA];
            ++touches_[contact.key.bodyB];
        }
    }
    touchChanges_.clear();
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        if (((bodies.filter[body].flags & kColliding) != 0) != isTouched(body)) {
            touchChanges_.push_back(body);
        }
    }
}

void ContactSet::forgetUnsound(const Bodies& bodies, const Tolerances& tolerances) {
    visitAll();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        if (!isSound(contact)) {
            clearContact(contact);
            followContact(contact, bodies, tolerances, false);
            findContact(contact, bodies, tolerances);
            kodo::measureApproach(contact, bodies);
            noteManifold(i);
        }
    }
}

/// Contacts were added, removed or moved to other slots.
void ContactSet::changed() {
    contactsChanged_ = true;
    liveStale_ = true;
}

/// Moves the last contacts into the free slots.
void ContactSet::fillHoles() {
    changed();
    if (holes_.empty()) {
        return;
    }
    const std::size_t kept = contacts_.size() - holes_.size();
    std::sort(holes_.begin(), holes_.end()); // total order: slots are unique
    // The contacts in slots beyond the new end move down, the lowest first.
    std::vector<std::uint32_t>& movedTo = slots_;
    assignReusing(movedTo, holes_.size(), 0u);
    std::size_t hole = 0;
    std::size_t beyond = static_cast<std::size_t>(
        std::lower_bound(holes_.begin(), holes_.end(), kept) - holes_.begin());
    for (std::size_t slot = kept; slot < contacts_.size(); ++slot) {
        if (beyond < holes_.size() && holes_[beyond] == slot) {
            ++beyond;
            continue;
        }
        movedTo[slot - kept] = holes_[hole];
        const ContactSummary& moved = summaries_[slot];
        if (lists_.isValid()) {
            lists_.move(static_cast<std::uint32_t>(slot), holes_[hole], moved.bodyA, moved.bodyB);
        }
        summaries_[holes_[hole]] = moved;
        contacts_[holes_[hole++]] = contacts_[slot];
    }
    reorderPolicy_.strayed += hole;
    std::erase_if(records_.toggled, [&](std::uint32_t slot) {
        return std::binary_search(holes_.begin(), holes_.end(), slot);
    });
    for (std::uint32_t& slot : records_.toggled) {
        slot = slot < kept ? slot : movedTo[slot - kept];
    }
    for (Place& place : order_) {
        if (place.slot >= kept) {
            place.slot = movedTo[place.slot - kept];
        }
    }
    contacts_.resize(kept);
    summaries_.resize(kept);
}

void ContactSet::sortByKey(std::span<std::uint32_t> slots) const {
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return summaries_[a].proxies < summaries_[b].proxies;
    };
    if (!std::is_sorted(slots.begin(), slots.end(), before)) {
        std::sort(slots.begin(), slots.end(), before); // total order: pairs are unique
    }
}

/// Reorders the contacts by key, so that a loop over them reads bodies in sequence. Follows each
/// cycle of the permutation with one contact as temporary.
void ContactSet::sortContacts() {
    reorderPolicy_ = {};
    for (std::uint32_t start = 0; start < order_.size(); ++start) {
        if (order_[start].slot == start) {
            continue;
        }
        changed();
        lists_.forget();
        const Contact contact = contacts_[start];
        const ContactSummary summary = summaries_[start];
        std::uint32_t to = start;
        for (std::uint32_t from = order_[to].slot; from != start; from = order_[to].slot) {
            contacts_[to] = contacts_[from];
            summaries_[to] = summaries_[from];
            order_[to].slot = to;
            to = from;
        }
        contacts_[to] = contact;
        summaries_[to] = summary;
        order_[to].slot = to;
    }
}

void ContactSet::updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                             WorkerTeam& team) {
    records_.begin();
    applyChanges(bodies, tolerances);
    if (reorderPolicy_.countStep(contacts_.size())) {
        sortContacts();
    }
    bounds_.coverPrediction(bodies, tolerances, dt, team);
    refreshPairs(bodies, team);
}

void ContactSet::coverDisplacements(const Bodies& bodies, const Tolerances& tolerances,
                                    WorkerTeam& team) {
    bounds_.coverDisplacements(bodies, tolerances, team);
    refreshPairs(bodies, team);
}

/// Searches the pairs of parts whose grown bounds have changed.
void ContactSet::refreshPairs(const Bodies& bodies, WorkerTeam& team) {
    if (bounds_.changed().empty()) {
        if (bodies.awake.size() < still_.awakeCount() / 2) {
            still_.update(bodies,
                          bounds_); // in the step after they fell asleep, not at the next hit
        }
        return;
    }
    findPairs(bodies, team);
    if (!pairs_.empty() || !order_.empty()) {
        mergePairs(bodies, team);
    }
    bounds_.clearChanged();
}

void ContactSet::setExcludedPairs(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
    if (!std::equal(excludedPairs_.begin(), excludedPairs_.end(), pairs.begin(), pairs.end())) {
        excludedPairs_.assign(pairs.begin(), pairs.end());
        pairsStale_ = true;
    }
}

void ContactSet::findPairs(const Bodies& bodies, WorkerTeam& team) {
    const auto accept = [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = bounds_.part(i).body;
        const std::uint32_t b = bounds_.part(j).body;
        const Flags flagsA = bodies.filter[a].flags;
        const Flags flagsB = bodies.filter[b].flags;
        const bool sensor = ((flagsA ^ flagsB) & kSensor) != 0; // exactly one of them
        // An inactive body that arrives may touch a sleeping one: see SleepSystem::wakeTouched.
        const auto arrives = [&] {
            return ((flagsA | flagsB) & (kAsleep | kOutside)) == kAsleep &&
                   (bodies.hasArrived[a] | bodies.hasArrived[b]) != 0;
        };
        return a != b && (sensor || !(bodies.locked(a) && bodies.locked(b))) &&
               (sensor || ((flagsA & flagsB) & kSensor) == 0) &&
               (bodies.active(a) || bodies.active(b) || arrives()) &&
               shouldCollide(bodies.filter[a], bodies.filter[b]) &&
               !std::binary_search(excludedPairs_.begin(), excludedPairs_.end(), std::pair(a, b));
    };
    pairs_.clear();
    if (still_.update(bodies, bounds_) || bounds_.hasUnused()) {
        findPairsOfMovers(bodies, accept, team);
        return;
    }
    if (movers_.forget()) {
        finder_.forget();
    }
    finder_.pairs(bounds_.grown(), {bounds_.changed(), bounds_.isChanged()}, accept, pairs_, team);
}

/// The same for listed parts alone, and for those of inactive bodies in a tree if there is one.
template <typename Accept>
void ContactSet::findPairsOfMovers(const Bodies& bodies, Accept accept, WorkerTeam& team) {
    MovingParts& movers = movers_;
    still_.listOthers(bodies, bounds_, movers.parts);
    if (movers.gather(bounds_)) {
        finder_.forget();
    }
    const auto acceptMovers = [&](std::uint32_t k, std::uint32_t other) {
        return accept(movers.parts[k], movers.parts[other]);
    };
    finder_.pairs(movers.bounds, {movers.changed, movers.isChanged}, acceptMovers, pairs_, team);
    for (BoundsPair& pair : pairs_) {
        pair = {movers.parts[pair.first], movers.parts[pair.second]};
    }
    if (!still_.hasTree()) {
        return; // all parts were compared
    }
    const std::size_t among = pairs_.size();
    for (const std::uint32_t k : movers.changed) {
        const std::uint32_t i = movers.parts[k];
        const Octagon& own = movers.bounds[k];
        const Aabb box = own.box();
        still_.tree().search(
            [&](const Aabb& other) { return overlap(box, other) ? 0 : BoundsTree::kMissed; },
            [&](std::uint32_t body, std::uint32_t part) {
                const std::uint32_t j = bounds_.indexOf(body, static_cast<std::uint16_t>(part));
                if (overlap(own, bounds_.grown()[j]) &&
                    !std::binary_search(movers.parts.begin(), movers.parts.end(), j)) {
                    addPair(i, j, accept, pairs_);
                }
            });
    }
    if (pairs_.size() > among) {
        std::sort(pairs_.begin(), pairs_.end()); // total order: pairs are distinct
    }
}

/// Merges pairs_ with order_: both are in the order of keys. A pair can only be added or removed if
/// the bounds of one of its parts have changed.
void ContactSet::findPairChanges(WorkerTeam& team) {
    pairChanges_.clear();
    changesFound_.gather(
        team, order_.size(), kContactsPerPiece, pairChanges_,
        [&](std::size_t first, std::size_t last, std::vector<PairChange>& change) {
            const std::uint8_t* const isChanged = bounds_.isChanged().data();
            const Place* const order = order_.data();
            const auto from = [&](std::size_t at) {
                return std::lower_bound(pairs_.begin(), pairs_.end(), order_[at].pair);
            };
            auto pair = first == 0 ? pairs_.begin() : from(first);
            const auto end = last == order_.size() ? pairs_.end() : from(last);
            for (std::size_t at = first; at < last; ++at) {
                const BoundsPair own = order[at].pair;
                for (; pair != end && *pair < own; ++pair) {
                    change.push_back({*pair, static_cast<std::uint32_t>(at), true});
                }
                const bool found = pair != end && *pair == own;
                const bool affected = (isChanged[own.first] | isChanged[own.second]) != 0;
                pair += found ? 1 : 0;
                if (affected & !found) { // rare; branchless `&`, since `affected` alone mispredicts
                    change.push_back({own, static_cast<std::uint32_t>(at), false});
                }
            }
            for (; pair != end; ++pair) {
                change.push_back({*pair, static_cast<std::uint32_t>(last), true});
            }
        });
}

/// Adds and removes contacts so that the list matches pairs_.
void ContactSet::mergePairs(const Bodies& bodies, WorkerTeam& team) {
    findPairChanges(team);
    if (pairChanges_.empty()) {
        return;
    }
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
    for (const PairChange& change : pairChanges_) {
        keepUpTo(change.at);
        if (change.isNew) {
            added_.push_back(static_cast<std::uint32_t>(newOrder_.size()));
            newOrder_.push_back({change.pair, 0});
        } else {
            holes_.push_back(order_[next++].slot);
            release(holes_.back(), bodies);
        }
    }
    keepUpTo(order_.size());
    std::swap(order_, newOrder_);
    addContacts(bodies, team);
    fillHoles();
}

/// Must be called before the removal of a contact whose grown bounds have separated.
void ContactSet::release(std::uint32_t slot, const Bodies& bodies) {
    Contact& gone = contacts_[slot];
    if (lists_.isValid()) {
        lists_.remove(slot, gone.key.bodyA, gone.key.bodyB);
    }
    if (gone.row.resident) {
        gone.centerA = bodies.start[gone.key.bodyA];
    }
    noteEnd(gone);
}

/// Creates the contacts of new pairs, in the last free slots first.
void ContactSet::addContacts(const Bodies& bodies, WorkerTeam& team) {
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
    team.forEach(added_.size(), kNewPerPiece, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t at : std::span(added_).subspan(first, last - first)) {
            const auto& [pair, slot] = order_[at];
            const PartBounds::Part& a = bounds_.part(pair.first);
            const PartBounds::Part& b = bounds_.part(pair.second);
            contacts_[slot].key = {a.body, a.part, b.body, b.part};
            describeContact(contacts_[slot], bodies);
            summaries_[slot] = ContactSummary::of(contacts_[slot], pair);
        }
    });
    if (lists_.isValid()) {
        for (const std::uint32_t at : added_) {
            const ContactSummary& summary = summaries_[order_[at].slot];
            lists_.add(order_[at].slot, summary.bodyA, summary.bodyB);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
