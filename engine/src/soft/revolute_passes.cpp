// SPDX-License-Identifier: MIT
#include "soft/revolute_passes.inl"

namespace kodo {
inline namespace KODO_PRECISION {

const RevolutePasses& RevolutePasses::baseline() {
    static constexpr RevolutePasses kPasses = revolutePassesNamed("baseline");
    return kPasses;
}

const RevolutePasses& RevolutePasses::best() {
    static const RevolutePasses& kBest = avx2() != nullptr ? *avx2() : baseline();
    return kBest;
}

} // namespace KODO_PRECISION
} // namespace kodo
