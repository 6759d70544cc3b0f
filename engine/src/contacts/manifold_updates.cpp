// SPDX-License-Identifier: MIT
// ContactSet: updates of the contacts within a step.
#include "base/prefetch.hpp"
#include "base/vector_reuse.hpp"
#include "contacts/contact_report.hpp"
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kFar = 65536; // contacts, from which on their data exceeds the near caches
constexpr std::size_t kSummariesAhead = 16; // summaries; prefetch distance for their data
constexpr std::size_t kContactsPerPiece = 128;

using Summaries = std::span<const ContactSummary>;

struct Piece { // of the contacts; `end` is that of the whole range of the thread
    std::size_t first, last, end;
};

/// Updates the manifolds of a step. On any thread; each contact on one.
class ManifoldPass {
public:
    ContactStore& store;
    const ContactBlocks& lanes;
    const PartBounds& bounds;
    const Bodies& bodies;
    const Tolerances& tolerances;
    Real dt; // s

    /// Summaries, lanes and bounds select the contacts of the piece that need a visit; only these
    /// are read, with prefetching. Returns the largest approach speed, m/s.
    Real update(const Piece& piece) const {
        const auto& [first, last, end] = piece;
        const std::span<const ContactSummary> summaries = store.summaries();
        const bool far = summaries.size() >= kFar;
        Real fastest = 0;
        PrefetchList<kContactsPerPiece> visited;
        for (std::size_t i = first; i < last; ++i) {
            if (far && i + kSummariesAhead < end) {
                prefetchFor(summaries[i + kSummariesAhead]);
            }
            const auto slot = static_cast<std::uint32_t>(i);
            if (isCurrent(slot, summaries[i])) {
                fastest = std::max(fastest, store.approachSpeed(slot));
            } else {
                visited.add(slot, !summaries[i].idle || boundsMeet(i));
            }
        }
        visitPrefetched<2>(visited.list(), store.contacts(), [&](std::uint32_t slot) {
            updateContact(slot);
            fastest = std::max(fastest, summaries[slot].idle ? Real(0) : store.approachSpeed(slot));
        });
        return fastest;
    }

private:
    void prefetchFor(const ContactSummary& next) const {
        if (next.idle) {
            prefetch(bounds.tight(next.proxies.first));
            prefetch(bounds.tight(next.proxies.second));
        } else if (next.kept) {
            prefetch(lanes.relativeDisplacement(next.row.index));
        }
    }
    /// True if the lane has all of the contact, and its manifold stays valid.
    bool isCurrent(std::uint32_t slot, const ContactSummary& summary) const {
        const std::uint32_t row = summary.row.index;
        const Real moved = summary.kept ? lanes.relativeDisplacement(row) : ContactLane::kExpired;
        return !isOutdated(moved, true, tolerances) ||
               (!isOutdated(moved, false, tolerances) && !summary.bounces &&
                !arrives(lanes.leastSeparation(row), store.approachSpeed(slot), tolerances.slop,
                         dt));
    }
    /// True if the tight bounds of both parts overlap when one is grown by the margin.
    bool boundsMeet(std::size_t slot) const {
        const BoundsPair& proxies = store.summaries()[slot].proxies;
        return overlap(bounds.tight(proxies.first).grown(tolerances.margin),
                       bounds.tight(proxies.second));
    }
    /// Updates one manifold, and whether the contact is idle in this step.
    void updateContact(std::uint32_t slot) const {
        const ContactEntry entry = store.entry(slot);
        auto& [contact, summary, place] = entry;
        const ContactLane lane = store.lane(slot);
        summary.kept = false;
        if (contact.filled || boundsMeet(slot)) {
            if (!followContact(contact, lane, bodies, tolerances, dt, summary.inPasses())) {
                findContact(contact, lane, bodies, tolerances, dt);
            }
            if (!contact.filled) {
                measureApproach(contact, lane, bodies);
            }
        } else if (contact.near || contact.hidden || contact.manifold.count > 0) {
            clearContact(contact, lane);
            summary.row = {};
        }
        // An End is still to be recorded, or was recorded and has to be reset.
        const bool ends = contact.wasTouching || contact.phase;
        summary.idle = !(contact.near | ends | contact.sensor);
        summary.mayTouch = contact.manifold.count > 0 || contact.sensor;
    }
};

