// SPDX-License-Identifier: MIT
#include "broad/sweep_and_prune.hpp"

#include <algorithm>
#include <bit>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::uint32_t kAxisInterval = 64;  // calls between two choices of the axis
constexpr std::size_t kShiftsPerBounds = 16; // beyond, a full sort is faster
constexpr Real kWorthSwapping = Real(1.25);  // ratio of occupied cells at which the axis changes

} // namespace

/// Divides both axes into as many cells as there are bounds and counts the cells in which an
/// interval begins or ends. The axis with more occupied cells separates the bounds better
/// [Thesis06, 5.1.1]. True if the axis has changed and a full sort pays.
bool SweepAndPrune::chooseAxis(std::span<const Octagon> bounds) {
    Aabb all = bounds[0].box();
    for (const Octagon& each : bounds) {
        all = unite(all, each.box());
    }
    const auto tagged = [&](Real low, Real high, auto from, auto to) {
        cells_.assign(bounds.size(), false);
        const Real scale = static_cast<Real>(bounds.size()) / std::max(high - low, Real(1e-30));
        std::size_t count = 0;
        for (const Octagon& each : bounds) {
            const Aabb box = each.box();
            for (const Real at : {from(box), to(box)}) {
                const Real cell = (at - low) * scale;
                const std::size_t k = std::min(static_cast<std::size_t>(cell), cells_.size() - 1);
                count += cells_[k] ? 0u : 1u;
                cells_[k] = true;
            }
        }
        return count;
    };
    const std::size_t x = tagged(
        all.lower.x, all.upper.x, [](const Aabb& b) { return b.lower.x; },
        [](const Aabb& b) { return b.upper.x; });
    const std::size_t y = tagged(
        all.lower.y, all.upper.y, [](const Aabb& b) { return b.lower.y; },
        [](const Aabb& b) { return b.upper.y; });
    const std::size_t now = alongX_ ? x : y;
    const std::size_t other = alongX_ ? y : x;
    if (static_cast<Real>(other) <= kWorthSwapping * static_cast<Real>(now)) {
        return false;
    }
    alongX_ = !alongX_;
    return true;
}

void SweepAndPrune::sort(std::span<const Octagon> bounds) {
    bool unsorted = entries_.size() != bounds.size();
    if (unsorted) {
        entries_.resize(bounds.size());
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            entries_[i].index = static_cast<std::uint32_t>(i);
        }
        calls_ = 0;
    }
    if (!bounds.empty() && calls_++ % kAxisInterval == 0) {
        unsorted = chooseAxis(bounds) || unsorted;
    }
    for (Entry& e : entries_) {
        const Aabb box = bounds[e.index].box();
        e.low = alongX_ ? box.lower.x : box.lower.y;
        e.high = alongX_ ? box.upper.x : box.upper.y;
    }
    work_.addRefreshed(entries_.size());
    if (unsorted || !insertAll()) {
        sortAll();
    }
}

/// Insertion sort: linear for a nearly sorted list. False if it was stopped, with the list
/// unsorted.
bool SweepAndPrune::insertAll() {
    const std::size_t most = kShiftsPerBounds * entries_.size();
    std::size_t shifted = 0;
    for (std::size_t i = 1; i < entries_.size() && shifted <= most; ++i) {
        const Entry e = entries_[i];
        std::size_t j = i;
        for (; j > 0 && e < entries_[j - 1]; --j) {
            entries_[j] = entries_[j - 1];
        }
        entries_[j] = e;
        shifted += i - j;
    }
    work_.addShifted(shifted);
    return shifted <= most;
}

void SweepAndPrune::sortAll() {
    std::sort(entries_.begin(), entries_.end()); // total order
    work_.addSorted(entries_.size() * static_cast<std::size_t>(std::bit_width(entries_.size())));
}

} // namespace KODO_PRECISION
} // namespace kodo
