// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstddef>
#include <cstdint>

namespace kodo {
inline namespace KODO_PRECISION {

/// A permutation of `count` elements: a stride coprime to the count, from a varying start. A new
/// one in every pass favours no side of a pile [Thesis06, 4.2.2.3]. It takes two remainders and no
/// storage. The thesis picks from a list of primes, which cannot step backwards.
///
/// Start and stride follow from `pass` alone. If the steps of a World number its passes, a copy or
/// a replay has the same orders.
class StrideOrder {
public:
    StrideOrder(std::size_t count, std::uint64_t pass);

    /// The next place, 0 to count - 1; starts over after `count` calls. Requires count > 0.
    std::size_t next() {
        const std::size_t place = at_;
        at_ = at_ < count_ - stride_ ? at_ + stride_ : at_ - (count_ - stride_);
        return place;
    }
    std::size_t stride() const { return stride_; } // 1 to count - 1, or 1; for tests

private:
    std::size_t count_;
    std::size_t at_ = 0;
    std::size_t stride_ = 1;
};

} // namespace KODO_PRECISION
} // namespace kodo
