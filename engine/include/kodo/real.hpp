// SPDX-License-Identifier: MIT
#pragma once

#if __cplusplus < 202002L
#error "Kodo needs C++20 or newer: compile with -std=c++20"
#endif

#include <kodo/export.hpp>

#include <cfloat>

// -ffast-math and its parts let the compiler reorder sums, multiply by reciprocals, or take no
// number for infinite: results would differ between builds. g++ announces each part by a macro.
// Clang announces -ffast-math and -ffinite-math-only; the other parts change FLT_EVAL_METHOD since
// clang 15, and are noticed at the start of the program before (below).
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "Kodo gives the same bits on every machine: build without -ffast-math and its parts"
#endif

// kodo::kodo computes in float, kodo::kodo64 in double, from the same sources. Each has an inline
// namespace of its own, so one program can link both, from different source files. With
// -D_GLIBCXX_DEBUG containers have other sizes, so that the linker must refuse a library that was
// built without it: its name then says why.
#if defined(KODO_DOUBLE) && defined(_GLIBCXX_DEBUG)
#define KODO_PRECISION f64_glibcxx_debug
#elif defined(KODO_DOUBLE)
#define KODO_PRECISION f64
#elif defined(_GLIBCXX_DEBUG)
#define KODO_PRECISION f32_glibcxx_debug
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

// Numbers that the compiler may not compute with in advance.
inline const volatile Real kBig = Real(1e30);
inline const volatile Real kFive = 5;

/// Throws std::runtime_error unless the numbers are what IEEE 754 makes of (kBig + 1) - kBig, which
/// is 0, and of kFive / 49. Also if the processor does not round to nearest or flushes subnormal
/// numbers to 0.
KODO_API bool requireExactArithmetic(Real sum, Real quotient);

#if defined(__clang__) && __clang_major__ < 15 // checks the flags of each file that includes this
[[maybe_unused]] static const bool kExactArithmetic = [] {
    const Real big = kBig;
    return requireExactArithmetic((big + 1) - big, kFive / 49);
}();
#endif

} // namespace detail

} // namespace KODO_PRECISION
} // namespace kodo
