// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

namespace kodo::inline KODO_PRECISION {

/// Distances (m) that follow from the length unit of a World: one number scales them all.
struct Tolerances {
    Real slop;   // closer than this counts as touching
    Real margin; // contacts are kept ready up to this gap
    Real grown;  // bounds are grown by this at most, so that they need not follow every move

    static constexpr Real kSlopsPerUnit = 256;

    constexpr Real unit() const { return kSlopsPerUnit * slop; } // m, exactly as it was given
    static constexpr Tolerances forUnit(Real unit) {
        return {1 / kSlopsPerUnit * unit, Real(1) / 64 * unit, Real(1) / 16 * unit};
    }
};

} // namespace kodo::inline KODO_PRECISION
