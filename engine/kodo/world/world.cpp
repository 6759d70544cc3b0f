// SPDX-License-Identifier: MIT
#include <kodo/base/hash.hpp>
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/impact.hpp>
#include <kodo/world/world.hpp>

#include <algorithm>
#include <string>
#include <tuple>

namespace kodo::inline KODO_PRECISION {
namespace {

bool sameBuild(const std::vector<Part>& a, const std::vector<Part>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Part& p, const Part& q) {
        return p.primitive == q.primitive && p.material == q.material && p.density == q.density;
    });
}

void refuse(const std::optional<Problem>& problem) {
    if (problem) {
        throw BadDefinition(*problem);
    }
}

} // namespace

std::optional<Problem> check(const WorldDef& def) {
    if (auto problem = checkVelocity("gravity", def.gravity)) {
        return problem;
    }
    if (auto problem = checkRange("lengthUnit", def.lengthUnit, Real(1e-6), Real(1e6))) {
        return problem;
    }
    return check(def.settings);
}

World::World(const WorldDef& def) : tolerances_() {
    refuse(check(def));
    settings_ = def.settings;
    tolerances_ = Tolerances::forUnit(def.lengthUnit);
    if (def.gravity != Vec2{}) {
        addField({std::make_shared<Gravity>(def.gravity)});
    }
}

void World::requireAlive(BodyId id) const {
    if (!contains(id)) {
        throw BadBodyId("body " + std::to_string(id.index) + " of generation " +
                        std::to_string(id.generation) +
                        " is not in this World: it was removed, or never added");
    }
}

std::shared_ptr<const Form> World::formFor(const BodyDef& def) {
    std::vector<Part> parts = partsOf(def);
    if (!lastForm_ || !sameBuild(lastForm_->parts, parts)) {
        lastForm_ = makeForm(std::move(parts));
    }
    return lastForm_;
}

BodyId World::add(const BodyDef& def) {
    refuse(check(def));
    const BodyId id = addBody(bodies_, def, formFor(def));
    contacts_.bodiesChanged();
    ++count_;
    return id;
}

void World::remove(BodyId id) {
    requireAlive(id);
    rest_.disturb(bodies_, contacts_, id.index);
    contacts_.drop(id.index);
    joints_.dropBody(id);
    contacts_.setApart(joints_.apart());
    removeBody(bodies_, id.index);
    --count_;
}

BodyId World::clone(BodyId id, Vec2 position) {
    requireAlive(id);
    refuse(checkPosition("position", position));
    const BodyView source(*this, id);
    BodyDef def;
    def.position = position;
    def.rotation = source.rotation();
    def.velocity = source.velocity();
    def.angularVelocity = source.angularVelocity();
    def.flags = source.flags();
    def.required = source.required();
    def.userData = source.userData();
    const BodyId copy = addBody(bodies_, def, bodies_.record[id.index].form);
    contacts_.bodiesChanged();
    ++count_;
    return copy;
}

std::vector<BodyId> World::bodies() const {
    std::vector<BodyId> ids;
    ids.reserve(count_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_.ids.aliveAt(i)) {
            ids.push_back(bodies_.idAt(i));
        }
    }
    return ids;
}

std::size_t World::weld(BodyId into, BodyId part) {
    requireAlive(into);
    requireAlive(part);
    if (into == part) {
        throw BadDefinition({"part", "is the body that it is to be welded to"});
    }
    rest_.disturb(bodies_, contacts_, into.index);
    const std::size_t firstPart = bodies_.form(into.index).parts.size();
    const Transform frame{bodies_.originOf(into.index), bodies_.pose[into.index].rotation};
    const Transform other{bodies_.originOf(part.index), bodies_.pose[part.index].rotation};
    joints_.transfer(part, into, between(frame, other));
    weldBodies(bodies_, into.index, part.index);
    remove(part);
    return firstPart;
}

void World::requireAlive(JointId id) const {
    if (!joints_.contains(id)) {
        throw BadDefinition({"joint", std::to_string(id.index) + " of generation " +
                                          std::to_string(id.generation) +
                                          " is not in this World: it was removed, broke, or was "
                                          "never added"});
    }
}

/// Its bodies wake, and whether they may touch is asked again.
void World::jointsChanged(const JointDef& def) {
    rest_.wake(bodies_, contacts_, firstBody(def).index);
    rest_.wake(bodies_, contacts_, secondBody(def).index);
    contacts_.setApart(joints_.apart());
}

JointId World::add(const JointDef& def) {
    refuse(check(def));
    requireAlive(firstBody(def));
    requireAlive(secondBody(def));
    const JointId id = joints_.add(def);
    jointsChanged(def);
    return id;
}

void World::remove(JointId id) {
    const JointDef def = joint(id);
    joints_.remove(id);
    jointsChanged(def);
}

const JointDef& World::joint(JointId id) const {
    requireAlive(id);
    return joints_.def(id);
}

void World::setJoint(JointId id, const JointDef& def) {
    const JointDef& old = joint(id);
    refuse(check(def));
    if (old.index() != def.index() || firstBody(old) != firstBody(def) ||
        secondBody(old) != secondBody(def)) {
        throw BadDefinition({"joint", "must stay of the same kind and between the same bodies"});
    }
    joints_.setDef(id, def);
    jointsChanged(def);
}

Vec2 World::jointForce(JointId id) const {
    requireAlive(id);
    return joints_.force(id);
}

Real World::jointTorque(JointId id) const {
    requireAlive(id);
    return joints_.torque(id);
}

void World::addField(FieldEntry entry) {
    fields_.push_back(std::move(entry));
    rest_.wakeAll(bodies_, contacts_);
}

void World::setFields(std::vector<FieldEntry> fields) {
    fields_ = std::move(fields);
    rest_.wakeAll(bodies_, contacts_);
}

