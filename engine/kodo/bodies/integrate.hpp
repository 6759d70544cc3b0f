// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/force_field.hpp>
#include <kodo/bodies/tolerances.hpp>

#include <span>

namespace kodo::inline KODO_PRECISION {

/// The accelerations of this step, from the fields and from the forces that were applied since the
/// last one, which are then forgotten [Thesis06, 4.1.3]. Forces that brake are taken implicitly
/// over dt; see Push.
void gatherAccelerations(Bodies& bodies, std::span<const FieldEntry> fields, Real dt);

/// Forgets the motion of the last step.
void beginMotion(Bodies& bodies);

/// v += h a.
void integrateVelocities(Bodies& bodies, Real h);

/// move += h v. A body that nothing touches (held == 0) moves by the exact parabola instead,
///
///   x(t + h) = x + h v_old + a h^2 / 2 = x + h v_new - a h^2 / 2
///
/// so that free fall has no error but rounding, whatever the step.
void integrateMoves(Bodies& bodies, std::span<const std::uint8_t> held, Real h);

/// Puts every body where its motion has taken it.
void movePoses(Bodies& bodies);

} // namespace kodo::inline KODO_PRECISION
