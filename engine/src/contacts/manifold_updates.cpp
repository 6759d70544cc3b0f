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
    const PartBounds& bounds;
    const Bodies& bodies;
    const Tolerances& tolerances;
    Real dt; // s
    const SolverStorage& keeper;

    /// Summaries, lanes and bounds select the contacts of the piece that need a visit; only these
    /// are read, with prefetching.
    void update(const Piece& piece) const {
        const auto& [first, last, end] = piece;
        const std::span<const ContactSummary> summaries = store.summaries();
        const bool far = summaries.size() >= kFar;
        PrefetchList<kContactsPerPiece> visited;
        for (std::size_t i = first; i < last; ++i) {
            if (far && i + kSummariesAhead < end) {
                prefetchFor(summaries[i + kSummariesAhead]);
            }
            if (!staysKept(i) && !(summaries[i].idle && !boundsMeet(i))) {
                visited.add(static_cast<std::uint32_t>(i));
            }
        }
        visitPrefetched<2>(visited.list(), store.contacts(),
                           [&](std::uint32_t slot) { updateContact(slot); });
    }

private:
    void prefetchFor(const ContactSummary& next) const {
        if (next.idle) {
            prefetch(bounds.tight(next.proxies.first));
            prefetch(bounds.tight(next.proxies.second));
        } else if (next.row < keeper.carried.size()) {
            prefetch(keeper.carried[next.row]);
        }
    }
    /// True if the contact stays resident and its manifold is kept. Updates its summary from the
    /// lane.
    bool staysKept(std::size_t slot) const {
        ContactSummary& summary = store.summaries()[slot];
        if (!summary.kept || keeper.carried.empty()) {
            return false;
        }
        const Carried& now = keeper.carried[summary.row];
        summary.separation = now.separation;
        summary.approachSpeed = now.approachSpeed;
        return !isOutdated(now.relativeDisplacement, summary.bounces, tolerances);
    }
    /// True if the tight bounds of both parts overlap when one is grown by the margin.
    bool boundsMeet(std::size_t slot) const {
        const BoundsPair& proxies = store.summaries()[slot].proxies;
        return overlap(bounds.tight(proxies.first).grown(tolerances.margin),
                       bounds.tight(proxies.second));
    }
    /// Updates one manifold, and whether the contact is idle in this step.
    void updateContact(std::size_t slot) const {
        Contact& contact = store.contacts()[slot];
        if (contact.carried || boundsMeet(slot)) {
            const bool wasResident = contact.row.resident;
            KODO_ASSERT(!wasResident || !keeper.carried.empty());
            if (wasResident) {
                keeper.evict(contact);
            }
            if (!followContact(contact, bodies, tolerances, wasResident)) {
                findContact(contact, bodies, tolerances, dt);
            }
            if (!contact.carried) {
                measureApproach(contact, bodies);
            }
        } else if (contact.near || contact.hidden || contact.manifold.count > 0) {
            clearContact(contact);
        }
        // An End is still to be recorded, or was recorded and has to be reset.
        const bool ends = contact.wasTouching || contact.phase;
        ContactSummary& summary = store.summaries()[slot];
        summary.idle = !(contact.near | ends | contact.sensor);
        summary.note(contact);
    }
};

/// Appends the contacts of a range that are not idle. Returns their largest approach speed, m/s.
Real listLive(std::span<const ContactSummary> summaries, std::size_t first, std::size_t last,
              std::vector<std::uint32_t>& found) {
    Real fastest = 0;
    std::size_t count = found.size();
    found.resize(count + (last - first));
    for (std::size_t i = first; i < last; ++i) {
        const ContactSummary& summary = summaries[i];
        fastest = std::max(fastest, summary.idle ? Real(0) : summary.approachSpeed);
        found[count] = static_cast<std::uint32_t>(i);
        count += summary.idle ? 0 : 1;
    }
    found.resize(count);
    return fastest;
}

/// True if the summary agrees with the contact (assertion).
[[maybe_unused]] bool agrees(const ContactSummary& summary, const Contact& contact) {
    const bool meets = contact.manifold.count > 0 || contact.sensor;
    return contact.sensor || (summary.row == contact.row.index && summary.meets == meets &&
                              (!summary.steady || summary.wasTouching == contact.wasTouching));
}

} // namespace