/// Appends the contacts of a range that are not idle.
void listLive(std::span<const ContactSummary> summaries, std::size_t first, std::size_t last,
              std::vector<std::uint32_t>& found) {
    std::size_t count = found.size();
    found.resize(count + (last - first));
    for (std::size_t i = first; i < last; ++i) {
        const ContactSummary& summary = summaries[i];
        found[count] = static_cast<std::uint32_t>(i);
        count += summary.idle ? 0 : 1;
    }
    found.resize(count);
}

/// True if the summary agrees with the contact (assertion).
[[maybe_unused]] bool agrees(const ContactSummary& summary, const Contact& contact) {
    const bool mayTouch = contact.manifold.count > 0 || contact.sensor;
    return contact.sensor || (summary.mayTouch == mayTouch &&
                              (!summary.settled || summary.wasTouching == contact.wasTouching));
}

} // namespace

void ContactSet::measureApproach(const Bodies& bodies, std::uint32_t body) {
    store_.lists().forEach(body, [&](std::uint32_t slot) {
        kodo::measureApproach(contacts()[slot], store_.lane(slot), bodies);
        manifoldChanged(slot);
    });
}

/// Determines whether the contact touches. Adds its slot to `toggled` if that differs from the last
/// step.
void ContactSet::finishContact(std::uint32_t slot, bool touchesInRow, const Tolerances& tolerances,
                               const WorkerTeam& team, std::vector<std::uint32_t>& toggled) {
    ContactSummary& summary = store_.summaries()[slot];
    Contact& contact = contacts()[slot];
    const bool before = contact.wasTouching;
    kodo::finishContact(contact, summary.inPasses()
                                     ? touchesInRow || store_.lane(slot).impacts() > 0
                                     : touches(contact, store_.lane(slot), tolerances));
    summary.wasTouching = contact.touching;
    summary.settled = !contact.phase || contact.phase == TouchPhase::Persist;
    if (contact.touching != before) {
        toggled.push_back(slot);
        touchCounts_.count(team, summary, !before);
    }
}

std::span<const std::uint32_t> ContactSet::live() {
    if (std::exchange(liveStale_, false)) {
        live_.clear();
        for (std::uint32_t i = 0; i < store_.size(); ++i) {
            if (!summaries()[i].idle) {
                live_.push_back(i);
            }
        }
    }
    return live_;
}

void ContactSet::visitAll() {
    for (ContactSummary& summary : store_.summaries()) {
        summary.idle = false;
    }
    liveStale_ = true;
}

void ContactSet::leavePasses(const Bodies& bodies) {
    visitAll();
    for (std::uint32_t slot = 0; slot < store_.size(); ++slot) {
        store_.leavePasses(slot, bodies);
    }
}

void ContactSet::manifoldChanged(std::uint32_t slot) {
    ContactSummary& summary = store_.summaries()[slot];
    summary.mayTouch = contacts()[slot].manifold.count > 0 || summary.sensor;
    liveStale_ = std::exchange(summary.idle, false) || liveStale_;
    fastestApproach_ = std::max(fastestApproach_, store_.approachSpeed(slot));
}

