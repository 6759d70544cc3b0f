// SPDX-License-Identifier: MIT
#include <kodo/bodies/bodies.hpp>

#include <algorithm>
#include <utility>

namespace kodo::inline KODO_PRECISION {

BodyId addBody(Bodies& bodies, const BodyDef& def, std::shared_ptr<const Form> form) {
    const IdPool::Slot slot = bodies.ids.allocate();
    if (slot.index == bodies.size()) {
        bodies.motion.emplace_back();
        bodies.pose.emplace_back();
        bodies.acceleration.emplace_back();
        bodies.extent.emplace_back();
        bodies.jumps.emplace_back();
        bodies.hasJumped.emplace_back();
        bodies.filter.emplace_back();
        bodies.record.emplace_back();
        bodies.parts.emplace_back();
        bodies.rest.emplace_back();
    }
    Motion motion;
    motion.velocity = def.velocity;
    motion.angularVelocity = def.angularVelocity;
    bodies.motion[slot.index] = motion;
    const Rot rotation = normalize(def.rotation);
    bodies.pose[slot.index] = {def.position + rotation * form->mass.center, rotation};
    bodies.acceleration[slot.index] = {};
    bodies.thinnest = std::min(bodies.thinnest, form->inside);
    BodyRecord record;
    record.form = std::move(form);
    record.userData = def.userData;
    bodies.record[slot.index] = std::move(record);
    bodies.filter[slot.index] = {def.flags & ~kStatusFlags, def.required};
    bodies.rest[slot.index] = {};
    bodies.rest[slot.index].since = bodies.pose[slot.index];
    bodies.awakeStale = true;
    refreshBuild(bodies, slot.index);
    return {slot.index, slot.generation};
}

void removeBody(Bodies& bodies, std::uint32_t index) {
    bodies.ids.release(index);
    bodies.motion[index] = {};
    bodies.pose[index] = {};
    bodies.acceleration[index] = {};
    bodies.filter[index] = {};
    bodies.record[index] = {};
    bodies.parts[index] = nullptr;
    bodies.rest[index] = {};
    bodies.awakeStale = true;
}

BodyId unweldPart(Bodies& bodies, std::uint32_t body, std::size_t part, Flags flags) {
    const Transform frame{bodies.originOf(body), bodies.pose[body].rotation};
    const Motion before = bodies.motion[body];
    const Vec2 center = bodies.pose[body].position;

    std::vector<Part> rest = bodies.form(body).parts;
    const std::vector<Part> taken{rest[part]};
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(part));
    BodyDef def;
    def.position = frame.position;
    def.rotation = frame.rotation;
    def.angularVelocity = before.angularVelocity;
    def.flags = flags;
    const BodyId freed = addBody(bodies, def, makeForm(taken));
    setForm(bodies, body, makeForm(std::move(rest)));
    for (const std::uint32_t index : {body, freed.index}) {
        bodies.motion[index].velocity = velocityAt(before, bodies.pose[index].position - center);
    }
    return freed;
}

Aabb boundsOfBody(const Bodies& bodies, std::size_t body) {
    const std::vector<Part>& parts = bodies.form(body).parts;
    Aabb box = boundsOf(parts[0].convex, bodies.pose[body]);
    for (const Part& part : parts) {
        box = unite(box, boundsOf(part.convex, bodies.pose[body]));
    }
    return box;
}

void addForce(Bodies& bodies, std::uint32_t body, Vec2 force, Real torque) {
    BodyRecord& record = bodies.record[body];
    if (record.force == Vec2{} && record.torque == 0) {
        bodies.forced.push_back(body);
        bodies.pushesStale = true;
    }
    record.force += force;
    record.torque += torque;
}

void freeze(Bodies& bodies, std::uint32_t body) {
    bodies.filter[body].flags |= kFrozen;
    bodies.motion[body] = {};
    bodies.acceleration[body] = {};
    bodies.jumped(body);
    bodies.awakeStale = true;
}

