// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <numbers>

namespace kodo::inline KODO_PRECISION {

/// A spring and a damper as a solver of impulses wants them [Catto11]: the rate at which an error
/// is removed (1/s), the share of the rigid impulse to apply, and the share of the impulse so far
/// to take back.
///
///   impulse = -mass_scale m (speed + bias_rate error) - impulse_scale impulse_sum
struct Softness {
    Real biasRate = 0;
    Real massScale = 1;
    Real impulseScale = 0;

    /// Like a mass on a spring of that frequency (Hz) and damping ratio (1: critical), implicit
    /// over h seconds and therefore stable for any of them.
    static Softness from(Real hertz, Real damping, Real h) {
        const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
        const Real a1 = 2 * damping + h * omega;
        const Real a2 = h * omega * a1;
        const Real a3 = 1 / (1 + a2);
        return {omega / a1, a2 * a3, a3};
    }
    /// Removes the whole error within h.
    static Softness rigid(Real h) { return {1 / h, 1, 0}; }
};

} // namespace kodo::inline KODO_PRECISION
