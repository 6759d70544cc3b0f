// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

/// Limits of friction and of rolling resistance, the same in all solvers. Number is Real, or Lanes
/// for several contacts at once; every function is inlined, as lanes.hpp requires.
namespace kodo {
inline namespace KODO_PRECISION {

/// The value nearest to `wanted` between -limit and limit.
template <typename Number>
[[gnu::always_inline]] inline Number within(Number limit, Number wanted) {
    const Number below = wanted < limit ? wanted : limit;
    return below > -limit ? below : -limit;
}

/// The friction rule with one coefficient: |j| <= mu load. `stopping` is the impulse that stops all
/// sliding (N s).
template <typename Number>
[[gnu::always_inline]] inline Number frictionImpulse(Number coefficient, Number load,
                                                     Number stopping) {
    return within<Number>(coefficient * load, stopping);
}

/// What limits the friction of a contact.
template <typename Number>
struct FrictionLimits {
    Number staticCoefficient;
    Number kineticCoefficient;
    Number load;  // N s, sum of the normal impulses
    Number reach; // >= 1; a contact that slides sticks again with 1 alone
};

template <typename Number>
struct FrictionAnswer {
    Number impulse;                       // N s
    Number coefficient;                   // the one that limits the impulse
    decltype(Number{} < Number{}) slides; // with a kinetic coefficient below the static one
};

/// The friction rule where the static coefficient may exceed the kinetic one:
///
///   |stopping| <= reach mu_s load:  the contact sticks,  |j| <= mu_s load
///   else:                        it slides,           |j| <= mu_k load
///
/// What happens at once, as the push of a belt that changes its speed once a step, is shared by the
/// substeps that are left: `reach` is their number.
template <typename Number>
[[gnu::always_inline]] inline FrictionAnswer<Number>
frictionImpulse(const FrictionLimits<Number>& is, Number stopping) {
    const Number hold = is.staticCoefficient * is.load;
    const decltype(Number{} < Number{}) slides =
        ((stopping < Number{} ? -stopping : stopping) > is.reach * hold) & (is.load > Number{}) &
        (is.kineticCoefficient < is.staticCoefficient);
    const Number coefficient = slides ? is.kineticCoefficient : is.staticCoefficient;
    return {frictionImpulse<Number>(coefficient, is.load, stopping), coefficient, slides};
}

} // namespace KODO_PRECISION
} // namespace kodo
