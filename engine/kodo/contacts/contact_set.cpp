// SPDX-License-Identifier: MIT
#include <kodo/base/refill.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/contacts/contact_update.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::size_t kNewAPiece = 32; // contacts

} // namespace

void ContactSet::noteEnd(const Contact& contact) {
    if (contact.wasTouching) {
        ended_.push_back(endOf(contact));
        countTouch(contact, false);
    }
}

/// Its bodies have a contact more that touches them, or one less.
void ContactSet::countTouch(const Contact& contact, bool touches) {
    for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
        touches_[body] += touches ? 1u : kOneLess;
        touchChanges_.push_back(body);
    }
    const std::size_t many = 4 * touches_.size();
    if (touchChanges_.size() > many) { // as when a region goes about between two steps
        // total order: equal numbers are the same
        std::sort(touchChanges_.begin(), touchChanges_.end());
        touchChanges_.erase(std::unique(touchChanges_.begin(), touchChanges_.end()),
                            touchChanges_.end());
    }
}

/// Counts them all, of a World that was just read. What kColliding does not tell yet is a change.
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

/// Before a contact goes.
void ContactSet::writeRecords() const {
    records([](const Contact& contact) -> const Contact& { return contact; });
}

void ContactSet::forgetUnsound(const Bodies& bodies, const Tolerances& tolerances) {
    lookAtAll();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        if (!isSound(contact)) {
            clearContact(contact);
            followContact(contact, bodies, tolerances, false);
            findContact(contact, bodies, tolerances);
            kodo::measureApproach(contact, bodies);
            heads_[i].note(contact);
        }
    }
}

/// Contacts came, went, or have other places.
void ContactSet::changed() {
    contactsChanged_ = true;
    liveStale_ = true;
}

/// Moves the last contacts into the slots that are free.
void ContactSet::fillHoles() {
    changed();
    if (holes_.empty()) {
        return;
    }
    const std::size_t kept = contacts_.size() - holes_.size();
    std::sort(holes_.begin(), holes_.end()); // total order: slots are unique
    // Of the slots beyond the new end, those that are no holes move down, the lowest first.
    std::vector<std::uint32_t>& movedTo = slots_;
    refill(movedTo, holes_.size(), 0u);
    std::size_t hole = 0;
    std::size_t beyond = static_cast<std::size_t>(
        std::lower_bound(holes_.begin(), holes_.end(), kept) - holes_.begin());
    for (std::size_t slot = kept; slot < contacts_.size(); ++slot) {
        if (beyond < holes_.size() && holes_[beyond] == slot) {
            ++beyond;
            continue;
        }
        movedTo[slot - kept] = holes_[hole];
        heads_[holes_[hole]] = heads_[slot];
        contacts_[holes_[hole++]] = contacts_[slot];
    }
    disorder_.strayed += hole;
    for (Place& place : order_) {
        if (place.slot >= kept) {
            place.slot = movedTo[place.slot - kept];
        }
    }
    contacts_.resize(kept);
    heads_.resize(kept);
}

/// Moves the contacts into the order of their keys, so that who goes through them comes to bodies
/// in their order, too. Goes round each cycle of the permutation, with one contact put aside.
void ContactSet::sortContacts() {
    disorder_ = {};
    for (std::uint32_t start = 0; start < order_.size(); ++start) {
        if (order_[start].slot == start) {
            continue;
        }
        changed();
        const Contact contact = contacts_[start];
        const ContactHead head = heads_[start];
        std::uint32_t to = start;
        for (std::uint32_t from = order_[to].slot; from != start; from = order_[to].slot) {
            contacts_[to] = contacts_[from];
            heads_[to] = heads_[from];
            order_[to].slot = to;
            to = from;
        }
        contacts_[to] = contact;
        heads_[to] = head;
        order_[to].slot = to;
    }
}

void ContactSet::updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                             Crew& crew) {
    recordsDue_ = false; // nobody asked
    dropped_.clear();
    applyChanges(bodies, tolerances);
    if (disorder_.countStep(contacts_.size())) {
        sortContacts();
    }
    bounds_.foresee(bodies, tolerances, dt, crew);
    refreshPairs(bodies, crew);
}

void ContactSet::coverMoves(const Bodies& bodies, const Tolerances& tolerances, Crew& crew) {
    bounds_.coverMoves(bodies, tolerances, crew);
    refreshPairs(bodies, crew);
}

