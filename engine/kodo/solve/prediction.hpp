// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact.hpp>

#include <array>

namespace kodo::inline KODO_PRECISION {

/// What contacts are predicted by, for one part of a step.
struct Prediction {
    const Tolerances& tolerances;
    Real h;     // s, the length of the part
    bool swept; // a sweep catches what is too fast
    bool fresh; // the manifolds are those of the start of the part
};

/// Finds a contact where its bodies would be after h if nothing stopped them [Thesis06, 4.2.2.1],
/// and returns how far apart its points are now (m). What hardly moves keeps a fresh manifold,
/// moved along to first order. What moves so fast that it could come out on the far side is found
/// where it is now, if it is swept, and so is what meets a line. The fastest approach goes into the
/// contact's record.
std::array<Real, 2> predictContact(Contact& contact, const Bodies& bodies,
                                   const Prediction& prediction);

} // namespace kodo::inline KODO_PRECISION
