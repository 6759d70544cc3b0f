// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "broad/part_tree.hpp"

#include <atomic>
#include <mutex>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Bounds of all parts, for the queries of a World. A cache and no state: the first query after a
/// change updates it, so a World without queries pays nothing. Queries of one World may run on
/// several threads at once; changes may not.
class QueryTree {
public:
    /// Parts of planes, which have no bounds.
    struct PlanePart {
        std::uint32_t body;
        std::uint32_t part;
    };
    struct View {
        const BoundsTree& tree;
        std::span<const PlanePart> planes;
        const BoundsTree& compounds; // bounds of each body with several parts; part: 0
    };

    QueryTree() = default;
    QueryTree(const QueryTree&) {} // a copy builds its own at its first query
    QueryTree& operator=(const QueryTree&) {
        allStale_ = true; // the bodies are others now; most of the bounds may fit
        stale_ = true;
        return *this;
    }

    /// A body was added, removed or teleported, or its geometry changed.
    void bodyChanged(std::uint32_t body);
    /// Bodies moved in a step.
    void bodiesMoved(std::span<const std::uint32_t> bodies);
    /// All bodies may have changed.
    void bodiesChanged();

    /// True if a view() only follows the bodies that have changed.
    bool isBuilt() const { return !allStale_; }
    /// Up to date until the next change.
    View view(const Bodies& bodies, const Tolerances& tolerances);

private:
    enum class Change : std::uint8_t { None, Moved, Any };

    void note(std::uint32_t body, Change change);
    void update(const Bodies& bodies, Real margin);
    void updateBody(const Bodies& bodies, std::uint32_t body, Real margin);
    void moveBody(const Bodies& bodies, std::uint32_t body, Real margin);
    void removePlanes(std::uint32_t body);
    void rebuild(const Bodies& bodies, Real margin);
    void updateCompound(std::uint32_t body, std::span<const BoundsTree::Leaf> parts);
    void append(const Bodies& bodies, std::uint32_t body, Real margin,
                std::vector<BoundsTree::Leaf>& leaves);

    PartTree parts_;
    PartTree compounds_;                 // of each body with several leaves, their union
    std::vector<std::uint8_t> hasPlane_; // by body
    std::vector<PlanePart> planes_;
    std::vector<std::uint32_t> changed_; // bodies
    std::vector<Change> changeOf_;       // by body; None: not in changed_
    std::vector<Transform> leafPose_;    // by body: Bodies::pose when its leaves were made
    bool allStale_ = true;
    std::atomic<bool> stale_ = true;
    std::mutex mutex_;
};

} // namespace KODO_PRECISION
} // namespace kodo
