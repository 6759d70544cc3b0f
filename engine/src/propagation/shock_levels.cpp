// SPDX-License-Identifier: MIT
#include "propagation/shock_levels.hpp"

#include "base/vector_reuse.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kReached = ShockLevels::kUnreached - 1; // supported, without a level yet
constexpr std::uint32_t kDone = ~std::uint32_t{};               // its level is final

} // namespace

/// Counting sort by lower body.
void ShockLevels::groupByLower(std::uint32_t bodyCount, std::span<const SupportEdge> edges) {
    assignReusing(first_, std::size_t{bodyCount} + 1, 0u);
    for (const SupportEdge& edge : edges) {
        ++first_[edge.lower + 1];
    }
    for (std::size_t body = 0; body < bodyCount; ++body) {
        first_[body + 1] += first_[body];
    }
    waiting_.resize(bodyCount); // here: the place of the next upper body
    std::copy(first_.begin(), first_.end() - 1, waiting_.begin());
    uppers_.resize(edges.size());
    for (const SupportEdge& edge : edges) {
        uppers_[waiting_[edge.lower]++] = edge.upper;
    }
}

/// Breadth-first search over all bodies that the ground supports; counts the supports of each.
void ShockLevels::reach(std::span<const std::uint32_t> immovable) {
    assignReusing(levels_, waiting_.size(), kUnreached);
    assignReusing(waiting_, waiting_.size(), 0u);
    order_.clear();
    for (const std::uint32_t body : immovable) {
        levels_[body] = 0;
        order_.push_back(body);
    }
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const std::uint32_t lower = order_[i];
        for (std::uint32_t k = first_[lower]; k < first_[lower + 1]; ++k) {
            const std::uint32_t upper = uppers_[k];
            if (levels_[upper] == kUnreached) {
                levels_[upper] = kReached;
                order_.push_back(upper);
            }
            ++waiting_[upper];
        }
    }
}

/// A body gets its level once all its supports have theirs. If none can, some bodies form a cycle:
/// then the first in breadth-first order is next.
void ShockLevels::assignLevels() {
    queue_.clear();
    for (const std::uint32_t first : order_) {
        if (waiting_[first] == kDone) {
            continue;
        }
        waiting_[first] = kDone;
        queue_.push_back(first);
        while (!queue_.empty()) {
            const std::uint32_t lower = queue_.back();
            queue_.pop_back();
            for (std::uint32_t k = first_[lower]; k < first_[lower + 1]; ++k) {
                const std::uint32_t upper = uppers_[k];
                if (waiting_[upper] == kDone || levels_[upper] == 0) {
                    continue;
                }
                const std::uint32_t next = levels_[lower] + 1;
                levels_[upper] = levels_[upper] == kReached ? next : std::max(levels_[upper], next);
                if (--waiting_[upper] == 0) {
                    waiting_[upper] = kDone;
                    queue_.push_back(upper);
                }
            }
        }
    }
}

std::span<const std::uint32_t> ShockLevels::find(std::uint32_t bodyCount,
                                                 std::span<const std::uint32_t> immovable,
                                                 std::span<const SupportEdge> edges) {
    for (std::vector<std::uint32_t>* list : {&first_, &waiting_, &levels_, &order_, &queue_}) {
        reserveReusing(*list, std::size_t{bodyCount} + 1);
    }
    reserveReusing(uppers_, edges.size());
    groupByLower(bodyCount, edges);
    reach(immovable);
    assignLevels();
    return levels_;
}

} // namespace KODO_PRECISION
} // namespace kodo
