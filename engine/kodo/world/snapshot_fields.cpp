// SPDX-License-Identifier: MIT
#include <kodo/contacts/contact_update.hpp>
#include <kodo/world/snapshot_fields.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <typeinfo>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr Real kBeyondEverything = kEndless * Real(1e9); // m, or m/s

// False for NaN.
bool bounded(Real value) {
    return std::abs(value) <= kBeyondEverything;
}
bool bounded(Vec2 v) {
    return bounded(v.x) && bounded(v.y);
}
bool bounded(const Octagon& bounds) {
    bool good = true;
    for (int i = 0; i < 4; ++i) {
        good = good && bounded(bounds.lower[i]) && bounded(bounds.upper[i]) &&
               bounds.lower[i] <= bounds.upper[i];
    }
    return good;
}

bool inOrder(std::span<const std::uint32_t> bodies, std::size_t count) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i] >= count || (i > 0 && bodies[i - 1] >= bodies[i])) {
            return false;
        }
    }
    return true;
}

std::size_t partCount(const Bodies& bodies) {
    std::size_t parts = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        parts += bodies.ids.aliveAt(i) ? bodies.form(i).parts.size() : 0;
    }
    return parts;
}

enum class FieldKind : std::uint8_t { Own, Gravity, Drag, Wind, Attractor, Buoyancy };

/// By the exact type: one that was derived from a Drag is the user's own.
FieldKind kindOf(const ForceField& field) {
    const std::type_info& type = typeid(field);
    return type == typeid(Gravity)     ? FieldKind::Gravity
           : type == typeid(Drag)      ? FieldKind::Drag
           : type == typeid(Wind)      ? FieldKind::Wind
           : type == typeid(Attractor) ? FieldKind::Attractor
           : type == typeid(Buoyancy)  ? FieldKind::Buoyancy
                                       : FieldKind::Own;
}

} // namespace

std::uint32_t SnapshotFields::lengthOf(std::size_t size) {
    auto length = static_cast<std::uint32_t>(size);
    one(length);
    require(!reads() || length <= stream_.left(), "a list is longer than the bytes that are left");
    return length;
}

/// Forms are written once, however many bodies share them.
void SnapshotFields::forms(World& world) {
    const auto note = [&](const std::shared_ptr<const Form>& form) {
        const auto number = static_cast<std::uint32_t>(forms_.size() + 1); // 0: none
        if (form && formNumbers_.emplace(form.get(), number).second) {
            forms_.push_back(form);
        }
    };
    for (const BodyRecord& record : world.bodies_.record) {
        note(record.form);
    }
    note(world.lastForm_);
    forms_.resize(lengthOf(forms_.size()));
    for (std::shared_ptr<const Form>& form : forms_) {
        std::vector<Part> parts = form ? form->parts : std::vector<Part>{};
        one(parts);
        if (!reads()) {
            continue;
        }
        require(!parts.empty(), "a body has no parts");
        for (const Part& part : parts) {
            require(checkMoved(part.primitive));
            require(check(part.material));
            require(checkRange("density", part.density, kLowestDensity, kHighestDensity));
        }
        form = makeForm(std::move(parts));
        require(form->mass.mass >= 0 && form->mass.inertia >= 0 && bounded(form->mass.center) &&
                    bounded(form->reach),
                "a shape is out of all bounds");
    }
}

void SnapshotFields::one(std::shared_ptr<const Form>& form) {
    std::uint32_t number = form && !reads() ? formNumbers_.at(form.get()) : 0;
    one(number);
    if (reads()) {
        require(number <= forms_.size(), "there is no such form");
        form = number > 0 ? forms_[number - 1] : nullptr;
    }
}

void SnapshotFields::one(IdPool& pool) {
    auto& [generations, free] = pool;
    all(generations, free);
    std::vector<bool> seen(generations.size());
    for (const std::uint32_t index : free) {
        require(index < generations.size() && generations[index] % 2 == 0 &&
                    generations[index] != 0 && !seen[index],
                "an id is free that cannot be");
        seen[index] = true;
    }
}

void SnapshotFields::one(Bodies& bodies) {
    auto& [ids, motion, pose, acceleration, extent, jumps, hasJumped, start, filter, record, parts,
           rest, forced, awake, thinnest, loads, awakeStale, anyRests, turns, startStale,
           pushesStale, anyJumped] = bodies;
    one(ids);
    if (reads()) {
        const std::size_t count = ids.capacity();
        motion.resize(count + 1);
        pose.resize(count);
        acceleration.resize(count);
        extent.resize(count + 1);
        jumps.resize(count);
        hasJumped.resize(count);
        filter.resize(count);
        record.resize(count);
        parts.resize(count);
        rest.resize(count);
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        one(jumps[i]); // goes on where it was when the slot is used again
        if (ids.aliveAt(i)) {
            auto& [form, userData, force, torque] = record[i];
            all(form, filter[i], userData, force, torque, pose[i], motion[i], acceleration[i],
                rest[i]);
            if (reads()) {
                completeBody(bodies, i);
            }
        }
    }
    all(awake, awakeStale, thinnest);
    if (reads()) {
        checkAwake(bodies);
        checkThinnest(bodies);
    }
}

