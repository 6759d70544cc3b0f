// SPDX-License-Identifier: MIT
#include "sleep/sleep_system.hpp"

#include "bodies/continuous_mode.hpp"
#include "collide/time_of_impact.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kNoIsland = SleepState::kNoIsland;

/// Inserts a contact into those of an island, in the order of keys. An existing contact of that key
/// dates from before a neighbour woke, and is replaced.
void keep(std::vector<StoredContact>& held, const StoredContact& contact) {
    if (held.empty() || held.back().key < contact.key) {
        held.push_back(contact);
        return;
    }
    const auto place =
        std::lower_bound(held.begin(), held.end(), contact,
                         [](const Contact& a, const Contact& b) { return a.key < b.key; });
    if (place->key == contact.key) {
        *place = contact;
    } else {
        held.insert(place, contact);
    }
}

} // namespace

/// The list of a body.
std::vector<SleepSystem::NeighbourIsland>& SleepSystem::neighboursFor(std::uint32_t body) {
    if (body >= neighboursOf_.size()) {
        neighboursOf_.resize(body + std::size_t{1}, 0);
    }
    std::uint32_t& index = neighboursOf_[body];
    if (index == 0) {
        index = static_cast<std::uint32_t>(neighbourIslands_.size());
        neighbourIslands_.emplace_back();
    }
    return neighbourIslands_[index];
}

/// Notes that an island has a contact with a body that is not its own.
void SleepSystem::noteIslandContact(const Bodies& bodies, const Contact& contact,
                                    std::uint32_t island) {
    for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
        if (bodies.sleep[body].island == island) {
            continue;
        }
        std::vector<NeighbourIsland>& all = neighboursFor(body);
        if (all.size() == all.capacity()) {
            std::erase_if(all, [&](const NeighbourIsland& old) { return hasWoken(old); });
        }
        const NeighbourIsland neighbour{island, islands_[island].version};
        if (all.empty() || all.back() != neighbour) {
            all.push_back(neighbour);
        }
    }
}

/// Wakes the islands in woken_, all at once: their contacts are sorted into the list together.
void SleepSystem::wakeIslands(Bodies& bodies, ContactSet& contacts) {
    sortUnique(woken_);
    returning_.clear();
    for (const std::uint32_t number : woken_) {
        Island& island = islands_[number];
        ++island.version;
        for (const std::uint32_t body : island.bodies) {
            bodies.filter[body].flags &= ~kAsleep;
            bodies.sleep[body] = {};
            bodies.sleep[body].since = bodies.pose[body];
            bodies.motion[body].clearDisplacement();
            bodies.acceleration[body] = {};
            bodies.changes.entered.push_back(body); // also if the list has it still
            contacts.activityChanged(body);
            bodies.noteActivity(body);
        }
        returning_.insert(returning_.end(), island.contacts.begin(), island.contacts.end());
        island.bodies.clear(); // keeps its capacity for the next island
        island.contacts.clear();
        freeIslands_.push_back(number);
        std::push_heap(freeIslands_.begin(), freeIslands_.end(), std::greater<>());
    }
    sleepingIslands_ -= woken_.size();
    woken_.clear();
    if (!returning_.empty()) {
        contacts.putBack(returning_, bodies);
    }
}

/// Restarts the calm count of a body, and notes its island for wakeIslands().
void SleepSystem::disturb(Bodies& bodies, std::uint32_t body) {
    restartCount(bodies.sleep[body], bodies.pose[body]);
    if (bodies.sleep[body].island != kNoIsland) {
        woken_.push_back(bodies.sleep[body].island);
    }
}

void SleepSystem::wake(Bodies& bodies, ContactSet& contacts, std::uint32_t body) {
    disturb(bodies, body);
    wakeIslands(bodies, contacts);
}

void SleepSystem::wakeAll(Bodies& bodies, ContactSet& contacts) {
    for (const std::uint32_t body : bodies.awake) {
        restartCount(bodies.sleep[body], bodies.pose[body]);
    }
    for (std::uint32_t island = 0; island < islands_.size(); ++island) {
        if (!islands_[island].bodies.empty()) {
            woken_.push_back(island);
        }
    }
    wakeIslands(bodies, contacts);
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        bodies.noteLostLoad(body);
    }
}

void SleepSystem::wakeOn(Bodies& bodies, ContactSet& contacts, std::span<const std::uint32_t> of) {
    members_.clear();
    for (const std::uint32_t body : of) {
        if (body >= neighboursOf_.size() || !bodies.active(body)) {
            continue;
        }
        for (const NeighbourIsland& neighbour : neighbourIslands_[neighboursOf_[body]]) {
            if (hasWoken(neighbour)) {
                continue;
            }
            for (const Contact& contact : islands_[neighbour.island].contacts) {
                const auto& [bodyA, partA, bodyB, partB] = contact.key;
                if (contact.wasTouching && (bodyA == body || bodyB == body)) {
                    members_.push_back(bodyA == body ? bodyB : bodyA);
                }
            }
        }
    }
    for (const std::uint32_t body : members_) {
        disturb(bodies, body);
    }
    wakeIslands(bodies, contacts);
}

