// SPDX-License-Identifier: MIT
#pragma once

#include "broad/bounds_pair.hpp"
#include "math/octagon.hpp"

#include <algorithm>

namespace kodo {

/// The pair search of the thesis, as a witness for that of the engine: sorts bounds by their lower
/// ends along one axis, and tests only pairs whose projections overlap [Thesis06, 5.1]. Up to a
/// threshold it tests all pairs instead [Thesis06, 5.1.3].
///
/// Order and axis persist across calls, which makes sorting cheap while little moves.
class SweepAndPrune {
public:
    explicit SweepAndPrune(std::size_t threshold = 0) : threshold_(threshold) {}

    /// All overlapping pairs, in order.
    std::vector<BoundsPair> pairs(std::span<const Octagon> bounds) {
        std::vector<BoundsPair> found;
        tests_ = 0;
        const auto test = [&](std::uint32_t i, std::uint32_t j) {
            ++tests_;
            if (overlap(bounds[i], bounds[j])) {
                found.push_back({std::min(i, j), std::max(i, j)});
            }
        };
        if (bounds.size() <= threshold_) {
            for (std::uint32_t i = 0; i < bounds.size(); ++i) {
                for (std::uint32_t j = i + 1; j < bounds.size(); ++j) {
                    test(i, j);
                }
            }
            return found;
        }
        sort(bounds);
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const Entry& e = entries_[i];
            for (std::size_t j = i + 1; j < entries_.size() && entries_[j].low <= e.high; ++j) {
                test(e.index, entries_[j].index);
            }
        }
        std::sort(found.begin(), found.end()); // total order: pairs are distinct
        return found;
    }

    /// Pairs that the last call tested.
    std::size_t testCount() const { return tests_; }
    /// True if the last call had to sort all.
    bool hasSortedAll() const { return sortedAll_; }
    bool alongX() const { return alongX_; }

private:
    static constexpr std::uint32_t kAxisInterval = 64;  // calls between two choices of the axis
    static constexpr std::size_t kShiftsPerBounds = 16; // beyond, a full sort is faster
    static constexpr Real kWorthSwapping = Real(1.25);  // ratio of occupied cells

    struct Entry {
        Real low;
        Real high;
        std::uint32_t index;

        /// A total order.
        friend bool operator<(const Entry& a, const Entry& b) {
            return a.low < b.low || (a.low == b.low && a.index < b.index);
        }
    };

    void sort(std::span<const Octagon> bounds) {
        sortedAll_ = entries_.size() != bounds.size();
        if (sortedAll_) {
            entries_.resize(bounds.size());
            for (std::size_t i = 0; i < bounds.size(); ++i) {
                entries_[i].index = static_cast<std::uint32_t>(i);
            }
            calls_ = 0;
        }
        if (!bounds.empty() && calls_++ % kAxisInterval == 0) {
            sortedAll_ = chooseAxis(bounds) || sortedAll_;
        }
        const int axis = alongX_ ? 0 : 1;
        for (Entry& e : entries_) {
            e.low = bounds[e.index].lower[axis];
            e.high = bounds[e.index].upper[axis];
        }
        sortedAll_ = sortedAll_ || !insertAll();
        if (sortedAll_) {
            std::sort(entries_.begin(), entries_.end());
        }
    }

    /// Insertion sort: linear for a nearly sorted list. False if it was stopped, with the list
    /// unsorted.
    bool insertAll() {
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
        return shifted <= most;
    }

    /// Divides both axes into as many cells as there are bounds and counts the cells in which an
    /// interval begins or ends. The axis with more occupied cells separates the bounds better
    /// [Thesis06, 5.1.1]. True if the axis has changed.
    bool chooseAxis(std::span<const Octagon> bounds) {
        Octagon all = bounds[0];
        for (const Octagon& each : bounds) {
            all = unite(all, each);
        }
        const auto tagged = [&](int axis) {
            std::vector<bool> cells(bounds.size(), false);
            const Real length = std::max(all.upper[axis] - all.lower[axis], Real(1e-30));
            for (const Octagon& each : bounds) {
                for (const Real at : {each.lower[axis], each.upper[axis]}) {
                    const Real cell =
                        (at - all.lower[axis]) * (static_cast<Real>(bounds.size()) / length);
                    cells[std::min(static_cast<std::size_t>(cell), cells.size() - 1)] = true;
                }
            }
            return static_cast<Real>(std::count(cells.begin(), cells.end(), true));
        };
        const Real now = tagged(alongX_ ? 0 : 1);
        const Real other = tagged(alongX_ ? 1 : 0);
        if (other <= kWorthSwapping * now) {
            return false;
        }
        alongX_ = !alongX_;
        return true;
    }

    std::size_t threshold_;
    std::vector<Entry> entries_;
    std::size_t tests_ = 0;
    std::uint32_t calls_ = 0;
    bool sortedAll_ = false;
    bool alongX_ = true;
};

} // namespace kodo
