// SPDX-License-Identifier: MIT
#include "world/query_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// By which the bounds of a leaf exceed the part, in units of the length unit: a body that moves
/// slowly keeps its leaf, and rounding errors of searches are smaller (see kMaxCoordinate).
constexpr Real kMargin = Real(0.1);

/// Pose from which any distance is unknown.
constexpr Transform kUnknown{{std::numeric_limits<Real>::quiet_NaN(), 0}, {}};

} // namespace

/// Needs changeOf_ up to the body.
void QueryTree::note(std::uint32_t body, Change change) {
    if (changeOf_[body] == Change::None) {
        changed_.push_back(body);
    }
    changeOf_[body] = std::max(changeOf_[body], change);
}

void QueryTree::bodyChanged(std::uint32_t body) {
    if (allStale_) {
        return;
    }
    if (body >= changeOf_.size()) {
        changeOf_.resize(body + std::size_t{1}, Change::None);
    }
    note(body, Change::Any);
    stale_.store(true, std::memory_order_release);
}

void QueryTree::bodiesMoved(std::span<const std::uint32_t> bodies) {
    if (allStale_ || bodies.empty()) {
        return;
    }
    const std::uint32_t last = *std::max_element(bodies.begin(), bodies.end());
    if (last >= changeOf_.size()) {
        changeOf_.resize(last + std::size_t{1}, Change::None);
    }
    for (const std::uint32_t body : bodies) {
        note(body, Change::Moved);
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
        leafPose_.resize(count);
        if (allStale_) {
            changed_.resize(count);
            std::iota(changed_.begin(), changed_.end(), 0u);
        }
        for (const std::uint32_t body : changed_) {
            if (!allStale_ && changeOf_[body] == Change::Moved) {
                moveBody(bodies, body, margin);
            } else {
                updateBody(bodies, body, margin);
            }
        }
    }
    if (std::exchange(allStale_, false)) {
        changeOf_.reserve(bodies.record.capacity());
        changeOf_.assign(bodies.size(), Change::None);
    } else {
        for (const std::uint32_t body : changed_) {
            changeOf_[body] = Change::None;
        }
    }
    changed_.clear();
}

/// Lists the parts of a body: convex ones in `leaves`, planes in planes_.
void QueryTree::append(const Bodies& bodies, std::uint32_t body, Real margin,
                       std::vector<BoundsTree::Leaf>& leaves) {
    const std::vector<Part>& parts = bodies.geometry(body).parts;
    leafPose_[body] = bodies.pose[body];
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
    leafPose_.reserve(bodies.record.capacity());
    leafPose_.assign(bodies.size(), {});
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
            leafPose_[body] = kUnknown; // it may have another centre of mass now
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

/// For a body that moved in a step: its parts are the same. Most leaves are kept by the distance
/// that the body has moved, which costs less than its bounds.
void QueryTree::moveBody(const Bodies& bodies, std::uint32_t body, Real margin) {
    if (hasPlane_[body] != 0 || !bodies.ids.aliveAt(body)) {
        updateBody(bodies, body, margin);
        return;
    }
    const Transform& pose = bodies.pose[body];
    const Transform& before = leafPose_[body];
    const BodyGeometry& geometry = bodies.geometry(body);
    const Vec2 turn{pose.rotation.c - before.rotation.c, pose.rotation.s - before.rotation.s};
    const Real farthest =
        length(pose.position - before.position) + geometry.boundingRadius * length(turn);
    if (farthest < Real(0.75) * margin) { // a quarter for rounding errors far from the origin
        return;
    }
    const std::vector<Part>& parts = geometry.parts;
    const auto isInside = [&](const Aabb& leaf, std::size_t i) {
        return leaf.contains(boundsOf(parts[i].convex, pose));
    };
    if (parts_.fits(body, parts.size(), isInside)) {
        return;
    }
    leafPose_[body] = pose;
    const auto boxOf = [&](std::size_t i) { return boundsOf(parts[i].convex, pose).grown(margin); };
    parts_.move(body, parts.size(), boxOf);
    if (parts.size() > 1) {
        Aabb box = boxOf(0);
        for (std::size_t i = 1; i < parts.size(); ++i) {
            box = unite(box, boxOf(i));
        }
        compounds_.move(body, 1, [&](std::size_t) { return box; });
    }
}

void QueryTree::removePlanes(std::uint32_t body) {
    if (std::exchange(hasPlane_[body], std::uint8_t{0}) != 0) {
        std::erase_if(planes_, [&](const PlanePart& plane) { return plane.body == body; });
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
