// SPDX-License-Identifier: MIT
#include "world/query_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// By which the bounds of a leaf exceed the part, in units of the length unit: a body that moves
/// slowly keeps its leaf, and rounding errors of searches are smaller (see kMaxCoordinate).
constexpr Real kMargin = Real(0.1);

} // namespace

void QueryTree::bodyChanged(std::uint32_t body) {
    bodiesMoved({&body, 1});
}

void QueryTree::bodiesMoved(std::span<const std::uint32_t> bodies) {
    if (allStale_ || bodies.empty()) {
        return;
    }
    const std::uint32_t last = *std::max_element(bodies.begin(), bodies.end());
    if (last >= isChanged_.size()) {
        isChanged_.resize(last + std::size_t{1}, 0);
    }
    for (const std::uint32_t body : bodies) {
        if (isChanged_[body] == 0) {
            isChanged_[body] = 1;
            changed_.push_back(body);
        }
    }
    stale_.store(true, std::memory_order_release);
}

void QueryTree::bodiesChanged() {
    allStale_ = true;
    stale_.store(true, std::memory_order_release);
}

QueryTree::View QueryTree::view(const Bodies& bodies, const Tolerances& tolerances) {
    if (stale_.load(std::memory_order_acquire)) {
        const std::lock_guard lock(mutex_);
        if (stale_.load(std::memory_order_relaxed)) {
            update(bodies, kMargin * tolerances.unit());
            stale_.store(false, std::memory_order_release);
        }
    }
    return {parts_.tree(), planes_, compounds_.tree()};
}

void QueryTree::update(const Bodies& bodies, Real margin) {
    if (parts_.isEmpty()) {
        rebuild(bodies, margin);
    } else {
        const std::size_t count = std::max({bodies.size(), parts_.bodyCount(), hasPlane_.size()});
        hasPlane_.resize(count, 0);
        if (allStale_) {
            changed_.resize(count);
            std::iota(changed_.begin(), changed_.end(), 0u);
        }
        for (const std::uint32_t body : changed_) {
            updateBody(bodies, body, margin);
        }
    }
    if (std::exchange(allStale_, false)) {
        isChanged_.reserve(bodies.record.capacity());
        isChanged_.assign(bodies.size(), 0);
    } else {
        for (const std::uint32_t body : changed_) {
            isChanged_[body] = 0;
        }
    }
    changed_.clear();
}

/// Lists the parts of a body: convex ones in `leaves`, planes in planes_.
void QueryTree::append(const Bodies& bodies, std::uint32_t body, Real margin,
                       std::vector<BoundsTree::Leaf>& leaves) {
    const std::vector<Part>& parts = bodies.geometry(body).parts;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        if (parts[i].convex.isPlane()) {
            hasPlane_[body] = 1;
            planes_.push_back({body, i});
        } else {
            leaves.push_back({boundsOf(parts[i].convex, bodies.pose[body]).grown(margin), body, i});
        }
    }
}

void QueryTree::rebuild(const Bodies& bodies, Real margin) {
    hasPlane_.reserve(bodies.record.capacity());
    hasPlane_.assign(bodies.size(), 0);
    planes_.clear();
    compounds_.clear();
    std::vector<BoundsTree::Leaf> leaves;
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        if (bodies.ids.aliveAt(body)) {
            const std::size_t first = leaves.size();
            append(bodies, body, margin, leaves);
            updateCompound(body, std::span(leaves).subspan(first));
        }
    }
    const std::size_t room = bodies.record.capacity();
    parts_.build(leaves, std::max(leaves.size(), room), room);
}

/// Replaces the union of the leaves of a body.
void QueryTree::updateCompound(std::uint32_t body, std::span<const BoundsTree::Leaf> parts) {
    compounds_.remove(body);
    if (parts.size() > 1) {
        Aabb box = parts.front().box;
        for (const BoundsTree::Leaf& part : parts) {
            box = unite(box, part.box);
        }
        compounds_.insert({box, body, 0});
    }
}

/// Keeps the leaves of a body whose parts are within them.
void QueryTree::updateBody(const Bodies& bodies, std::uint32_t body, Real margin) {
    const bool alive = body < bodies.size() && bodies.ids.aliveAt(body);
    if (alive && hasPlane_[body] == 0) {
        const std::vector<Part>& parts = bodies.geometry(body).parts;
        const auto isInside = [&](const Aabb& leaf, std::size_t i) {
            return !parts[i].convex.isPlane() &&
                   leaf.contains(boundsOf(parts[i].convex, bodies.pose[body]));
        };
        if (parts_.fits(body, parts.size(), isInside)) {
            return;
        }
    }
    parts_.remove(body);
    removePlanes(body);
    std::vector<BoundsTree::Leaf> leaves;
    if (alive) {
        append(bodies, body, margin, leaves);
        for (const BoundsTree::Leaf& leaf : leaves) {
            parts_.insert(leaf);
        }
    }
    updateCompound(body, leaves);
}

void QueryTree::removePlanes(std::uint32_t body) {
    if (std::exchange(hasPlane_[body], std::uint8_t{0}) != 0) {
        std::erase_if(planes_, [&](const PlanePart& plane) { return plane.body == body; });
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
