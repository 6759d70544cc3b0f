// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "broad/part_tree.hpp"
#include "contacts/part_bounds.hpp"

#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Parts of bodies that take no part in steps (static, asleep, outside the region), in a tree. So
/// the pairs of what moves are searched among what moves, and in the tree: many tiles cost the
/// logarithm of their number. Scratch: it follows from bodies and bounds.
///
/// A body that wakes keeps its leaves, since it often falls asleep within them again. A search of
/// the tree must skip the parts of active bodies.
///
/// Parts of planes have no bounds worth a tree: they are searched with what moves.
class StillParts {
public:
    /// All bodies may have changed.
    void forget() { built_ = false; }
    /// Bodies were added, removed or changed otherwise. Ignored if there is no tree.
    void bodiesChanged(const Bodies& bodies, const PartBounds& bounds,
                       std::span<const std::uint32_t> changed);
    /// Follows Bodies::awake. False if too few parts are still for a tree to pay.
    bool update(const Bodies& bodies, const PartBounds& bounds);
    /// Number of awake bodies when the last update() decided.
    std::size_t awakeCount() const { return counted_; }
    /// Result of the last update().
    bool hasTree() const { return hasTree_; }

    /// Lists the parts to search without the tree, by rank: of active bodies, of planes, and the
    /// changed ones; all if there is no tree.
    void listOthers(const Bodies& bodies, const PartBounds& bounds,
                    std::vector<std::uint32_t>& parts);
    const BoundsTree& tree() const { return parts_.tree(); }

private:
    static constexpr std::size_t kFew = 512; // still parts; fewer are compared one by one

    void place(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body);
    void stop(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body);
    void insert(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body);
    void removePlanes(std::uint32_t body);
    void rebuild(const Bodies& bodies, const PartBounds& bounds);
    void followAwake(const Bodies& bodies, const PartBounds& bounds);

    PartTree parts_;
    std::vector<std::uint32_t> planes_; // bodies with a plane, in order
    std::vector<std::uint32_t> active_; // Bodies::awake at the last update
    std::vector<std::uint32_t> listed_; // scratch: bodies with parts
    std::size_t counted_ = 0;           // bodies awake when `hasTree_` was decided
    std::size_t all_ = 0;               // parts, at that time
    bool built_ = false;                // the tree is valid
    bool hasTree_ = false;
};

/// Scratch: the parts that are searched beside the tree, and their bounds, contiguous.
struct MovingParts {
    std::vector<std::uint32_t> parts; // indices in PartBounds, by rank
    std::vector<Octagon> bounds;
    std::vector<std::uint32_t> changed; // indices in `parts`
    std::vector<std::uint8_t> isChanged;

    /// Fills all but `parts`. True if they are not those of the last call.
    bool gather(const PartBounds& all);
    /// True if gather() was called since the last forget().
    bool forget() { return !std::exchange(before, {}).empty(); }

    std::vector<std::uint32_t> before; // `parts` of the last gather()
};

} // namespace KODO_PRECISION
} // namespace kodo
