// SPDX-License-Identifier: MIT
// ContactSet: updates of the contacts within a step.
#include "base/prefetch.hpp"
#include "base/vector_reuse.hpp"
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kFar = 65536; // contacts, from which on their data exceeds the near caches
constexpr std::size_t kSummariesAhead = 16; // summaries; prefetch distance for their data

} // namespace

void ContactSet::measureApproach(const Bodies& bodies) {
    fastestApproach_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        kodo::measureApproach(contacts_[i], bodies);
        noteManifold(i);
    }
}

/// True if the summary agrees with the contact (assertion).
bool ContactSet::summaryAgrees(std::uint32_t place) const {
    const ContactSummary& summary = summaries_[place];
    const Contact& contact = contacts_[place];
    const bool meets = contact.manifold.count > 0 || contact.sensor;
    return contact.sensor || (summary.row == contact.row.index && summary.meets == meets &&
                              (!summary.steady || summary.wasTouching == contact.wasTouching));
}

/// Determines whether the contact touches. Adds its slot to `toggled` if that differs from the last
/// step.
void ContactSet::finishContact(std::uint32_t place, bool touchesInRow, const Tolerances& tolerances,
                               const WorkerTeam& team, std::vector<std::uint32_t>& toggled) {
    ContactSummary& summary = summaries_[place];
    Contact& contact = contacts_[place];
    const bool before = contact.wasTouching;
    kodo::finishContact(contact, summary.row == ContactRow::kNone ? touches(contact, tolerances)
                                                                  : touchesInRow);
    summary.wasTouching = contact.touching;
    summary.steady = !contact.phase || contact.phase == TouchPhase::Persist;
    if (contact.touching != before) {
        toggled.push_back(place);
        for (const std::uint32_t body : {summary.bodyA, summary.bodyB}) {
            team.count(touches_[body], before ? kOneLess : 1u);
        }
    }
}

std::span<const std::uint32_t> ContactSet::live() {
    if (std::exchange(liveStale_, false)) {
        live_.clear();
        for (std::uint32_t i = 0; i < summaries_.size(); ++i) {
            if (!summaries_[i].idle) {
                live_.push_back(i);
            }
        }
    }
    return live_;
}

void ContactSet::visitAll() {
    for (ContactSummary& summary : summaries_) {
        summary.idle = false;
    }
    liveStale_ = true;
}

void ContactSet::noteManifolds() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        noteManifold(i);
    }
}

void ContactSet::noteManifold(std::size_t slot) {
    summaries_[slot].note(contacts_[slot]);
    fastestApproach_ = std::max(fastestApproach_, summaries_[slot].approachSpeed);
}

/// True if the contact stays resident and its manifold is kept. Updates its summary from the lane.
bool ContactSet::staysKept(std::size_t i, const Tolerances& tolerances,
                           std::span<const Carried> carried) {
    ContactSummary& summary = summaries_[i];
    if (!summary.kept || carried.empty()) {
        return false;
    }
    const Carried& now = carried[summary.row];
    summary.separation = now.separation;
    summary.approachSpeed = now.approachSpeed;
    return !isOutdated(now.relativeDisplacement, summary.bounces, tolerances);
}

/// Updates the manifolds of a range. Summaries, lanes and bounds select the contacts that need a
/// visit; only these are read, with prefetching.
void ContactSet::updatePiece(const Bodies& bodies, const Tolerances& tolerances,
                             const SolverStorage& keeper, const Piece& piece) {
    const auto& [first, last, end] = piece;
    const bool far = summaries_.size() >= kFar;
    PrefetchList<kContactsPerPiece> visited;
    for (std::size_t i = first; i < last; ++i) {
        if (far && i + kSummariesAhead < end) {
            const ContactSummary& next = summaries_[i + kSummariesAhead];
            if (next.idle) {
                prefetch(bounds_.tight(next.proxies.first));
                prefetch(bounds_.tight(next.proxies.second));
            } else if (next.row < keeper.carried.size()) {
                prefetch(keeper.carried[next.row]);
            }
        }
        if (!staysKept(i, tolerances, keeper.carried) &&
            !(summaries_[i].idle && !boundsMeet(i, tolerances))) {
            visited.add(static_cast<std::uint32_t>(i));
        }
    }
    visitPrefetched<2>(visited.list(), contacts(), [&](std::uint32_t place) {
        updateManifold(bodies, tolerances, place, keeper);
    });
}

/// Appends the contacts of a range that are not idle. Returns their largest approach speed, m/s.
Real ContactSet::listLive(std::size_t first, std::size_t last,
                          std::vector<std::uint32_t>& found) const {
    Real fastest = 0;
    std::size_t count = found.size();
    found.resize(count + (last - first));
    for (std::size_t i = first; i < last; ++i) {
        const ContactSummary& summary = summaries_[i];
        fastest = std::max(fastest, summary.idle ? Real(0) : summary.approachSpeed);
        found[count] = static_cast<std::uint32_t>(i);
        count += summary.idle ? 0 : 1;
    }
    found.resize(count);
    return fastest;
}

