// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/integrate.hpp"
#include "world/world_impl.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

void refuseIfStatic(const char* field, const BodyView& body, bool moves) {
    if (moves && body.type() == BodyType::Static) {
        refuse(Problem{field, kMustBeZeroForStatic});
    }
}

/// Refusal of a target of moveTo() that requires too high a speed, in a unit of length or rotation.
Problem tooFar(const char* field, Real speed, Real most, const char* unit, Real dt) {
    return Problem{field, "is too far to be reached in dt = " + textOf(dt) + " s: it takes " +
                              textOf(speed) + " " + unit + ", but a body has at most " +
                              textOf(most) + " " + unit +
                              "; setPosition() and setRotation() teleport"};
}

/// The material of each part of another body; that of its last part for the parts beyond.
void copyMaterials(PartList& list, const BodyView& other) {
    for (std::size_t i = 0; i < list.parts.size(); ++i) {
        list.parts[i].material = other.part(std::min(i, other.partCount() - 1)).material;
    }
}

/// Moment of inertia of a body by m r^2, r being the distance of its farthest point. Welded masses
/// may have less than kMinInertiaShare.
Real inertiaShareOf(const BodyView& body) {
    Real rim = 0;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        rim = std::max(rim, body.part(i).convex.boundingRadius);
    }
    return body.inertia() / (body.mass() * rim * rim); // NaN for a particle
}

/// Checks the mass of another body for these parts. The inertia of a particle is 0. A rim need not
/// be firmer than that of the other body.
std::optional<Problem> checkCopied(const BodyView& other, std::span<const Part> parts, Real unit) {
    MassDef mass{other.mass(), other.localCenter(), other.inertia()};
    if (mass.inertia == 0 && massFromDensity(parts).inertia == 0) {
        mass.inertia.reset();
    }
    constexpr Real kRounding = Real(0.999);
    const Real share = std::fmin(kRounding * inertiaShareOf(other), kMinInertiaShare);
    auto problem = checkMassDef(mass, parts, unit, share);
    if (problem) {
        problem->field = "other." + problem->field;
    }
    return problem;
}

/// Gives parts the mass of another body. False if a body that no force moves keeps its own mass,
/// since its parts cannot have that of the other.
bool copyMass(PartList& list, const BodyView& other, Flags flags, Real unit) {
    const auto hasMass = [&](const Mass& own) {
        return other.mass() == own.mass && other.localCenter() == own.center &&
               other.inertia() == own.inertia;
    };
    if (hasMass(massOf(list))) {
        return true;
    }
    if (hasMass(massFromDensity(list.parts))) {
        list.setMasses.clear();
        return true;
    }
    const auto problem = checkCopied(other, list.parts, unit);
    if (problem && locksOf(flags) == kLockBoth) {
        return false;
    }
    refuse(problem);
    setMass(list, {other.mass(), other.localCenter(), other.inertia()});
    return true;
}

} // namespace

BodyRef::BodyRef(WorldImpl& world, BodyId id) : BodyView(world.bodies_, id), world_(&world) {}

/// For setters: the index, checked.
std::uint32_t BodyRef::changing(const char* call) const {
    world_->guard_.requireChangeable(call);
    return index();
}

void BodyRef::setPosition(Vec2 position) {
    const std::uint32_t body = changing("BodyRef::setPosition");
    Bodies& bodies = world_->bodies_;
    refuse(checkPosition("position", position, world_->tolerances_.unit()));
    Transform& pose = bodies.pose[body];
    pose.position = position + pose.rotation * bodies.geometry(body).mass.center;
    world_->bodyChanged(body);
}

void BodyRef::setRotation(Rot rotation) {
    const std::uint32_t body = changing("BodyRef::setRotation");
    refuse(checkRotation("rotation", rotation));
    const Vec2 origin = position();
    refuse(checkPosition("position", origin, world_->tolerances_.unit())); // before any change
    world_->bodies_.pose[body].rotation = normalize(rotation);
    setPosition(origin);
}

void BodyRef::setVelocity(Vec2 velocity) {
    const std::uint32_t body = changing("BodyRef::setVelocity");
    refuse(checkVelocity("velocity", velocity, world_->tolerances_.unit()));
    refuseIfStatic("velocity", *this, velocity != Vec2{});
    world_->thaw(body);
    world_->bodies_.motion[body].velocity = velocity;
    world_->velocityChanged(body);
}

void BodyRef::setAngularVelocity(Real radiansPerSecond) {
    const std::uint32_t body = changing("BodyRef::setAngularVelocity");
    refuse(checkAngularVelocity("angularVelocity", radiansPerSecond));
    refuseIfStatic("angularVelocity", *this, radiansPerSecond != 0);
    world_->thaw(body);
    world_->bodies_.motion[body].angularVelocity = radiansPerSecond;
    world_->velocityChanged(body);
}

void BodyRef::moveTo(Vec2 position, Real dt) {
    moveTo(position, rotation(), dt);
}

