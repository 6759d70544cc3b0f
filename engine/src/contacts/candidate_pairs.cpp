// SPDX-License-Identifier: MIT
#include "contacts/candidate_pairs.hpp"

#include "bodies/part_filter.hpp"

#include <algorithm>
#include <array>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Rest restOf(const Bodies& bodies, std::uint32_t body) {
    return bodies.active(body) ? Rest::Moving : bodies.asleep(body) ? Rest::Asleep : Rest::Static;
}

} // namespace

void CandidatePairs::renew(const Bodies& bodies, const Tolerances& tolerances) {
    bounds_.renew(bodies, tolerances);
    buildTrees(bodies);
}

void CandidatePairs::buildTrees(const Bodies& bodies) {
    trees_.clear();
    planes_.clear();
    std::array<std::vector<BoundsTrees::Leaf>, kRests> leaves;
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
        if (!bounds_.isUsed(i)) {
            continue;
        }
        if (bounds_.isPlane(i)) {
            planes_.push_back(i);
        } else {
            const Rest rest = restOf(bodies, bounds_.part(i).body);
            leaves[static_cast<std::size_t>(rest)].push_back({bounds_.grown()[i].box(), i});
        }
    }
    for (std::size_t rest = 0; rest < kRests; ++rest) {
        trees_.add(static_cast<Rest>(rest), leaves[rest]);
    }
}

void CandidatePairs::renew(const Bodies& bodies, const Tolerances& tolerances, std::uint32_t body) {
    const std::uint32_t first = bounds_.firstOf(body);
    const std::uint32_t count = bounds_.countOf(body);
    std::erase_if(planes_, [&](std::uint32_t i) { return bounds_.part(i).body == body; });
    bounds_.renew(bodies, tolerances, body);
    const std::uint32_t firstNow = bounds_.firstOf(body);
    const std::uint32_t countNow = bounds_.countOf(body);
    for (std::uint32_t i = first; i < first + count; ++i) {
        if (i - firstNow >= countNow || bounds_.isPlane(i)) {
            trees_.remove(i);
        }
    }
    for (std::uint32_t i = firstNow; i < firstNow + countNow; ++i) {
        if (bounds_.isPlane(i)) {
            planes_.push_back(i);
        } else {
            trees_.set(i, restOf(bodies, body), bounds_.grown()[i].box());
        }
    }
}

bool CandidatePairs::renumberIfDue(const Bodies& bodies, std::size_t contacts) {
    if (!bounds_.renumberIfDue(contacts)) {
        return false;
    }
    buildTrees(bodies);
    return true;
}

void CandidatePairs::moveToTrees(const Bodies& bodies, std::span<const std::uint32_t> toggled) {
    for (const Rest rest : {Rest::Static, Rest::Asleep, Rest::Moving}) {
        leaves_.clear();
        for (const std::uint32_t body : toggled) {
            const std::uint32_t first = bounds_.firstOf(body);
            for (std::uint32_t i = first; i < first + bounds_.countOf(body); ++i) {
                if (trees_.has(i) && restOf(bodies, body) == rest && trees_.restOf(i) != rest) {
                    leaves_.push_back({trees_.boxOf(i), i});
                    trees_.remove(i);
                }
            }
        }
        trees_.add(rest, leaves_);
    }
}

void CandidatePairs::coverPoses(const Bodies& bodies, const Tolerances& tolerances) {
    for (const std::uint32_t body : bodies.awake) {
        const BodyVelocity& motion = bodies.motion[body];
        const Real rotationReach = bodies.extent[body].reachOfTurn(motion.deltaAngle);
        if (axialWay(motion, rotationReach) < tolerances.margin / 2) {
            continue; // the grown bounds exceed the part by the margin, at least
        }
        const std::uint32_t first = bounds_.firstOf(body);
        for (std::uint32_t i = first; i < first + bounds_.countOf(body); ++i) {
            const Octagon& tight = bounds_.tight(i);
            if (!bounds_.grown()[i].contains(
                    tight.moved(motion.deltaPosition).grown(rotationReach)) &&
                trees_.has(i)) {
                const Aabb box = bounds_.at(bodies, i, bodies.pose[body]).box();
                trees_.set(i, trees_.restOf(i), unite(trees_.boxOf(i), box));
            }
        }
    }
}

