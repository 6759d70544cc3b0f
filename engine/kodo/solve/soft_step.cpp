// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/soft_step.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kodo::inline KODO_PRECISION {
namespace {

// So many bodies may overlap one deeply before their pushes are shared out: no more fit around it.
constexpr int kNeighbours = 7;

/// What all rows of a substep share.
struct PassSettings {
    Softness soft;
    Softness onLocked;
    Real invH;
    bool friction;
};

Real effectiveMass(const Motion& a, const Motion& b, Real leverA, Real leverB) {
    const Real k =
        a.invMass + b.invMass + a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    return k > 0 ? 1 / k : 0; // 0: neither can give way
}

ContactRow makeRow(const Bodies& bodies, const Contact& contact, std::uint32_t place) {
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    const Manifold& manifold = contact.manifold;
    const Vec2 n = manifold.normal;
    ContactRow row{};
    row.a = contact.key.bodyA;
    row.b = contact.key.bodyB;
    row.contact = place;
    row.count = manifold.count;
    row.onLocked = a.invMass == 0 || b.invMass == 0;
    row.normal = n;
    Vec2 meanA;
    Vec2 meanB;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        const ManifoldPoint& p = manifold.points[i];
        const Real leverA = cross(p.armA, n);
        const Real leverB = cross(p.armB, n);
        row.points[i] = {leverA, leverB, effectiveMass(a, b, leverA, leverB), p.separation,
                         contact.impulse[i].normal};
        meanA += p.armA;
        meanB += p.armB;
    }
    const Real share = Real(1) / static_cast<Real>(row.count);
    row.tangentLeverA = cross(share * meanA, perp(n));
    row.tangentLeverB = cross(share * meanB, perp(n));
    row.tangentMass = effectiveMass(a, b, row.tangentLeverA, row.tangentLeverB);
    row.friction = contact.friction;
    row.staticFriction = contact.material.staticFriction;
    row.kineticFriction = contact.material.kineticFriction;
    return row;
}

/// A rolling body is braked with a torque of at most resistance * radius * normal force, where the
/// radius is the distance from its centre to the contact [Thesis06, 4.3.3].
void addRolling(ContactRow& row, const Bodies& bodies, const Contact& contact) {
    const Motion& a = bodies.motion[row.a];
    const Motion& b = bodies.motion[row.b];
    const Real freedom = a.invInertia + b.invInertia;
    if (contact.material.rollingResistance == 0 || freedom == 0) {
        return;
    }
    const ManifoldPoint& p = contact.manifold.points[0];
    const Real radiusA = a.invInertia > 0 ? length(p.armA) : std::numeric_limits<Real>::max();
    const Real radiusB = b.invInertia > 0 ? length(p.armB) : std::numeric_limits<Real>::max();
    row.rollingLever = contact.material.rollingResistance * std::min(radiusA, radiusB);
    row.rollingMass = 1 / freedom;
    row.rolling = contact.rolling;
}

/// A row is needed once the bodies are near enough to touch within the step. Those that bounce must
/// not be braked before they touch, or they would lose the speed they bounce with.
bool needsRow(const Bodies& bodies, const Contact& contact, const StepSettings& settings,
              const Tolerances& tolerances) {
    // What rests is woken by a touch, not by what comes near.
    if (!contact.responds() || bodies.resting(contact.key.bodyA) ||
        bodies.resting(contact.key.bodyB)) {
        return false;
    }
    const bool bounces = contact.material.restitution > 0 && settings.has(Feature::Restitution);
    return !bounces || contact.manifold.points[0].separation <= tolerances.slop;
}

void push(Motion& a, Motion& b, Vec2 impulse, Real spinA, Real spinB) {
    a.velocity -= a.invMass * impulse;
    a.angularVelocity -= a.invInertia * spinA;
    b.velocity += b.invMass * impulse;
    b.angularVelocity += b.invInertia * spinB;
}

