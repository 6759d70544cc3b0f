// SPDX-License-Identifier: MIT
#include "world/world_impl.hpp"

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/integrate.hpp"
#include "world/world_step.hpp"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

bool sameParts(const PartList& a, const PartList& b) {
    const auto same = [](const Part& p, const Part& q) {
        return p.primitive == q.primitive && p.material == q.material && p.density == q.density;
    };
    const auto sameMass = [](const SetMass& p, const SetMass& q) {
        return p.mass.mass == q.mass.mass && p.mass.center == q.mass.center &&
               p.mass.inertia == q.mass.inertia; // of all parts
    };
    return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), same) &&
           std::equal(a.setMasses.begin(), a.setMasses.end(), b.setMasses.begin(),
                      b.setMasses.end(), sameMass);
}

// With fewer awake bodies, a step ends before a helper could start.
constexpr std::size_t kMinBodiesForHelp = 256;
// Features that may keep bodies at rest: a change wakes all islands.
constexpr Features kSleepFeatures = Feature::Friction | Feature::RollingResistance |
                                    Feature::Sleep | Feature::Rotation | Feature::Collision;

void requireValid(const FieldEntry& entry, Real lengthUnit) {
    if (!entry.field) {
        refuse(Problem{"field", "must not be null: FieldEntry::field holds a std::shared_ptr to a "
                                "field"});
    }
    refuse(checkFilter(entry.which));
    refuse(checkField(*entry.field, lengthUnit));
}

/// Never 0, which matches all Worlds.
std::uint32_t nextStamp() {
    static std::atomic<std::uint32_t> last{0};
    std::uint32_t stamp = 0;
    while (stamp == 0) {
        stamp = ++last;
    }
    return stamp;
}

/// Throws BadBodyId if a body of the joint is not in this World.
void requireEndsAlive(const Bodies& bodies, const JointDef& def) {
    const bool mouse = std::holds_alternative<MouseJoint>(def);
    for (const auto& [body, field] : {std::pair{firstBody(def), mouse ? "body" : "ends.a"},
                                      std::pair{secondBody(def), mouse ? "body" : "ends.b"}}) {
        if (body.generation != 0) { // check() names the end without a body
            requireAlive(bodies, body, field);
        }
    }
}

} // namespace

std::optional<Problem> check(const WorldDef& def) {
    return firstOf({checkRange("lengthUnit", def.lengthUnit, Real(1e-6), Real(1e6), "m"),
                    checkVelocity("gravity", def.gravity, def.lengthUnit, "m/s^2"),
                    check(def.settings)});
}

WorldImpl::WorldImpl(const WorldDef& def) : tolerances_() {
    const Real big = detail::kBig;
    detail::requireExactArithmetic((big + 1) - big, detail::kFive / 49);
    refuse(check(def));
    const std::uint32_t stamp = nextStamp();
    bodies_.stamp = stamp;
    joints_.setStamp(stamp);
    settings_ = def.settings;
    bodies_.leftOut = settings_.leaveOut;
    tolerances_ = Tolerances::forUnit(def.lengthUnit);
    if (def.gravity != Vec2{}) {
        addField({std::make_shared<Gravity>(def.gravity)});
    }
}

BodyId WorldImpl::add(const BodyDef& def) {
    refuse(check(def, tolerances_.unit()));
    PartList list = partListOf(def);
    if (!lastGeometry_ || !sameParts(*lastGeometry_, list)) {
        lastGeometry_ = makeGeometry(std::move(list));
    }
    const BodyId id = addBody(bodies_, def, lastGeometry_);
    bodyAdded(id.index);
    return id;
}

void WorldImpl::bodyAdded(std::uint32_t body) {
    region_.update(bodies_, body);
    contacts_.bodyChanged(bodies_, tolerances_, body);
    flagBlocks_.note(body, bodies_.filter[body].flags);
    ++count_;
}

void WorldImpl::step(Real dt, const StepOptions& options) {
    refuse(checkTimeStep(dt));
    const ChangeGuard::Step running(guard_);
    if (options.listener != nullptr) {
        options.listener->enter(StepStage::Broad);
    }
    updateAwake();
    WorkerTeam team(bodies_.awake.size() >= kMinBodiesForHelp ? options.executor : nullptr);
    WorldStep(*this,
              {bodies_, contacts_, joints_, settings_, tolerances_, dt, team, stepCount_, work_})
        .run(options.listener);
    ++stepCount_;
}

/// Brings the list of awake bodies up to date. True if any may have toggled.
bool WorldImpl::listAwake() {
    const bool toggled = refreshAwake(bodies_);
    joints_.findBusy(bodies_, toggled);
    if (toggled) {
        contacts_.candidates().moveToTrees(bodies_, bodies_.changes.toggled);
    }
    return toggled;
}

