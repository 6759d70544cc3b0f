// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "collide/manifold.hpp"

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Removes the points of a manifold that move over a hilltop of a one-sided or jointed line before
/// they touch it, in a step of dt (s). With them, the straight extension of the line would lift a
/// shape whose last corner leaves a ramp. All points of sensors and round shapes are kept: the
/// next contact of a disc is the vertex. Likewise those of two parts thinner than the slop: without
/// its contact, such a part could pass the next line within the step.
///
/// Returns the relative displacement (m) up to which no other point comes to a hilltop: the
/// manifold must be found again then.
Real removePassingPoints(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                         const Tolerances& tolerances, Real dt);

} // namespace KODO_PRECISION
} // namespace kodo
