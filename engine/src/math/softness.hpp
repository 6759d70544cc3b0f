// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <numbers>

namespace kodo {
inline namespace KODO_PRECISION {

/// Soft constraint: coefficients of a spring and a damper for an impulse solver [Catto11].
/// `biasRate` (1/s) is the rate of error removal. `massScale` scales the rigid impulse.
/// `impulseScale` is the fraction of the accumulated impulse that is taken back.
///
///   impulse = -mass_scale m (speed + bias_rate error) - impulse_scale impulse_sum
struct Softness {
    Real biasRate = 0;
    Real massScale = 1;
    Real impulseScale = 0;

    /// Equivalent to a mass on a spring of that frequency (Hz) and damping ratio (1: critical).
    /// Implicit over h (s), so it is stable for any values.
    static Softness from(Real hertz, Real damping, Real h) {
        const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
        const Real a1 = 2 * damping + h * omega;
        const Real a2 = h * omega * a1;
        const Real a3 = 1 / (1 + a2);
        return {omega / a1, a2 * a3, a3};
    }
    /// Removes the whole error within h (s).
    static Softness rigid(Real h) { return {1 / h, 1, 0}; }
};

} // namespace KODO_PRECISION
} // namespace kodo
