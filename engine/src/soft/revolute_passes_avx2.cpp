// SPDX-License-Identifier: MIT
// Compiled with -mavx2 for x86-64, and without special options for other targets.
#include "soft/revolute_passes.inl"

namespace kodo {
inline namespace KODO_PRECISION {

const RevolutePasses* RevolutePasses::avx2() {
#ifdef __AVX2__
    static constexpr RevolutePasses kPasses = revolutePassesNamed("AVX2");
    return __builtin_cpu_supports("avx2") ? &kPasses : nullptr;
#else
    return nullptr;
#endif
}

} // namespace KODO_PRECISION
} // namespace kodo
