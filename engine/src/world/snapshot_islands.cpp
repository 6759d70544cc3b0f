// SPDX-License-Identifier: MIT
#include "contacts/contact_update.hpp"
#include "world/snapshot_fields.hpp"

// Islands and joints of a snapshot.
namespace kodo {
inline namespace KODO_PRECISION {

bool areInOrder(std::span<const std::uint32_t> bodies, std::size_t count) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i] >= count || (i > 0 && bodies[i - 1] >= bodies[i])) {
            return false;
        }
    }
    return true;
}

void SnapshotFields::rest(SleepSystem& stage, Bodies& bodies) {
    auto& [islands, sleepingIslands, freeIslands, neighboursOf, neighbourIslands, calm, reached,
           reachedBy, leastCalm, bases, sleepers, members, woken, returning] = stage;
    all(islands);
    if (!reads()) {
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
        for (Contact& contact : islands[island].contacts) {
            completeContact(contact, bodies);
            contact.row = {}; // only contacts of the list have a row
            stage.noteIslandContact(bodies, contact, island);
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

void SnapshotFields::joints(JointSet& set, const Bodies& bodies, Real lengthUnit) {
    auto& [ids, stamp, joints, lists, pairChanges, broken, trees, treeCandidates, hinges, springs,
           inertias, rotations, own, takenRevolutes, busy, busyStale, lastPass] = set;
    one(ids);
    stamp = reads() ? 0 : stamp;
    joints.resize(ids.capacity());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!ids.aliveAt(i)) {
            continue;
        }
        one(joints[i]);
        if (!reads()) {
            continue;
        }
        require(check(joints[i].def, lengthUnit));
        for (const BodyId body : {firstBody(joints[i].def), secondBody(joints[i].def)}) {
            require(bodies.ids.alive(body.index, body.generation),
                    "a joint refers to a body that does not exist");
        }
    }
    set.refreshLists();
}

} // namespace KODO_PRECISION
} // namespace kodo