/// Moves the leaves of changed bounds.
void CandidatePairs::followChanged(const Bodies& bodies) {
    anyArrived_ = false;
    for (const std::uint32_t i : bounds_.changed()) {
        const std::uint32_t body = bounds_.part(i).body;
        anyArrived_ = anyArrived_ || (bodies.hasArrived[body] != 0 && !bodies.active(body));
        if (trees_.has(i)) { // the body may be a new one in the slot of one that was active
            trees_.set(i, restOf(bodies, body), bounds_.grown()[i].box());
        }
    }
}

bool CandidatePairs::search(const Bodies& bodies, const JointLists& joints, WorkerTeam& team) {
    pairs_.clear();
    if (bounds_.changed().empty()) {
        return false;
    }
    if (bodies.leftOut.has(Feature::Collision)) {
        return true; // there are no pairs
    }
    followChanged(bodies);
    const std::uint8_t* const isChanged = bounds_.isChanged().data();
    const Octagon* const grown = bounds_.grown().data();
    const auto accept = [&](std::uint32_t i, std::uint32_t j) {
        if ((isChanged[i] | isChanged[j]) == 0 || !overlap(grown[i], grown[j])) {
            return false;
        }
        const std::uint32_t a = bounds_.part(i).body;
        const std::uint32_t b = bounds_.part(j).body;
        const CollisionFilter filterA = filterOf(bodies, a, bounds_.part(i).part);
        const CollisionFilter filterB = filterOf(bodies, b, bounds_.part(j).part);
        const Flags flagsA = filterA.flags;
        const Flags flagsB = filterB.flags;
        const bool sensor = ((flagsA ^ flagsB) & kSensor) != 0; // exactly one of them
        // An inactive body that arrives may touch a sleeping one: see SleepSystem::wakeTouched.
        const auto arrives = [&] {
            return ((flagsA | flagsB) & (kAsleep | kOutside)) == kAsleep &&
                   (bodies.hasArrived[a] | bodies.hasArrived[b]) != 0;
        };
        return a != b && (sensor || !(bodies.locked(a) && bodies.locked(b))) &&
               (sensor || ((flagsA & flagsB) & kSensor) == 0) &&
               (bodies.active(a) || bodies.active(b) || arrives()) &&
               shouldCollide(filterA, filterB) && !joints.exclude(a, b);
    };
    nodePairs_.clear();
    trees_.findNodePairs(anyArrived_, nodePairs_);
    work_ += nodePairs_.size();
    found_.gather(team, nodePairs_.size(), kNodePairsPerPiece, pairs_,
                  [&](std::size_t first, std::size_t last, std::vector<BoundsPair>& found) {
                      for (std::size_t k = first; k < last; ++k) {
                          trees_.forPairs(nodePairs_[k], [&](std::uint32_t i, std::uint32_t j) {
                              if (accept(i, j)) {
                                  found.push_back({i, j});
                              }
                          });
                      }
                  });
    trees_.clearMarks();
    searchPlanes(accept);
    sortPairs();
    return true;
}

/// Compares each plane with all parts if its bounds have changed, otherwise with those whose have.
template <typename Accept>
void CandidatePairs::searchPlanes(Accept accept) {
    const auto add = [&](std::uint32_t plane, std::uint32_t i) {
        if (accept(plane, i)) {
            pairs_.push_back({plane, i});
        }
    };
    const std::span<const std::uint8_t> isChanged = bounds_.isChanged();
    for (const std::uint32_t plane : planes_) {
        if (isChanged[plane] == 0) {
            for (const std::uint32_t i : bounds_.changed()) {
                if (bounds_.isUsed(i)) {
                    add(plane, i);
                }
            }
            continue;
        }
        for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
            const bool again = bounds_.isPlane(i) && isChanged[i] != 0 && i < plane;
            if (bounds_.isUsed(i) && !again) {
                add(plane, i);
            }
        }
        work_ += bounds_.size() / 64; // as many parts as a pair of nodes has pairs of leaves
    }
}

/// Puts the pairs in order, and the members of each.
void CandidatePairs::sortPairs() {
    for (BoundsPair& pair : pairs_) {
        if (bounds_.rank(pair.second) < bounds_.rank(pair.first)) {
            std::swap(pair.first, pair.second);
        }
    }
    if (bounds_.isInOrder()) {
        sorter_.sort(pairs_, bounds_.size());
    } else {
        std::sort(pairs_.begin(), pairs_.end(), // total order: pairs are distinct
                  [&](BoundsPair a, BoundsPair b) { return bounds_.isBefore(a, b); });
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