void BodyRef::moveTo(Vec2 position, Rot rotation, Real dt) {
    const std::uint32_t body = changing("BodyRef::moveTo");
    const Real unit = world_->tolerances_.unit();
    refuse(checkPosition("position", position, unit));
    refuse(checkRotation("rotation", rotation));
    refuse(checkTimeStep(dt));
    const Vec2 target = position + rotation * world_->bodies_.geometry(body).mass.center;
    const Vec2 velocity = (target - center()) / dt;
    const Real spin = (rotation * this->rotation().inverse()).angle() / dt;
    if (checkVelocity("position", velocity, unit)) {
        refuse(tooFar("position", length(velocity), kMaxSpeed * unit, "m/s", dt));
    }
    if (checkAngularVelocity("rotation", spin)) {
        refuse(tooFar("rotation", std::abs(spin), kMaxSpeed, "rad/s", dt));
    }
    if (type() == BodyType::Static && (velocity != Vec2{} || spin != 0)) {
        refuse(Problem{"position", "and rotation must be the present ones for a static body: make "
                                   "it Kinematic"});
    }
    world_->thaw(body);
    BodyVelocity& motion = world_->bodies_.motion[body];
    motion.velocity = velocity;
    motion.angularVelocity = spin;
    world_->velocityChanged(body);
}

void BodyRef::applyForce(Vec2 force) {
    const std::uint32_t body = changing("BodyRef::applyForce");
    refuse(checkFinite("force", force));
    world_->addForce(body, force, 0);
}

void BodyRef::applyForce(Vec2 force, Vec2 point) {
    const std::uint32_t body = changing("BodyRef::applyForce");
    refuse(checkPosition("point", point, world_->tolerances_.unit()));
    refuse(checkFinite("force", force));
    world_->addForce(body, force, cross(point - center(), force));
}

void BodyRef::applyTorque(Real torque) {
    const std::uint32_t body = changing("BodyRef::applyTorque");
    refuse(checkFinite("torque", torque));
    world_->addForce(body, {}, torque);
}

void BodyRef::applyImpulse(Vec2 impulse) {
    world_->applyImpulse(changing("BodyRef::applyImpulse"), impulse, 0);
}

void BodyRef::applyImpulse(Vec2 impulse, Vec2 point) {
    const std::uint32_t body = changing("BodyRef::applyImpulse");
    refuse(checkPosition("point", point, world_->tolerances_.unit()));
    world_->applyImpulse(body, impulse, cross(point - center(), impulse));
}

void BodyRef::applyAngularImpulse(Real impulse) {
    const std::uint32_t body = changing("BodyRef::applyAngularImpulse");
    refuse(checkFinite("impulse", impulse));
    world_->applyImpulse(body, {}, impulse);
}

void BodyRef::setType(BodyType type) {
    const std::uint32_t body = changing("BodyRef::setType");
    refuse(checkType(type));
    for (std::size_t i = 0; i < partCount(); ++i) {
        refuse(checkPlaneType(part(i).primitive, (flags() & ~kTypeBits) | bitsOf(type)));
    }
    world_->bodyChanged(body);
    Flags& own = world_->bodies_.filter[body].flags; // after bodyChanged, which may wake the body
    own = (own & ~kTypeBits) | bitsOf(type);
    if (type == BodyType::Static) {
        world_->bodies_.motion[body].stop();
    }
    refreshDerived(world_->bodies_, body);
}

void BodyRef::setFlags(Flags flags) {
    const std::uint32_t body = changing("BodyRef::setFlags");
    constexpr Flags kKept = kStatusFlags | kTypeBits;
    const Flags kept = world_->bodies_.filter[body].flags & kKept;
    refuse(checkFlags("flags", flags));
    for (std::size_t i = 0; i < partCount(); ++i) {
        if (checkPlaneType(part(i).primitive, (flags & ~kKept) | kept)) {
            refuse(Problem{"flags", "must have kLockMove and kLockRotate: a plane has no mass"});
        }
    }
    world_->bodyChanged(body);
    Flags& own = world_->bodies_.filter[body].flags; // bodyChanged() may have changed the status
    own = (flags & ~kKept) | (own & kKept);
    world_->flagBlocks_.note(body, flags);
    refreshDerived(world_->bodies_, body);
}

void BodyRef::setRequired(Flags required) {
    const std::uint32_t body = changing("BodyRef::setRequired");
    refuse(checkRequired("required", required));
    world_->bodies_.filter[body].required = required;
    world_->bodyChanged(body);
}

void BodyRef::setGroup(std::int32_t group) {
    const std::uint32_t body = changing("BodyRef::setGroup");
    world_->bodies_.filter[body].group = group;
    world_->bodyChanged(body);
}

void BodyRef::setUserData(std::uint64_t userData) {
    world_->bodies_.record[changing("BodyRef::setUserData")].userData = userData;
}

void BodyRef::setMaterial(const Material& material) {
    const std::uint32_t body = changing("BodyRef::setMaterial");
    refuse(check(material));
    PartList list = world_->bodies_.geometry(body);
    for (Part& part : list.parts) {
        part.material = material;
    }
    setGeometry(world_->bodies_, body, makeGeometry(std::move(list)));
    world_->bodyChanged(body);
}

