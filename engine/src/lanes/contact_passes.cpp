// SPDX-License-Identifier: MIT
#include "lanes/contact_passes.inl"

namespace kodo {
inline namespace KODO_PRECISION {

const ContactPasses& ContactPasses::baseline() {
    static constexpr ContactPasses kPasses = passesNamed("baseline");
    return kPasses;
}

const ContactPasses& ContactPasses::best() {
    static const ContactPasses& kBest = avx2() != nullptr ? *avx2() : baseline();
    return kBest;
}

} // namespace KODO_PRECISION
} // namespace kodo
