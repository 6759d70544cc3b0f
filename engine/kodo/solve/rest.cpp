// SPDX-License-Identifier: MIT
#include <kodo/collide/time_of_impact.hpp>
#include <kodo/solve/rest.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::uint32_t kNoIsland = RestState::kNoIsland;

// What contacts and rounding do to a body that stands still: speeds of up to this share of what its
// forces would give it in a step.
constexpr Real kNoise = Real(1) / 2048;

Real kineticEnergy(const Motion& motion, const Mass& mass) {
    const Real w = motion.angularVelocity;
    return (mass.mass * lengthSquared(motion.velocity) + mass.inertia * w * w) / 2;
}

/// What the forces give a body within dt from a standstill.
Real energyOfForces(const Acceleration& acceleration, const Mass& mass, Real dt) {
    const Real v = dt * acceleration.effort;
    const Real w = dt * acceleration.angular;
    return (mass.mass * v * v + mass.inertia * w * w) / 2;
}

/// Adds a contact to those of an island, in the order of keys. One that is there already is from
/// before a neighbour woke. True if it was not.
bool keep(std::vector<Contact>& held, const Contact& contact) {
    const auto place =
        std::lower_bound(held.begin(), held.end(), contact,
                         [](const Contact& a, const Contact& b) { return a.key < b.key; });
    if (place != held.end() && place->key == contact.key) {
        *place = contact;
        return false;
    }
    held.insert(place, contact);
    return true;
}

/// Has any point of the body moved farther than that since `since`?
bool crept(const Transform& pose, const Transform& since, Real reach, Real distance) {
    const Rot turn = pose.rotation * since.rotation.inverse();
    const Real moved = lengthSquared(pose.position - since.position);
    const Real turned = reach * reach * turn.s * turn.s;
    return moved + turned > distance * distance || turn.c < 0;
}

void startCounting(RestState& rest, const Transform& pose) {
    const std::uint32_t island = rest.island;
    rest = {};
    rest.island = island;
    rest.since = pose;
}

} // namespace

/// An island has got a contact more, or one less.
void RestStage::countLeaning(const Contact& contact, bool leans) {
    for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
        if (body >= leaning_.size()) {
            leaning_.resize(body + std::size_t{1}, 0);
        }
        if (leans) {
            ++leaning_[body];
        } else {
            --leaning_[body];
        }
    }
}

void RestStage::wakeIsland(Bodies& bodies, ContactSet& contacts, std::uint32_t island) {
    Island& woken = islands_[island];
    --restingIslands_;
    for (const std::uint32_t body : woken.bodies) {
        bodies.filter[body].flags &= ~kResting;
        bodies.rest[body] = {};
        bodies.rest[body].since = bodies.pose[body];
        bodies.motion[body].halt();
        bodies.acceleration[body] = {};
    }
    contacts.putBack(woken.contacts, bodies);
    for (const Contact& contact : woken.contacts) {
        countLeaning(contact, false);
    }
    for (const std::uint32_t body : woken.bodies) {
        contacts.activityChanged(body);
    }
    woken.bodies.clear(); // keeps its memory for the next island
    woken.contacts.clear();
    bodies.awakeStale = true;
}

void RestStage::wake(Bodies& bodies, ContactSet& contacts, std::uint32_t body) {
    startCounting(bodies.rest[body], bodies.pose[body]);
    if (bodies.rest[body].island != kNoIsland) {
        wakeIsland(bodies, contacts, bodies.rest[body].island);
    }
}

void RestStage::wakeAll(Bodies& bodies, ContactSet& contacts) {
    for (std::uint32_t island = 0; island < islands_.size(); ++island) {
        if (!islands_[island].bodies.empty()) {
            wakeIsland(bodies, contacts, island);
        }
    }
}

void RestStage::disturb(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                        std::uint32_t body) {
    wake(bodies, contacts, body);
    joints.forEach([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        const std::uint32_t b = secondBody(joint.def).index;
        if (a == body || b == body) {
            wake(bodies, contacts, a == body ? b : a);
        }
    });
    if (body >= leaning_.size()) {
        return;
    }
    for (std::uint32_t island = 0; island < islands_.size() && leaning_[body] > 0; ++island) {
        const std::vector<Contact>& held = islands_[island].contacts;
        const bool leans = std::any_of(held.begin(), held.end(), [&](const Contact& contact) {
            return contact.key.bodyA == body || contact.key.bodyB == body;
        });
        if (leans) {
            wakeIsland(bodies, contacts, island);
        }
    }
}

