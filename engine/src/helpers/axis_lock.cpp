// SPDX-License-Identifier: MIT
#include <kodo/axis_lock.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

BodyId lockAxis(World& world, BodyId body, Vec2 axis) {
    const BodyView held = world[body];
    constexpr BodyId kLater{.index = ~std::uint32_t{0}, .generation = 1}; // so that check() passes
    WheelJoint groove{.ends = {.a = kLater, .b = body, .anchorB = held.toLocal(held.center())},
                      .axis = perp(axis)};
    if (const auto problem = check(groove)) {
        throw BadDefinition(*problem);
    }
    groove.ends.a = world.add({.shape = Point{},
                               .position = held.center(),
                               .type = BodyType::Static,
                               .flags = kDisabled});
    world.add(groove);
    return groove.ends.a;
}

} // namespace KODO_PRECISION
} // namespace kodo
