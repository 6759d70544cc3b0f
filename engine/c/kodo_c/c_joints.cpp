// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <type_traits>
#include <variant>

namespace kodo_c {
namespace {

constexpr std::int32_t kJointKinds = std::variant_size_v<kodo::JointDef>;

template <int kind, typename Joint>
constexpr bool isKind = std::is_same_v<std::variant_alternative_t<kind, kodo::JointDef>, Joint>;
static_assert(isKind<KODO_REVOLUTE_JOINT, kodo::RevoluteJoint>);
static_assert(isKind<KODO_FIXED_JOINT, kodo::FixedJoint>);
static_assert(isKind<KODO_DISTANCE_JOINT, kodo::DistanceJoint>);
static_assert(isKind<KODO_PRISMATIC_JOINT, kodo::PrismaticJoint>);
static_assert(isKind<KODO_MOTOR_JOINT, kodo::MotorJoint>);
static_assert(isKind<KODO_MOUSE_JOINT, kodo::MouseJoint>);
static_assert(isKind<KODO_WHEEL_JOINT, kodo::WheelJoint>);
static_assert(isKind<KODO_PULLEY_JOINT, kodo::PulleyJoint>);
static_assert(isKind<KODO_GEAR_JOINT, kodo::GearJoint>);
static_assert(isKind<KODO_FILTER_JOINT, kodo::FilterJoint>);

kodo::JointEnds endsFromC(const kodo_JointEnds& ends) {
    return {fromC(ends.a),   fromC(ends.b),    fromC(ends.anchorA), fromC(ends.anchorB),
            ends.breakForce, ends.breakTorque, ends.collide,        ends.userData};
}
kodo_JointEnds endsToC(const kodo::JointEnds& ends) {
    const auto& [a, b, anchorA, anchorB, breakForce, breakTorque, collide, userData] = ends;
    return {toC(a), toC(b), toC(anchorA), toC(anchorB), breakForce, breakTorque, collide, userData};
}

/// An optional range as flag and range.
template <typename Joint>
void writeLimits(const std::optional<kodo::Range>& limits, Joint& joint) {
    joint.hasLimits = limits.has_value();
    if (limits) {
        joint.limits = toC(*limits);
    }
}

/// Writes the alternative of the union, which is zero before.
struct WriteJoint {
    kodo_JointDef& def;

