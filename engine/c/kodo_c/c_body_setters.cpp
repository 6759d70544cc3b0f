// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

using namespace kodo_c;

namespace {

/// Calls a function with a handle to a body.
template <typename Call>
kodo_Status change(kodo_World* world, kodo_BodyId id, Call&& call) noexcept {
    return guarded([&] { call(worldOf(world)[fromC(id)]); });
}

} // namespace

kodo_Status kodo_setPosition(kodo_World* world, kodo_BodyId id, kodo_Vec2 position) {
    return change(world, id, [&](kodo::BodyRef body) { body.setPosition(fromC(position)); });
}

kodo_Status kodo_setRotation(kodo_World* world, kodo_BodyId id, kodo_Rot rotation) {
    return change(world, id, [&](kodo::BodyRef body) { body.setRotation(fromC(rotation)); });
}

kodo_Status kodo_setVelocity(kodo_World* world, kodo_BodyId id, kodo_Vec2 velocity) {
    return change(world, id, [&](kodo::BodyRef body) { body.setVelocity(fromC(velocity)); });
}

kodo_Status kodo_setAngularVelocity(kodo_World* world, kodo_BodyId id, kodo_Real radiansPerSecond) {
    return change(world, id,
                  [&](kodo::BodyRef body) { body.setAngularVelocity(radiansPerSecond); });
}

kodo_Status kodo_moveTo(kodo_World* world, kodo_BodyId id, kodo_Vec2 position, kodo_Real dt) {
    return change(world, id, [&](kodo::BodyRef body) { body.moveTo(fromC(position), dt); });
}

kodo_Status kodo_moveToPose(kodo_World* world, kodo_BodyId id, kodo_Transform pose, kodo_Real dt) {
    return change(world, id, [&](kodo::BodyRef body) {
        body.moveTo(fromC(pose.position), fromC(pose.rotation), dt);
    });
}

kodo_Status kodo_applyForce(kodo_World* world, kodo_BodyId id, kodo_Vec2 force) {
    return change(world, id, [&](kodo::BodyRef body) { body.applyForce(fromC(force)); });
}

kodo_Status kodo_applyForceAt(kodo_World* world, kodo_BodyId id, kodo_Vec2 force, kodo_Vec2 point) {
    return change(world, id,
                  [&](kodo::BodyRef body) { body.applyForce(fromC(force), fromC(point)); });
}

kodo_Status kodo_applyTorque(kodo_World* world, kodo_BodyId id, kodo_Real torque) {
    return change(world, id, [&](kodo::BodyRef body) { body.applyTorque(torque); });
}

kodo_Status kodo_applyImpulse(kodo_World* world, kodo_BodyId id, kodo_Vec2 impulse) {
    return change(world, id, [&](kodo::BodyRef body) { body.applyImpulse(fromC(impulse)); });
}

kodo_Status kodo_applyImpulseAt(kodo_World* world, kodo_BodyId id, kodo_Vec2 impulse,
                                kodo_Vec2 point) {
    return change(world, id,
                  [&](kodo::BodyRef body) { body.applyImpulse(fromC(impulse), fromC(point)); });
}

kodo_Status kodo_applyAngularImpulse(kodo_World* world, kodo_BodyId id, kodo_Real impulse) {
    return change(world, id, [&](kodo::BodyRef body) { body.applyAngularImpulse(impulse); });
}

kodo_Status kodo_setType(kodo_World* world, kodo_BodyId id, kodo_BodyType type) {
    return change(world, id, [&](kodo::BodyRef body) { body.setType(bodyTypeFromC(type)); });
}

kodo_Status kodo_setFlags(kodo_World* world, kodo_BodyId id, kodo_Flags flags) {
    return change(world, id, [&](kodo::BodyRef body) { body.setFlags(flags); });
}

kodo_Status kodo_setRequired(kodo_World* world, kodo_BodyId id, kodo_Flags required) {
    return change(world, id, [&](kodo::BodyRef body) { body.setRequired(required); });
}

kodo_Status kodo_setGroup(kodo_World* world, kodo_BodyId id, int32_t group) {
    return change(world, id, [&](kodo::BodyRef body) { body.setGroup(group); });
}

kodo_Status kodo_setUserData(kodo_World* world, kodo_BodyId id, uint64_t userData) {
    return change(world, id, [&](kodo::BodyRef body) { body.setUserData(userData); });
}

kodo_Status kodo_setMaterial(kodo_World* world, kodo_BodyId id, const kodo_Material* material) {
    return change(world, id, [&](kodo::BodyRef body) {
        body.setMaterial(fromC(required(material, "material")));
    });
}

kodo_Status kodo_setLinearDamping(kodo_World* world, kodo_BodyId id, kodo_Real perSecond) {
    return change(world, id, [&](kodo::BodyRef body) { body.setLinearDamping(perSecond); });
}

kodo_Status kodo_setAngularDamping(kodo_World* world, kodo_BodyId id, kodo_Real perSecond) {
    return change(world, id, [&](kodo::BodyRef body) { body.setAngularDamping(perSecond); });
}

kodo_Status kodo_setGravityScale(kodo_World* world, kodo_BodyId id, kodo_Real scale) {
    return change(world, id, [&](kodo::BodyRef body) { body.setGravityScale(scale); });
}

kodo_Status kodo_setContinuousMode(kodo_World* world, kodo_BodyId id, kodo_ContinuousMode mode) {
    return change(world, id,
                  [&](kodo::BodyRef body) { body.setContinuousMode(continuousModeFromC(mode)); });
}

kodo_Status kodo_setMass(kodo_World* world, kodo_BodyId id, const kodo_MassDef* mass) {
    return change(world, id,
                  [&](kodo::BodyRef body) { body.setMass(fromC(required(mass, "mass"))); });
}

kodo_Status kodo_setMassFromDensity(kodo_World* world, kodo_BodyId id) {
    return change(world, id, [&](kodo::BodyRef body) { body.setMassFromDensity(); });
}

kodo_Status kodo_copyBodyFrom(kodo_World* world, kodo_BodyId id, const kodo_World* from,
                              kodo_BodyId other) {
    return change(world, id, [&](kodo::BodyRef body) {
        body.copyFrom(required(from, "from").world[fromC(other)]);
    });
}

kodo_Status kodo_wake(kodo_World* world, kodo_BodyId id) {
    return change(world, id, [&](kodo::BodyRef body) { body.wake(); });
}

kodo_Status kodo_sleep(kodo_World* world, kodo_BodyId id, bool* asleep) {
    return change(world, id, [&](kodo::BodyRef body) {
        bool& sleeps = required(asleep, "asleep");
        sleeps = body.sleep();
    });
}