/// Notes the islands that touch a body for wakeIslands(). Of the others, as beside a sensor, the
/// contacts with it return to the list of steps, since the body may change.
void SleepSystem::noteTouching(Bodies& bodies, ContactSet& contacts, std::uint32_t body) {
    if (body >= neighboursOf_.size() || neighboursOf_[body] == 0) {
        return;
    }
    std::vector<NeighbourIsland>& neighbours = neighbourIslands_[neighboursOf_[body]];
    const auto isOfBody = [&](const Contact& contact) {
        return contact.key.bodyA == body || contact.key.bodyB == body;
    };
    const auto touches = [&](const Contact& contact) {
        return contact.wasTouching && !contact.sensor && isOfBody(contact);
    };
    returning_.clear();
    for (const NeighbourIsland& neighbour : neighbours) {
        if (hasWoken(neighbour)) {
            continue;
        }
        std::vector<StoredContact>& all = islands_[neighbour.island].contacts;
        if (std::any_of(all.begin(), all.end(), touches)) {
            woken_.push_back(neighbour.island);
        } else {
            std::copy_if(all.begin(), all.end(), std::back_inserter(returning_), isOfBody);
            std::erase_if(all, isOfBody);
        }
    }
    neighbours.clear();
    if (!returning_.empty()) {
        contacts.putBack(returning_, bodies);
    }
}

void SleepSystem::wakeAround(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                             std::uint32_t body) {
    disturb(bodies, body);
    // An awake neighbour may have been about to fall asleep.
    contacts.touchedBy(body, members_);
    for (const std::uint32_t other : members_) {
        restartCount(bodies.sleep[other], bodies.pose[other]);
    }
    joints.visitOf(body, [&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        disturb(bodies, a == body ? secondBody(joint.def).index : a);
    });
    noteTouching(bodies, contacts, body);
    wakeIslands(bodies, contacts);
}

void SleepSystem::wakeNeighbours(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                                 std::uint32_t body) {
    wakeAround(bodies, contacts, joints, body);
    contacts.touchedBy(body, members_); // again, with the contacts of the islands
    std::for_each(members_.begin(), members_.end(), [&](auto i) { bodies.noteLostLoad(i); });
}

void SleepSystem::wakeTouched(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances) {
    // Contacts of woken islands are appended, and visited in the next round.
    std::uint32_t next = 0;
    do {
        const std::span<const ContactSummary> summaries = contacts.summaries();
        for (; next < summaries.size(); ++next) {
            const ContactSummary& summary = summaries[next];
            if (!summary.mayTouch || contacts.store().separation(next) > tolerances.slop ||
                !(bodies.asleep(summary.bodyA) || bodies.asleep(summary.bodyB)) ||
                !contacts.contacts()[next].responds()) {
                continue;
            }
            for (const std::uint32_t body : {summary.bodyA, summary.bodyB}) {
                if (bodies.sleep[body].island != kNoIsland) {
                    woken_.push_back(bodies.sleep[body].island);
                }
            }
        }
        wakeIslands(bodies, contacts);
    } while (next < contacts.summaries().size());
}

void SleepSystem::wakeJointed(Bodies& bodies, ContactSet& contacts, const JointSet& joints) {
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        const std::uint32_t b = secondBody(joint.def).index;
        if (bodies.active(a) && bodies.asleep(b)) {
            disturb(bodies, b);
        } else if (bodies.active(b) && bodies.asleep(a)) {
            disturb(bodies, a);
        }
    });
    wakeIslands(bodies, contacts);
}

bool SleepSystem::wakeRunOver(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances) {
    const auto isMovingKinematic = [&](std::uint32_t body) {
        return bodies.isMovingKinematic(body);
    };
    if (std::none_of(bodies.awake.begin(), bodies.awake.end(), isMovingKinematic)) {
        return false;
    }
    members_.clear();
    for (const Contact& contact : contacts.contacts()) {
        const auto& [bodyA, partA, bodyB, partB] = contact.key;
        const std::uint32_t wall = bodies.asleep(bodyA) ? bodyB : bodyA;
        if (bodies.asleep(bodyA) == bodies.asleep(bodyB) || !bodies.locked(wall) ||
            contact.sensor || contact.passing || !areChecked(bodies, bodyA, bodyB)) {
            continue;
        }
        const Real way = bodies.motion[wall].way(bodies.extent[wall].rotationReach);
        if (!contact.bounces &&
            way <= std::min(bodies.extent[bodyA].coreRadius, bodies.extent[bodyB].coreRadius) / 2) {
            continue; // the contact of the next step suffices
        }
        const auto pathOf = [&](std::uint32_t body) {
            return MotionPath{bodies.pose[body], bodies.motion[body].deltaPosition,
                              bodies.motion[body].deltaAngle};
        };
        if (timeOfImpact(bodies.convex(bodyA, partA), pathOf(bodyA), bodies.convex(bodyB, partB),
                         pathOf(bodyB), tolerances.slop / 64) < 1) {
            members_.push_back(wall == bodyA ? bodyB : bodyA);
        }
    }
    for (const std::uint32_t body : members_) {
        disturb(bodies, body);
    }
    wakeIslands(bodies, contacts);
    return !members_.empty();
}

