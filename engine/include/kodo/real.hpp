// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/export.hpp>

#include <cfloat>

// -ffast-math and its parts let the compiler reorder sums: results would differ between builds.
// g++ announces each part by a macro. Clang announces -ffast-math; its parts change FLT_EVAL_METHOD
// since clang 15, and are noticed at the start of the program before (below).
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "Kodo gives the same bits on every machine: build without -ffast-math and its parts"
#endif

// kodo::kodo computes in float, kodo::kodo64 in double, from the same sources. Each has an inline
// namespace of its own, so one program can link both, from different source files.
#ifdef KODO_DOUBLE
#define KODO_PRECISION f64
#else
#define KODO_PRECISION f32
#endif

namespace kodo {
inline namespace KODO_PRECISION {

static_assert(FLT_EVAL_METHOD == 0, "x87 arithmetic rounds differently: use SSE2 or newer");

/// The number type of the engine. All quantities are in SI units.
#ifdef KODO_DOUBLE
using Real = double;
#else
using Real = float;
#endif

namespace detail {

// A number that the compiler may not compute with in advance.
inline const volatile Real kBig = Real(1e30);

/// Throws std::runtime_error unless sum is what IEEE 754 makes of (kBig + 1) - kBig: 0. Also if the
/// processor does not round to nearest or flushes subnormal numbers to 0.
KODO_API bool requireExactArithmetic(Real sum);

#if defined(__clang__) && __clang_major__ < 15 // checks the flags of each file that includes this
[[maybe_unused]] static const bool kExactArithmetic = [] {
    const Real big = kBig;
    return requireExactArithmetic((big + 1) - big);
}();
#endif

} // namespace detail

} // namespace KODO_PRECISION
} // namespace kodo
