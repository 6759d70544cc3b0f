// SPDX-License-Identifier: MIT
#include <kodo/solve/pin_passes.inl>

namespace kodo::inline KODO_PRECISION {

const PinPasses& PinPasses::baseline() {
    static constexpr PinPasses kPasses = pinPassesNamed("baseline");
    return kPasses;
}

const PinPasses& PinPasses::best() {
    static const PinPasses& kBest = avx2() != nullptr ? *avx2() : baseline();
    return kBest;
}

} // namespace kodo::inline KODO_PRECISION
