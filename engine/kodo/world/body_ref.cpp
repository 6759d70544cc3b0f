// SPDX-License-Identifier: MIT
#include <kodo/world/body_ref.hpp>
#include <kodo/world/world.hpp>

namespace kodo::inline KODO_PRECISION {

BodyView::BodyView(const World& world, BodyId id) : world_(&world), id_(id) {
    world.requireAlive(id);
}

const Bodies& BodyView::bodies() const {
    return world_->bodies_;
}

Vec2 BodyView::position() const {
    return bodies().originOf(index());
}
Rot BodyView::rotation() const {
    return bodies().pose[index()].rotation;
}
Vec2 BodyView::center() const {
    return bodies().pose[index()].position;
}
Vec2 BodyView::velocity() const {
    return bodies().motion[index()].velocity;
}
Real BodyView::angularVelocity() const {
    return bodies().motion[index()].angularVelocity;
}
Vec2 BodyView::velocityAt(Vec2 point) const {
    return kodo::velocityAt(bodies().motion[index()], point - center());
}
Real BodyView::mass() const {
    return bodies().form(index()).mass.mass;
}
Real BodyView::inertia() const {
    return bodies().form(index()).mass.inertia;
}
Real BodyView::area() const {
    return bodies().form(index()).area;
}
Flags BodyView::flags() const {
    return bodies().filter[index()].flags;
}
std::uint16_t BodyView::required() const {
    return bodies().filter[index()].required;
}
std::uint64_t BodyView::userData() const {
    return bodies().record[index()].userData;
}
std::size_t BodyView::partCount() const {
    return bodies().form(index()).parts.size();
}
const Part& BodyView::part(std::size_t index) const {
    return bodies().form(this->index()).parts.at(index);
}
const Transform& BodyView::placement() const {
    return bodies().pose[index()];
}

Aabb BodyView::bounds() const {
    return boundsOfBody(bodies(), index());
}

bool BodyView::contains(Vec2 point) const {
    for (std::size_t i = 0; i < partCount(); ++i) {
        if (kodo::contains(part(i).convex, placement(), point)) {
            return true;
        }
    }
    return false;
}

BodyRef::BodyRef(World& world, BodyId id) : BodyView(world, id), world_(&world) {}

Real BodyRef::unit() const {
    return world_->tolerances_.unit();
}

Motion& BodyRef::motion() {
    return world_->bodies_.motion[index()];
}

void BodyRef::changed() {
    world_->disturb(index());
    world_->placeInRegion(index());
    world_->contacts_.bodyChanged(index());
    world_->bodies_.jumped(index());
    world_->bodies_.awakeStale = true;
}

void BodyRef::thaw() {
    Flags& flags = world_->bodies_.filter[index()].flags;
    if ((flags & kFrozen) != 0) {
        flags &= ~kFrozen;
        refreshBuild(world_->bodies_, index());
        changed();
    }
}

void BodyRef::wake() {
    world_->wake(index());
}

void BodyRef::pushed() {
    wake();
    if (!bodies().locked(index())) {
        return;
    }
    const Motion& own = bodies().motion[index()];
    if (own.move == Vec2{} && own.turn == 0) { // it stood, and may begin to move what lies on it
        world_->disturb(index());
        if ((bodies().filter[index()].flags & kOutside) != 0) {
            world_->putContactsAside(); // again: it goes on waiting
        }
    }
    world_->bodies_.awakeStale = true;
}

void BodyRef::setPosition(Vec2 position) {
    refuse(checkPosition("position", position, unit()));
    Transform& pose = world_->bodies_.pose[index()];
    pose.position = position + pose.rotation * bodies().form(index()).mass.center;
    changed();
}

void BodyRef::setRotation(Rot rotation) {
    refuse(checkRotation("rotation", rotation));
    const Vec2 origin = position();
    refuse(checkPosition("position", origin, unit())); // before anything is changed
    world_->bodies_.pose[index()].rotation = normalize(rotation);
    setPosition(origin);
}

void BodyRef::setVelocity(Vec2 velocity) {
    refuse(checkVelocity("velocity", velocity, unit()));
    thaw();
    motion().velocity = velocity;
    pushed();
}

void BodyRef::setAngularVelocity(Real radiansPerSecond) {
    refuse(checkRange("angularVelocity", radiansPerSecond, -kHighestSpeed, kHighestSpeed));
    thaw();
    motion().angularVelocity = radiansPerSecond;
    pushed();
}

void BodyRef::moveTo(Vec2 position, Real dt) {
    moveTo(position, rotation(), dt);
}

void BodyRef::moveTo(Vec2 position, Rot rotation, Real dt) {
    refuse(checkPosition("position", position, unit()));
    refuse(checkRotation("rotation", rotation));
    refuse(checkRange("dt", dt, kShortestStep, kLongestStep));
    const Vec2 target = position + rotation * bodies().form(index()).mass.center;
    const Vec2 velocity = (target - center()) / dt;
    const Real spin = (rotation * this->rotation().inverse()).angle() / dt;
    refuse(checkVelocity("velocity", velocity, unit()));
    refuse(checkRange("angularVelocity", spin, -kHighestSpeed, kHighestSpeed));
    thaw();
    motion().velocity = velocity;
    motion().angularVelocity = spin;
    pushed();
}

void BodyRef::applyForce(Vec2 force) {
    pushFrom({}, force);
}

void BodyRef::applyForce(Vec2 force, Vec2 point) {
    refuse(checkPosition("point", point, unit()));
    pushFrom(point - center(), force);
}

void BodyRef::pushFrom(Vec2 arm, Vec2 force) {
    refuse(isFinite(force) ? std::nullopt : std::optional(Problem{"force", "must be finite"}));
    addForce(world_->bodies_, index(), force, cross(arm, force));
    wake();
}

void BodyRef::applyTorque(Real torque) {
    refuse(std::isfinite(torque) ? std::nullopt
                                 : std::optional(Problem{"torque", "must be finite"}));
    addForce(world_->bodies_, index(), {}, torque);
    wake();
}

void BodyRef::applyImpulse(Vec2 impulse) {
    strikeFrom({}, impulse);
}

void BodyRef::applyImpulse(Vec2 impulse, Vec2 point) {
    refuse(checkPosition("point", point, unit()));
    strikeFrom(point - center(), impulse);
}

void BodyRef::strikeFrom(Vec2 arm, Vec2 impulse) {
    refuse(isFinite(impulse) ? std::nullopt : std::optional(Problem{"impulse", "must be finite"}));
    Motion after = bodies().motion[index()];
    kodo::applyImpulse(after, arm, impulse);
    refuse(checkVelocity("velocity after the impulse", after.velocity, unit()));
    refuse(checkRange("angularVelocity after the impulse", after.angularVelocity, -kHighestSpeed,
                      kHighestSpeed));
    motion() = after;
    pushed();
}

void BodyRef::setFlags(Flags flags) {
    for (std::size_t i = 0; i < partCount(); ++i) {
        refuse(checkLock(part(i).primitive, flags));
    }
    refuse(checkFlags("flags", flags));
    changed();
    Flags& own = world_->bodies_.filter[index()].flags;
    own = (flags & ~kStatusFlags) | (own & kStatusFlags);
    refreshBuild(world_->bodies_, index());
}

void BodyRef::setRequired(std::uint16_t required) {
    world_->bodies_.filter[index()].required = required;
    changed();
}

void BodyRef::setUserData(std::uint64_t userData) {
    world_->bodies_.record[index()].userData = userData;
}

void BodyRef::setMaterial(const Material& material) {
    refuse(check(material));
    std::vector<Part> parts = bodies().form(index()).parts;
    for (Part& part : parts) {
        part.material = material;
    }
    setForm(world_->bodies_, index(), makeForm(std::move(parts)));
    changed();
}

} // namespace kodo::inline KODO_PRECISION
