// SPDX-License-Identifier: MIT
#pragma once

#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"
#include "bodies/joint_lists.hpp"
#include "broad/pair_finder.hpp"
#include "contacts/part_bounds.hpp"
#include "contacts/still_parts.hpp"

#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The pairs of parts that may touch in a step: their grown bounds overlap, and filters and joints
/// allow a contact. Owns the bounds and what searches them.
class CandidatePairs {
public:
    PartBounds& bounds() { return bounds_; }
    const PartBounds& bounds() const { return bounds_; }
    PairFinder& finder() { return finder_; }
    const PairFinder& finder() const { return finder_; }

    /// After changes of any number of bodies: all bounds are computed.
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    /// The same if only these bodies have changed, in order. True if the indices of other parts
    /// have changed.
    bool renew(const Bodies& bodies, const Tolerances& tolerances,
               std::span<const std::uint32_t> changed);
    /// Removes the unused indices of bounds and orders the others. True if that changed anything.
    bool compact();
    /// Searches the pairs of parts whose grown bounds have changed. False if none has.
    bool search(const Bodies& bodies, const JointLists& joints, WorkerTeam& team);
    /// Result of the last search, in the order of PartBounds::isBefore().
    std::span<const BoundsPair> pairs() const { return pairs_; }
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    void forgetOrder();
    template <typename Accept>
    void searchMovers(const Bodies& bodies, Accept accept, WorkerTeam& team);
    template <typename Accept>
    void searchTree(const Bodies& bodies, Accept accept);

    PartBounds bounds_;
    PairFinder finder_;
    StillParts still_;
    MovingParts movers_;
    std::vector<BoundsPair> pairs_;
};

} // namespace KODO_PRECISION
} // namespace kodo
