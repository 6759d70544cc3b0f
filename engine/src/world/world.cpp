// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "world/world_impl.hpp"

#include <stdexcept>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

const WorldImpl& wholeOf(const World& world) {
    world.impl().guard().requireWhole("A copy of this World");
    return world.impl();
}

} // namespace

World::World(const WorldDef& def) : impl_(std::make_unique<WorldImpl>(def)) {}
World::World(const World& other) : impl_(std::make_unique<WorldImpl>(wholeOf(other))) {}
World::World(World&& other) noexcept = default;
World& World::operator=(const World& other) {
    if (this == &other) {
        return *this;
    }
    if (impl_) {
        change("World::operator=");
        *impl_ = wholeOf(other); // in place: handles to bodies of this World stay valid
    } else {
        impl_ = std::make_unique<WorldImpl>(wholeOf(other));
    }
    return *this;
}
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

WorldImpl& World::impl() {
    return const_cast<WorldImpl&>(std::as_const(*this).impl());
}
const WorldImpl& World::impl() const {
    if (!impl_) {
        throw std::logic_error("this World was moved from: assign a World to it first");
    }
    return *impl_;
}

/// For calls that change the World.
WorldImpl& World::change(const char* call) {
    impl().guard().requireChangeable(call);
    return impl();
}

BodyId World::add(const BodyDef& def) {
    return change("World::add").add(def);
}
void World::remove(BodyId id) {
    change("World::remove").remove(id);
}
BodyId World::clone(BodyId id, Vec2 position) {
    return change("World::clone").clone(id, position);
}
bool World::contains(BodyId id) const {
    return impl().bodyData().alive(id);
}
std::size_t World::bodyCount() const {
    return impl().bodyCount();
}
std::vector<BodyId> World::bodies() const {
    const Bodies& all = impl().bodyData();
    std::vector<BodyId> ids;
    ids.reserve(bodyCount());
    all.ids.forEach([&](std::uint32_t body) { ids.push_back(all.idAt(body)); });
    return ids;
}
std::vector<BodyId> World::movedBodies() const {
    const Bodies& all = impl().bodyData();
    std::vector<BodyId> ids;
    for (const std::uint32_t body : all.awake) { // also those that fell asleep in the step
        if (all.ids.aliveAt(body) && (all.asleep(body) || !all.motion[body].unmoved())) {
            ids.push_back(all.idAt(body));
        }
    }
    return ids;
}

BodyRef World::operator[](BodyId id) {
    return impl()[id];
}
BodyView World::operator[](BodyId id) const {
    return {impl().bodyData(), id};
}
std::size_t World::weld(BodyId into, BodyId part) {
    return change("World::weld").weld(into, part);
}
std::size_t World::weld(BodyId into, const Primitive& shape, const Material& material,
                        Real density) {
    return change("World::weld").weld(into, shape, material, density);
}
BodyId World::unweld(BodyId body, std::size_t part, std::optional<Flags> flags) {
    return change("World::unweld").unweld(body, part, flags);
}

JointId World::addJoint(const JointDef& def) {
    return change("World::add").add(def);
}
void World::remove(JointId id) {
    change("World::remove").remove(id);
}
bool World::contains(JointId id) const {
    return impl().jointData().contains(id);
}
const JointDef& World::joint(JointId id) const {
    return impl().joint(id);
}
void World::setJoint(JointId id, const JointDef& def) {
    change("World::setJoint").setJoint(id, def);
}
Vec2 World::jointForce(JointId id) const {
    impl().requireAlive(id);
    return impl().jointData()[id].force;
}
Real World::jointTorque(JointId id) const {
    impl().requireAlive(id);
    return impl().jointData()[id].torque;
}
std::vector<JointId> World::joints(std::optional<BodyId> id) const {
    if (!id) {
        return impl().jointData().ids();
    }
    requireAlive(impl().bodyData(), *id);
    return impl().jointData().ids(id->index);
}
JointState World::jointState(JointId id) const {
    impl().requireAlive(id);
    return stateOf(impl().jointData()[id], impl().bodyData());
}
std::span<const BrokenJoint> World::brokenJoints() const {
    return impl().brokenJoints();
}

void World::addField(FieldEntry entry) {
    change("World::addField").addField(std::move(entry));
}
void World::setFields(std::vector<FieldEntry> fields) {
    change("World::setFields").setFields(std::move(fields));
}
const std::vector<FieldEntry>& World::fields() const {
    return impl().fields();
}
void World::applyForceToAll(Vec2 force, CollisionFilter which) {
    change("World::applyForceToAll").applyToAll(force, 0, which);
}
void World::applyTorqueToAll(Real torque, CollisionFilter which) {
    change("World::applyTorqueToAll").applyToAll({}, torque, which);
}

void World::step(Real dt, const StepOptions& options) {
    change("World::step").step(dt, options);
}
std::span<const CollisionRecord> World::collisions() const {
    return impl().records().all(impl().recordSource());
}
std::vector<CollisionRecord> World::collisions(BodyId id) const {
    requireAlive(impl().bodyData(), id);
    return impl().records().of(id, impl().recordSource());
}
std::span<const CollisionRecord> World::begunCollisions() const {
    return impl().records().begun(impl().recordSource());
}
std::span<const CollisionRecord> World::endedCollisions() const {
    return impl().records().ended(impl().recordSource());
}
std::vector<CollisionRecord> World::hits(Real minSpeed) const {
    refuse(checkNotNegative("minSpeed", minSpeed, "m/s"));
    return impl().records().hits(minSpeed, impl().recordSource());
}
std::uint64_t World::stepCount() const {
    return impl().stepCount();
}
void World::setRegion(std::optional<Aabb> region) {
    change("World::setRegion").setRegion(region);
}
const std::optional<Aabb>& World::region() const {
    return impl().region();
}
std::span<const BodyId> World::frozenBodies() const {
    return impl().frozenBodies();
}
const StepSettings& World::settings() const {
    return impl().settings();
}
void World::setSettings(const StepSettings& settings) {
    change("World::setSettings").setSettings(settings);
}
const Tolerances& World::tolerances() const {
    return impl().tolerances();
}
std::uint64_t World::stateHash() const {
    return impl().stateHash();
}

StepStats stepStats(const World& world) {
    return world.impl().stats();
}
Spring springOf(const World& world, const JointDef& def, Real stiffness, Real damping) {
    const Bodies& bodies = world.impl().bodyData();
    requireAlive(bodies, firstBody(def), "joint");
    requireAlive(bodies, secondBody(def), "joint");
    return springOf(bodies, def, stiffness, damping);
}

} // namespace KODO_PRECISION
} // namespace kodo
