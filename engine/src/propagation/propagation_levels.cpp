// SPDX-License-Identifier: MIT
// Levels of the shock propagation: which rows the ground supports, and through how many bodies.
#include "base/vector_reuse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "propagation/propagation.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// A contact supports a body only if its normal has a larger share than this along the acceleration.
constexpr Real kSteepPull = Real(0.25);

} // namespace

void Propagation::makeRoom(const Bodies& bodies) {
    islands_.reserve(bodies.record.capacity());
    islands_.resize(bodies.size());
    resizeByBody(numbers_, bodies);
    resizeByBody(parting_, bodies);
    resizeByBody(exposure_, bodies);
    resizeByBody(node_, bodies);
    resizeByBody(levelOf_, bodies);
}

/// Finds the levels of all bodies with rows, and sorts the rows by the higher level of their
/// bodies. Rows between bodies without support from the ground are left out.
void Propagation::findLevels(const Bodies& bodies) {
    constexpr std::uint32_t kNoNode = ~std::uint32_t{};
    for (const PropagationRow& row : rows_) {
        node_[row.a] = node_[row.b] = kNoNode;
    }
    std::uint32_t nodes = 0;
    immovable_.clear();
    supports_.clear();
    reserveReusing(immovable_, 2 * rows_.size());
    reserveReusing(supports_, rows_.size());
    for (const PropagationRow& row : rows_) {
        for (const std::uint32_t body : {row.a, row.b}) {
            if (node_[body] == kNoNode) {
                node_[body] = nodes++;
                if (bodies.motion[body].invMass == 0) {
                    immovable_.push_back(node_[body]);
                }
            }
        }
        const Vec2 pull = bodies.acceleration[row.a].linear + bodies.acceleration[row.b].linear;
        const Real along = dot(row.normal, pull);
        if (std::abs(along) > kSteepPull * length(pull)) {
            supports_.push_back(along < 0 ? SupportEdge{node_[row.a], node_[row.b]}
                                          : SupportEdge{node_[row.b], node_[row.a]});
        }
    }
    const std::span<const std::uint32_t> found = levels_.find(nodes, immovable_, supports_);
    for (PropagationRow& row : rows_) {
        levelOf_[row.a] = found[node_[row.a]];
        levelOf_[row.b] = found[node_[row.b]];
        row.level = std::max(levelOf_[row.a], levelOf_[row.b]);
    }
    sortByLevel();
}

RowMasses Propagation::frozenMasses(const Bodies& bodies, const PropagationRow& row) const {
    return massesOf(bodies, row, levelOf_[row.a] < row.level, levelOf_[row.b] < row.level);
}

/// Lists the rows that the ground supports, by island and level.
void Propagation::sortByLevel() {
    byLevel_.clear();
    levelRows_.clear();
    reserveReusing(byLevel_, rows_.size());
    reserveReusing(levelRows_, rows_.size());
    std::uint32_t first = 0;
    for (const std::uint32_t end : rowEnds_) {
        const auto begin = static_cast<std::ptrdiff_t>(byLevel_.size());
        for (; first < end; ++first) {
            if (rows_[first].level != ShockLevels::kUnreached) {
                byLevel_.push_back(first);
            }
        }
        std::sort(byLevel_.begin() + begin, byLevel_.end(), // total order: indices are unique
                  [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(rows_[a].level, a) < std::pair(rows_[b].level, b);
                  });
        for (auto k = static_cast<std::uint32_t>(begin); k < byLevel_.size(); ++k) {
            const std::uint32_t level = rows_[byLevel_[k]].level;
            if (k == static_cast<std::uint32_t>(begin) || levelRows_.back().level != level) {
                levelRows_.push_back({k, k, level});
            }
            ++levelRows_.back().end;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