void ContactSet::measureApproach(const Bodies& bodies, std::uint32_t body) {
    store_.lists().forEach(body, [&](std::uint32_t slot) {
        kodo::measureApproach(contacts()[slot], bodies);
        noteManifold(slot);
    });
}

/// Determines whether the contact touches. Adds its slot to `toggled` if that differs from the last
/// step.
void ContactSet::finishContact(std::uint32_t slot, bool touchesInRow, const Tolerances& tolerances,
                               const WorkerTeam& team, std::vector<std::uint32_t>& toggled) {
    ContactSummary& summary = store_.summaries()[slot];
    Contact& contact = contacts()[slot];
    const bool before = contact.wasTouching;
    kodo::finishContact(contact, summary.row == ContactRow::kNone ? touches(contact, tolerances)
                                                                  : touchesInRow);
    summary.wasTouching = contact.touching;
    summary.steady = !contact.phase || contact.phase == TouchPhase::Persist;
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

void ContactSet::noteManifolds() {
    for (std::size_t slot = 0; slot < store_.size(); ++slot) {
        noteManifold(slot);
    }
}

void ContactSet::noteManifold(std::size_t slot) {
    ContactSummary& summary = store_.summaries()[slot];
    summary.note(contacts()[slot]);
    fastestApproach_ = std::max(fastestApproach_, summary.approachSpeed);
}

void ContactSet::finishStepOfContacts(std::span<const std::uint8_t> touched,
                                      const Tolerances& tolerances, WorkerTeam& team) {
    const std::uint8_t* const touchedOf = touched.data();
    const std::size_t none = touched.size() - 1;
    const auto touches = [=](const ContactSummary& summary) {
        KODO_ASSERT(summary.row == ContactRow::kNone || summary.row < none);
        return touchedOf[std::min<std::size_t>(summary.row, none)] != 0;
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
                    const bool hasNoRow = summary.meets & (summary.row == ContactRow::kNone);
                    visited.add(live_[i], hasNoRow | !summary.steady |
                                              (touches(summary) != summary.wasTouching));
                }
                visitPrefetched<1>(visited.list(), contacts(), [&](std::uint32_t slot) {
                    finishContact(slot, touches(all[slot]), tolerances, team, found);
                });
            });
        });
    touchCounts_.noteChanges(all, toggled);
}

void ContactSet::updateManifolds(const Bodies& bodies, const Tolerances& tolerances, Real dt,
                                 const SolverStorage& keeper, WorkerTeam& team) {
    fastestApproach_ = 0;
    if (store_.size() == 0 && !contactsChanged_) {
        return;
    }
    const ManifoldPass pass{store_, candidates_.bounds(), bodies, tolerances, dt, keeper};
    live_.clear();
    live_.reserve(store_.capacity());
    found_.gather(team, store_.size(), kContactsPerPiece, live_,
                  [&](std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) {
                      found.reserve(found.size() + (last - first));
                      Real fastest = 0;
                      forPieces(first, last, kContactsPerPiece, [&](auto from, auto to) {
                          pass.update({from, to, last});
                          fastest = std::max(fastest, listLive(summaries(), from, to, found));
                      });
                      WorkerTeam::raise(fastestApproach_, fastest);
                  });
    liveStale_ = false;
    if (std::exchange(contactsChanged_, false)) {
        noteKinds(bodies, team);
        ghostCollisions_.link(bodies, summaries(), onGround_);
        const bool anyLines = !(bodies.thinnest > 0); // points and lines have no core radius
        oneWayBodies_.link(bodies, contacts(), anyLines ? summaries() : Summaries());
        lineSides_.link(bodies, contacts(), anyLines ? summaries() : Summaries());
    }
    if (!lineSides_.empty()) {
        lineSides_.spread({bodies, contacts(), store_.summaries(), tolerances, dt, keeper.evict});
    }
    if (!oneWayBodies_.empty()) {
        oneWayBodies_.hide({bodies, contacts(), store_.summaries(), tolerances, dt, keeper.evict});
    }
    ghostCollisions_.hide({bodies, contacts(), store_.summaries(), tolerances, dt, keeper.evict});
}

/// Notes whether any contact has a sensor or restitution. Lists the contacts between an immovable
/// and a movable body for GhostCollisions.
void ContactSet::noteKinds(const Bodies& bodies, WorkerTeam& team) {
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