/// It may be that of a body that is gone.
void SnapshotFields::checkThinnest(const Bodies& bodies) {
    bool good = bodies.thinnest >= 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        good = good && (!bodies.ids.aliveAt(i) || bodies.thinnest <= bodies.extent[i].inside);
    }
    require(good, "a body is thinner than the thinnest");
}

/// What follows from its form and flags.
void SnapshotFields::completeBody(Bodies& bodies, std::uint32_t body) {
    const BodyRecord& record = bodies.record[body];
    require(record.form != nullptr, "a body has no form");
    for (const Part& part : record.form->parts) {
        require(checkLock(part.primitive, bodies.filter[body].flags));
    }
    const Transform& pose = bodies.pose[body];
    const Motion& motion = bodies.motion[body];
    require(bounded(pose.position) && bounded(motion.velocity) && bounded(motion.angularVelocity) &&
                bounded(motion.move) && bounded(motion.turn),
            "a body is out of all bounds");
    require(checkRotation("rotation", pose.rotation));
    if (record.force != Vec2{} || record.torque != 0) {
        bodies.forced.push_back(body);
    }
    refreshBuild(bodies, body);
}

void SnapshotFields::checkAwake(const Bodies& bodies) {
    const char* const sentence = "the list of the bodies that are awake is wrong";
    require(inOrder(bodies.awake, bodies.size()), sentence);
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < bodies.size() && !bodies.awakeStale; ++i) {
        const bool listed = next < bodies.awake.size() && bodies.awake[next] == i;
        next += listed ? 1 : 0;
        const bool alive = bodies.ids.aliveAt(i);
        require(listed ? alive : !alive || !bodies.active(i), sentence);
    }
}

/// A field by what it was made of: the functions that give the arguments of its constructor.
template <typename Field, typename... Values>
void SnapshotFields::field(std::shared_ptr<const ForceField>& field,
                           Values (Field::*... get)() const) {
    std::tuple<Values...> values;
    if (!reads()) {
        const auto& own = static_cast<const Field&>(*field);
        values = {(own.*get)()...};
    }
    std::apply([this](auto&... value) { this->all(value...); }, values);
    if (reads()) {
        field = std::apply(
            [](const auto&... value) { return std::make_shared<const Field>(value...); }, values);
    }
}

std::shared_ptr<const ForceField> SnapshotFields::nextOwnField() {
    require(!ownFields_.empty(), "it holds more force fields of your own than were given");
    const std::shared_ptr<const ForceField> field = ownFields_.front();
    require(field != nullptr, "a force field that was given is null");
    ownFields_ = ownFields_.subspan(1);
    return field;
}

void SnapshotFields::one(FieldEntry& entry) {
    auto& [shared, which] = entry;
    FieldKind kind = shared ? kindOf(*shared) : FieldKind::Own;
    as<std::uint8_t>(kind);
    switch (kind) {
    case FieldKind::Own:
        shared = reads() ? nextOwnField() : shared;
        break;
    case FieldKind::Gravity:
        field(shared, &Gravity::acceleration);
        break;
    case FieldKind::Drag:
        field(shared, &Drag::law, &Drag::air);
        break;
    case FieldKind::Wind:
        field(shared, &Wind::law, &Wind::velocity, &Wind::region);
        break;
    case FieldKind::Attractor:
        field(shared, &Attractor::law, &Attractor::center, &Attractor::strength,
              &Attractor::softening);
        break;
    case FieldKind::Buoyancy:
        field(shared, &Buoyancy::fluid, &Buoyancy::surface, &Buoyancy::gravity);
        break;
    default:
        require(false, "there is no such kind of force field");
    }
    one(which);
}

void SnapshotFields::completeContact(Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const auto there = [&](std::uint32_t body, std::uint16_t part) {
        return body < bodies.size() && bodies.ids.aliveAt(body) &&
               part < bodies.form(body).parts.size();
    };
    require(bodyA < bodyB && there(bodyA, partA) && there(bodyB, partB),
            "a contact is between bodies that are not there");
    describeContact(contact, bodies);
}

