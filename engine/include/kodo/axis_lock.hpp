// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// Locks the motion of a body along one axis, {1, 0} for x: its centre stays on a line through its
/// present place, as in a groove. The rotation stays free; kLockRotate locks it too. Velocity along
/// the axis ends in the next step. An impact with restitution comes before joints, so it meets the
/// body as if it were free; the groove then takes the part along the axis.
///
/// Adds the static body that has the groove, a point that nothing meets, and returns its id.
/// Removing that body unlocks; remove it with the locked one too. Its only joint tells the load.
/// Lock again after setPosition(), and after weld() or setPart() has moved the centre. Throws
/// BadDefinition for an axis that is not a unit vector and for a body that is not dynamic, and
/// BadBodyId for an unknown one, BadDefinition for a centre beyond kMaxCoordinate too; nothing has
/// changed then.
KODO_API BodyId lockAxis(World& world, BodyId body, Vec2 axis);

} // namespace KODO_PRECISION
} // namespace kodo