    void operator()(const kodo::RevoluteJoint& joint) const {
        const auto& [ends, reference, limits, motorSpeed, motorTorque, target, hertz, damping,
                     ratchet] = joint;
        def.revolute.ends = endsToC(ends);
        def.revolute.reference = reference;
        writeLimits(limits, def.revolute);
        def.revolute.motorSpeed = motorSpeed;
        def.revolute.motorTorque = motorTorque;
        def.revolute.target = target;
        def.revolute.hertz = hertz;
        def.revolute.damping = damping;
        def.revolute.ratchet = ratchet;
    }
    void operator()(const kodo::FixedJoint& joint) const {
        const auto& [ends, reference, hertz, damping] = joint;
        def.fixed = {endsToC(ends), reference, hertz, damping};
    }
    void operator()(const kodo::DistanceJoint& joint) const {
        const auto& [ends, length, hertz, damping, limits, motorSpeed, motorForce] = joint;
        def.distance.ends = endsToC(ends);
        def.distance.length = length;
        def.distance.hertz = hertz;
        def.distance.damping = damping;
        writeLimits(limits, def.distance);
        def.distance.motorSpeed = motorSpeed;
        def.distance.motorForce = motorForce;
    }
    void operator()(const kodo::PrismaticJoint& joint) const {
        const auto& [ends, axis, reference, limits, motorSpeed, motorForce, target, hertz,
                     damping] = joint;
        def.prismatic.ends = endsToC(ends);
        def.prismatic.axis = toC(axis);
        def.prismatic.reference = reference;
        writeLimits(limits, def.prismatic);
        def.prismatic.motorSpeed = motorSpeed;
        def.prismatic.motorForce = motorForce;
        def.prismatic.target = target;
        def.prismatic.hertz = hertz;
        def.prismatic.damping = damping;
    }
    void operator()(const kodo::MotorJoint& joint) const {
        const auto& [ends, reference, force, torque, hertz, damping] = joint;
        def.motor = {endsToC(ends), reference, force, torque, hertz, damping};
    }
    void operator()(const kodo::MouseJoint& joint) const {
        const auto& [body, anchor, target, force, hertz, damping, userData] = joint;
        def.mouse = {toC(body), toC(anchor), toC(target), force, hertz, damping, userData};
    }
    void operator()(const kodo::WheelJoint& joint) const {
        const auto& [ends, axis, limits, hertz, damping, motorSpeed, motorTorque] = joint;
        def.wheel.ends = endsToC(ends);
        def.wheel.axis = toC(axis);
        writeLimits(limits, def.wheel);
        def.wheel.hertz = hertz;
        def.wheel.damping = damping;
        def.wheel.motorSpeed = motorSpeed;
        def.wheel.motorTorque = motorTorque;
    }
    void operator()(const kodo::PulleyJoint& joint) const {
        const auto& [ends, groundA, groundB, length, ratio] = joint;
        def.pulley = {endsToC(ends), toC(groundA), toC(groundB), length, ratio};
    }
    void operator()(const kodo::GearJoint& joint) const {
        const auto& [ends, ratio, rack] = joint;
        def.gear.ends = endsToC(ends);
        def.gear.ratio = ratio;
        def.gear.hasRack = rack.has_value();
        if (rack) {
            def.gear.rack = toC(*rack);
        }
    }
    void operator()(const kodo::FilterJoint& joint) const {
        const auto& [ends] = joint;
        def.filter.ends = endsToC(ends);
    }
};

kodo::WheelJoint wheelFromC(const kodo_WheelJoint& joint) {
    return {endsFromC(joint.ends),
            fromC(joint.axis),
            optionalFromC(joint.hasLimits, joint.limits, "hasLimits"),
            joint.hertz,
            joint.damping,
            joint.motorSpeed,
            joint.motorTorque};
}
kodo::PulleyJoint pulleyFromC(const kodo_PulleyJoint& joint) {
    return {endsFromC(joint.ends), fromC(joint.groundA), fromC(joint.groundB), joint.length,
            joint.ratio};
}
kodo::GearJoint gearFromC(const kodo_GearJoint& joint) {
    return {endsFromC(joint.ends), joint.ratio,
            optionalFromC(joint.hasRack, joint.rack, "hasRack")};
}

kodo::JointDef defaultsOf(kodo_JointKind kind) {
    switch (kind) {
    case KODO_REVOLUTE_JOINT:
        return kodo::RevoluteJoint{};
    case KODO_FIXED_JOINT:
        return kodo::FixedJoint{};
    case KODO_DISTANCE_JOINT:
        return kodo::DistanceJoint{};
    case KODO_PRISMATIC_JOINT:
        return kodo::PrismaticJoint{};
    case KODO_MOTOR_JOINT:
        return kodo::MotorJoint{};
    case KODO_MOUSE_JOINT:
        return kodo::MouseJoint{};
    case KODO_WHEEL_JOINT:
        return kodo::WheelJoint{};
    case KODO_PULLEY_JOINT:
        return kodo::PulleyJoint{};
    case KODO_GEAR_JOINT:
        return kodo::GearJoint{};
    case KODO_FILTER_JOINT:
        return kodo::FilterJoint{};
    default:
        requireKind(kind, kJointKinds, "kind");
        return {};
    }
}

} // namespace

kodo::JointDef fromC(const kodo_JointDef& def) {
    switch (def.kind) {
    case KODO_REVOLUTE_JOINT: {
        const kodo_RevoluteJoint& joint = def.revolute;
        return kodo::RevoluteJoint{endsFromC(joint.ends),
                                   joint.reference,
                                   optionalFromC(joint.hasLimits, joint.limits, "hasLimits"),
                                   joint.motorSpeed,
                                   joint.motorTorque,
                                   joint.target,
                                   joint.hertz,
                                   joint.damping,
                                   joint.ratchet};
    }
    case KODO_FIXED_JOINT:
        return kodo::FixedJoint{endsFromC(def.fixed.ends), def.fixed.reference, def.fixed.hertz,
                                def.fixed.damping};
    case KODO_DISTANCE_JOINT: {
        const kodo_DistanceJoint& joint = def.distance;
        return kodo::DistanceJoint{endsFromC(joint.ends),
                                   joint.length,
                                   joint.hertz,
                                   joint.damping,
                                   optionalFromC(joint.hasLimits, joint.limits, "hasLimits"),
                                   joint.motorSpeed,
                                   joint.motorForce};
    }
    case KODO_PRISMATIC_JOINT: {
        const kodo_PrismaticJoint& joint = def.prismatic;
        return kodo::PrismaticJoint{
            endsFromC(joint.ends), fromC(joint.axis),
            joint.reference,       optionalFromC(joint.hasLimits, joint.limits, "hasLimits"),
            joint.motorSpeed,      joint.motorForce,
            joint.target,          joint.hertz,
            joint.damping};
    }
    case KODO_MOTOR_JOINT: {
        const kodo_MotorJoint& joint = def.motor;
        return kodo::MotorJoint{endsFromC(joint.ends), joint.reference, joint.force,
                                joint.torque,          joint.hertz,     joint.damping};
    }
    case KODO_MOUSE_JOINT: {
        const kodo_MouseJoint& joint = def.mouse;
        return kodo::MouseJoint{fromC(joint.body), fromC(joint.anchor), fromC(joint.target),
                                joint.force,       joint.hertz,         joint.damping,
                                joint.userData};
    }
    case KODO_WHEEL_JOINT:
        return wheelFromC(def.wheel);
    case KODO_PULLEY_JOINT:
        return pulleyFromC(def.pulley);
    case KODO_GEAR_JOINT:
        return gearFromC(def.gear);
    case KODO_FILTER_JOINT:
        return kodo::FilterJoint{endsFromC(def.filter.ends)};
    default:
        requireKind(def.kind, kJointKinds, "kind");
        return {};
    }
}

kodo_JointDef toC(const kodo::JointDef& joint) {
    kodo_JointDef def{};
    def.head = kodo_headOf(sizeof(kodo_JointDef));
    def.kind = static_cast<kodo_JointKind>(joint.index());
    std::visit(WriteJoint{def}, joint);
    return def;
}

kodo_JointState toC(const kodo::JointState& state) {
    const auto& [anchorA, anchorB, angle, angularSpeed, length, lengthSpeed, translation, speed] =
        state;
    return {toC(anchorA), toC(anchorB), angle,       angularSpeed,
            length,       lengthSpeed,  translation, speed};
}

kodo_BrokenJoint toC(const kodo::BrokenJoint& broken) {
    const auto& [id, a, b, force, torque] = broken;
    return {toC(id), toC(a), toC(b), force, torque};
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initJointDef(kodo_JointDef* def, kodo_Head head, kodo_JointKind kind) {
    return guarded([&] {
        initialise(def, head, "kodo_JointDef");
        def->kind = kind;
        *def = toC(defaultsOf(kind));
    });
}

kodo_Status kodo_addJoint(kodo_World* world, const kodo_JointDef* def, kodo_JointId* id) {
    return guarded([&] {
        kodo_JointId& added = required(id, "id");
        const kodo::JointDef joint = fromC(checked(def, "def", "kodo_JointDef"));
        added = toC(worldOf(world).add(joint));
    });
}

kodo_Status kodo_removeJoint(kodo_World* world, kodo_JointId id) {
    return guarded([&] { worldOf(world).remove(fromC(id)); });
}

kodo_Status kodo_containsJoint(const kodo_World* world, kodo_JointId id, bool* contained) {
    return guarded([&] { required(contained, "contained") = worldOf(world).contains(fromC(id)); });
}

kodo_Status kodo_joints(const kodo_World* world, kodo_JointId* ids, size_t capacity,
                        size_t* count) {
    return guarded([&] { writeList(worldOf(world).joints(), ids, capacity, count); });
}

kodo_Status kodo_jointsOf(const kodo_World* world, kodo_BodyId body, kodo_JointId* ids,
                          size_t capacity, size_t* count) {
    return guarded([&] { writeList(worldOf(world).joints(fromC(body)), ids, capacity, count); });
}

kodo_Status kodo_joint(const kodo_World* world, kodo_JointId id, kodo_JointDef* def) {
    return guarded([&] { required(def, "def") = toC(worldOf(world).joint(fromC(id))); });
}

kodo_Status kodo_setJoint(kodo_World* world, kodo_JointId id, const kodo_JointDef* def) {
    return guarded(
        [&] { worldOf(world).setJoint(fromC(id), fromC(checked(def, "def", "kodo_JointDef"))); });
}

kodo_Status kodo_jointLoad(const kodo_World* world, kodo_JointId id, kodo_Load* load) {
    return guarded([&] {
        const kodo::World& of = worldOf(world);
        required(load, "load") = {toC(of.jointForce(fromC(id))), of.jointTorque(fromC(id))};
    });
}

kodo_Status kodo_springOf(const kodo_World* world, const kodo_JointDef* def, kodo_Real stiffness,
                          kodo_Real damping, kodo_Spring* spring) {
    return guarded([&] {
        const auto [hertz, ratio] = kodo::springOf(
            worldOf(world), fromC(checked(def, "def", "kodo_JointDef")), stiffness, damping);
        required(spring, "spring") = {hertz, ratio};
    });
}

kodo_Status kodo_jointState(const kodo_World* world, kodo_JointId id, kodo_JointState* state) {
    return guarded([&] { required(state, "state") = toC(worldOf(world).jointState(fromC(id))); });
}

kodo_Status kodo_brokenJoints(const kodo_World* world, kodo_BrokenJoint* joints, size_t capacity,
                              size_t* count) {
    return guarded([&] { writeList(worldOf(world).brokenJoints(), joints, capacity, count); });
}
