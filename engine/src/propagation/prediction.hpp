// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"

#include <array>

#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Inputs for the prediction of contacts in one substep.
struct Prediction {
    const Tolerances& tolerances;
    Real h;     // s, length of the substep
    bool swept; // continuous collision stops bodies that are too fast
    bool fresh; // manifolds are those of the start of the substep
};

/// Computes a contact at the poses that its bodies would have after h without contacts [Thesis06,
/// 4.2.2.1]. Returns the current separations of its points (m).
///
/// A slow pair, or one that forces part, keeps a fresh manifold, advanced to first order. A pair
/// that is fast enough to tunnel is computed at its current poses if continuous collision stops it.
/// A pair with a segment always is. The fastest approach goes into the contact, for the record.
std::array<Real, 2> predictContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                                   const Prediction& prediction);

} // namespace KODO_PRECISION
} // namespace kodo
