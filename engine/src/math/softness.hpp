// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cmath>
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
    static constexpr Real kMostLag = 32;
    /// Further damping of a spring that a substep of h (s) cannot carry, see spring(); else 0.
    static Real springLag(Real h, Real bound) {
        constexpr Real kMostAngle = Real(0.5); // rad
        const Real most = h * h * bound / (kMostAngle * kMostAngle);
        return most > 1 ? most - 1 : 0;
    }
    /// A spring and a damper that act once in a substep of h (s), before bodies move. With q =
    /// omega h, the velocity v and the displacement x change to
    ///
    ///   v' = d (v - q omega x),  x' = x + h v',  1 / d = 1 + 2 damping q + O(q^2) + lag
    ///
    /// Without damping this is the symplectic step. It keeps the energy of an oscillation but for a
    /// ripple of q / 2. Its error is of second order, and it is stable for q < 2. `bound` (1/s^2):
    /// see SpringRates. Where its root exceeds half a radian in h, a further damping `lag` keeps
    /// the step stable. The extension under a constant force stays exact. A lag above kMostLag
    /// would couple too many springs for the passes of a substep, so the stiffness is reduced
    /// instead.
    static Softness spring(Real hertz, Real damping, Real h, Real bound, Real mostLag = kMostLag) {
        constexpr Real kLeast = Real(1e-9); // the stiffness is stored as rate times scale
        const Real full = springLag(h, bound);
        const Real lag = full < mostLag ? full : mostLag;
        const Real carried = (1 + lag) / (1 + full); // fraction of the stiffness
        const Real omega = 2 * std::numbers::pi_v<Real> * hertz * std::sqrt(carried);
        const Real loss = damping * h * omega;
        const Real under = damping < 1 ? 1 - damping * damping : 0; // decay of second order
        const Real lost = 2 * loss * (1 + under * loss) + lag;
        const Real kept = 1 / (1 + lost);
        const Real scale = lost * kept > kLeast ? lost * kept : kLeast;
        return {h * omega * omega * kept / scale, scale, kept};
    }
    /// Removes the whole error within h (s).
    static Softness rigid(Real h) { return {1 / h, 1, 0}; }
};

} // namespace KODO_PRECISION
} // namespace kodo
