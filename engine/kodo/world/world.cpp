// SPDX-License-Identifier: MIT
#include <kodo/world/world.hpp>

#include <algorithm>
#include <string>

namespace kodo::inline KODO_PRECISION {
namespace {

bool sameBuild(const std::vector<Part>& a, const std::vector<Part>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Part& p, const Part& q) {
        return p.primitive == q.primitive && p.material == q.material && p.density == q.density;
    });
}

/// May the parts of both be one body? `place` is where the frame of the other's shape lies.
std::optional<Problem> checkTogether(const Form& into, const Form& part, const Transform& place) {
    if (into.parts.size() + part.parts.size() > kMaxParts) {
        return Problem{"part", "must not give the body more than " + std::to_string(kMaxParts) +
                                   " parts, but they would be " +
                                   std::to_string(into.parts.size() + part.parts.size())};
    }
    Mass added = part.mass;
    added.center = place * added.center;
    const Mass sum = combine(into.mass, added);
    auto problem = sum.mass > 0 ? checkMass(sum) : std::nullopt; // two planes have none
    if (problem) {
        problem->field = "part";
        problem->reason = "makes a body that cannot be: " + problem->reason;
    }
    return problem;
}

// What rests may do so because of these.
constexpr auto kHoldsAtRest = static_cast<std::uint8_t>(Feature::Friction) |
                              static_cast<std::uint8_t>(Feature::RollingResistance) |
                              static_cast<std::uint8_t>(Feature::Resting) |
                              static_cast<std::uint8_t>(Feature::Rotation);

} // namespace

std::optional<Problem> check(const WorldDef& def) {
    if (auto problem = checkRange("lengthUnit", def.lengthUnit, Real(1e-6), Real(1e6))) {
        return problem;
    }
    if (auto problem = checkVelocity("gravity", def.gravity, def.lengthUnit)) {
        return problem;
    }
    return check(def.settings);
}

World::World(const WorldDef& def) : tolerances_() {
    refuse(check(def));
    settings_ = def.settings;
    bodies_.turns = settings_.has(Feature::Rotation);
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
    refuse(check(def, tolerances_.unit()));
    const BodyId id = addBody(bodies_, def, formFor(def));
    askRegion(id.index);
    contacts_.bodyChanged(id.index);
    ++count_;
    return id;
}

/// With all that the solver has of it.
Contact World::current(const Contact& contact) const {
    Contact copy = contact;
    softStep_.blocks().fetch(copy, bodies_);
    return copy;
}

std::span<const CollisionRecord> World::collisions() const {
    return contacts_.records([this](const Contact& contact) { return current(contact); });
}

void World::wake(std::uint32_t body) {
    if (bodies_.rest[body].island != RestState::kNoIsland) {
        fetchContacts();
    }
    rest_.wake(bodies_, contacts_, body);
}

void World::wakeAll() {
    fetchContacts();
    rest_.wakeAll(bodies_, contacts_);
}

/// It goes, jumps or changes: what leans on it, or hangs on it by a joint, wakes.
void World::disturb(std::uint32_t body) {
    if (rest_.anyResting()) {
        fetchContacts();
    }
    takeBackContactsOf(body);
    rest_.disturb(bodies_, contacts_, joints_, body);
}

void World::remove(BodyId id) {
    requireAlive(id);
    disturb(id.index);
    contacts_.drop(id.index, [&](Contact& contact) { softStep_.blocks().fetch(contact, bodies_); });
    joints_.dropBody(id);
    contacts_.setApart(joints_.apart());
    removeBody(bodies_, id.index);
    --count_;
}

BodyId World::clone(BodyId id, Vec2 position) {
    requireAlive(id);
    refuse(checkPosition("position", position, tolerances_.unit()));
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
    askRegion(copy.index);
    contacts_.bodyChanged(copy.index);
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
    for (const Part& added : bodies_.form(part.index).parts) {
        refuse(checkLock(added.primitive, bodies_.filter[into.index].flags));
    }
    const Transform frame{bodies_.originOf(into.index), bodies_.pose[into.index].rotation};
    const Transform other{bodies_.originOf(part.index), bodies_.pose[part.index].rotation};
    const Transform place = between(frame, other);
    refuse(checkTogether(bodies_.form(into.index), bodies_.form(part.index), place));
    fetchContacts();
    disturb(into.index);
    const std::size_t firstPart = bodies_.form(into.index).parts.size();
    joints_.transfer(part, into, place);
    weldBodies(bodies_, into.index, part.index);
    placeInRegion(into.index);
    contacts_.bodyChanged(into.index);
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
    wake(firstBody(def).index);
    wake(secondBody(def).index);
    contacts_.setApart(joints_.apart());
}

