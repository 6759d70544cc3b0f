// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cstddef>
#include <cstdint>

namespace kodo::inline KODO_PRECISION {

/// A way through `count` things that comes to each of them exactly once: a stride without a common
/// factor with the count, from a start of its own. A solver that takes a new one in every pass
/// favours no side of a pile [Thesis06, 4.2.2.3]. Two remainders to find, nothing to store; the
/// thesis picks from a list of primes, which cannot step backwards.
///
/// Start and stride follow from `pass` alone: number the passes of a World by its steps, and a copy
/// or a replay takes the same ways.
class StrideOrder {
public:
    StrideOrder(std::size_t count, std::uint64_t pass);

    /// The next place, 0 to count - 1; begins anew after `count` calls. Not to be called for count
    /// 0.
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

} // namespace kodo::inline KODO_PRECISION