/// The bounds of what does not move are from when it last did, so they do not follow from the
/// bodies.
void SnapshotFields::contacts(ContactSet& set, const Bodies& bodies, const Tolerances& tolerances) {
    // The way pairs are found changes what that costs and not what is found, so it begins anew.
    auto& [bounds, pairs, finder, seams, contacts, order, newOrder, news, newsFound, holes, added,
           heads, live, found, onGround, slots, idle, dropped, changes, hasChanged, stirred,
           touches, touchChanges, ended, endedInStep, records, recordsDue, apart, fastestApproach,
           disorder, stale, pairsStale, contactsChanged, liveStale, anySensors, anyBounces] = set;
    auto& [parts, firstPart, firstBefore, replaced, outlines, corners, leftOver, tight, grown,
           changed, isChanged, outgrown] = bounds;
    set.writeRecords();
    if (!reads()) {
        set.applyChanges(bodies, tolerances);
    }
    all(contacts, ended, records, tight, grown, changed, disorder);
    if (!reads()) {
        return;
    }
    const auto good = [](const Octagon& octagon) { return bounded(octagon); };
    require(tight.size() == partCount(bodies) && grown.size() == tight.size() &&
                std::all_of(tight.begin(), tight.end(), good) &&
                std::all_of(grown.begin(), grown.end(), good),
            "the bounds do not fit the bodies");
    std::vector<Octagon> tightAsRead = std::move(tight);
    std::vector<Octagon> grownAsRead = std::move(grown);
    const std::vector<std::uint32_t> changedAsRead = std::move(changed);
    bounds.number(bodies);
    tight = std::move(tightAsRead);
    grown = std::move(grownAsRead);
    for (const std::uint32_t i : changedAsRead) {
        require(i < tight.size() && isChanged[i] == 0,
                "the list of the bounds that are new is wrong");
        bounds.list(i, changed);
    }
    stale = false;
    pairsStale = false;
    for (Contact& contact : contacts) {
        completeContact(contact, bodies);
    }
    set.orderContacts();
    set.countTouches(bodies);
    const auto before = [&all = contacts](const auto& a, const auto& b) {
        return all[a.slot].key < all[b.slot].key;
    };
    require(std::adjacent_find(order.begin(), order.end(), std::not_fn(before)) == order.end(),
            "a contact is there twice");
}

void SnapshotFields::rest(RestStage& stage, Bodies& bodies) {
    auto& [islands, restingIslands, leaning, touching, leastCalm, supports, resting, members,
           standing] = stage;
    all(islands);
    if (!reads()) {
        return;
    }
    const char* const sentence = "what rests and what does not is at odds";
    for (std::uint32_t island = 0; island < islands.size(); ++island) {
        require(inOrder(islands[island].bodies, bodies.size()), sentence);
        for (const std::uint32_t body : islands[island].bodies) {
            require(bodies.ids.aliveAt(body) && bodies.resting(body) &&
                        bodies.rest[body].island == RestState::kNoIsland,
                    sentence);
            bodies.rest[body].island = island;
        }
        for (Contact& contact : islands[island].contacts) {
            completeContact(contact, bodies);
            contact.row = {}; // only those of the list have one
            stage.countLeaning(contact, true);
        }
        require(!islands[island].bodies.empty() || islands[island].contacts.empty(), sentence);
        restingIslands += islands[island].bodies.empty() ? 0 : 1;
    }
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        require(!bodies.resting(i) || bodies.rest[i].island != RestState::kNoIsland, sentence);
    }
}

void SnapshotFields::joints(JointSet& set, const Bodies& bodies, Real lengthUnit) {
    auto& [ids, joints, live, apart, broken, trees, held, turned, own, lent, busy, busyStale] = set;
    one(ids);
    joints.resize(ids.capacity());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!ids.aliveAt(i)) {
            continue;
        }
        one(joints[i]);
        if (!reads()) {
            continue;
        }
        require(check(joints[i].def, lengthUnit));
        for (const BodyId body : {firstBody(joints[i].def), secondBody(joints[i].def)}) {
            require(bodies.ids.alive(body.index, body.generation),
                    "a joint holds a body that is not there");
        }
    }
    set.refreshLists();
}

void SnapshotFields::world(World& world) {
    auto& [settings, tolerances, stepCount, count, bodies, fields, contacts, impacts, softStep,
           propagation, contactVisits, sweep, rest, joints, broken, frozen, region, held, aside,
           returning, wereAwake, switched, lastForm] = world;
    softStep.blocks().fetchAll(contacts.contacts(), bodies);
    all(settings, tolerances, stepCount);
    bodies.turns = settings.has(Feature::Rotation);
    forms(world);
    all(bodies, lastForm, fields);
    require(ownFields_.empty(), "more force fields were given than it holds of your own");
    this->joints(joints, bodies, tolerances.unit());
    if (reads()) {
        contacts.setApart(joints.apart());
    }
    this->contacts(contacts, bodies, tolerances);
    this->rest(rest, bodies);
    as<std::uint64_t>(contactVisits);
    all(broken, frozen, region, aside);
    if (reads()) {
        for (Contact& contact : aside) {
            completeContact(contact, bodies);
            contact.row = {};
        }
    }
    if (region) {
        require(region->lower.x <= region->upper.x && region->lower.y <= region->upper.y,
                "the region is inside out");
    }
    count = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        count += bodies.ids.aliveAt(i) ? 1 : 0;
    }
}

} // namespace kodo::inline KODO_PRECISION