void BodyRef::setPart(std::size_t index, const Part& part) {
    const std::uint32_t body = changing("BodyRef::setPart");
    const Part& old = this->part(index);
    refuse(checkRules(part));
    PartList list = world_->bodies_.geometry(body);
    list.parts[index] = part;
    if (!(part.primitive == old.primitive)) {
        refuse(check(part.primitive));
        refuse(checkPlaneType(part.primitive, world_->bodies_.filter[body].flags));
        if (hasSetMass()) {
            refuse(Problem{"primitive", "must stay while a mass is set: call setMassFromDensity() "
                                        "before, and setMass() after"});
        }
    }
    refuse(checkParts(list.parts, world_->tolerances_.unit()));
    setGeometryInMotion(world_->bodies_, body, makeGeometry(std::move(list)));
    world_->bodyChanged(body);
}

void BodyRef::setLinearDamping(Real perSecond) {
    const std::uint32_t body = changing("BodyRef::setLinearDamping");
    world_->setRules(body, {perSecond, angularDamping(), gravityScale(), continuousMode()});
}

void BodyRef::setAngularDamping(Real perSecond) {
    const std::uint32_t body = changing("BodyRef::setAngularDamping");
    world_->setRules(body, {linearDamping(), perSecond, gravityScale(), continuousMode()});
}

void BodyRef::setGravityScale(Real scale) {
    const std::uint32_t body = changing("BodyRef::setGravityScale");
    world_->setRules(body, {linearDamping(), angularDamping(), scale, continuousMode()});
}

void BodyRef::setContinuousMode(ContinuousMode mode) {
    const std::uint32_t body = changing("BodyRef::setContinuousMode");
    world_->setRules(body, {linearDamping(), angularDamping(), gravityScale(), mode});
}

void BodyRef::setMass(const MassDef& mass) {
    const std::uint32_t body = changing("BodyRef::setMass");
    PartList list = world_->bodies_.geometry(body);
    refuse(checkMassDef(mass, list.parts, world_->tolerances_.unit()));
    kodo::setMass(list, massOf(mass, massFromDensity(list.parts)));
    setGeometryInMotion(world_->bodies_, body, makeGeometry(std::move(list)));
    world_->bodyChanged(body);
}

void BodyRef::setMassFromDensity() {
    const std::uint32_t body = changing("BodyRef::setMassFromDensity");
    PartList list = world_->bodies_.geometry(body);
    refuse(checkHasMass(list.parts));
    list.setMasses.clear();
    setGeometryInMotion(world_->bodies_, body, makeGeometry(std::move(list)));
    world_->bodyChanged(body);
}

void BodyRef::copyFrom(const BodyView& other) {
    const std::uint32_t body = changing("BodyRef::copyFrom");
    const Real unit = world_->tolerances_.unit();
    refuse(checkPosition("other.position", other.position(), unit));
    refuse(checkVelocity("other.velocity", other.velocity(), unit));
    const Flags given = (other.flags() & ~kStatusFlags) | bitsOf(other.type());
    PartList list = world_->bodies_.geometry(body);
    for (const Part& part : list.parts) {
        refuse(checkPlaneType(part.primitive, given));
    }
    copyMaterials(list, other);
    Transform pose = other.massFrame(); // copies: `other` may be this body
    if (!copyMass(list, other, given, unit)) {
        pose.position = other.position() + pose.rotation * kodo::massOf(list).center;
    }
    const Vec2 velocity =
        pose.position == other.center() ? other.velocity() : other.velocityAt(pose.position);
    Bodies& bodies = world_->bodies_;
    const Real spin = other.angularVelocity();
    const Flags required = other.required();
    const std::int32_t group = other.group();
    const MotionRules rules{other.linearDamping(), other.angularDamping(), other.gravityScale(),
                            other.continuousMode()};
    setGeometry(bodies, body, makeGeometry(std::move(list)));
    bodies.pose[body] = pose;
    world_->bodyChanged(body);
    CollisionFilter& filter = bodies.filter[body]; // after bodyChanged, which may wake the body
    filter = {(filter.flags & kStatusFlags & ~kFrozen) | given, required, group};
    world_->flagBlocks_.note(body, given);
    setRules(bodies, body, rules);
    bodies.motion[body].velocity = velocity;
    bodies.motion[body].angularVelocity = spin;
    if (type() == BodyType::Static) {
        bodies.motion[body].stop();
    }
    refreshDerived(bodies, body);
    world_->velocityChanged(body);
}

void BodyRef::wake() {
    const std::uint32_t body = changing("BodyRef::wake");
    world_->sleep_.wakeAround(world_->bodies_, world_->contacts_, world_->joints_, body);
}

bool BodyRef::sleep() {
    const std::uint32_t body = changing("BodyRef::sleep");
    return world_->settings_.has(Feature::Sleep) &&
           world_->sleep_.putToSleep(world_->bodies_, world_->contacts_, world_->joints_, body);
}

} // namespace KODO_PRECISION
} // namespace kodo