/// Looks for the pairs of those whose bounds are new.
void ContactSet::refreshPairs(const Bodies& bodies, Crew& crew) {
    if (bounds_.changed().empty()) {
        return;
    }
    findPairs(bodies, crew);
    if (!pairs_.empty() || !order_.empty()) {
        mergePairs(bodies, crew);
    }
    bounds_.clearChanged();
}

void ContactSet::setApart(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
    if (!std::equal(apart_.begin(), apart_.end(), pairs.begin(), pairs.end())) {
        apart_.assign(pairs.begin(), pairs.end());
        pairsStale_ = true;
    }
}

void ContactSet::findPairs(const Bodies& bodies, Crew& crew) {
    const auto accept = [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = bounds_.part(i).body;
        const std::uint32_t b = bounds_.part(j).body;
        const Flags flagsA = bodies.filter[a].flags;
        const Flags flagsB = bodies.filter[b].flags;
        const bool sensor = ((flagsA ^ flagsB) & kSensor) != 0; // one of them, not both
        return a != b && (sensor || !(bodies.locked(a) && bodies.locked(b))) &&
               (sensor || ((flagsA & flagsB) & kSensor) == 0) &&
               (bodies.active(a) || bodies.active(b)) &&
               shouldCollide(bodies.filter[a], bodies.filter[b]) &&
               !std::binary_search(apart_.begin(), apart_.end(), std::pair(a, b));
    };
    pairs_.clear();
    finder_.pairs(bounds_.grown(), {bounds_.changed(), bounds_.isChanged()}, accept, pairs_, crew);
}

/// Both lists are in the order of the keys, so one walk over both finds what is gone and what is
/// new. Only pairs with one whose bounds are new can be either.
void ContactSet::findNews(Crew& crew) {
    news_.clear();
    newsFound_.gather(
        crew, order_.size(), kContactsAPiece, news_,
        [&](std::size_t first, std::size_t last, std::vector<News>& news) {
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
                    news.push_back({*pair, static_cast<std::uint32_t>(at), true});
                }
                const bool found = pair != end && *pair == own;
                const bool asked = (isChanged[own.first] | isChanged[own.second]) != 0;
                pair += found ? 1 : 0;
                if (asked & !found) { // hardly ever; what of it holds is hard to foresee
                    news.push_back({own, static_cast<std::uint32_t>(at), false});
                }
            }
            for (; pair != end; ++pair) {
                news.push_back({*pair, static_cast<std::uint32_t>(last), true});
            }
        });
}

/// Keeps what stays, drops what is gone and adds what is new.
void ContactSet::mergePairs(const Bodies& bodies, Crew& crew) {
    findNews(crew);
    if (news_.empty()) {
        return;
    }
    newOrder_.clear();
    newOrder_.reserve(order_.capacity()); // the two take turns
    holes_.clear();
    added_.clear();
    std::size_t next = 0;
    const auto keepUpTo = [&](std::size_t end) {
        newOrder_.insert(newOrder_.end(), order_.begin() + static_cast<std::ptrdiff_t>(next),
                         order_.begin() + static_cast<std::ptrdiff_t>(end));
        next = end;
    };
    for (const News& news : news_) {
        keepUpTo(news.at);
        if (news.comes) {
            added_.push_back(static_cast<std::uint32_t>(newOrder_.size()));
            newOrder_.push_back({news.pair, 0});
        } else {
            holes_.push_back(order_[next++].slot);
            dismiss(contacts_[holes_.back()], bodies);
        }
    }
    keepUpTo(order_.size());
    std::swap(order_, newOrder_);
    addContacts(bodies, crew);
    fillHoles();
}

/// Before a contact goes whose bounds have parted.
void ContactSet::dismiss(Contact& gone, const Bodies& bodies) {
    if (gone.row.lent) {
        gone.centerA = bodies.start[gone.key.bodyA];
    }
    noteEnd(gone);
}

/// Makes contacts for the pairs that are new, in the last holes as long as there are some.
void ContactSet::addContacts(const Bodies& bodies, Crew& crew) {
    disorder_.strayed += added_.size();
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
    heads_.resize(slots);
    crew.forEach(added_.size(), kNewAPiece, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t at : std::span(added_).subspan(first, last - first)) {
            const auto& [pair, slot] = order_[at];
            const PartBounds::Part& a = bounds_.part(pair.first);
            const PartBounds::Part& b = bounds_.part(pair.second);
            contacts_[slot].key = {a.body, a.part, b.body, b.part};
            describeContact(contacts_[slot], bodies);
            heads_[slot] = ContactHead::of(contacts_[slot], pair);
        }
    });
}

} // namespace kodo::inline KODO_PRECISION