/// Deactivates bodies that left the region, and activates those that it reaches.
void WorldImpl::updateAwake() {
    if (region_.isActive()) {
        for (const std::uint32_t body : bodies_.awake) {
            if (bodies_.ids.aliveAt(body) && !region_.contains(bodies_, body)) {
                region_.place(body, bodies_, contacts_);
            }
        }
    }
    if (listAwake() && (sleep_.anyAsleep() || region_.isActive())) {
        for (const std::uint32_t body : bodies_.changes.toggled) {
            contacts_.activityChanged(body);
        }
    }
    region_.followActivity(bodies_, contacts_);
}

void WorldImpl::setRegion(std::optional<Aabb> region) {
    if (region) {
        refuse(checkBox("region", *region));
    }
    const std::optional<Aabb> before = region_.box();
    if (!before && !region) {
        return;
    }
    region_.setBox(region);
    const bool isMove = before && region && settings_.has(Feature::Collision);
    std::vector<std::uint32_t> moved =
        isMove ? region_.mayCross(*before, bodies_, contacts_.candidates())
               : allIndices(bodies_.size());
    changeVisits_ += moved.size();
    region_.moveInOut(moved, bodies_, contacts_);
    sleep_.wakeOn(bodies_, contacts_, moved);
}

void WorldImpl::wake(std::uint32_t body) {
    sleep_.wake(bodies_, contacts_, body);
}

/// For a body that is removed, teleported or changed: wakes sleeping bodies that touch it or are
/// jointed to it.
void WorldImpl::wakeNeighbours(std::uint32_t body) {
    region_.unparkContactsOf(body, bodies_, contacts_);
    sleep_.wakeNeighbours(bodies_, contacts_, joints_, body);
}

/// For a change of pose, geometry, type or filter: updates contacts, region and touching islands.
void WorldImpl::bodyChanged(std::uint32_t body) {
    wakeNeighbours(body);
    region_.place(body, bodies_, contacts_);
    contacts_.bodyChanged(bodies_, tolerances_, body);
    bodies_.teleported(body);
    bodies_.noteArrival(body);
    bodies_.noteActivity(body);
}

void WorldImpl::velocityChanged(std::uint32_t body) {
    wake(body);
    if (!bodies_.locked(body)) {
        bodies_.noteLostLoad(body);
        return;
    }
    const BodyVelocity& own = bodies_.motion[body];
    // It was motionless, and may begin to push others.
    if (own.deltaPosition == Vec2{} && own.deltaAngle == 0) {
        wakeNeighbours(body);
        if ((bodies_.filter[body].flags & kOutside) != 0) {
            // Again, since it stays outside the region.
            region_.park({&body, 1}, bodies_, contacts_);
        }
    }
    bodies_.noteActivity(body);
}

/// Ends the frozen state of a body.
void WorldImpl::thaw(std::uint32_t body) {
    Flags& flags = bodies_.filter[body].flags;
    if ((flags & kFrozen) != 0) {
        flags &= ~kFrozen;
        refreshDerived(bodies_, body);
        bodyChanged(body);
    }
}

/// Adds a force (N) and a torque (N m) for the next step, and wakes the body. Zeros change nothing.
void WorldImpl::addForce(std::uint32_t body, Vec2 force, Real torque) {
    if (force != Vec2{} || torque != 0) {
        kodo::addForce(bodies_, body, force, torque);
        wake(body);
    }
}

/// An impulse (N s) at the centre of mass, and an angular one (N m s).
void WorldImpl::applyImpulse(std::uint32_t body, Vec2 impulse, Real angular) {
    refuse(checkFinite("impulse", impulse));
    BodyVelocity after = bodies_.motion[body];
    kodo::applyImpulse(after, after.invMass, impulse, after.invInertia, angular);
    refuse(checkVelocity("velocity after the impulse", after.velocity, tolerances_.unit()));
    refuse(checkAngularVelocity("angularVelocity after the impulse", after.angularVelocity));
    bodies_.motion[body] = after;
    velocityChanged(body);
}

void WorldImpl::setRules(std::uint32_t body, const MotionRules& rules) {
    refuse(check(rules));
    kodo::setRules(bodies_, body, rules);
    wake(body);
    bodies_.noteLostLoad(body);
}

void WorldImpl::remove(BodyId id) {
    kodo::requireAlive(bodies_, id);
    wakeNeighbours(id.index);
    contacts_.drop(id.index, bodies_);
    joints_.dropBody(id.index);
    notePairChanges();
    removeBody(bodies_, id.index);
    contacts_.bodyChanged(bodies_, tolerances_, id.index);
    --count_;
}

