// SPDX-License-Identifier: MIT
#pragma once

#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"
#include "bodies/joint_lists.hpp"
#include "broad/bounds_trees.hpp"
#include "contacts/part_bounds.hpp"

#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// The pairs of parts that may touch in a step: their grown bounds overlap, and filters and joints
/// allow a contact. Owns the bounds, and the trees of them that pair search, queries and the region
/// share. The trees follow each change at once; no result depends on their shape.
class CandidatePairs {
public:
    PartBounds& bounds() { return bounds_; }
    const PartBounds& bounds() const { return bounds_; }
    /// The leaves are indices of bounds. Each contains the grown bounds of its part when their
    /// pairs were last searched, and the part itself at all times except within the solver.
    const BoundsTrees& trees() const { return trees_; }
    /// Indices of the bounds of planes, which are in no tree.
    std::span<const std::uint32_t> planes() const { return planes_; }
    /// Pairs of nodes that all searches so far have compared.
    std::uint64_t work() const { return work_; }

    /// All bodies may have changed.
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    /// A body was added, removed or changed.
    void renew(const Bodies& bodies, const Tolerances& tolerances, std::uint32_t body);
    /// See PartBounds. True if the indices of bounds have changed.
    bool renumberIfDue(const Bodies& bodies, std::size_t contacts);
    /// Fills the trees from the bounds.
    void buildTrees(const Bodies& bodies);
    /// These bodies have become active or inactive.
    void moveToTrees(const Bodies& bodies, std::span<const std::uint32_t> toggled);
    /// After the poses have moved: the leaves contain the parts.
    void coverPoses(const Bodies& bodies, const Tolerances& tolerances);
    /// Searches the pairs of parts whose grown bounds have changed. False if none has.
    bool search(const Bodies& bodies, const JointLists& joints, WorkerTeam& team);
    /// Result of the last search, in the order of PartBounds::isBefore().
    std::span<const BoundsPair> pairs() const { return pairs_; }
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    static constexpr std::size_t kNodePairsPerPiece = 64;

    void followChanged(const Bodies& bodies);
    template <typename Accept>
    void searchPlanes(Accept accept);
    void sortPairs();

    PartBounds bounds_;
    BoundsTrees trees_;
    std::vector<std::uint32_t> planes_;
    std::vector<BoundsPair> pairs_;
    std::vector<BoundsTrees::NodePair> nodePairs_; // scratch
    std::vector<BoundsTrees::Leaf> leaves_;        // scratch
    ParallelCollector<BoundsPair> found_;
    PairSorter sorter_;
    bool anyArrived_ = false; // an inactive body among those that the search concerns
    std::uint64_t work_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
