// SPDX-License-Identifier: MIT
#include "contacts/still_parts.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kFewToInsert = 8; // parts; more are sorted

/// By which the leaf of a body that stops exceeds its bounds, as a share of their half perimeter: a
/// body that wakes and moves a little keeps its leaf.
constexpr Real kSpare = Real(1) / 32;

bool hasPlane(const Bodies& bodies, std::uint32_t body) {
    const std::vector<Part>& parts = bodies.geometry(body).parts;
    return std::any_of(parts.begin(), parts.end(),
                       [](const Part& part) { return part.convex.isPlane(); });
}

bool isAwake(const Bodies& bodies, std::uint32_t body) {
    return std::binary_search(bodies.awake.begin(), bodies.awake.end(), body);
}

} // namespace

void StillParts::bodiesChanged(const Bodies& bodies, const PartBounds& bounds,
                               std::span<const std::uint32_t> changed) {
    for (std::size_t i = 0; built_ && i < changed.size(); ++i) {
        place(bodies, bounds, changed[i]);
    }
}

bool StillParts::update(const Bodies& bodies, const PartBounds& bounds) {
    const std::size_t awake = bodies.awake.size();
    if (built_ ? awake > 2 * counted_ + kFew : awake != counted_ || bounds.usedCount() != all_) {
        counted_ = awake;
        all_ = bounds.usedCount();
        std::size_t moving = 0;
        for (const std::uint32_t body : bodies.awake) {
            moving += bounds.countOf(body);
        }
        const std::size_t still = all_ - moving;
        hasTree_ = still >= kFew && still >= moving;
    }
    if (!hasTree_) {
        built_ = false;
    } else if (built_) {
        followAwake(bodies, bounds);
    } else {
        rebuild(bodies, bounds);
        built_ = true;
    }
    return hasTree_;
}

/// Moves the bodies that have become active or inactive.
void StillParts::followAwake(const Bodies& bodies, const PartBounds& bounds) {
    if (active_ == bodies.awake) {
        return;
    }
    // Both lists are in order: visits what is in one of them alone.
    auto was = active_.begin();
    for (const std::uint32_t body : bodies.awake) {
        for (; was != active_.end() && *was < body; ++was) {
            stop(bodies, bounds, *was);
        }
        if (was != active_.end() && *was == body) {
            ++was;
        } else {
            removePlanes(body);
        }
    }
    std::for_each(was, active_.end(), [&](std::uint32_t body) { stop(bodies, bounds, body); });
    active_ = bodies.awake;
}

void StillParts::rebuild(const Bodies& bodies, const PartBounds& bounds) {
    planes_.clear();
    std::vector<BoundsTree::Leaf> leaves;
    bounds.listBodies(listed_);
    for (const std::uint32_t body : listed_) {
        const std::uint32_t count = bounds.countOf(body);
        if (isAwake(bodies, body)) {
            continue;
        }
        if (hasPlane(bodies, body)) {
            planes_.push_back(body);
            continue;
        }
        for (std::uint16_t part = 0; part < count; ++part) {
            leaves.push_back({bounds.grown()[bounds.indexOf(body, part)].box(), body, part});
        }
    }
    parts_.build(leaves, bounds.capacity(), bodies.record.capacity());
    active_ = bodies.awake;
}

/// Puts the parts of a changed body where they belong now.
void StillParts::place(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body) {
    parts_.remove(body);
    removePlanes(body);
    if (body < bodies.size() && bodies.ids.aliveAt(body) && !isAwake(bodies, body)) {
        insert(bodies, bounds, body);
    }
}

/// Puts the parts of a body that has become inactive into the tree, unless they are within the
/// leaves that it has kept.
void StillParts::stop(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body) {
    const auto isInside = [&](const Aabb& leaf, std::size_t part) {
        const auto i = bounds.indexOf(body, static_cast<std::uint16_t>(part));
        return leaf.contains(bounds.grown()[i].box());
    };
    const bool alive = body < bodies.size() && bodies.ids.aliveAt(body);
    if (!alive || !parts_.fits(body, bounds.countOf(body), isInside)) {
        place(bodies, bounds, body);
    }
}

void StillParts::insert(const Bodies& bodies, const PartBounds& bounds, std::uint32_t body) {
    if (hasPlane(bodies, body)) {
        planes_.insert(std::lower_bound(planes_.begin(), planes_.end(), body), body);
        return;
    }
    for (std::uint16_t part = 0; part < bounds.countOf(body); ++part) {
        const Aabb box = bounds.grown()[bounds.indexOf(body, part)].box();
        const Vec2 size = box.upper - box.lower;
        parts_.insert({box.grown(kSpare * (size.x + size.y)), body, part});
    }
}

void StillParts::removePlanes(std::uint32_t body) {
    const auto at = std::lower_bound(planes_.begin(), planes_.end(), body);
    if (at != planes_.end() && *at == body) {
        planes_.erase(at);
    }
}

void StillParts::listOthers(const Bodies& bodies, const PartBounds& bounds,
                            std::vector<std::uint32_t>& parts) {
    parts.clear();
    const auto add = [&](std::uint32_t body) {
        const std::uint32_t first = bounds.indexOf(body, 0);
        for (std::uint32_t i = 0; i < bounds.countOf(body); ++i) {
            parts.push_back(first + i);
        }
    };
    if (!hasTree_) {
        bounds.listBodies(listed_);
        std::for_each(listed_.begin(), listed_.end(), add);
        return;
    }
    std::for_each(bodies.awake.begin(), bodies.awake.end(), add);
    std::for_each(planes_.begin(), planes_.end(), add);
    const std::size_t moving = parts.size();
    for (const std::uint32_t i : bounds.changed()) {
        if (!isAwake(bodies, bounds.part(i).body)) {
            parts.push_back(i);
        }
    }
    const auto before = [&](std::uint32_t i, std::uint32_t k) {
        return bounds.rank(i) < bounds.rank(k);
    };
    if (planes_.empty() && parts.size() <= moving + kFewToInsert) {
        for (std::size_t k = moving; k < parts.size(); ++k) {
            const auto end = parts.begin() + static_cast<std::ptrdiff_t>(k);
            std::rotate(std::lower_bound(parts.begin(), end, parts[k], before), end, end + 1);
        }
    } else {
        std::sort(parts.begin(), parts.end(), before); // total order: equal indices are identical
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    }
}

bool MovingParts::gather(const PartBounds& all) {
    bounds.resize(parts.size());
    isChanged.resize(parts.size());
    changed.clear();
    changed.reserve(parts.capacity());
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
        bounds[k] = all.grown()[parts[k]];
        isChanged[k] = all.isChanged()[parts[k]];
        if (isChanged[k] != 0) {
            changed.push_back(k);
        }
    }
    const bool others = parts != before;
    if (others) {
        before = parts;
    }
    return others;
}

} // namespace KODO_PRECISION
} // namespace kodo
