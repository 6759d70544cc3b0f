// SPDX-License-Identifier: MIT
// What a step does with the contacts that a ContactSet has.
#include <kodo/base/prefetch.hpp>
#include <kodo/base/refill.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/contacts/contact_update.hpp>

#include <algorithm>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::size_t kFar = 65536; // so many contacts: what belongs to them is in no near cache
constexpr std::size_t kHeadsAhead = 16; // then what these lead to is asked for beforehand

} // namespace

void ContactSet::measureApproach(const Bodies& bodies) {
    fastestApproach_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        kodo::measureApproach(contacts_[i], bodies);
        heads_[i].note(contacts_[i]);
        fastestApproach_ = std::max(fastestApproach_, heads_[i].approachSpeed);
    }
}

/// Does the head of a contact tell what the contact does?
bool ContactSet::isTrue(std::uint32_t place) const {
    const ContactHead& head = heads_[place];
    const Contact& contact = contacts_[place];
    const bool meets = contact.manifold.count > 0 || contact.sensor;
    return contact.sensor || (head.row == contact.row.index && head.meets == meets &&
                              (!head.steady || head.wasTouching == contact.wasTouching));
}

/// Does it touch, after all? Adds its bodies to the changes if that is not as a step ago.
void ContactSet::finishContact(std::uint32_t place, bool touchesInRow, const Tolerances& tolerances,
                               const Crew& crew, std::vector<std::uint32_t>& changes) {
    ContactHead& head = heads_[place];
    Contact& contact = contacts_[place];
    const bool before = contact.wasTouching;
    kodo::finishContact(contact, head.row == ContactRow::kNone ? touches(contact, tolerances)
                                                               : touchesInRow);
    head.wasTouching = contact.touching;
    head.steady = !contact.phase || contact.phase == TouchPhase::Persist;
    if (contact.touching != before) {
        for (const std::uint32_t body : {head.bodyA, head.bodyB}) {
            crew.count(touches_[body], before ? kOneLess : 1u);
            changes.push_back(body);
        }
    }
}

std::span<const std::uint32_t> ContactSet::live() {
    if (std::exchange(liveStale_, false)) {
        live_.clear();
        for (std::uint32_t i = 0; i < heads_.size(); ++i) {
            if (!heads_[i].idle) {
                live_.push_back(i);
            }
        }
    }
    return live_;
}

void ContactSet::lookAtAll() {
    for (ContactHead& head : heads_) {
        head.idle = false;
    }
    liveStale_ = true;
}

void ContactSet::noteManifolds() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        heads_[i].note(contacts_[i]);
    }
}

/// Does its lane carry it on for this step, too? Then brings its head up to date.
bool ContactSet::staysKept(std::size_t i, const Tolerances& tolerances,
                           std::span<const Carried> carried) {
    ContactHead& head = heads_[i];
    if (!head.kept || carried.empty()) {
        return false;
    }
    const Carried& now = carried[head.row];
    head.separation = now.separation;
    head.approachSpeed = now.approachSpeed;
    return !isOutdated(now.drift, head.bounces, tolerances);
}

/// Of some contacts: tells by their heads, and by what these lead to, which have to be looked at,
/// and then looks at those.
void ContactSet::updatePiece(const Bodies& bodies, const Tolerances& tolerances,
                             const ContactKeeper& keeper, const Piece& piece) {
    const auto& [first, last, end] = piece;
    const bool far = heads_.size() >= kFar;
    Places<kContactsAPiece> asked;
    for (std::size_t i = first; i < last; ++i) {
        if (far && i + kHeadsAhead < end) {
            const ContactHead& next = heads_[i + kHeadsAhead];
            if (next.idle) {
                prefetch(bounds_.tight(next.proxies.first));
                prefetch(bounds_.tight(next.proxies.second));
            } else if (next.row < keeper.carried.size()) {
                prefetch(keeper.carried[next.row]);
            }
        }
        if (!staysKept(i, tolerances, keeper.carried) &&
            !(heads_[i].idle && !boundsMeet(i, tolerances))) {
            asked.add(static_cast<std::uint32_t>(i));
        }
    }
    visitAhead<2>(asked.list(), contacts(),
                  [&](std::uint32_t place) { updateManifold(bodies, tolerances, place, keeper); });
}

/// Adds those of some contacts that anything may come of. Gives their fastest approach, m/s.
Real ContactSet::listLive(std::size_t first, std::size_t last,
                          std::vector<std::uint32_t>& found) const {
    Real fastest = 0;
    std::size_t count = found.size();
    found.resize(count + (last - first));
    for (std::size_t i = first; i < last; ++i) {
        const ContactHead& head = heads_[i];
        fastest = std::max(fastest, head.idle ? Real(0) : head.approachSpeed);
        found[count] = static_cast<std::uint32_t>(i);
        count += head.idle ? 0 : 1;
    }
    found.resize(count);
    return fastest;
}

