// SPDX-License-Identifier: MIT
#include "bodies/integrate.hpp"

#include "math/decay.hpp"
#include "math/lane_rotations.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kBodiesPerPiece = 128;

Acceleration accelerationOf(const Bodies& bodies, std::uint32_t i,
                            std::span<const FieldEntry> fields, Real dt) {
    const BodyRecord& record = bodies.record[i];
    const BodyVelocity& motion = bodies.motion[i];
    if (motion.locked()) {
        return {};
    }
    FieldForce push{record.force, record.torque};
    Real forces = length(push.force);
    for (const FieldEntry& entry : fields) {
        if (accepts(entry.which, bodies.filter[i])) {
            const FieldForce more = entry.field->at({bodies, bodies.idAt(i)}, dt);
            push.force += more.force;
            forces += length(more.force);
            push.torque += more.torque;
            push.drag += more.drag;
            push.spinDrag += more.spinDrag;
        }
    }
    return {motion.invMass / (1 + dt * push.drag * motion.invMass) * push.force,
            motion.invInertia / (1 + dt * push.spinDrag * motion.invInertia) * push.torque,
            std::min(std::numeric_limits<Real>::max(), motion.invMass * forces)}; // also for NaN
}

/// exp(-c dt) for one coefficient after the other; most bodies in sequence have the same.
class Decay {
public:
    explicit Decay(Real dt) : dt_(dt) {}
    Real of(Real perSecond) {
        if (perSecond != last_) {
            last_ = perSecond;
            factor_ = decay(perSecond * dt_);
        }
        return factor_;
    }

private:
    Real dt_;
    Real last_ = 0;
    Real factor_ = 1;
};

/// movePoses() for kLanes bodies, bit-identical.
void movePosesInLanes(Bodies& bodies, const std::uint32_t* list) {
    std::uint32_t motionAt[kLanes];
    std::uint32_t poseAt[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        motionAt[i] = list[i] * static_cast<std::uint32_t>(sizeof(BodyVelocity) / sizeof(Real));
        poseAt[i] = list[i] * static_cast<std::uint32_t>(sizeof(Transform) / sizeof(Real));
    }
    const Quad moved = gather(&bodies.motion[0].deltaPosition.x, motionAt);
    Quad pose = gather(&bodies.pose[0].position.x, poseAt);
    pose.x += moved.x;
    pose.y += moved.y;
    const Couple next = turnedBy(cosSin(moved.z), {pose.z, pose.w});
    const Lanes missing = (all(1) - (next.x * next.x + next.y * next.y)) * all(Real(0.5));
    const auto stays = moved.z == Lanes{};
    pose.z = stays ? pose.z : next.x + missing * next.x;
    pose.w = stays ? pose.w : next.y + missing * next.y;
    scatter(&bodies.pose[0].position.x, poseAt, pose);
}

} // namespace

bool gatherAccelerations(Bodies& bodies, std::span<const FieldEntry> fields, Real dt,
                         WorkerTeam& team) {
    std::vector<std::uint32_t>& entered = bodies.changes.entered;
    const bool all = std::exchange(bodies.accelerationsStale, false);
    if (!all) {
        sortUnique(entered);
        std::erase_if(entered, [&](std::uint32_t body) {
            return !std::binary_search(bodies.awake.begin(), bodies.awake.end(), body);
        });
    }
    const std::span<const std::uint32_t> list = all ? bodies.awake : entered;
    bodies.changes.loadsStale = bodies.changes.loadsStale || !list.empty();
    std::uint8_t unsound = 0;
    team.forEach(list.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t i : list.subspan(first, last - first)) {
            bodies.acceleration[i] = accelerationOf(bodies, i, fields, dt);
            if (!isSound(bodies.acceleration[i])) {
                WorkerTeam::mark(unsound);
            }
        }
    });
    entered.clear();
    bodies.accelerationsStale =
        !bodies.forced.empty() ||
        std::any_of(fields.begin(), fields.end(),
                    [](const FieldEntry& entry) { return !entry.field->steady(); });
    for (const std::uint32_t i : bodies.forced) { // also of inactive bodies
        BodyRecord& record = bodies.record[i];
        if (record.force == Vec2{} && record.torque == 0) {
            continue; // cancelled, or of a body that was removed
        }
        record.force = {};
        record.torque = 0;
        bodies.noteLostLoad(i, 2); // the next step has another force
    }
    bodies.forced.clear();
    return unsound == 0;
}

