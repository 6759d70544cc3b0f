// SPDX-License-Identifier: MIT
#include <kodo/force_field.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

ForceField::ForceField() = default;
ForceField::ForceField(FieldKind kind) : kind_(kind) {}
ForceField::~ForceField() = default;

Transform midStep(const BodyView& body, Real dt) {
    const Transform& pose = body.massFrame();
    return {pose.position + dt / 2 * body.velocity(),
            turned(pose.rotation, dt / 2 * body.angularVelocity())};
}

FieldForce Gravity::at(const BodyView& body, Real) const {
    return {body.gravityScale() * body.mass() * acceleration_};
}

} // namespace KODO_PRECISION
} // namespace kodo
