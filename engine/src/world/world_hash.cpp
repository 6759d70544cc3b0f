// SPDX-License-Identifier: MIT
#include <kodo/state_hash.hpp>

#include "bodies/body_checks.hpp"
#include "world/world_impl.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

/// Adds what decides the future beside the motion: settings, fields, geometry, materials, filters,
/// user data and joints. Of a user's own fields only that they exist.
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
    }
    const Bodies& bodies = world.bodyData();
    bodies.ids.forEach([&](std::uint32_t i) {
        stream.write(bodies.filter[i].required, bodies.filter[i].group, bodies.record[i].userData,
                     bodies.record[i].rules, bodies.geometry(i));
    });
    world.jointData().forEach([&](const JointSet::Joint& joint) { stream.write(joint.def); });
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
        const Flags flags = bodies_.filter[i].flags; // the type counts as its motion locks
        hash.add((flags & ~kTypeBits) | locksOf(flags));
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
    joints_.forEach([&](const JointSet::Joint& joint) {
        for (const Real value : {joint.point.x, joint.point.y, joint.counted, joint.held}) {
            hash.add(value);
        }
        for (const Real impulse : joint.axes) {
            hash.add(impulse);
        }
        hash.add(static_cast<std::uint8_t>(joint.atLimit ? 1 : 0));
    });
    addDefinitions(hash, *this);
    return hash.value();
}

} // namespace KODO_PRECISION
} // namespace kodo
