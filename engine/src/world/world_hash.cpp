// SPDX-License-Identifier: MIT
#include <kodo/state_hash.hpp>

#include "bodies/body_checks.hpp"
#include "world/world_impl.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

/// True for a box, polygon or segment without a radius.
bool isSharp(const Primitive& primitive) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.radius; }) {
                return kind.radius == 0;
            }
            return false;
        },
        primitive);
}

/// Numbers that most materials do not have count only if a material has them.
void writeMaterial(StateStream& stream, const Material& material) {
    const auto& [staticFriction, kineticFriction, restitution, rolling, speed, frictionRule,
                 restitutionRule] = material;
    stream.write(staticFriction, kineticFriction, restitution, rolling);
    constexpr Material kUsual;
    if (speed != 0 || frictionRule != kUsual.frictionRule ||
        restitutionRule != kUsual.restitutionRule) {
        stream.write(speed, frictionRule, restitutionRule);
    }
}

/// Numbers of a filter that few have, beside the low 32 and 16 bits that always count.
template <typename Write>
void forRareBits(const CollisionFilter& filter, Write write) {
    if ((filter.flags >> 32 | filter.required >> 16) != 0 || filter.group != 0) {
        write(filter.flags >> 32);
        write(filter.required >> 16);
        write(filter.group);
    }
}

void writeFilter(StateStream& stream, const CollisionFilter& filter) {
    stream.write(static_cast<std::uint32_t>(filter.flags),
                 static_cast<std::uint16_t>(filter.required));
    forRareBits(filter, [&](auto number) { stream.write(number); });
}

void writeRules(StateStream& stream, const MotionRules& rules) {
    if (rules != MotionRules{}) {
        stream.write(rules);
    }
}

/// Number of last members, of those that a joint got after its first version, without effect.
template <typename Joint>
std::size_t unusedNumbers(const Joint&) {
    return 0;
}
std::size_t unusedNumbers(const FixedJoint& joint) {
    return joint.hertz == 0 && joint.damping == 0 ? 2 : 0;
}
std::size_t unusedNumbers(const DistanceJoint& joint) {
    return joint.motorSpeed == 0 && joint.motorForce == 0 ? 2 : 0;
}
std::size_t unusedNumbers(const PrismaticJoint& joint) {
    return joint.target == 0 && joint.hertz == 0 && joint.damping == 0 ? 3 : 0;
}
std::size_t unusedNumbers(const RevoluteJoint& joint) {
    const bool springs = joint.target != 0 || joint.hertz != 0 || joint.damping != 0;
    return joint.ratchet != 0 ? 0 : springs ? 1 : 4;
}

/// Writes the numbers of a joint. Unused ones and user data of 0 add nothing.
template <typename Joint>
void writeJoint(StateStream& stream, const Joint& joint) {
    const auto dropUserData = [&](const auto& last) {
        stream.write(last);
        stream.drop(last.userData == 0 ? sizeof last.userData : 0);
    };
    if constexpr (requires { joint.ends; }) {
        dropUserData(joint.ends);
        withMembers(joint,
                    [&](const JointEnds&, const auto&... numbers) { stream.write(numbers...); });
        stream.drop(unusedNumbers(joint) * sizeof(Real));
    } else {
        dropUserData(joint);
    }
}

/// Adds the state of a joint. A slot that joints got later counts only with an impulse.
void addJoint(StateHash& hash, const JointSet::Joint& joint) {
    constexpr std::size_t kFirstSlots = 5;
    hash.add(static_cast<std::uint32_t>(joint.def.index()));
    hash.add(firstBody(joint.def).index);
    hash.add(secondBody(joint.def).index);
    hash.add(joint.point.x);
    hash.add(joint.point.y);
    for (std::size_t i = 0; i < joint.axes.size(); ++i) {
        if (i < kFirstSlots || joint.axes[i] != 0) {
            hash.add(joint.axes[i]);
        }
    }
    if (joint.counted != 0) {
        hash.add(joint.counted);
    }
}