void ContactSet::sumUp(std::span<const std::uint8_t> touched, const Tolerances& tolerances,
                       Crew& crew) {
    const std::uint8_t* const touchedOf = touched.data();
    const std::size_t none = touched.size() - 1;
    const auto touches = [=](const ContactHead& head) {
        KODO_ASSERT(head.row == ContactRow::kNone || head.row < none);
        return touchedOf[std::min<std::size_t>(head.row, none)] != 0;
    };
    makeRoom(touchChanges_, touchChanges_.size() + 2 * contacts_.capacity());
    found_.gather(
        crew, live().size(), kContactsAPiece, touchChanges_,
        [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
            found.reserve(found.size() + 2 * (last - first));
            forPieces(first, last, kContactsAPiece, [&](std::size_t from, std::size_t to) {
                Places<kContactsAPiece> asked;
                for (std::size_t i = from; i < to; ++i) {
                    const ContactHead& head = heads_[live_[i]];
                    KODO_ASSERT(isTrue(live_[i]));
                    const bool asks = head.meets & (head.row == ContactRow::kNone);
                    asked.add(live_[i], asks | !head.steady | (touches(head) != head.wasTouching));
                }
                visitAhead<1>(asked.list(), contacts(), [&](std::uint32_t place) {
                    finishContact(place, touches(heads_[place]), tolerances, crew, found);
                });
            });
        });
}

void ContactSet::updateManifolds(const Bodies& bodies, const Tolerances& tolerances,
                                 const ContactKeeper& keeper, Crew& crew) {
    fastestApproach_ = 0;
    if (contacts_.empty() && !contactsChanged_) {
        return;
    }
    live_.clear();
    live_.reserve(contacts_.capacity());
    found_.gather(crew, contacts_.size(), kContactsAPiece, live_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      found.reserve(found.size() + (last - first));
                      Real fastest = 0;
                      forPieces(first, last, kContactsAPiece, [&](auto from, auto to) {
                          updatePiece(bodies, tolerances, keeper, {from, to, last});
                          fastest = std::max(fastest, listLive(from, to, found));
                      });
                      Crew::raise(fastestApproach_, fastest);
                  });
    liveStale_ = false;
    if (std::exchange(contactsChanged_, false)) {
        noteKinds(bodies, crew);
        seams_.link(bodies, heads_, onGround_);
    }
    seams_.hide(bodies, contacts_, heads_, tolerances);
}

/// What kinds of contacts there are, and which of them are on the ground: see Seams.
void ContactSet::noteKinds(const Bodies& bodies, Crew& crew) {
    anySensors_ = 0;
    anyBounces_ = 0;
    onGround_.clear();
    makeRoom(onGround_, heads_.size());
    found_.gather(crew, heads_.size(), kContactsAPiece, onGround_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      bool sensors = false;
                      bool bounces = false;
                      for (std::size_t i = first; i < last; ++i) {
                          const ContactHead& head = heads_[i];
                          sensors |= head.sensor;
                          bounces |= head.bounces;
                          if (!head.sensor &&
                              bodies.locked(head.bodyA) != bodies.locked(head.bodyB)) {
                              found.push_back(static_cast<std::uint32_t>(i));
                          }
                      }
                      if (sensors) {
                          Crew::mark(anySensors_);
                      }
                      if (bounces) {
                          Crew::mark(anyBounces_);
                      }
                  });
}

/// Do the bounds of the parts of a contact meet, grown by the margin?
bool ContactSet::boundsMeet(std::size_t i, const Tolerances& tolerances) const {
    const BoundsPair& proxies = heads_[i].proxies;
    return overlap(bounds_.tight(proxies.first).grown(tolerances.margin),
                   bounds_.tight(proxies.second));
}

/// Of one contact, and whether anything may come of it in this step.
void ContactSet::updateManifold(const Bodies& bodies, const Tolerances& tolerances, std::size_t i,
                                const ContactKeeper& keeper) {
    Contact& contact = contacts_[i];
    if (contact.carried || boundsMeet(i, tolerances)) {
        const bool wentOn = contact.row.lent;
        KODO_ASSERT(!wentOn || !keeper.carried.empty());
        if (wentOn) {
            keeper.reclaim(contact);
        }
        if (!followContact(contact, bodies, tolerances, wentOn)) {
            findContact(contact, bodies, tolerances);
        }
        if (!contact.carried) {
            kodo::measureApproach(contact, bodies);
        }
    } else if (contact.near || contact.hidden || contact.manifold.count > 0) {
        clearContact(contact);
    }
    // Its end is still to be told, or was and is to be forgotten.
    const bool ends = contact.wasTouching || contact.phase;
    heads_[i].idle = !(contact.near | ends | contact.sensor);
    heads_[i].note(contact);
}

} // namespace kodo::inline KODO_PRECISION
