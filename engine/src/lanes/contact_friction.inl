// SPDX-License-Identifier: MIT
// Included by contact_passes.inl, whose first lines hold here too: both points of a contact and
// friction at once, and the limits of friction.
#include "math/friction.hpp"

#include <limits>

#include "lanes/contact_lanes.inl"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Impulse before clamping, from the velocities before the impulses of this visit.
struct Unclamped {
    Lanes impulse; // N s
    Lanes mass;    // kg; decrease of the impulse per m/s that other impulses add along the line
    decltype(Lanes{} > Lanes{}) pushes; // its bodies apart, or in the relax pass any
};

/// Impulse of the first of two points before clamping, such that sequential clamping of both points
/// solves both at once. With d = lambda' - lambda,
///
///   d1 + c21 d2 = e1,  c12 d1 + d2 = e2
///
/// e is the change of one point alone; c are the couplings. If the second point would pull, it is
/// let go, and the first carries all. If the bodies hardly rotate, both points act as one. Without
/// this, bodies that are pushed apart get a rotation, which stays with them.
KODO_LANES_INLINE Lanes firstOfBoth(const ContactBlock& block, int at, const Unclamped& first,
                                    const Unclamped& second, Lanes response12) {
    const Lanes before2 = load(block.points[1].impulse + at);
    const Lanes c12 = second.mass * response12;
    const Lanes c21 = first.mass * response12;
    const Lanes determinant = all(1) - c12 * c21;
    const Lanes e1 = first.impulse - load(block.points[0].impulse + at);
    const Lanes e2 = second.impulse - before2;
    const auto coupled = determinant < all(Real(1e-3));
    const Lanes d2 = (e2 - c12 * e1) / (coupled ? all(1) : determinant);
    const Lanes both =
        before2 + d2 > Lanes{} ? first.impulse - c21 * d2 : first.impulse + c21 * before2;
    return coupled | ~(first.pushes | second.pushes) ? first.impulse : both;
}

constexpr Real kLeastMass = std::numeric_limits<Real>::min(); // kg

/// Effect of the impulses of a contact on each other.
struct Couplings {
    Lanes response12; // m/s per N s, from one point to the other
    Lanes first;      // m_t k_1t: decrease of `stopping` per N s at the first point
    Lanes second;
    Lanes mass;     // m_t, kg
    Lanes stopping; // N s, friction that stops all sliding without change of the points
};

/// Impulses of both points of a contact before clamping.
struct Together {
    Lanes first; // N s
    Lanes second;
    decltype(Lanes{} > Lanes{}) sticks; // `second` is valid: it takes account of friction
};

/// Solves both points and friction at once, so that a box on a slope sticks in the first substep.
/// With d = lambda' - lambda, e_i the change of point i alone, and the tangent t,
///
///   d_i = e_i - m_i (sum_(k != i) k_ik d_k + k_it d_t),  d_t = e_t - m_t (k_1t d_1 + k_2t d_2)
///
/// Eliminating d_t leaves two equations with k'_ik = k_ik - m_t k_it k_kt. Valid where no impulse
/// exceeds its limit.
KODO_LANES_INLINE Together sticking(const ContactBlock& block, int at, const Unclamped& first,
                                    const Unclamped& second, const Couplings& by) {
    const Lanes before1 = load(block.points[0].impulse + at);
    const Lanes before2 = load(block.points[1].impulse + at);
    const Lanes et = by.stopping - load(block.friction + at);
    const Lanes over = all(1) / larger(by.mass, all(kLeastMass));
    const Lanes k1t = by.first * over;
    const Lanes k2t = by.second * over;
    const Lanes a11 = all(1) - first.mass * by.first * k1t;
    const Lanes a12 = first.mass * (by.response12 - by.first * k2t);
    const Lanes a21 = second.mass * (by.response12 - by.first * k2t);
    const Lanes a22 = all(1) - second.mass * by.second * k2t;
    const Lanes r1 = (first.impulse - before1) - first.mass * k1t * et;
    const Lanes r2 = (second.impulse - before2) - second.mass * k2t * et;
    const Lanes determinant = a11 * a22 - a12 * a21;
    const auto regular = determinant > all(Real(1e-3));
    const Lanes over2 = all(1) / (regular ? determinant : all(1));
    const Lanes d1 = (r1 * a22 - a12 * r2) * over2;
    const Lanes d2 = (a11 * r2 - a21 * r1) * over2;
    const Lanes next1 = before1 + d1;
    const Lanes next2 = before2 + d2;
    const Lanes friction = by.stopping - by.first * d1 - by.second * d2;
    const Lanes holds = load(block.staticFriction + at);            // < 0: it slides
    const auto isUnlike = load(block.kineticFriction + at) < holds; // other lanes are as if alone
    const Lanes most = holds * (next1 + next2);
    return {next1, next2,
            regular & isUnlike & (next1 > Lanes{}) & (next2 > Lanes{}) &
                (larger(friction, -friction) < most)};
}

/// Unclamped impulses of a contact, in the relax pass of two points such that they suit each other.
template <bool both, bool stiction>
KODO_LANES_INLINE Together together(const ContactBlock& block, int at, const Unclamped& first,
                                    const Unclamped& second, const Couplings& by) {
    Together wanted{first.impulse, {}, {}};
    if constexpr (both) {
        wanted.first = firstOfBoth(block, at, first, second, by.response12);
    }
    if constexpr (both && stiction) {
        const Together stuck = sticking(block, at, first, second, by);
        wanted = {stuck.sticks ? stuck.first : wanted.first, stuck.second, stuck.sticks};
    }
    return wanted;
}

/// Both points share one friction impulse. `stopping` is the impulse that stops all sliding (N s),
/// `left` the number of substeps that are left. If a block is not `stiction`, its static
/// coefficients are the kinetic ones. Returns the change (N s).
template <bool stiction>
KODO_LANES_INLINE Lanes applyFriction(ContactBlock& block, int at, Lanes stopping, Lanes pressed,
                                      Real left) {
    const Lanes friction = load(block.friction + at);
    const Lanes kinetic = load(block.kineticFriction + at);
    Lanes next;
    if constexpr (stiction) {
        const Lanes known = load(block.staticFriction + at); // < 0: it slides
        const Lanes coefficient = larger(known, -known);
        const Lanes reach = known < Lanes{} ? all(1) : all(left);
        const auto answer =
            frictionImpulse<Lanes>({coefficient, kinetic, pressed, reach}, stopping);
        next = answer.impulse;
        store(block.staticFriction + at, answer.slides ? -coefficient : coefficient);
    } else {
        next = frictionImpulse<Lanes>(kinetic, pressed, stopping);
    }
    store(block.friction + at, next);
    return next - friction;
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
