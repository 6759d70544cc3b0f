// SPDX-License-Identifier: MIT
#include <kodo/axis_lock.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

BodyId lockAxis(World& world, BodyId body, Vec2 axis) {
    const BodyView held = world[body];
    if (held.type() != BodyType::Dynamic) {
        throw BadDefinition({"body", "must be dynamic: nothing pushes another one off its way"});
    }
    // A later index passes check(), which asks for two bodies.
    const JointEnds ends{.a = {~std::uint32_t{0}, 1}, .b = body, .anchorB = held.localCenter()};
    WheelJoint groove{.ends = ends, .axis = axis};
    if (const auto problem = check(groove, world.tolerances().unit())) {
        throw BadDefinition(*problem);
    }
    groove.axis = perp(axis);
    groove.ends.a = world.add({.shape = Point{},
                               .position = held.center(),
                               .type = BodyType::Static,
                               .flags = kDisabled});
    world.add(groove);
    return groove.ends.a;
}

} // namespace KODO_PRECISION
} // namespace kodo