void ContactSet::finishStepOfContacts(std::span<const std::uint8_t> touched,
                                      const Tolerances& tolerances, WorkerTeam& team) {
    const std::uint8_t* const touchedOf = touched.data();
    const std::size_t none = touched.size() - 1;
    const auto touches = [=](const ContactSummary& summary) {
        KODO_ASSERT(summary.row == ContactRow::kNone || summary.row < none);
        return touchedOf[std::min<std::size_t>(summary.row, none)] != 0;
    };
    reserveReusing(touchChanges_, touchChanges_.size() + 2 * contacts_.capacity());
    reserveReusing(records_.toggled, contacts_.capacity());
    found_.gather(
        team, live().size(), kContactsPerPiece, records_.toggled,
        [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
            found.reserve(found.size() + (last - first));
            forPieces(first, last, kContactsPerPiece, [&](std::size_t from, std::size_t to) {
                PrefetchList<kContactsPerPiece> visited;
                for (std::size_t i = from; i < to; ++i) {
                    const ContactSummary& summary = summaries_[live_[i]];
                    KODO_ASSERT(summaryAgrees(live_[i]));
                    const bool hasNoRow = summary.meets & (summary.row == ContactRow::kNone);
                    visited.add(live_[i], hasNoRow | !summary.steady |
                                              (touches(summary) != summary.wasTouching));
                }
                visitPrefetched<1>(visited.list(), contacts(), [&](std::uint32_t place) {
                    finishContact(place, touches(summaries_[place]), tolerances, team, found);
                });
            });
        });
    for (const std::uint32_t slot : records_.toggled) {
        touchChanges_.push_back(summaries_[slot].bodyA);
        touchChanges_.push_back(summaries_[slot].bodyB);
    }
}

void ContactSet::updateManifolds(const Bodies& bodies, const Tolerances& tolerances,
                                 const SolverStorage& keeper, WorkerTeam& team) {
    fastestApproach_ = 0;
    if (contacts_.empty() && !contactsChanged_) {
        return;
    }
    live_.clear();
    live_.reserve(contacts_.capacity());
    found_.gather(team, contacts_.size(), kContactsPerPiece, live_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      found.reserve(found.size() + (last - first));
                      Real fastest = 0;
                      forPieces(first, last, kContactsPerPiece, [&](auto from, auto to) {
                          updatePiece(bodies, tolerances, keeper, {from, to, last});
                          fastest = std::max(fastest, listLive(from, to, found));
                      });
                      WorkerTeam::raise(fastestApproach_, fastest);
                  });
    liveStale_ = false;
    if (std::exchange(contactsChanged_, false)) {
        noteKinds(bodies, team);
        ghostCollisions_.link(bodies, summaries_, onGround_);
    }
    ghostCollisions_.hide({bodies, contacts_, summaries_, tolerances, keeper.evict});
}

/// Notes whether any contact has a sensor or restitution. Lists the contacts between an immovable
/// and a movable body for GhostCollisions.
void ContactSet::noteKinds(const Bodies& bodies, WorkerTeam& team) {
    anySensors_ = 0;
    anyBounces_ = 0;
    onGround_.clear();
    reserveReusing(onGround_, order_.size());
    found_.gather(team, order_.size(), kContactsPerPiece, onGround_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      bool sensors = false;
                      bool bounces = false;
                      for (std::size_t i = first; i < last; ++i) {
                          const ContactSummary& summary = summaries_[order_[i].slot];
                          sensors |= summary.sensor;
                          bounces |= summary.bounces;
                          if (!summary.sensor &&
                              bodies.locked(summary.bodyA) != bodies.locked(summary.bodyB)) {
                              found.push_back(order_[i].slot);
                          }
                      }
                      if (sensors) {
                          WorkerTeam::mark(anySensors_);
                      }
                      if (bounces) {
                          WorkerTeam::mark(anyBounces_);
                      }
                  });
}

/// True if the tight bounds of both parts overlap when one is grown by the margin.
bool ContactSet::boundsMeet(std::size_t i, const Tolerances& tolerances) const {
    const BoundsPair& proxies = summaries_[i].proxies;
    return overlap(bounds_.tight(proxies.first).grown(tolerances.margin),
                   bounds_.tight(proxies.second));
}

/// Updates one manifold, and whether the contact is idle in this step.
void ContactSet::updateManifold(const Bodies& bodies, const Tolerances& tolerances, std::size_t i,
                                const SolverStorage& keeper) {
    Contact& contact = contacts_[i];
    if (contact.carried || boundsMeet(i, tolerances)) {
        const bool wasResident = contact.row.resident;
        KODO_ASSERT(!wasResident || !keeper.carried.empty());
        if (wasResident) {
            keeper.evict(contact);
        }
        if (!followContact(contact, bodies, tolerances, wasResident)) {
            findContact(contact, bodies, tolerances);
        }
        if (!contact.carried) {
            kodo::measureApproach(contact, bodies);
        }
    } else if (contact.near || contact.hidden || contact.manifold.count > 0) {
        clearContact(contact);
    }
    // An End is still to be recorded, or was recorded and has to be reset.
    const bool ends = contact.wasTouching || contact.phase;
    summaries_[i].idle = !(contact.near | ends | contact.sensor);
    summaries_[i].note(contact);
}

} // namespace KODO_PRECISION
} // namespace kodo