void RestStage::wakeTouched(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances) {
    std::size_t i = 0;
    while (i < contacts.contacts().size()) {
        const Contact& contact = contacts.contacts()[i];
        const Real separation = contacts.heads()[i++].separation[0];
        if (!contact.responds() || separation > tolerances.slop) {
            continue;
        }
        for (const std::uint32_t body : {contact.key.bodyA, contact.key.bodyB}) {
            if (bodies.rest[body].island != kNoIsland) {
                wakeIsland(bodies, contacts, bodies.rest[body].island);
                i = 0; // the list has grown and is in order again
                break;
            }
        }
    }
}

void RestStage::wakeJointed(Bodies& bodies, ContactSet& contacts, const JointSet& joints) {
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        const std::uint32_t b = secondBody(joint.def).index;
        if (bodies.active(a) && bodies.resting(b)) {
            wake(bodies, contacts, b);
        } else if (bodies.active(b) && bodies.resting(a)) {
            wake(bodies, contacts, a);
        }
    });
}

bool RestStage::wakeRunOver(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances) {
    const auto drives = [&](std::uint32_t body) { return bodies.drives(body); };
    if (std::none_of(bodies.awake.begin(), bodies.awake.end(), drives)) {
        return false;
    }
    members_.clear();
    for (const Contact& contact : contacts.contacts()) {
        const auto& [bodyA, partA, bodyB, partB] = contact.key;
        const std::uint32_t wall = bodies.resting(bodyA) ? bodyB : bodyA;
        if (bodies.resting(bodyA) == bodies.resting(bodyB) || !bodies.locked(wall) ||
            contact.sensor || contact.passing) {
            continue;
        }
        const Motion& motion = bodies.motion[wall];
        const Real way = length(motion.move) + std::abs(motion.turn) * bodies.extent[wall].swing;
        if (way <= std::min(bodies.extent[bodyA].inside, bodies.extent[bodyB].inside) / 2) {
            continue; // the contact of the next step will do
        }
        const auto sweepOf = [&](std::uint32_t body) {
            return Sweep{bodies.pose[body], bodies.motion[body].move, bodies.motion[body].turn};
        };
        if (timeOfImpact(bodies.outline(bodyA, partA), sweepOf(bodyA), bodies.outline(bodyB, partB),
                         sweepOf(bodyB), tolerances.slop / 64) < 1) {
            members_.push_back(wall == bodyA ? bodyB : bodyA);
        }
    }
    for (const std::uint32_t body : members_) {
        wake(bodies, contacts, body);
    }
    return !members_.empty();
}

/// True if some body has been calm for long enough, so that islands are worth looking at.
bool RestStage::countCalm(Bodies& bodies, const StepSettings& settings,
                          const Tolerances& tolerances, Real dt) {
    bool any = false;
    for (const std::uint32_t body : bodies.awake) {
        RestState& rest = bodies.rest[body];
        const Form& form = bodies.form(body);
        const Real energy = kineticEnergy(bodies.motion[body], form.mass);
        const bool calm = (bodies.filter[body].flags & kNeverRest) == 0 &&
                          energy <= energyOfForces(bodies.acceleration[body], form.mass, dt) &&
                          !crept(bodies.pose[body], rest.since, form.reach, tolerances.slop / 4);
        if (calm) {
            ++rest.calmSteps;
            rest.leastEnergy = std::min(rest.leastEnergy, energy);
        } else {
            startCounting(rest, bodies.pose[body]);
        }
        any = any || rest.calmSteps >= static_cast<std::uint32_t>(settings.restSteps);
    }
    return any;
}

/// A face or a round outline holds a body by two points or more, and so does a joint; one corner
/// alone can only balance it.
void RestStage::countSupports(const Bodies& bodies, const ContactSet& contacts,
                              const JointSet& joints) {
    supports_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        supports_[body] = 0;
    }
    for (const Contact& contact : contacts.contacts()) {
        const ContactKey& key = contact.key;
        if (contact.touching && !contact.sensor) {
            const bool round = bodies.outline(key.bodyA, key.partA).isRound() ||
                               bodies.outline(key.bodyB, key.partB).isRound();
            const auto points = static_cast<std::uint32_t>(round ? 2 : contact.manifold.count);
            supports_[key.bodyA] += points;
            supports_[key.bodyB] += points;
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        supports_[firstBody(joint.def).index] += 2;
        supports_[secondBody(joint.def).index] += 2;
    });
}