/// Adds what decides the future beside the motion: settings, fields, geometry, materials, user
/// data and the numbers of joints. Of a user's own fields only that they exist.
void addDefinitions(StateHash& hash, const WorldImpl& world) {
    StateStream stream;
    StepSettings settings = world.settings();
    visitState(stream, settings);
    Tolerances tolerances = world.tolerances();
    visitState(stream, tolerances);
    stream.write(world.region());
    OwnFields none;
    for (FieldEntry entry : world.fields()) {
        visitState(stream, entry, none);
        stream.drop(2 * sizeof(Flags) + sizeof entry.which.group);
        writeFilter(stream, entry.which);
    }
    const Bodies& bodies = world.bodyData();
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        if (!bodies.ids.aliveAt(i)) {
            continue;
        }
        stream.write(bodies.record[i].userData);
        writeRules(stream, bodies.record[i].rules);
        const PartList& list = bodies.geometry(i);
        for (const Part& part : list.parts) {
            stream.write(part.primitive);
            if (isSharp(part.primitive)) { // a radius, the last member, counts only if it rounds
                stream.drop(sizeof(Real));
            }
            writeMaterial(stream, part.material);
            stream.write(part.density);
            if (part.filter || part.userData != 0) {
                stream.write(part.filter, part.userData);
            }
        }
        for (const SetMass& set : list.setMasses) { // nothing is added if none was set
            stream.write(set);
        }
        for (const auto& [known, filter, userData, rules] : list.former) { // likewise
            if (filter.flags != 0 || filter.required != 0 || filter.group != 0 || userData != 0) {
                stream.write(known);
                writeFilter(stream, filter);
                stream.write(userData);
            }
            writeRules(stream, rules);
        }
    }
    world.jointData().forEach([&](const JointSet::Joint& joint) {
        stream.write(static_cast<std::uint8_t>(joint.def.index()));
        std::visit([&](const auto& kind) { writeJoint(stream, kind); }, joint.def);
    });
    for (const std::byte byte : stream.takeWritten()) {
        hash.add(std::to_integer<std::uint8_t>(byte));
    }
}

} // namespace

std::uint64_t WorldImpl::stateHash() const {
    StateHash hash;
    hash.add(stepCount_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        hash.add(bodies_.ids.generationAt(i));
        if (!bodies_.ids.aliveAt(i)) {
            continue;
        }
        const BodyVelocity& motion = bodies_.motion[i];
        const Transform& pose = bodies_.pose[i];
        const BodyRecord& record = bodies_.record[i];
        for (const Real value :
             {pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s, motion.velocity.x,
              motion.velocity.y, motion.angularVelocity, motion.invMass, motion.invInertia,
              record.force.x, record.force.y, record.torque}) {
            hash.add(value);
        }
        hash.add(bodies_.sleep[i].calmSteps);
        hash.add(record.lostLoad);
        const CollisionFilter& filter = bodies_.filter[i]; // the type counts as its motion locks
        hash.add(static_cast<std::uint32_t>((filter.flags & ~kTypeBits) | locksOf(filter.flags)));
        hash.add(static_cast<std::uint16_t>(filter.required));
        forRareBits(filter, [&](auto number) { hash.add(number); });
        hash.add(static_cast<std::uint32_t>(record.geometry->parts.size()));
    }
    const auto addContact = [&](const StoredContact& contact) {
        if (!contact.wasTouching) {
            return;
        }
        hash.add(contact.key.bodyA);
        hash.add(contact.key.partA);
        hash.add(contact.key.bodyB);
        hash.add(contact.key.partB);
        for (const Real value :
             {contact.numbers.impulse[0].normal, contact.numbers.impulse[1].normal,
              contact.numbers.friction, contact.numbers.rolling}) {
            hash.add(value);
        }
        hash.add(static_cast<std::uint8_t>(contact.numbers.sliding ? 1 : 0));
    };
    contacts_.store().forEachInOrder(
        [&](std::uint32_t slot) { addContact(contacts_.store().copyOf(slot, bodies_)); });
    sleep_.forEachContact(addContact);
    region_.parked().forEach(addContact);
    joints_.forEach([&](const JointSet::Joint& joint) { addJoint(hash, joint); });
    addDefinitions(hash, *this);
    return hash.value();
}

} // namespace KODO_PRECISION
} // namespace kodo
