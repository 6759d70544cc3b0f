// SPDX-License-Identifier: MIT
// Compiled with -mavx2 for x86-64, and without special options for other targets.
#include "lanes/contact_passes.inl"

namespace kodo {
inline namespace KODO_PRECISION {

const ContactPasses* ContactPasses::avx2() {
#ifdef __AVX2__
    static constexpr ContactPasses kPasses = passesNamed("AVX2");
    return __builtin_cpu_supports("avx2") ? &kPasses : nullptr;
#else
    return nullptr;
#endif
}

} // namespace KODO_PRECISION
} // namespace kodo
