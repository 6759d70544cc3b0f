// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>

#ifdef __FAST_MATH__
#error "Kodo promises the same bits on every machine; build without -ffast-math"
#endif

// One set of sources, two libraries: kodo::kodo computes in float, kodo::kodo64 in double. Each has
// its own inline namespace, so that one program may link both (in different source files).
#ifdef KODO_DOUBLE
#define KODO_PRECISION f64
#else
#define KODO_PRECISION f32
#endif

namespace kodo::inline KODO_PRECISION {

static_assert(FLT_EVAL_METHOD == 0, "x87 arithmetic rounds differently; use SSE2 or better");

/// The number that the engine computes in. SI units throughout.
#ifdef KODO_DOUBLE
using Real = double;
#else
using Real = float;
#endif

} // namespace kodo::inline KODO_PRECISION
