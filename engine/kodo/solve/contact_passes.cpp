// SPDX-License-Identifier: MIT
#include <kodo/solve/contact_passes.inl>

namespace kodo::inline KODO_PRECISION {

const ContactPasses& ContactPasses::baseline() {
    static constexpr ContactPasses kPasses{"baseline",
                                           warmStartBlocks,
                                           solveBlocks<Task::Push>,
                                           solveBlocks<Task::Settle>,
                                           solveBlocks<Task::Relax>,
                                           carryBlocks};
    return kPasses;
}

const ContactPasses& ContactPasses::best() {
    static const ContactPasses& kBest = avx2() != nullptr ? *avx2() : baseline();
    return kBest;
}

} // namespace kodo::inline KODO_PRECISION
