// SPDX-License-Identifier: MIT
#include <kodo/world/snapshot_fields.hpp>

// The plain values, in the order in which they lie in memory unless a comment says otherwise.
namespace kodo::inline KODO_PRECISION {

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

void SnapshotFields::one(Motion& motion) {
    auto& [velocity, angularVelocity, invMass, move, turn, invInertia] = motion;
    all(velocity, angularVelocity, move, turn);
}

void SnapshotFields::one(Acceleration& acceleration) {
    auto& [linear, angular, effort] = acceleration;
    all(linear, angular, effort);
}

void SnapshotFields::one(RestState& rest) {
    auto& [calmSteps, island, since, leastEnergy] = rest;
    all(calmSteps, since, leastEnergy);
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
    require(law <= Attractor::Law::Linear, "there is no such law of attraction");
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

/// Where a contact has its lane decides nothing.
void SnapshotFields::one(ContactRow& row) {
    auto& [index, colour, fixedA, fixedB, lent] = row;
    all(colour, fixedA, fixedB);
    require(colour < 64 || colour == ContactRow::kNoColour, "there is no such colour");
}

void SnapshotFields::one(Contact& contact) {
    auto& [key, jumpsA, jumpsB, drift, row, approachSpeed, near, carried, bounces, sensor, passing,
           hidden, touching, wasTouching, struck, phase, manifold, centerA, impulse, friction,
           rolling, total, a, b, material] = contact; // the phase is in the records
    all(key, centerA, manifold, jumpsA, jumpsB, drift, impulse, row, friction, rolling,
        approachSpeed, total);
    all(near, carried, passing, hidden, touching, wasTouching);
    struck = true; // for all that is known
}

void SnapshotFields::one(CollisionRecord& record) {
    auto& [a, b, partA, partB, phase, pointCount, point, normal, separation, approachSpeed,
           maxImpulse, totalImpulse] = record;
    all(a, b, partA, partB);
    as<std::uint8_t>(phase);
    require(phase <= TouchPhase::End, "a collision record has no such phase");
    all(pointCount, point, normal, separation, approachSpeed, maxImpulse, totalImpulse);
}

void SnapshotFields::one(RestStage::Island& island) {
    auto& [bodies, contacts] = island;
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

void SnapshotFields::one(Pin& pin) {
    auto& [ends, reference, limits, motorSpeed, motorTorque] = pin;
    all(ends, reference, limits, motorSpeed, motorTorque);
}

void SnapshotFields::one(Weld& weld) {
    auto& [ends, reference] = weld;
    all(ends, reference);
}

void SnapshotFields::one(Spring& spring) {
    auto& [ends, length, hertz, damping, limits] = spring;
    all(ends, length, hertz, damping, limits);
}

void SnapshotFields::one(Slider& slider) {
    auto& [ends, axis, reference, limits, motorSpeed, motorForce] = slider;
    all(ends, axis, reference, limits, motorSpeed, motorForce);
}

void SnapshotFields::one(Motor& motor) {
    auto& [ends, reference, force, torque, hertz, damping] = motor;
    all(ends, reference, force, torque, hertz, damping);
}

void SnapshotFields::one(Mouse& mouse) {
    auto& [body, anchor, target, force, hertz, damping] = mouse;
    all(body, anchor, target, force, hertz, damping);
}

/// The sums of a step begin anew in the next.
void SnapshotFields::one(JointSet::Joint& joint) {
    auto& [def, point, axes, pushSum, turnSum, force, torque, solved] = joint;
    all(def, point, axes, force, torque);
}

void SnapshotFields::one(BrokenJoint& broken) {
    auto& [id, a, b, force, torque] = broken;
    all(id, a, b, force, torque);
}

void SnapshotFields::one(StepSettings& settings) {
    auto& [strategy, substeps, impactPasses, contactPasses, shockPasses, contactHertz,
           contactDamping, jointHertz, jointDamping, pushSpeed, restSteps, leaveOut] = settings;
    as<std::uint8_t>(strategy);
    all(substeps, impactPasses, contactPasses, shockPasses, contactHertz, contactDamping);
    all(jointHertz, jointDamping, pushSpeed, restSteps, leaveOut);
    require(check(settings));
}

/// All follow from the length unit, and it from any of them: their ratios are powers of two.
void SnapshotFields::one(Tolerances& tolerances) {
    auto& [slop, margin, grown] = tolerances;
    Real unit = slop * Tolerances::kSlopsPerUnit;
    one(unit);
    require(check(WorldDef{{}, unit, {}}));
    tolerances = Tolerances::forUnit(unit);
}

} // namespace kodo::inline KODO_PRECISION
