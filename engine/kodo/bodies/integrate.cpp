// SPDX-License-Identifier: MIT
#include <kodo/base/crew.hpp>
#include <kodo/bodies/integrate.hpp>

namespace kodo::inline KODO_PRECISION {

bool gatherAccelerations(Bodies& bodies, std::span<const FieldEntry> fields, Real dt) {
    if (fields.empty() && bodies.forced.empty()) {
        for (const std::uint32_t i : bodies.awake) {
            bodies.acceleration[i] = {};
        }
        return true;
    }
    bool sound = true;
    for (const std::uint32_t i : bodies.awake) {
        const BodyRecord& record = bodies.record[i];
        const Motion& motion = bodies.motion[i];
        if (motion.locked()) {
            bodies.acceleration[i] = {};
            continue;
        }
        Push push{record.force, record.torque};
        Real effort = length(push.force);
        for (const FieldEntry& entry : fields) {
            if (accepts(entry.which, record.filter.flags)) {
                const Push more = entry.field->at(bodies, i, dt);
                push.force += more.force;
                effort += length(more.force);
                push.torque += more.torque;
                push.drag += more.drag;
                push.spinDrag += more.spinDrag;
            }
        }
        bodies.acceleration[i] = {
            motion.invMass / (1 + dt * push.drag * motion.invMass) * push.force,
            motion.invInertia / (1 + dt * push.spinDrag * motion.invInertia) * push.torque,
            motion.invMass * effort};
        sound = sound && isSound(bodies.acceleration[i]);
    }
    for (const std::uint32_t i : bodies.forced) { // also of what took no part in this step
        bodies.record[i].force = {};
        bodies.record[i].torque = 0;
    }
    bodies.forced.clear();
    return sound;
}

void beginMotion(Bodies& bodies, std::span<const std::uint32_t> list) {
    for (const std::uint32_t i : list) {
        bodies.motion[i].halt();
        if (bodies.stands(i)) {
            Crew::mark(bodies.awakeStale);
        }
    }
}

void integrateVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    for (const std::uint32_t i : list) {
        Motion& motion = bodies.motion[i];
        motion.velocity += h * bodies.acceleration[i].linear;
        motion.angularVelocity += h * bodies.acceleration[i].angular;
    }
}

void integrateMoves(Bodies& bodies, std::span<const std::uint32_t> list,
                    std::span<const Hold> holds, Real h) {
    const Real half = h * h / 2;
    for (const std::uint32_t i : list) {
        Motion& motion = bodies.motion[i];
        motion.move += h * motion.velocity;
        motion.turn += h * motion.angularVelocity;
        if (holds[i] != Hold::Touched) {
            motion.move -= half * bodies.acceleration[i].linear;
            motion.turn -= half * bodies.acceleration[i].angular;
        }
    }
}

void moveFreely(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    const Real half = h * h / 2;
    for (const std::uint32_t i : list) {
        Motion& motion = bodies.motion[i];
        const Acceleration& acceleration = bodies.acceleration[i];
        motion.velocity += h * acceleration.linear;
        motion.angularVelocity += h * acceleration.angular;
        motion.move += h * motion.velocity - half * acceleration.linear;
        motion.turn += h * motion.angularVelocity - half * acceleration.angular;
    }
}

void movePoses(Bodies& bodies, std::span<const std::uint32_t> list) {
    for (const std::uint32_t i : list) {
        const Motion& motion = bodies.motion[i];
        bodies.pose[i].position += motion.move;
        if (motion.turn != 0) {
            bodies.pose[i].rotation = turned(bodies.pose[i].rotation, motion.turn);
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
