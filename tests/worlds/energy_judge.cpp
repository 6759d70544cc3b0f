// SPDX-License-Identifier: MIT
#include <support/every_kind.hpp>
#include <support/scenes.hpp>

#include <worlds/judges.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace worlds {

using namespace kodo;

namespace {

long double wide(Real value) {
    return static_cast<long double>(value);
}

bool isDynamic(const World& world, BodyId id) {
    return world[id].type() == BodyType::Dynamic;
}

Vec2 anchorAt(const World& world, BodyId id, Vec2 anchor) {
    return world[id].transform() * anchor;
}

bool moves(const World& world, BodyId id) {
    return isDynamic(world, id) && (world[id].flags() & kLockMove) == 0;
}

/// kg; the upper bound of what a spring between two bodies moves.
long double reducedMass(const World& world, const JointEnds& ends) {
    const auto inverse = [&](BodyId id) {
        return moves(world, id) ? 1 / wide(world[id].mass()) : 0.0L;
    };
    const long double sum = inverse(ends.a) + inverse(ends.b);
    return sum > 0 ? 1 / sum : 0;
}

/// kg m^2; the same of a spring that rotates them about their anchors.
long double reducedInertia(const World& world, const JointEnds& ends) {
    const auto inverse = [&](BodyId id, Vec2 anchor) {
        const BodyView body = world[id];
        if (!isDynamic(world, id) || (body.flags() & kLockRotate) != 0) {
            return 0.0L;
        }
        const Vec2 arm = anchorAt(world, id, anchor) - body.center();
        const Real swung = moves(world, id) ? body.mass() * lengthSquared(arm) : Real(0);
        return 1 / wide(body.inertia() + swung);
    };
    const long double sum = inverse(ends.a, ends.anchorA) + inverse(ends.b, ends.anchorB);
    return sum > 0 ? 1 / sum : 0;
}

/// J; the upper bound of what the springs of a joint hold.
long double springEnergy(const World& world, JointId id) {
    const JointState state = world.jointState(id);
    const JointDef& def = world.joint(id);
    struct Spring {
        Real hertz = 0;
        Real stretch = 0; // m
        Real turn = 0;    // rad
    };
    const auto [hertz, stretch, turn] =
        std::visit(support::Each{[&](const RevoluteJoint& joint) {
                                     return Spring{joint.hertz, 0, state.angle - joint.target};
                                 },
                                 [&](const FixedJoint& joint) {
                                     return Spring{joint.hertz, state.length, state.angle};
                                 },
                                 [&](const DistanceJoint& joint) {
                                     return Spring{joint.hertz, state.length - joint.length};
                                 },
                                 [&](const PrismaticJoint& joint) {
                                     return Spring{joint.hertz, state.translation - joint.target};
                                 },
                                 [&](const WheelJoint& joint) {
                                     return Spring{joint.hertz, state.translation};
                                 },
                                 [](const MotorJoint&) { return Spring{}; },
                                 [](const MouseJoint&) { return Spring{}; },
                                 [](const PulleyJoint&) { return Spring{}; },
                                 [](const GearJoint&) { return Spring{}; },
                                 [](const FilterJoint&) { return Spring{}; }},
                   def);
    if (!(hertz > 0)) {
        return 0;
    }
    const JointEnds ends = std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.ends; }) {
                return kind.ends;
            } else {
                return JointEnds{};
            }
        },
        def);
    const long double omega = 2 * std::numbers::pi_v<long double> * wide(hertz);
    return omega * omega / 2 *
           (reducedMass(world, ends) * wide(stretch) * wide(stretch) +
            reducedInertia(world, ends) * wide(turn) * wide(turn));
}

/// Largest force (N) and torque (N m) with which a joint drives its bodies.
struct Drive {
    Real force = 0;
    Real torque = 0;
    Real loadOfA = 1; // load on a of a rope or a gear, as a multiple of that on b; at least 1
};
Drive driveOf(const JointDef& def) {
    const auto motor = [](Real speed, Real most) { return speed != 0 ? most : Real(0); };
    return std::visit(
        support::Each{[&](const RevoluteJoint& joint) {
                          return Drive{0, motor(joint.motorSpeed, joint.motorTorque)};
                      },
                      [&](const PrismaticJoint& joint) {
                          return Drive{motor(joint.motorSpeed, joint.motorForce)};
                      },
                      [&](const DistanceJoint& joint) {
                          return Drive{motor(joint.motorSpeed, joint.motorForce)};
                      },
                      [&](const WheelJoint& joint) {
                          return Drive{0, motor(joint.motorSpeed, joint.motorTorque)};
                      },
                      [](const MotorJoint& joint) {
                          return joint.hertz > 0 ? Drive{joint.force, joint.torque} : Drive{};
                      },
                      [](const MouseJoint& joint) { return Drive{joint.force}; },
                      [](const FixedJoint&) { return Drive{}; },
                      [](const PulleyJoint& joint) {
                          return Drive{0, 0, std::max(Real(1), 1 / joint.ratio)};
                      },
                      [](const GearJoint& joint) {
                          return Drive{0, 0, std::max(Real(1), std::abs(joint.ratio))};
                      },
                      [](const FilterJoint&) { return Drive{}; }},
        def);
}

