// SPDX-License-Identifier: MIT
#include "world/snapshot_fields.hpp"

#include <cmath>
#include <numeric>

// Plain values, in memory order unless a comment says otherwise.
namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// False if a number of the contact is larger than any of a World, or not a number. Products of
/// two such lengths and speeds are finite.
bool isBounded(const Contact& contact) {
    constexpr Real kMost = Real(1e15); // m or m/s
    const auto small = [](Real number, Real most) { return std::abs(number) <= most; };
    const auto near = [&](Vec2 v, Real most) { return small(v.x, most) && small(v.y, most); };
    const Manifold& manifold = contact.manifold;
    bool good = near(contact.centerA, kMost) && near(manifold.normal, 2) &&
                small(contact.approachSpeed, kMost) && contact.relativeDisplacement >= 0;
    for (const ManifoldPoint& p : manifold.points) {
        good = good && near(p.armA, kMost) && near(p.armB, kMost) && small(p.separation, kMost);
    }
    for (const Real impulse : {contact.impulse[0].normal, contact.impulse[1].normal,
                               contact.friction, contact.rolling, contact.total}) {
        good = good && small(impulse, kMaxMass * kMost);
    }
    return good;
}

} // namespace

void SnapshotFields::one(Circle& circle) {
    auto& [radius, center] = circle;
    all(radius, center);
}

void SnapshotFields::one(Box& box) {
    auto& [width, height, center, rotation] = box;
    all(width, height, center, rotation);
}

void SnapshotFields::one(Polygon& polygon) {
    auto& [corners] = polygon;
    all(corners);
}

void SnapshotFields::one(Point& point) {
    auto& [position] = point;
    all(position);
}

void SnapshotFields::one(Segment& segment) {
    auto& [from, to, oneSided, before, after] = segment;
    all(from, to, oneSided, before, after);
}

void SnapshotFields::one(Plane& plane) {
    auto& [normal, offset] = plane;
    all(normal, offset);
}

void SnapshotFields::one(Material& material) {
    auto& [staticFriction, kineticFriction, restitution, rollingResistance] = material;
    all(staticFriction, kineticFriction, restitution, rollingResistance);
}

void SnapshotFields::one(Part& part) {
    auto& [primitive, material, density, convex] = part;
    all(primitive, material, density);
}

void SnapshotFields::one(CollisionFilter& filter) {
    auto& [flags, required] = filter;
    all(flags, required);
}

void SnapshotFields::one(BodyVelocity& motion) {
    auto& [velocity, angularVelocity, invMass, move, turn, invInertia] = motion;
    all(velocity, angularVelocity, move, turn);
}

void SnapshotFields::one(Acceleration& acceleration) {
    auto& [linear, angular, effort] = acceleration;
    all(linear, angular, effort);
}

void SnapshotFields::one(SleepState& rest) {
    auto& [calmSteps, island, since, leastEnergy, samples] = rest;
    all(calmSteps, since, leastEnergy, samples);
}

void SnapshotFields::one(SleepState::Sample& sample) {
    auto& [velocity, angularVelocity] = sample;
    all(velocity, angularVelocity);
}

void SnapshotFields::one(DragLaw& law) {
    auto& [linear, quadratic] = law;
    all(linear, quadratic);
}

void SnapshotFields::one(Buoyancy::Fluid& fluid) {
    auto& [density, drag] = fluid;
    all(density, drag);
}

void SnapshotFields::one(Attractor::Law& law) {
    as<std::uint8_t>(law);
    require(law <= Attractor::Law::Linear, "the law of an attractor is unknown");
}

void SnapshotFields::one(ContactKey& key) {
    auto& [bodyA, partA, bodyB, partB] = key;
    all(bodyA, partA, bodyB, partB);
}

void SnapshotFields::one(ManifoldPoint& point) {
    auto& [armA, armB, separation, feature] = point;
    all(armA, armB, separation, feature);
}

void SnapshotFields::one(Manifold& manifold) {
    auto& [normal, points, count, fromBehind] = manifold;
    as<std::uint8_t>(count);
    require(count <= 2, "a contact has more than two points");
    all(normal, points, fromBehind);
}

void SnapshotFields::one(PointImpulse& impulse) {
    auto& [normal, impact, largest] = impulse;
    all(normal, impact, largest);
}

/// The row in the solver does not affect results, so it is not stored.
void SnapshotFields::one(ContactRow& row) {
    auto& [index, colour, fixedA, fixedB, resident] = row;
    all(colour, fixedA, fixedB);
    require(colour < 64 || colour == ContactRow::kNoColour, "the colour of a contact is unknown");
}