void World::applyForceToAll(Vec2 force, CollisionFilter which) {
    for (const BodyId id : bodies()) {
        if (accepts(which, bodies_.record[id.index].filter.flags)) {
            (*this)[id].applyForce(force);
        }
    }
}

void World::applyTorqueToAll(Real torque, CollisionFilter which) {
    for (const BodyId id : bodies()) {
        if (accepts(which, bodies_.record[id.index].filter.flags)) {
            (*this)[id].applyTorque(torque);
        }
    }
}

void World::setSettings(const StepSettings& settings) {
    refuse(check(settings));
    settings_ = settings;
}

void World::step(Real dt) {
    refuse(checkRange("dt", dt, kShortestStep, kLongestStep));
    if (refreshAwake(bodies_) && rest_.anyResting()) {
        contacts_.activityChanged();
    }
    beginMotion(bodies_);
    contacts_.updatePairs(bodies_, tolerances_, dt);
    contacts_.updateManifolds(bodies_, tolerances_);
    rest_.wakeTouched(bodies_, contacts_, tolerances_);
    rest_.wakeJointed(bodies_, contacts_, joints_);
    refreshAwake(bodies_);
    gatherAccelerations(bodies_, fields_, dt);
    solve(dt);
    if (settings_.has(Feature::Sweep)) {
        contacts_.coverMoves(bodies_, tolerances_);
        sweep_.run(bodies_, contacts_.contacts(), settings_, tolerances_, dt);
    }
    movePoses(bodies_);
    recordCollisions();
    breakJoints(dt);
    rest_.settle(bodies_, contacts_, joints_, settings_, tolerances_, dt);
    ++stepCount_;
}

void World::solve(Real dt) {
    const std::span<Contact> contacts = contacts_.contacts();
    if (settings_.strategy == Strategy::Propagation) {
        propagation_.solve(bodies_, contacts, joints_, {settings_, tolerances_, dt, stepCount_});
        contactVisits_ = propagation_.visits();
        return;
    }
    solveImpacts(bodies_, contacts, settings_, tolerances_, dt);
    softStep_.solve(bodies_, contacts, joints_, settings_, tolerances_, dt);
    contactVisits_ = 2 * softStep_.rowCount() * static_cast<std::size_t>(settings_.substeps);
}

void World::breakJoints(Real dt) {
    const std::span<const BrokenJoint> broken = joints_.endStep(dt);
    broken_.assign(broken.begin(), broken.end());
    if (!broken_.empty()) {
        contacts_.setApart(joints_.apart());
    }
}

void World::recordCollisions() {
    records_.clear();
    for (const std::uint32_t body : bodies_.awake) {
        bodies_.record[body].filter.flags &= ~kColliding;
    }
    const bool wanted = settings_.has(Feature::Records);
    for (Contact& contact : contacts_.contacts()) {
        finishContact(contact, tolerances_);
        if (wanted) {
            recordContact(contact, records_);
        }
        contact.wasTouching = contact.touching;
        if (contact.touching) {
            bodies_.record[contact.key.bodyA].filter.flags |= kColliding;
            bodies_.record[contact.key.bodyB].filter.flags |= kColliding;
        }
    }
    const std::span<const CollisionRecord> ended = contacts_.ended();
    if (wanted && !ended.empty()) {
        records_.insert(records_.end(), ended.begin(), ended.end());
        const auto key = [](const CollisionRecord& r) {
            return std::tie(r.a, r.partA, r.b, r.partB, r.phase);
        };
        std::sort(records_.begin(), records_.end(), // total order: a pair has one record, or an End
                  [&](const CollisionRecord& r, const CollisionRecord& s) { // and a new Begin
                      return key(r) < key(s);
                  });
    }
    contacts_.clearEnded();
}

std::uint64_t World::stateHash() const {
    StateHash hash;
    hash.add(stepCount_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        hash.add(bodies_.ids.generationAt(i));
        if (!bodies_.ids.aliveAt(i)) {
            continue;
        }
        const Motion& motion = bodies_.motion[i];
        const Transform& pose = bodies_.pose[i];
        const BodyRecord& record = bodies_.record[i];
        for (const Real value :
             {pose.position.x, pose.position.y, pose.rotation.c, pose.rotation.s, motion.velocity.x,
              motion.velocity.y, motion.angularVelocity, motion.invMass, motion.invInertia,
              record.force.x, record.force.y, record.torque}) {
            hash.add(value);
        }
        hash.add(bodies_.rest[i].calmSteps);
        hash.add(record.filter.flags);
        hash.add(record.filter.required);
        hash.add(static_cast<std::uint32_t>(record.form->parts.size()));
    }
    const auto addContact = [&](const Contact& contact) {
        if (!contact.wasTouching) {
            return;
        }
        hash.add(contact.key.bodyA);
        hash.add(contact.key.partA);
        hash.add(contact.key.bodyB);
        hash.add(contact.key.partB);
        for (const Real value : {contact.impulse[0].normal, contact.impulse[1].normal,
                                 contact.friction, contact.rolling}) {
            hash.add(value);
        }
    };
    for (const Contact& contact : contacts_.contacts()) {
        addContact(contact);
    }
    rest_.forEachContact(addContact);
    joints_.forEach([&](const JointSet::Joint& joint) {
        hash.add(static_cast<std::uint32_t>(joint.def.index()));
        hash.add(firstBody(joint.def).index);
        hash.add(secondBody(joint.def).index);
        hash.add(joint.point.x);
        hash.add(joint.point.y);
        for (const Real impulse : joint.axes) {
            hash.add(impulse);
        }
    });
    return hash.value();
}

} // namespace kodo::inline KODO_PRECISION