void warmStart(const ContactRow& row, Motion& a, Motion& b) {
    Vec2 impulse = row.friction * perp(row.normal);
    Real spinA = row.tangentLeverA * row.friction + row.rolling;
    Real spinB = row.tangentLeverB * row.friction + row.rolling;
    for (int i = 0; i < row.count; ++i) {
        const ContactRow::Point& p = row.points[i];
        impulse += p.impulse * row.normal;
        spinA += p.leverA * p.impulse;
        spinB += p.leverB * p.impulse;
    }
    push(a, b, impulse, spinA, spinB);
}

template <bool Biased>
void solveNormals(ContactRow& row, Motion& a, Motion& b, const PassSettings& pass) {
    const Softness& soft = row.onLocked ? pass.onLocked : pass.soft;
    const Vec2 n = row.normal;
    const Real moved = dot(n, b.move - a.move);
    for (int i = 0; i < row.count; ++i) {
        ContactRow::Point& p = row.points[i];
        const Real s = p.separation + moved + p.leverB * b.turn - p.leverA * a.turn;
        Real bias = 0;
        Real massScale = 1;
        Real impulseScale = 0;
        if (s > 0) {
            bias = s * pass.invH; // may close the gap within the substep, and no more
        } else if (Biased) {
            bias = std::max(soft.biasRate * s, -row.pushSpeed);
            massScale = soft.massScale;
            impulseScale = soft.impulseScale;
        }
        const Real speed = dot(n, b.velocity - a.velocity) + p.leverB * b.angularVelocity -
                           p.leverA * a.angularVelocity;
        const Real wanted =
            p.impulse - p.mass * (massScale * speed + bias * massScale) - impulseScale * p.impulse;
        const Real next = std::max(wanted, Real(0));
        const Real change = next - p.impulse;
        p.impulse = next;
        push(a, b, change * n, p.leverA * change, p.leverB * change);
    }
}

void solveFriction(ContactRow& row, Motion& a, Motion& b) {
    const Real load = row.points[0].impulse + (row.count == 2 ? row.points[1].impulse : 0);
    const Vec2 t = perp(row.normal);
    const Real speed = dot(t, b.velocity - a.velocity) + row.tangentLeverB * b.angularVelocity -
                       row.tangentLeverA * a.angularVelocity;
    const Real stick = row.friction - row.tangentMass * speed;
    const Real slip = row.kineticFriction * load;
    const bool sticks = std::abs(stick) <= row.staticFriction * load;
    const Real next = sticks ? stick : std::clamp(stick, -slip, slip);
    const Real change = next - row.friction;
    row.friction = next;
    push(a, b, change * t, row.tangentLeverA * change, row.tangentLeverB * change);
}

void solveRolling(ContactRow& row, Motion& a, Motion& b) {
    const Real load = row.points[0].impulse + (row.count == 2 ? row.points[1].impulse : 0);
    const Real limit = row.rollingLever * load;
    const Real wanted = row.rolling - row.rollingMass * (b.angularVelocity - a.angularVelocity);
    const Real next = std::clamp(wanted, -limit, limit);
    const Real change = next - row.rolling;
    row.rolling = next;
    push(a, b, {}, change, change);
}

template <bool Biased>
void solvePass(std::vector<ContactRow>& rows, Bodies& bodies, const PassSettings& pass) {
    for (ContactRow& row : rows) {
        Motion& a = bodies.motion[row.a];
        Motion& b = bodies.motion[row.b];
        solveNormals<Biased>(row, a, b, pass);
        if (pass.friction) {
            solveFriction(row, a, b);
        }
        if (row.rollingLever > 0) {
            solveRolling(row, a, b);
        }
    }
}

} // namespace