void listAwake(Bodies& bodies) {
    bodies.awakeStale = false;
    bodies.startStale = true; // those that are awake no more have moved until now
    bodies.pushesStale = true;
    bodies.awake.clear();
    Real thinnest = std::numeric_limits<Real>::max();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies.ids.aliveAt(i)) {
            thinnest = std::min(thinnest, bodies.extent[i].inside);
            if (bodies.active(i)) {
                bodies.awake.push_back(static_cast<std::uint32_t>(i));
            }
        }
    }
    bodies.thinnest = thinnest;
}

void noteStart(Bodies& bodies) {
    bodies.start.resize(bodies.size());
    if (std::exchange(bodies.startStale, false)) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            bodies.start[i] = bodies.pose[i].position;
        }
    } else {
        for (const std::uint32_t i : bodies.awake) {
            bodies.start[i] = bodies.pose[i].position;
        }
    }
    if (std::exchange(bodies.anyJumped, false)) {
        std::fill(bodies.hasJumped.begin(), bodies.hasJumped.end(), std::uint8_t{0});
    }
}

void setForm(Bodies& bodies, std::uint32_t index, std::shared_ptr<const Form> form) {
    const Vec2 origin = bodies.originOf(index);
    Transform& pose = bodies.pose[index];
    pose.position = origin + pose.rotation * form->mass.center;
    bodies.thinnest = std::min(bodies.thinnest, form->inside);
    bodies.record[index].form = std::move(form);
    bodies.jumped(index);
    refreshBuild(bodies, index);
}

void weldBodies(Bodies& bodies, std::uint32_t into, std::uint32_t part) {
    const Transform frame{bodies.originOf(into), bodies.pose[into].rotation};
    const Transform other{bodies.originOf(part), bodies.pose[part].rotation};
    Transform place = between(frame, other);
    place.rotation = normalize(place.rotation); // a part may come and go a thousand times
    std::vector<Part> parts = bodies.form(into).parts;
    for (const Part& added : bodies.form(part).parts) {
        parts.push_back({moved(added.primitive, place), added.material, added.density});
    }
    const std::shared_ptr<const Form> form = makeForm(std::move(parts));

    const Vec2 center = frame * form->mass.center;
    Vec2 momentum;
    Real spin = 0; // angular momentum about the new centre
    for (const std::uint32_t body : {into, part}) {
        const Mass& mass = bodies.form(body).mass;
        const Motion& motion = bodies.motion[body];
        momentum += mass.mass * motion.velocity;
        spin += mass.inertia * motion.angularVelocity +
                mass.mass * cross(bodies.pose[body].position - center, motion.velocity);
    }
    Motion& motion = bodies.motion[into];
    if (motion.invMass > 0) {
        motion.velocity = momentum / form->mass.mass;
    } else { // the centre moves within a body that goes on as it did
        motion.velocity = velocityAt(motion, center - bodies.pose[into].position);
    }
    setForm(bodies, into, form);
    if (motion.invInertia > 0) { // now: a particle has got some inertia
        motion.angularVelocity = spin / form->mass.inertia;
    }
}

void refreshBuild(Bodies& bodies, std::uint32_t index) {
    const Form& form = bodies.form(index);
    bodies.extent[index] = {form.swing, form.inside};
    bodies.parts[index] = form.parts.data();
    const Mass& mass = form.mass;
    const Flags flags = bodies.filter[index].flags;
    bodies.motion[index].invMass = (flags & (kLockMove | kFrozen)) != 0 ? 0 : 1 / mass.mass;
    // Nothing can turn a particle: it has no inertia, but no arm either.
    const bool free = bodies.turns && (flags & (kLockRotate | kFrozen)) == 0;
    const bool turns = free && mass.inertia > 0;
    bodies.motion[index].invInertia = turns ? 1 / mass.inertia : 0;
    bodies.pushesStale = true;
}

void setTurns(Bodies& bodies, bool turns) {
    bodies.turns = turns;
    for (std::uint32_t index = 0; index < bodies.size(); ++index) {
        if (!bodies.ids.aliveAt(index)) {
            continue;
        }
        refreshBuild(bodies, index);
        bodies.jumped(index);
        if (!turns && (bodies.filter[index].flags & kLockRotate) == 0) {
            bodies.motion[index].angularVelocity = 0;
        }
    }
    bodies.awakeStale = true;
}

} // namespace kodo::inline KODO_PRECISION