void SnapshotFields::one(Contact& contact) {
    auto& [key, teleportCounts, relativeDisplacement, row, approachSpeed, near, carried, bounces,
           sensor, sliding, passing, hidden, touching, wasTouching, hasStepImpulses, phase,
           manifold, centerA, impulse, friction, rolling, total, a, b,
           material] = contact; // the phase is part of the records
    all(key, centerA, manifold, teleportCounts, relativeDisplacement, impulse, row, friction,
        rolling, approachSpeed, total);
    all(near, carried, sliding, passing, hidden, touching, wasTouching);
    require(!reads() || isBounded(contact), "a number of a contact is too large, or not a number");
    hasStepImpulses = true; // conservative: it is not stored
}

void SnapshotFields::one(CollisionRecord& record) {
    auto& [a, b, partA, partB, phase, pointCount, points, point, normal, separation, approachSpeed,
           maxImpulse, totalImpulse] = record;
    all(a, b, partA, partB);
    as<std::uint8_t>(phase);
    require(phase <= TouchPhase::End, "the phase of a collision record is unknown");
    all(pointCount);
    require(pointCount <= 2, "a collision record has more than two points");
    Real sum = 0; // not finite if one of them is not
    for (auto& [position, gap, largest] : points) {
        all(position, gap, largest);
        sum += position.x + position.y + gap + largest;
    }
    all(point, normal, separation, approachSpeed, maxImpulse, totalImpulse);
    sum += point.x + point.y + normal.x + normal.y + separation + approachSpeed + maxImpulse;
    require(!reads() || std::isfinite(sum + totalImpulse),
            "a number of a collision record is not finite");
}

void SnapshotFields::one(SleepSystem::Island& island) {
    auto& [bodies, contacts, version] = island;
    all(bodies, contacts);
}

void SnapshotFields::one(Range& range) {
    auto& [lower, upper] = range;
    all(lower, upper);
}

void SnapshotFields::one(JointEnds& ends) {
    auto& [a, b, anchorA, anchorB, breakForce, breakTorque, collide] = ends;
    all(a, b, anchorA, anchorB, breakForce, breakTorque, collide);
}

void SnapshotFields::one(RevoluteJoint& joint) {
    auto& [ends, reference, limits, motorSpeed, motorTorque] = joint;
    all(ends, reference, limits, motorSpeed, motorTorque);
}

void SnapshotFields::one(FixedJoint& joint) {
    auto& [ends, reference] = joint;
    all(ends, reference);
}

void SnapshotFields::one(DistanceJoint& joint) {
    auto& [ends, length, hertz, damping, limits] = joint;
    all(ends, length, hertz, damping, limits);
}

void SnapshotFields::one(PrismaticJoint& joint) {
    auto& [ends, axis, reference, limits, motorSpeed, motorForce] = joint;
    all(ends, axis, reference, limits, motorSpeed, motorForce);
}

void SnapshotFields::one(MotorJoint& joint) {
    auto& [ends, reference, force, torque, hertz, damping] = joint;
    all(ends, reference, force, torque, hertz, damping);
}

void SnapshotFields::one(MouseJoint& joint) {
    auto& [body, anchor, target, force, hertz, damping] = joint;
    all(body, anchor, target, force, hertz, damping);
}

/// The sums of a step are not stored: the next step resets them.
void SnapshotFields::one(JointSet::Joint& joint) {
    auto& [def, point, axes, linearImpulseSum, angularImpulseSum, force, torque, solved,
           springBound, stiffness, mostBias] = joint;
    all(def, point, axes, force, torque);
    const Real impulses = std::accumulate(axes.begin(), axes.end(), point.x + point.y);
    require(!reads() || std::isfinite(impulses + force.x + force.y + torque),
            "an impulse of a joint is not finite");
}

void SnapshotFields::one(BrokenJoint& broken) {
    auto& [id, a, b, force, torque] = broken;
    all(id, a, b, force, torque);
}

void SnapshotFields::one(SoftSettings& settings) {
    auto& [substeps, impactPasses, contactHertz, contactDamping, jointHertz, jointDamping,
           pushSpeed] = settings;
    all(substeps, impactPasses, contactHertz, contactDamping, jointHertz, jointDamping, pushSpeed);
}

void SnapshotFields::one(PropagationSettings& settings) {
    auto& [substeps, impactPasses, contactPasses, shockPasses, jointHertz, jointDamping,
           pushSpeed] = settings;
    all(substeps, impactPasses, contactPasses, shockPasses, jointHertz, jointDamping, pushSpeed);
}

void SnapshotFields::one(StepSettings& settings) {
    auto& [solver, sleepSteps, leaveOut] = settings;
    all(solver, sleepSteps, leaveOut.bits);
    require(check(settings));
}

/// All tolerances follow from the length unit. It follows exactly from any of them, since their
/// ratios are powers of two.
void SnapshotFields::one(Tolerances& tolerances) {
    auto& [slop, margin, grown] = tolerances;
    Real unit = slop * Tolerances::kSlopsPerUnit;
    one(unit);
    require(check(WorldDef{{}, unit, {}}));
    tolerances = Tolerances::forUnit(unit);
}

} // namespace KODO_PRECISION
} // namespace kodo