/// J; bound of the work of a kinematic body, at an anchor within `reach` (m), in a step of dt (s).
long double workOf(const BodyView& body, Real force, Real torque, Real reach, Real dt) {
    if (body.type() != BodyType::Kinematic) {
        return 0;
    }
    const Real speed = length(body.velocity()) + std::abs(body.angularVelocity()) * reach;
    return wide(dt * force * speed) + wide(dt * std::abs(torque * body.angularVelocity()));
}

constexpr Real kFarAnchor = 30; // m, anchors far away

} // namespace

EnergyJudge::Ends EnergyJudge::endsOf(const World& world, const JointDef& def) {
    return std::visit(
        [&](const auto& joint) {
            if constexpr (requires { joint.ends; }) {
                const BodyView a = world[joint.ends.a];
                const BodyView b = world[joint.ends.b];
                const Vec2 onA = anchorAt(world, joint.ends.a, joint.ends.anchorA);
                const Vec2 onB = anchorAt(world, joint.ends.b, joint.ends.anchorB);
                return Ends{onB - onA, b.velocityAt(onB) - a.velocityAt(onA),
                            b.rotation() * a.rotation().inverse(),
                            b.angularVelocity() - a.angularVelocity()};
            } else {
                const Vec2 on = anchorAt(world, joint.body, joint.anchor);
                return Ends{on - joint.target, world[joint.body].velocityAt(on), {}, 0};
            }
        },
        def);
}

long double EnergyJudge::energyOf(const World& world) const {
    long double energy = support::totalsOf(world).kinetic;
    for (const BodyId id : world.bodies()) {
        if (isDynamic(world, id) && (world[id].flags() & kLockMove) == 0) {
            const Vec2 c = world[id].center();
            energy -= wide(world[id].mass()) *
                      (wide(gravity_.x) * wide(c.x) + wide(gravity_.y) * wide(c.y));
        }
    }
    return energy;
}

void EnergyJudge::restart(const World& world) {
    budget_ = energyOf(world);
    scale_ = std::max(scale_, support::totalsOf(world).kinetic);
    long double weight = 0;
    for (const BodyId id : world.bodies()) {
        weight += isDynamic(world, id) ? wide(world[id].mass() * length(gravity_)) : 0;
    }
    scale_ = std::max(scale_, weight * wide(world.tolerances().unit()));
    before_.clear();
    for (const JointId id : world.joints()) {
        before_[id] = endsOf(world, world.joint(id));
        budget_ += springEnergy(world, id);
    }
    scale_ = std::max(scale_, std::abs(budget_ - energyOf(world)));
}

long double EnergyJudge::workOfJoints(const World& world) {
    long double work = 0;
    for (const JointId id : world.joints()) {
        const JointDef& def = world.joint(id);
        const Ends now = endsOf(world, def);
        const Ends& last = before_[id];
        const Drive drive = driveOf(def);
        const Real moved = std::max(
            {length(now.gap - last.gap), dt_ * length(now.velocity), dt_ * length(last.velocity)});
        const Real turned = std::max({std::abs((now.angle * last.angle.inverse()).angle()),
                                      dt_ * std::abs(now.spin), dt_ * std::abs(last.spin)});
        work += wide(drive.force * moved) + wide(drive.torque * turned);
        for (const BodyId end : {firstBody(def), secondBody(def)}) {
            work +=
                workOf(world[end], drive.loadOfA * length(world.jointForce(id)),
                       drive.loadOfA * world.jointTorque(id), length(now.gap) + kFarAnchor, dt_);
        }
        before_[id] = now;
    }
    for (const BrokenJoint& joint : world.brokenJoints()) {
        for (const BodyId end : {joint.a, joint.b}) {
            if (world.contains(end)) {
                work += workOf(world[end], joint.force, joint.torque, kFarAnchor, dt_);
            }
        }
    }
    return work;
}

/// The work of a kinematic body is at most its impulses times the speed of its surface: along the
/// normal only if it moves towards the other, across by friction of at most 1.5.
long double EnergyJudge::workOfContacts(const World& world) const {
    long double work = 0;
    for (const CollisionRecord& record : world.collisions()) {
        for (const BodyId id : {record.a, record.b}) {
            if (!world.contains(id) || world[id].type() != BodyType::Kinematic) {
                continue;
            }
            const BodyView body = world[id];
            const Vec2 away = id == record.a ? record.normal : -record.normal;
            const Aabb bounds = body.bounds();
            const Real rim = std::abs(body.angularVelocity()) * length(bounds.extent());
            const Real along = std::max(Real(0), dot(body.velocity(), away)) + rim;
            const Real across = std::abs(cross(body.velocity(), away)) + rim;
            work += wide(record.totalImpulse * (along + Real(1.5) * across));
        }
    }
    return work;
}

std::optional<std::string> EnergyJudge::afterStep(const World& world) {
    const long double work = workOfJoints(world) + workOfContacts(world);
    budget_ += work;
    scale_ += work;
    const long double energy = energyOf(world);
    const long double kinetic = support::totalsOf(world).kinetic;
    scale_ = std::max(scale_, kinetic);
    const long double excess = energy - budget_;
    if (excess <= 0.005L * scale_) { // also false for NaN
        return std::nullopt;
    }
    std::ostringstream text;
    text << "energy " << static_cast<double>(energy) << " J, put in "
         << static_cast<double>(budget_) << " J: " << static_cast<double>(excess) << " J more, "
         << static_cast<double>(excess / scale_) << " of the scale";
    return text.str();
}

} // namespace worlds