JointId World::add(const JointDef& def) {
    refuse(check(def, tolerances_.unit()));
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
    refuse(check(def, tolerances_.unit()));
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
    refuse(entry.field ? std::nullopt : std::optional(Problem{"field", "must not be null"}));
    fields_.push_back(std::move(entry));
    bodies_.pushesStale = true;
    wakeAll();
}

void World::setFields(std::vector<FieldEntry> fields) {
    for (const FieldEntry& entry : fields) {
        refuse(entry.field ? std::nullopt : std::optional(Problem{"field", "must not be null"}));
    }
    fields_ = std::move(fields);
    bodies_.pushesStale = true;
    wakeAll();
}

std::size_t World::weld(BodyId into, const Primitive& shape, const Material& material,
                        Real density) {
    requireAlive(into);
    refuse(check(shape));
    refuse(check(material));
    refuse(checkRange("density", density, kLowestDensity, kHighestDensity));
    refuse(checkLock(shape, bodies_.filter[into.index].flags));
    const Part part{shape, material, density};
    refuse(checkBuild({&part, 1}, tolerances_.unit()));
    refuse(checkTogether(bodies_.form(into.index), *makeForm({part}), {}));
    fetchContacts();
    disturb(into.index);
    std::vector<Part> parts = bodies_.form(into.index).parts;
    parts.push_back(part);
    const Vec2 center = bodies_.pose[into.index].position;
    setForm(bodies_, into.index, makeForm(std::move(parts)));
    Motion& motion = bodies_.motion[into.index];
    motion.velocity = velocityAt(motion, bodies_.pose[into.index].position - center);
    placeInRegion(into.index);
    contacts_.bodyChanged(into.index);
    return bodies_.form(into.index).parts.size() - 1;
}

BodyId World::unweld(BodyId body, std::size_t part, Flags flags) {
    requireAlive(body);
    const std::vector<Part>& parts = bodies_.form(body.index).parts;
    if (part >= parts.size() || parts.size() == 1) {
        throw BadDefinition({"part", "is " + std::to_string(part) + ", but the body has " +
                                         std::to_string(parts.size()) +
                                         " parts, of which one must stay"});
    }
    refuse(checkLock(parts[part].primitive, flags));
    refuse(checkFlags("flags", flags));
    fetchContacts();
    disturb(body.index);
    contacts_.partRemoved(body.index, part);
    const BodyId freed = unweldPart(bodies_, body.index, part, flags & ~kStatusFlags);
    placeInRegion(body.index);
    askRegion(freed.index);
    contacts_.bodyChanged(freed.index);
    ++count_;
    return freed;
}

void World::applyForceToAll(Vec2 force, CollisionFilter which) {
    for (const BodyId id : bodies()) {
        if (accepts(which, bodies_.filter[id.index].flags)) {
            (*this)[id].applyForce(force);
        }
    }
}

void World::applyTorqueToAll(Real torque, CollisionFilter which) {
    for (const BodyId id : bodies()) {
        if (accepts(which, bodies_.filter[id.index].flags)) {
            (*this)[id].applyTorque(torque);
        }
    }
}

void World::setSettings(const StepSettings& settings) {
    refuse(check(settings));
    const auto held = static_cast<std::uint8_t>(settings_.leaveOut ^ settings.leaveOut);
    if ((held & kHoldsAtRest) != 0) {
        wakeAll();
    }
    fetchContacts();
    settings_ = settings;
    if (!settings.has(Feature::Friction)) {
        softStep_.blocks().startAnew();
        for (Contact& contact : contacts_.contacts()) {
            contact.friction = 0; // or it would go on from step to step
        }
    }
    if (settings.has(Feature::Rotation) != bodies_.turns) {
        setTurns(bodies_, settings.has(Feature::Rotation));
        contacts_.bodiesChanged(); // what can only turn is locked now, or was
    }
}

} // namespace kodo::inline KODO_PRECISION
