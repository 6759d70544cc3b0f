// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/bodies/force_field.hpp>

#include <span>

namespace kodo::inline KODO_PRECISION {

/// The accelerations of this step, from the fields and from the forces that were applied since the
/// last one, which are then forgotten [Thesis06, 4.1.3]. Forces that brake are taken implicitly
/// over dt; see Push. False if one of them is not sound.
bool gatherAccelerations(Bodies& bodies, std::span<const FieldEntry> fields, Real dt, Crew& crew);

/// Finds Bodies::loads, after accelerations, masses or who is awake have changed: see
/// Bodies::pushesStale.
void noteLoads(Bodies& bodies);

/// Forgets the motion that the bodies in the list had in the last step. A locked one that has come
/// to a stand is awake no more. Several threads call it at once.
void beginMotion(Bodies& bodies, std::span<const std::uint32_t> list);

/// What a body may be pushed by within a step.
enum class Hold : std::uint8_t {
    Free,    // nothing: no contact, no joint
    Near,    // what it may come to touch
    Touched, // what touches it, or a joint
};

/// v += h a, of the bodies in the list.
void integrateVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);

/// move += h v, of the bodies in the list. A body that nothing touches moves by the exact parabola
/// instead,
///
///   x(t + h) = x + h v_old + a h^2 / 2 = x + h v_new - a h^2 / 2
///
/// so that free fall has no error but rounding, whatever the step. `holds` is by body.
void integrateMoves(Bodies& bodies, std::span<const std::uint32_t> list,
                    std::span<const Hold> holds, Real h);

/// Both at once, for bodies that nothing holds.
void moveFreely(Bodies& bodies, std::span<const std::uint32_t> list, Real h);

/// Puts the bodies in the list where their motion has taken them.
void movePoses(Bodies& bodies, std::span<const std::uint32_t> list);

} // namespace kodo::inline KODO_PRECISION
