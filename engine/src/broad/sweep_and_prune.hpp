// SPDX-License-Identifier: MIT
#pragma once

#include "broad/broad_phase.hpp"

#include <cstddef>

namespace kodo {
inline namespace KODO_PRECISION {

/// Sorts bounds by their lower ends along one axis, and tests only pairs whose projections overlap
/// [Thesis06, 5.1].
///
/// Order and axis persist across calls, which makes sorting cheap while little moves. They affect
/// time only, not the pairs found.
class SweepAndPrune {
public:
    /// Appends each overlapping pair with at least one moved member for which `accept(first,
    /// second)` is true, once, in unspecified order.
    template <typename Accept>
    void pairs(std::span<const Octagon> bounds, const Moved& moved, Accept accept,
               std::vector<BoundsPair>& out) {
        work_ = {};
        sort(bounds);
        tests_ = 0;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const Entry& e = entries_[i];
            for (std::size_t j = i + 1; j < entries_.size() && entries_[j].low <= e.high; ++j) {
                ++tests_;
                const BoundsPair pair = e.index < entries_[j].index
                                            ? BoundsPair{e.index, entries_[j].index}
                                            : BoundsPair{entries_[j].index, e.index};
                if ((moved.has(pair.first) || moved.has(pair.second)) &&
                    overlap(bounds[pair.first], bounds[pair.second]) &&
                    accept(pair.first, pair.second)) {
                    out.push_back(pair);
                }
            }
        }
        work_.addSwept(tests_);
    }

    /// Reserves memory for that many bounds.
    void reserve(std::size_t bounds) {
        entries_.reserve(bounds);
        cells_.reserve(bounds);
    }

    /// Pairs whose projections overlapped in the last call.
    std::size_t testCount() const { return tests_; } // for tests
    PairWork work() const { return work_; }          // of the last call
    bool alongX() const { return alongX_; }          // for tests

private:
    struct Entry {
        Real low;
        Real high;
        std::uint32_t index;

        /// A total order.
        friend bool operator<(const Entry& a, const Entry& b) {
            return a.low < b.low || (a.low == b.low && a.index < b.index);
        }
    };

    void sort(std::span<const Octagon> bounds);
    bool insertAll();
    void sortAll();
    bool chooseAxis(std::span<const Octagon> bounds);

    std::vector<Entry> entries_;
    std::vector<bool> cells_;
    std::size_t tests_ = 0;
    PairWork work_;
    std::uint32_t calls_ = 0;
    bool alongX_ = true;
};

} // namespace KODO_PRECISION
} // namespace kodo