void noteLoads(Bodies& bodies) {
    LoadRange loads;
    for (const std::uint32_t body : bodies.awake) {
        if (bodies.locked(body)) {
            loads.driven = true;
            continue;
        }
        const Real square = lengthSquared(bodies.acceleration[body].linear);
        loads.minAccelerationSquared = std::min(loads.minAccelerationSquared, square);
        if (const Real invMass = bodies.motion[body].invMass; invMass > 0) {
            loads.maxInvMass = std::max(loads.maxInvMass, invMass);
            loads.minInvMass = std::min(loads.minInvMass, invMass);
            loads.maxAccelerationSquared = std::max(loads.maxAccelerationSquared, square);
        }
    }
    bodies.loads = loads;
    bodies.changes.loadsStale = false;
}

void beginMotion(Bodies& bodies, std::span<const std::uint32_t> list) {
    for (const std::uint32_t i : list) {
        bodies.motion[i].clearDisplacement();
        if (bodies.isStill(i)) {
            WorkerTeam::mark(bodies.anyStopped);
        }
    }
}

void setRules(Bodies& bodies, std::uint32_t body, const MotionRules& rules) {
    bodies.record[body].rules = rules;
    bodies.changes.anyDamped =
        bodies.changes.anyDamped || rules.linearDamping > 0 || rules.angularDamping > 0;
    bodies.changes.continuousModes =
        bodies.changes.continuousModes || rules.continuousMode != ContinuousMode::All;
    bodies.accelerationsStale = true;
}

void dampVelocities(Bodies& bodies, Real dt, WorkerTeam& team) {
    team.forEach(bodies.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        Decay linear(dt);
        Decay angular(dt);
        for (std::size_t k = first; k < last; ++k) {
            const MotionRules& rules = bodies.record[bodies.awake[k]].rules;
            BodyVelocity& motion = bodies.motion[bodies.awake[k]];
            if (rules.linearDamping > 0 && motion.invMass > 0) {
                motion.velocity *= linear.of(rules.linearDamping);
            }
            if (rules.angularDamping > 0 && motion.invInertia > 0) {
                motion.angularVelocity *= angular.of(rules.angularDamping);
            }
        }
    });
}

void integrateVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    const Four time{h, h, h, 0};
    for (const std::uint32_t i : list) {
        speeds(bodies.motion[i]) += time * rates(bodies.acceleration[i]);
    }
}

void integrateMoves(Bodies& bodies, std::span<const std::uint32_t> list,
                    std::span<const ContactExposure> holds, Real h) {
    const Real half = h * h / 2;
    const Four time{h, h, h, 0};
    const Four bend{half, half, half, 0};
    for (const std::uint32_t i : list) {
        BodyVelocity& motion = bodies.motion[i];
        moves(motion) += time * speeds(motion);
        if (holds[i] != ContactExposure::Touched) {
            moves(motion) -= bend * rates(bodies.acceleration[i]);
        }
    }
}

void moveFreely(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    const Real half = h * h / 2;
    const Four time{h, h, h, 0};
    const Four bend{half, half, half, 0};
    for (const std::uint32_t i : list) {
        BodyVelocity& motion = bodies.motion[i];
        const Four& rate = rates(bodies.acceleration[i]);
        speeds(motion) += time * rate;
        moves(motion) += time * speeds(motion) - bend * rate;
    }
}

void movePoses(Bodies& bodies, std::span<const std::uint32_t> list) {
    constexpr auto kSide = static_cast<std::size_t>(kLanes);
    std::size_t k = 0;
    for (; k + kSide <= list.size(); k += kSide) {
        movePosesInLanes(bodies, list.data() + k);
    }
    for (const std::uint32_t i : list.subspan(k)) {
        const BodyVelocity& motion = bodies.motion[i];
        bodies.pose[i].position += motion.deltaPosition;
        if (motion.deltaAngle != 0) {
            bodies.pose[i].rotation = turned(bodies.pose[i].rotation, motion.deltaAngle);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