void ContactSet::finishStepOfContacts(const Bodies& bodies, const Tolerances& tolerances,
                                      WorkerTeam& team) {
    const std::uint8_t* const touchedOf = lanes().touched().data();
    const auto touches = [=](const ContactSummary& summary) {
        return summary.inPasses() && touchedOf[summary.row.index] != 0;
    };
    const std::span<const ContactSummary> all = summaries();
    std::vector<std::uint32_t>& toggled = records_.toggled();
    touchCounts_.reserveChanges(store_.capacity());
    reserveReusing(toggled, store_.capacity());
    found_.gather(
        team, live().size(), kContactsPerPiece, toggled,
        [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
            found.reserve(found.size() + (last - first));
            forPieces(first, last, kContactsPerPiece, [&](std::size_t from, std::size_t to) {
                PrefetchList<kContactsPerPiece> visited;
                for (std::size_t i = from; i < to; ++i) {
                    const ContactSummary& summary = all[live_[i]];
                    KODO_ASSERT(agrees(summary, contacts()[live_[i]]));
                    const bool hasNoRow = summary.mayTouch & !summary.inPasses();
                    visited.add(live_[i], hasNoRow | !summary.settled |
                                              (touches(summary) != summary.wasTouching));
                }
                visitPrefetched<1>(visited.list(), contacts(), [&](std::uint32_t slot) {
                    finishContact(slot, touches(all[slot]), tolerances, team, found);
                });
            });
        });
    touchCounts_.addChanges(all, toggled);
    lineSides_.spread({bodies, store_, tolerances.margin}, contactsChanged_);
}

void ContactSet::updateManifolds(Bodies& bodies, const Tolerances& tolerances, Real dt,
                                 WorkerTeam& team) {
    fastestApproach_ = 0;
    for (const std::uint32_t body : bodies.changes.teleported) {
        store_.lists().forEach(body,
                               [&](std::uint32_t slot) { store_.summaries()[slot].kept = false; });
    }
    noteStart(bodies);
    lanes().advance(bodies, team);
    if (store_.size() == 0 && !contactsChanged_) {
        return;
    }
    if (contactsChanged_) {
        lineSides_.spread({bodies, store_, tolerances.margin}, contactsChanged_);
    }
    const ManifoldPass pass{store_, store_.lanes(), candidates_.bounds(), bodies, tolerances, dt};
    live_.clear();
    live_.reserve(store_.capacity());
    found_.gather(team, store_.size(), kContactsPerPiece, live_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      found.reserve(found.size() + (last - first));
                      Real fastest = 0;
                      forPieces(first, last, kContactsPerPiece, [&](auto from, auto to) {
                          fastest = std::max(fastest, pass.update({from, to, last}));
                          listLive(summaries(), from, to, found);
                      });
                      WorkerTeam::raise(fastestApproach_, fastest);
                  });
    liveStale_ = false;
    if (std::exchange(contactsChanged_, false)) {
        findKinds(bodies, team);
        ghostCollisions_.link(bodies, summaries(), onGround_);
        oneWayBodies_.link(bodies, contacts(), bodies.thin > 0 ? summaries() : Summaries());
    }
    if (!oneWayBodies_.empty()) {
        oneWayBodies_.hide({bodies, store_, tolerances, dt, liveStale_});
    }
    ghostCollisions_.hide({bodies, store_, tolerances, dt, liveStale_});
}

/// Finds whether any contact has a sensor or restitution. Lists the contacts between an immovable
/// and a movable body for GhostCollisions.
void ContactSet::findKinds(const Bodies& bodies, WorkerTeam& team) {
    anySensors_ = 0;
    anyBounces_ = 0;
    onGround_.clear();
    reserveReusing(onGround_, store_.size());
    found_.gather(team, store_.size(), kContactsPerPiece, onGround_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      bool sensors = false;
                      bool bounces = false;
                      for (std::size_t i = first; i < last; ++i) {
                          const std::uint32_t slot = store_.slotAt(i);
                          const ContactSummary& summary = summaries()[slot];
                          sensors |= summary.sensor;
                          bounces |= summary.bounces;
                          if (!summary.sensor &&
                              bodies.locked(summary.bodyA) != bodies.locked(summary.bodyB)) {
                              found.push_back(slot);
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

} // namespace KODO_PRECISION
} // namespace kodo
