// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/force_field.hpp>

#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"

#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Computes the accelerations of this step from fields and applied forces, and clears the forces
/// [Thesis06, 4.1.3]. Drag is integrated implicitly over dt, see FieldForce. False if an
/// acceleration is not finite.
bool gatherAccelerations(Bodies& bodies, std::span<const FieldEntry> fields, Real dt,
                         WorkerTeam& team);

/// Updates Bodies::loads. Call after a change of accelerations, masses or the awake list: see
/// BodyChanges::loadsStale.
void noteLoads(Bodies& bodies);

/// Clears the displacements of the last step. Marks the awake list as stale if a locked body has
/// stopped. Called from several threads.
void beginMotion(Bodies& bodies, std::span<const std::uint32_t> list);

/// Sets how a body moves by itself.
void setRules(Bodies& bodies, std::uint32_t body, const MotionRules& rules);

/// Damps the velocities over dt, exactly: v exp(-c dt). Before the forces of the step, so that a
/// body at rest on others presses on them with its whole weight.
void dampVelocities(Bodies& bodies, Real dt, WorkerTeam& team);

/// Constraints that may act on a body within a step.
enum class ContactExposure : std::uint8_t {
    Free,    // none: no contact, no joint
    Near,    // contacts that may begin to touch
    Touched, // a touching contact, or a joint
};

/// v += h a, for the bodies in the list.
void integrateVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);

/// x += h v, for the bodies in the list. A body without touching contacts follows the exact
/// parabola instead:
///
///   x(t + h) = x + h v_old + a h^2 / 2 = x + h v_new - a h^2 / 2
///
/// Free fall is then exact to rounding for any step. `holds`: by body.
void integrateMoves(Bodies& bodies, std::span<const std::uint32_t> list,
                    std::span<const ContactExposure> holds, Real h);

/// Both at once, for bodies without constraints.
void moveFreely(Bodies& bodies, std::span<const std::uint32_t> list, Real h);

/// Applies the displacements of the bodies in the list to their poses.
void movePoses(Bodies& bodies, std::span<const std::uint32_t> list);

} // namespace KODO_PRECISION
} // namespace kodo
