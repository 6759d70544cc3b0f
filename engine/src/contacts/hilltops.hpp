// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "collide/manifold.hpp"
#include "contacts/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Removes the points of a manifold that move over a hilltop of a one-sided or jointed line before
/// they touch it, in a step of dt (s). With them, the straight extension of the line would lift a
/// shape whose last corner leaves a ramp. Sensors and round shapes keep all points: a disc meets
/// the vertex next. So do two parts thinner than the slop: what touches the next line after all
/// would be behind it at once.
///
/// Returns the relative displacement (m) up to which no other point comes to a hilltop: the
/// manifold must be found again then.
Real removePassingPoints(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                         const Tolerances& tolerances, Real dt);

} // namespace KODO_PRECISION
} // namespace kodo