/// What balances on one corner, and is faster than it was at its slowest, is falling.
void RestStage::restartTipping(Bodies& bodies, Real dt) {
    for (const std::uint32_t body : bodies.awake) {
        RestState& rest = bodies.rest[body];
        if (supports_[body] != 1 || rest.calmSteps == 0) {
            continue;
        }
        const Mass& mass = bodies.form(body).mass;
        const Real now = std::sqrt(kineticEnergy(bodies.motion[body], mass));
        const Real noise = kNoise * std::sqrt(energyOfForces(bodies.acceleration[body], mass, dt));
        if (now - std::sqrt(rest.leastEnergy) > noise) {
            startCounting(rest, bodies.pose[body]);
        }
    }
}

void RestStage::joinTouching(const Bodies& bodies, const ContactSet& contacts,
                             const JointSet& joints) {
    touching_.resize(bodies.size());
    leastCalm_.resize(bodies.size());
    for (const std::uint32_t body : bodies.awake) {
        touching_.makeSet(body);
    }
    for (const Contact& contact : contacts.contacts()) {
        const ContactKey& key = contact.key;
        if (contact.touching && !contact.sensor && bodies.active(key.bodyA) &&
            bodies.active(key.bodyB)) {
            // A locked body that moves joins what it carries: none of it rests meanwhile.
            touching_.join(key.bodyA, key.bodyB);
        }
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        const std::uint32_t a = firstBody(joint.def).index;
        const std::uint32_t b = secondBody(joint.def).index;
        if (bodies.active(a) && bodies.active(b)) {
            touching_.join(a, b);
        }
    });
    for (const std::uint32_t body : bodies.awake) {
        leastCalm_[body] = bodies.locked(body) ? 0 : bodies.rest[body].calmSteps;
    }
    for (const std::uint32_t body : bodies.awake) {
        std::uint32_t& least = leastCalm_[touching_.rootOf(body)];
        const std::uint32_t own = bodies.locked(body) ? 0 : bodies.rest[body].calmSteps;
        least = std::min(least, own);
    }
}

void RestStage::putToRest(Bodies& bodies, std::span<const std::uint32_t> members) {
    std::uint32_t island = 0;
    while (island < islands_.size() && !islands_[island].bodies.empty()) {
        ++island;
    }
    if (island == islands_.size()) {
        islands_.emplace_back();
    }
    for (const std::uint32_t body : members) {
        bodies.filter[body].flags |= kResting;
        bodies.rest[body].island = island;
        bodies.motion[body].stand();
    }
    ++restingIslands_;
    islands_[island].bodies.assign(members.begin(), members.end());
}

bool RestStage::findRest(Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                         const StepSettings& settings, const Tolerances& tolerances, Real dt) {
    if (!countCalm(bodies, settings, tolerances, dt)) {
        return false;
    }
    countSupports(bodies, contacts, joints);
    restartTipping(bodies, dt);
    joinTouching(bodies, contacts, joints);
    const auto enough = static_cast<std::uint32_t>(settings.restSteps);
    resting_.clear();
    for (const std::uint32_t body : bodies.awake) {
        const std::uint32_t root = touching_.rootOf(body);
        if (leastCalm_[root] >= enough) {
            resting_.emplace_back(root, body);
        }
    }
    return !resting_.empty();
}

void RestStage::settle(Bodies& bodies, ContactSet& contacts) {
    std::sort(resting_.begin(), resting_.end()); // total order: bodies are unique
    members_.clear();
    for (std::size_t i = 0; i < resting_.size(); ++i) {
        members_.push_back(resting_[i].second);
        if (i + 1 == resting_.size() || resting_[i + 1].first != resting_[i].first) {
            putToRest(bodies, members_);
            members_.clear();
        }
    }
    standing_.clear();
    for (const Contact& contact : contacts.takeIdle(bodies)) {
        const std::uint32_t a = bodies.rest[contact.key.bodyA].island;
        const std::uint32_t island = a != kNoIsland ? a : bodies.rest[contact.key.bodyB].island;
        // What froze in this step neither rests nor takes part; its end is yet to be told.
        if (island == kNoIsland) {
            keep(standing_, contact);
        } else if (keep(islands_[island].contacts, contact)) {
            countLeaning(contact, true);
        }
    }
    contacts.putBack(standing_, bodies);
    bodies.awakeStale = true;
}

} // namespace kodo::inline KODO_PRECISION
