// SPDX-License-Identifier: MIT
#include <kodo/real.hpp>

#include <limits>
#include <stdexcept>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

template <typename T>
bool keepsSubnormals() {
    const volatile T smallest = std::numeric_limits<T>::min();
    const volatile T half = smallest / 2;
    return half > 0 && half * 2 == smallest;
}

template <typename T>
bool roundsToNearest() {
    const volatile T one = 1;
    const volatile T quarter = std::numeric_limits<T>::epsilon() / 4;
    return one + quarter == one && one - quarter == one && -one - quarter == -one;
}

} // namespace

bool detail::requireExactArithmetic(Real sum, Real quotient) {
    if (!keepsSubnormals<Real>()) {
        throw std::runtime_error("Kodo gives the same bits on every machine: this thread flushes "
                                 "subnormal numbers to 0 (linked with -ffast-math or "
                                 "-funsafe-math-optimizations?)");
    }
    if (!roundsToNearest<Real>()) {
        throw std::runtime_error("Kodo gives the same bits on every machine: this thread does not "
                                 "round to nearest");
    }
    const volatile Real divisor = 49;
    const volatile Real exact = kFive / divisor;
    if (sum != 0 || quotient != exact) {
        throw std::runtime_error("Kodo gives the same bits on every machine: build without "
                                 "-ffast-math and its parts, as -funsafe-math-optimizations");
    }
    return true;
}

} // namespace KODO_PRECISION
} // namespace kodo
