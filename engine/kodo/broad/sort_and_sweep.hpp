// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/broad/broad_phase.hpp>

#include <cstddef>

namespace kodo::inline KODO_PRECISION {

/// Sorts bounds along one axis and sweeps over them, so that only those whose projections overlap
/// are tested [Thesis06, 5.1].
///
/// It remembers the order and the axis from one call to the next, which makes sorting cheap while
/// little moves. Neither changes the pairs found, only the time it takes.
class SortAndSweep {
public:
    /// Every pair of overlapping bounds, of which at least one has moved, that
    /// `accept(first, second)` lets through, each once, in any order.
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

    /// Memory for so many bounds.
    void reserve(std::size_t bounds) {
        entries_.reserve(bounds);
        cells_.reserve(bounds);
    }

    /// Pairs whose projections overlapped in the last call: what it had to test.
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
    void sortAnew();
    bool chooseAxis(std::span<const Octagon> bounds);

    std::vector<Entry> entries_;
    std::vector<bool> cells_;
    std::size_t tests_ = 0;
    PairWork work_;
    std::uint32_t calls_ = 0;
    bool alongX_ = true;
};

} // namespace kodo::inline KODO_PRECISION
