// SPDX-License-Identifier: MIT
#include "contacts/candidate_pairs.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

void CandidatePairs::renew(const Bodies& bodies, const Tolerances& tolerances) {
    bounds_.renew(bodies, tolerances);
    finder_.forget();
    still_.forget();
}

bool CandidatePairs::renew(const Bodies& bodies, const Tolerances& tolerances,
                           std::span<const std::uint32_t> changed) {
    const std::size_t before = bounds_.size();
    const bool renumbered = bounds_.renew(bodies, tolerances, changed);
    if (renumbered || bounds_.size() != before) {
        forgetOrder();
    }
    still_.bodiesChanged(bodies, bounds_, changed);
    return renumbered;
}

bool CandidatePairs::compact() {
    if (!bounds_.compact()) {
        return false;
    }
    forgetOrder();
    return true;
}

/// The indices of bounds have changed.
void CandidatePairs::forgetOrder() {
    finder_.forget();
    movers_.forget();
}

bool CandidatePairs::search(const Bodies& bodies, const JointLists& joints, WorkerTeam& team) {
    pairs_.clear();
    if (bounds_.changed().empty()) {
        if (bodies.awake.size() < still_.awakeCount() / 2) {
            // In the step after they fell asleep, not at the next hit.
            still_.update(bodies, bounds_);
        }
        return false;
    }
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
               shouldCollide(bodies.filter[a], bodies.filter[b]) && !joints.exclude(a, b);
    };
    if (still_.update(bodies, bounds_) || bounds_.hasUnused() || !bounds_.isInOrder()) {
        searchMovers(bodies, accept, team);
        return true;
    }
    if (movers_.forget()) {
        finder_.forget();
    }
    finder_.pairs(bounds_.grown(), {bounds_.changed(), bounds_.isChanged()}, accept, pairs_, team);
    return true;
}

/// Searches listed parts alone, and those of inactive bodies in a tree if there is one.
template <typename Accept>
void CandidatePairs::searchMovers(const Bodies& bodies, Accept accept, WorkerTeam& team) {
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
    if (still_.hasTree()) { // otherwise all parts were compared
        searchTree(bodies, accept);
    }
}

/// Adds the pairs of changed moving parts with the parts of inactive bodies. Two inactive bodies
/// have none, unless one arrives.
template <typename Accept>
void CandidatePairs::searchTree(const Bodies& bodies, Accept accept) {
    const std::size_t among = pairs_.size();
    const auto ranksBefore = [&](std::uint32_t i, std::uint32_t j) {
        return bounds_.rank(i) < bounds_.rank(j);
    };
    for (const std::uint32_t k : movers_.changed) {
        const std::uint32_t i = movers_.parts[k];
        const std::uint32_t body = bounds_.part(i).body;
        if (!bodies.active(body) && bodies.hasArrived[body] == 0) {
            continue; // it has stopped or fallen asleep
        }
        const Octagon& own = movers_.bounds[k];
        const Aabb box = own.box();
        still_.tree().search(
            [&](const Aabb& node) { return overlap(box, node) ? 0 : BoundsTree::kMissed; },
            [&](std::uint32_t other, std::uint32_t part) {
                const std::uint32_t j = bounds_.indexOf(other, static_cast<std::uint16_t>(part));
                if (overlap(own, bounds_.grown()[j]) &&
                    !std::binary_search(movers_.parts.begin(), movers_.parts.end(), j,
                                        ranksBefore)) {
                    const auto [first, second] =
                        ranksBefore(j, i) ? BoundsPair{j, i} : BoundsPair{i, j};
                    if (accept(first, second)) {
                        pairs_.push_back({first, second});
                    }
                }
            });
    }
    if (pairs_.size() > among) {
        std::sort(pairs_.begin(), pairs_.end(), // total order: pairs are distinct
                  [&](BoundsPair a, BoundsPair b) { return bounds_.isBefore(a, b); });
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