BodyId WorldImpl::clone(BodyId id, Vec2 position) {
    kodo::requireAlive(bodies_, id);
    refuse(checkPosition("position", position, tolerances_.unit()));
    const BodyView source(bodies_, id);
    BodyDef def = definitionOf(formerBodyOf(bodies_, id.index));
    def.position = position;
    def.rotation = source.rotation();
    def.velocity = source.velocity();
    def.angularVelocity = source.angularVelocity();
    const BodyId copy = addBody(bodies_, def, bodies_.record[id.index].geometry);
    bodyAdded(copy.index);
    return copy;
}

void WorldImpl::requireAlive(JointId id) const {
    if (joints_.contains(id)) {
        return;
    }
    if (id.generation == 0) {
        throw BadDefinition({"joint", "the null id JointId{} names no joint"});
    }
    const bool foreign = id.world != 0 && bodies_.stamp != 0 && id.world != bodies_.stamp;
    throw BadDefinition(
        {"joint", "joint " + std::to_string(id.index) + " of generation " +
                      std::to_string(id.generation) +
                      (foreign ? " belongs to another World"
                               : " is not in this World: it was removed, broke, or never added")});
}

/// Wakes the bodies of a joint and updates the excluded pairs.
void WorldImpl::jointsChanged(const JointDef& def) {
    for (const std::uint32_t body : {firstBody(def).index, secondBody(def).index}) {
        wake(body);
        bodies_.noteLostLoad(body);
    }
    notePairChanges();
}

/// After joints were added, changed or removed: pairs of their bodies are searched again.
void WorldImpl::notePairChanges() {
    joints_.takePairChanges([&](std::uint32_t body) { contacts_.activityChanged(body); });
}

JointId WorldImpl::add(const JointDef& def) {
    requireEndsAlive(bodies_, def);
    refuse(check(def, tolerances_.unit()));
    const JointId id = joints_.add(def);
    jointsChanged(def);
    return id;
}

void WorldImpl::remove(JointId id) {
    const JointDef def = joint(id);
    joints_.remove(id);
    jointsChanged(def);
}

const JointDef& WorldImpl::joint(JointId id) const {
    requireAlive(id);
    return joints_[id].def;
}

void WorldImpl::setJoint(JointId id, const JointDef& def) {
    const JointDef& old = joint(id);
    requireEndsAlive(bodies_, def);
    refuse(check(def, tolerances_.unit()));
    if (old.index() != def.index() || firstBody(old) != firstBody(def) ||
        secondBody(old) != secondBody(def)) {
        throw BadDefinition({"joint", "must keep its kind and its bodies: to change them, remove "
                                      "the joint and add another"});
    }
    joints_.setDef(id, def);
    jointsChanged(def);
}

void WorldImpl::addField(FieldEntry entry) {
    requireValid(entry, tolerances_.unit());
    fields_.push_back(std::move(entry));
    bodies_.accelerationsStale = true;
    sleep_.wakeAll(bodies_, contacts_);
}

void WorldImpl::setFields(std::vector<FieldEntry> fields) {
    for (const FieldEntry& entry : fields) {
        requireValid(entry, tolerances_.unit());
    }
    fields_ = std::move(fields);
    bodies_.accelerationsStale = true;
    sleep_.wakeAll(bodies_, contacts_);
}

/// Force in N and torque in N m.
void WorldImpl::applyToAll(Vec2 force, Real torque, CollisionFilter which) {
    refuse(checkFilter(which));
    refuse(checkFinite("force", force));
    refuse(checkFinite("torque", torque));
    if (force == Vec2{} && torque == 0) {
        return;
    }
    flagBlocks_.forEachIn(which, bodies_.size(), [&](std::uint32_t body) {
        ++changeVisits_;
        if (bodies_.ids.aliveAt(body) && accepts(which, bodies_.filter[body])) {
            addForce(body, force, torque);
        }
    });
}

void WorldImpl::setSettings(const StepSettings& settings) {
    refuse(check(settings));
    Features changed;
    changed.bits = settings_.leaveOut.bits ^ settings.leaveOut.bits;
    if ((changed.bits & kSleepFeatures.bits) != 0) {
        sleep_.wakeAll(bodies_, contacts_);
    }
    settings_ = settings;
    bodies_.leftOut = settings.leaveOut;
    roomFor_ = 0; // other stages may run
    if (!settings.has(Feature::Friction)) {
        contacts_.lanes().discardLanes();
        for (std::uint32_t slot = 0; slot < contacts_.store().size(); ++slot) {
            contacts_.store().lane(slot).friction() = 0; // it would warm start the next step
        }
    }
    if (changed.has(Feature::Rotation)) {
        rotationChanged(bodies_);
        contacts_.bodiesChanged(); // bodies that can only rotate become immovable or movable
    }
    // Steps without it leave the bounds as they are.
    for (std::uint32_t i = 0; changed.has(Feature::Collision) && i < bodies_.size(); ++i) {
        contacts_.bodyChanged(bodies_, tolerances_, i);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