void SleepSystem::putToSleep(Bodies& bodies, std::span<const std::uint32_t> members) {
    auto island = static_cast<std::uint32_t>(islands_.size());
    if (freeIslands_.empty()) {
        islands_.emplace_back();
    } else { // the lowest, so that a copy takes the same one
        std::pop_heap(freeIslands_.begin(), freeIslands_.end(), std::greater<>());
        island = freeIslands_.back();
        freeIslands_.pop_back();
    }
    for (const std::uint32_t body : members) {
        bodies.filter[body].flags |= kAsleep;
        bodies.sleep[body].island = island;
        bodies.motion[body].stop();
        bodies.noteActivity(body);
    }
    ++sleepingIslands_;
    islands_[island].bodies.assign(members.begin(), members.end());
}

void SleepSystem::sleepIslands(Bodies& bodies, ContactSet& contacts) {
    std::sort(sleepers_.begin(), sleepers_.end()); // total order: bodies are unique
    members_.clear();
    for (std::size_t i = 0; i < sleepers_.size(); ++i) {
        members_.push_back(sleepers_[i].second);
        if (i + 1 == sleepers_.size() || sleepers_[i + 1].first != sleepers_[i].first) {
            putToSleep(bodies, members_);
            members_.clear();
        }
    }
    for (const auto& [root, body] : sleepers_) {
        members_.push_back(body);
    }
    keepContacts(bodies, contacts.takeIdle(bodies, members_));
}

bool SleepSystem::putToSleep(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                             std::uint32_t body) {
    makeRoom(bodies);
    reached_.clear();
    bool sleeps = followIsland(body, 1, bodies, contacts, joints, 0);
    sleepers_.clear();
    for (const std::uint32_t member : reached_) {
        reachedBy_[member] = 0;
        sleeps = sleeps && (bodies.filter[member].flags & kNeverSleep) == 0;
        sleepers_.emplace_back(body, member);
    }
    if (sleeps && !sleepers_.empty()) {
        sleepIslands(bodies, contacts);
    }
    return sleeps;
}

void SleepSystem::keepArrivals(const Bodies& bodies, ContactSet& contacts) {
    keepContacts(bodies, contacts.takeArrivals(bodies));
}

/// Inserts contacts into those of their islands.
void SleepSystem::keepContacts(const Bodies& bodies, std::span<const StoredContact> idle) {
    for (const StoredContact& contact : idle) {
        const std::uint32_t a = bodies.sleep[contact.key.bodyA].island;
        const std::uint32_t island = a != kNoIsland ? a : bodies.sleep[contact.key.bodyB].island;
        keep(islands_[island].contacts, contact);
        noteIslandContact(bodies, contact, island);
    }
}

void SleepSystem::Island::visitState(StateStream& stream) {
    static_assert(countMembers<Island>() == 3, "list a new member, or leave it out");
    stream(bodies, contacts);
}

void SleepSystem::visitState(StateStream& stream, Bodies& bodies) {
    auto& [islands, sleepingIslands, freeIslands, neighboursOf, neighbourIslands, calm, reached,
           reachedBy, leastCalm, bases, sleepers, members, woken, returning] = *this;
    stream(islands);
    if (!stream.reads()) {
        return;
    }
    const char* const sentence =
        "the snapshot is corrupt: a sleeping body is missing from its island";
    for (std::uint32_t island = 0; island < islands.size(); ++island) {
        require(areInOrder(islands[island].bodies, bodies.size()), sentence);
        for (const std::uint32_t body : islands[island].bodies) {
            require(bodies.ids.aliveAt(body) && bodies.asleep(body) &&
                        bodies.sleep[body].island == SleepState::kNoIsland,
                    sentence);
            bodies.sleep[body].island = island;
        }
        for (StoredContact& contact : islands[island].contacts) {
            completeContact(contact, bodies);
            contact.row = {}; // only contacts of the list have a row
            noteIslandContact(bodies, contact, island);
        }
        require(!islands[island].bodies.empty() || islands[island].contacts.empty(), sentence);
        sleepingIslands += islands[island].bodies.empty() ? 0 : 1;
        if (islands[island].bodies.empty()) {
            freeIslands.push_back(island); // ascending: a heap
        }
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        require(!bodies.asleep(i) || bodies.sleep[i].island != SleepState::kNoIsland, sentence);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
