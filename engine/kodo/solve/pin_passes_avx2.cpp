// SPDX-License-Identifier: MIT
// Compiled with -mavx2 where the compiler aims at x86-64, and for nothing in particular elsewhere.
#include <kodo/solve/pin_passes.inl>

namespace kodo::inline KODO_PRECISION {

const PinPasses* PinPasses::avx2() {
#ifdef __AVX2__
    static constexpr PinPasses kPasses = pinPassesNamed("AVX2");
    return __builtin_cpu_supports("avx2") ? &kPasses : nullptr;
#else
    return nullptr;
#endif
}

} // namespace kodo::inline KODO_PRECISION