void SoftStep::makeRows(const Bodies& bodies, std::span<const Contact> contacts,
                        const JointSet& joints, const StepSettings& settings,
                        const Tolerances& tolerances) {
    rows_.clear();
    held_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        held_[body] = 0;
    }
    joints.forEach([&](const JointSet::Joint& joint) {
        held_[firstBody(joint.def).index] = 1;
        held_[secondBody(joint.def).index] = 1;
    });
    countCrowds(bodies, contacts, tolerances);
    const Real pushSpeed = settings.pushSpeed * tolerances.slop * Tolerances::kSlopsPerUnit;
    // Contacts with the ground come last in each pass, so that they have the last word.
    for (const bool onLocked : {false, true}) {
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact& contact = contacts[i];
            const bool locked = bodies.motion[contact.key.bodyA].invMass == 0 ||
                                bodies.motion[contact.key.bodyB].invMass == 0;
            if (locked != onLocked || !needsRow(bodies, contact, settings, tolerances)) {
                continue;
            }
            rows_.push_back(makeRow(bodies, contact, static_cast<std::uint32_t>(i)));
            const int crowd = std::max(crowd_[contact.key.bodyA], crowd_[contact.key.bodyB]);
            rows_.back().pushSpeed =
                pushSpeed / static_cast<Real>(std::max(1, crowd - kNeighbours));
            if (settings.has(Feature::RollingResistance)) {
                addRolling(rows_.back(), bodies, contact);
            }
            if (contact.manifold.points[0].separation <= tolerances.slop) {
                held_[contact.key.bodyA] = 1;
                held_[contact.key.bodyB] = 1;
            }
        }
    }
}

/// A body in the middle of a heap is pushed by all of it, and those behind push on; together they
/// must not exceed the speed that one of them may push with, or the heap would burst.
void SoftStep::countCrowds(const Bodies& bodies, std::span<const Contact> contacts,
                           const Tolerances& tolerances) {
    crowd_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        crowd_[body] = 0;
    }
    for (const Contact& contact : contacts) {
        if (contact.responds() && contact.manifold.points[0].separation < -4 * tolerances.slop) {
            for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
                crowd_[body] = static_cast<std::uint16_t>(crowd_[body] + !bodies.locked(body));
            }
        }
    }
}

void SoftStep::solve(Bodies& bodies, std::span<Contact> contacts, JointSet& joints,
                     const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    makeRows(bodies, contacts, joints, settings, tolerances);
    const Real h = dt / static_cast<Real>(settings.substeps);
    const Real hertz = std::min(settings.contactHertz, Real(0.25) / h);
    const PassSettings pass{Softness::from(hertz, settings.contactDamping, h),
                            Softness::from(2 * hertz, settings.contactDamping, h), 1 / h,
                            settings.has(Feature::Friction)};
    JointPass jointPass{
        h, Softness::from(std::min(settings.jointHertz, Real(0.25) / h), settings.jointDamping, h)};
    joints.beginStep();
    for (int substep = 0; substep < settings.substeps; ++substep) {
        integrateVelocities(bodies, h);
        joints.warmStart(bodies, jointPass);
        for (const ContactRow& row : rows_) {
            warmStart(row, bodies.motion[row.a], bodies.motion[row.b]);
        }
        jointPass.biased = true;
        joints.solve(bodies, jointPass);
        solvePass<true>(rows_, bodies, pass);
        integrateMoves(bodies, held_, h);
        jointPass.biased = false;
        joints.solve(bodies, jointPass);
        solvePass<false>(rows_, bodies, pass);
        store(contacts);
    }
}

/// Hands the impulses of one substep to the contacts they belong to.
void SoftStep::store(std::span<Contact> contacts) const {
    for (const ContactRow& row : rows_) {
        Contact& contact = contacts[row.contact];
        contact.friction = row.friction;
        contact.rolling = row.rolling;
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
            PointImpulse& impulse = contact.impulse[i];
            impulse.normal = row.points[i].impulse;
            impulse.largest = std::max(impulse.largest, impulse.normal);
            contact.total += impulse.normal;
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
