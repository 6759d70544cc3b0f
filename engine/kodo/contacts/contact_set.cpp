// SPDX-License-Identifier: MIT
#include <kodo/broad/brute_force.hpp>
#include <kodo/collide/collide.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/contacts/contact_set.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

// Up to here the brute force beats sorting; both find the same pairs.
constexpr std::size_t kBruteForceLimit = 32;

/// Bounds of a part moved by the motion of its body within this step.
Aabb boundsAfter(const Convex& convex, const Transform& pose, const Motion& motion) {
    return boundsOf(convex, {pose.position + motion.move, turned(pose.rotation, motion.turn)});
}

Real approachSpeedOf(const Contact& contact, const Bodies& bodies) {
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    Real fastest = 0;
    for (int i = 0; i < contact.manifold.count; ++i) {
        const ManifoldPoint& p = contact.manifold.points[static_cast<std::size_t>(i)];
        const Vec2 relative = velocityAt(b, p.armB) - velocityAt(a, p.armA);
        fastest = std::max(fastest, -dot(contact.manifold.normal, relative));
    }
    return fastest;
}

/// Hands the impulses of the old points on to the new ones that are made by the same features.
void keepImpulses(const Contact& old, Contact& now) {
    now.impulse = {};
    for (std::size_t i = 0; i < static_cast<std::size_t>(now.manifold.count); ++i) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(old.manifold.count); ++k) {
            if (now.manifold.points[i].feature == old.manifold.points[k].feature) {
                now.impulse[i].normal = old.impulse[k].normal;
            }
        }
    }
    if (now.manifold.count == 0) {
        now.friction = 0;
        now.rolling = 0;
    }
}

// A manifold is kept until its bodies have gone so far, in slops.
constexpr std::uint32_t kKept = 8;

/// Keeps a manifold while its bodies have not gone far since it was found: only the separations
/// follow the last step, to first order in the turn. This saves most of the work in a
/// pile, and a point of contact that stays where it is steadies it. False if it must be found anew.
bool carry(const Bodies& bodies, Contact& contact) {
    const std::uint32_t a = contact.key.bodyA;
    const std::uint32_t b = contact.key.bodyB;
    const std::uint32_t way =
        (bodies.travel[a] - contact.travelA) + (bodies.travel[b] - contact.travelB);
    if (!std::exchange(contact.carried, false) || way > kKept * Bodies::kTravelPerSlop) {
        return false;
    }
    const Motion& motionA = bodies.motion[a];
    const Motion& motionB = bodies.motion[b];
    const Vec2 n = contact.manifold.normal;
    const Real moved = dot(n, motionB.move - motionA.move);
    for (ManifoldPoint& p : contact.manifold.points) {
        p.separation += moved + (cross(p.armB, n) * motionB.turn - cross(p.armA, n) * motionA.turn);
    }
    for (PointImpulse& impulse : contact.impulse) {
        impulse.largest = 0;
    }
    return true;
}

CollisionRecord endOf(const Contact& contact) {
    CollisionRecord record;
    record.a = contact.a;
    record.b = contact.b;
    record.partA = contact.key.partA;
    record.partB = contact.key.partB;
    record.phase = TouchPhase::End;
    record.normal = contact.manifold.normal;
    record.point = contact.centerA + contact.manifold.points[0].armA;
    return record;
}

} // namespace

void ContactSet::noteEnd(const Contact& contact) {
    if (contact.wasTouching) {
        ended_.push_back(endOf(contact));
    }
}

void ContactSet::forgetUnsoundImpulses() {
    for (Contact& contact : contacts_) {
        const Real sum = contact.impulse[0].normal + contact.impulse[1].normal + contact.friction +
                         contact.rolling + contact.total;
        if (!std::isfinite(sum)) {
            contact.impulse = {};
            contact.friction = 0;
            contact.rolling = 0;
            contact.total = 0;
        }
    }
}

void ContactSet::drop(std::uint32_t body) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const Contact& contact = contacts_[i];
        if (contact.key.bodyA != body && contact.key.bodyB != body) {
            contacts_[kept++] = contact;
        } else {
            noteEnd(contact);
        }
    }
    contacts_.resize(kept);
    stale_ = true;
}

void ContactSet::partRemoved(std::uint32_t body, std::size_t part) {
    std::size_t kept = 0;
    for (Contact contact : contacts_) {
        bool gone = false;
        for (const bool isA : {true, false}) {
            std::uint16_t& own = isA ? contact.key.partA : contact.key.partB;
            if ((isA ? contact.key.bodyA : contact.key.bodyB) == body && own >= part) {
                gone = own == part;
                own = static_cast<std::uint16_t>(gone ? own : own - 1);
            }
        }
        if (gone) {
            noteEnd(contact);
        } else {
            contacts_[kept++] = contact;
        }
    }
    contacts_.resize(kept);
    stale_ = true;
}

std::vector<Contact> ContactSet::takeIdle(const Bodies& bodies) {
    std::vector<Contact> idle;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactKey& key = contacts_[i].key;
        if (bodies.active(key.bodyA) || bodies.active(key.bodyB)) {
            contacts_[kept++] = contacts_[i];
        } else {
            idle.push_back(contacts_[i]);
        }
    }
    contacts_.resize(kept);
    return idle;
}

void ContactSet::putBack(std::span<const Contact> contacts) {
    const auto before = [](const Contact& a, const Contact& b) { return a.key < b.key; };
    const std::size_t old = contacts_.size();
    for (const Contact& contact : contacts) {
        const auto end = contacts_.begin() + static_cast<std::ptrdiff_t>(old);
        const auto place = std::lower_bound(contacts_.begin(), end, contact, before);
        if (place == end || place->key != contact.key) {
            contacts_.push_back(contact);
            contacts_.back().proxyA = firstProxy_[contact.key.bodyA] + contact.key.partA;
            contacts_.back().proxyB = firstProxy_[contact.key.bodyB] + contact.key.partB;
        }
    }
    std::sort(contacts_.begin(), contacts_.end(), before); // total order: keys are unique
}

const Convex& ContactSet::outline(const Bodies& bodies, std::size_t proxy) const {
    return bodies.form(proxies_[proxy].body).parts[proxies_[proxy].part].convex;
}

void ContactSet::rebuildProxies(const Bodies& bodies) {
    proxies_.clear();
    firstProxy_.assign(bodies.size(), 0);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        if (!bodies.ids.aliveAt(body)) {
            continue;
        }
        firstProxy_[body] = static_cast<std::uint32_t>(proxies_.size());
        const std::size_t parts = bodies.form(body).parts.size();
        for (std::size_t part = 0; part < parts; ++part) {
            proxies_.push_back(
                {static_cast<std::uint32_t>(body), static_cast<std::uint16_t>(part)});
        }
    }
    tight_.assign(proxies_.size(), {});
    grown_.assign(proxies_.size(), {});
}

void ContactSet::updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt) {
    const bool anew = std::exchange(stale_, false);
    bool outgrown = std::exchange(pairsStale_, false) || anew;
    if (anew) {
        rebuildProxies(bodies);
        for (std::size_t i = 0; i < proxies_.size(); ++i) {
            tight_[i] = boundsOf(outline(bodies, i), bodies.pose[proxies_[i].body]);
            grown_[i] = tight_[i].grown(tolerances.margin);
        }
    }
    for (const std::uint32_t body : bodies.awake) {
        const Motion& motion = bodies.motion[body];
        const Form& form = bodies.form(body);
        // A bounce may send it in any direction, so it is grown by its motion on all sides.
        const Real reachable =
            dt * (length(motion.velocity) + form.reach * std::abs(motion.angularVelocity));
        for (std::size_t part = 0; part < form.parts.size(); ++part) {
            const std::size_t i = firstProxy_[body] + part;
            tight_[i] = boundsOf(form.parts[part].convex, bodies.pose[body]);
            const Aabb needed = tight_[i].grown(tolerances.margin + reachable);
            if (!grown_[i].contains(needed)) {
                grown_[i] = needed.grown(tolerances.grown + reachable);
                outgrown = true;
            }
        }
    }
    if (outgrown) {
        findPairs(bodies);
        mergePairs(bodies);
    }
}

void ContactSet::coverMoves(const Bodies& bodies, const Tolerances& tolerances) {
    bool outgrown = false;
    for (const std::uint32_t body : bodies.awake) {
        const Form& form = bodies.form(body);
        const Motion& motion = bodies.motion[body];
        const Real way = length(motion.move) + std::abs(motion.turn) * bodies.extent[body].reach;
        for (std::size_t part = 0; part < form.parts.size(); ++part) {
            const std::size_t i = firstProxy_[body] + part;
            if (grown_[i].contains(tight_[i].grown(way))) {
                continue;
            }
            const Aabb after = boundsAfter(form.parts[part].convex, bodies.pose[body], motion);
            if (!grown_[i].contains(after)) {
                grown_[i] = unite(tight_[i], after).grown(tolerances.margin + tolerances.grown);
                outgrown = true;
            }
        }
    }
    if (outgrown) {
        findPairs(bodies);
        mergePairs(bodies);
    }
}

void ContactSet::setApart(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
    apart_.assign(pairs.begin(), pairs.end());
    pairsStale_ = true;
}

void ContactSet::findPairs(const Bodies& bodies) {
    const auto accept = [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = proxies_[i].body;
        const std::uint32_t b = proxies_[j].body;
        const Flags flagsA = bodies.record[a].filter.flags;
        const Flags flagsB = bodies.record[b].filter.flags;
        const bool sensor = ((flagsA ^ flagsB) & kSensor) != 0; // one of them, not both
        return a != b && (sensor || !(bodies.locked(a) && bodies.locked(b))) &&
               (sensor || ((flagsA & flagsB) & kSensor) == 0) &&
               (bodies.active(a) || bodies.active(b)) &&
               shouldCollide(bodies.record[a].filter, bodies.record[b].filter) &&
               !std::binary_search(apart_.begin(), apart_.end(), std::pair(a, b));
    };
    pairs_.clear();
    if (grown_.size() <= kBruteForceLimit) {
        bruteForce(grown_, accept, pairs_);
    } else {
        sortAndSweep_.pairs(grown_, accept, pairs_);
    }
}

Contact ContactSet::makeContact(const Bodies& bodies, BoundsPair pair) const {
    const Proxy& a = proxies_[pair.first];
    const Proxy& b = proxies_[pair.second];
    Contact contact;
    contact.key = {a.body, a.part, b.body, b.part};
    contact.a = bodies.idAt(a.body);
    contact.b = bodies.idAt(b.body);
    return contact;
}

/// Both lists are in the order of the keys, so one walk over both keeps what stays, drops what is
/// gone and adds what is new.
void ContactSet::mergePairs(const Bodies& bodies) {
    std::swap(contacts_, previous_);
    contacts_.clear();
    std::size_t old = 0;
    const auto skipOld = [&](const ContactKey* upTo) {
        for (; old < previous_.size() && (upTo == nullptr || previous_[old].key < *upTo); ++old) {
            noteEnd(previous_[old]);
        }
    };
    for (const BoundsPair pair : pairs_) {
        Contact contact = makeContact(bodies, pair);
        skipOld(&contact.key);
        if (old < previous_.size() && previous_[old].key == contact.key) {
            contact = previous_[old++];
        }
        contact.proxyA = pair.first;
        contact.proxyB = pair.second;
        contact.sensor = ((bodies.record[contact.key.bodyA].filter.flags |
                           bodies.record[contact.key.bodyB].filter.flags) &
                          kSensor) != 0;
        contact.material = mix(bodies.form(contact.key.bodyA).parts[contact.key.partA].material,
                               bodies.form(contact.key.bodyB).parts[contact.key.partB].material);
        contacts_.push_back(contact);
    }
    skipOld(nullptr);
}

void ContactSet::updateManifolds(const Bodies& bodies, const Tolerances& tolerances) {
    // Which face carries a contact of parallel faces must not flicker with rounding.
    const Real preference = tolerances.slop / 8;
    for (Contact& contact : contacts_) {
        contact.touching = false;
        contact.hidden = false;
        contact.total = 0;
        contact.approachSpeed = 0;
        if (carry(bodies, contact)) {
            contact.centerA = bodies.pose[contact.key.bodyA].position;
            contact.approachSpeed = approachSpeedOf(contact, bodies);
            continue;
        }
        const bool near =
            overlap(tight_[contact.proxyA].grown(tolerances.margin), tight_[contact.proxyB]);
        if (!near) {
            contact.manifold.count = 0;
            contact.impulse = {};
            contact.friction = 0;
            contact.rolling = 0;
            contact.passing = false;
            continue;
        }
        const Transform& a = bodies.pose[contact.key.bodyA];
        const Transform& b = bodies.pose[contact.key.bodyB];
        const Contact old = contact;
        contact.travelA = bodies.travel[contact.key.bodyA];
        contact.travelB = bodies.travel[contact.key.bodyB];
        contact.manifold =
            collide(outline(bodies, contact.proxyA), a, outline(bodies, contact.proxyB), b,
                    tolerances.margin, preference);
        contact.passing = letPass(contact.passing, contact.manifold);
        contact.centerA = a.position;
        keepImpulses(old, contact);
        contact.approachSpeed = approachSpeedOf(contact, bodies);
    }
    seams_.hide(bodies, contacts_, tolerances);
}

void finishContact(Contact& contact, const Tolerances& tolerances) {
    if (contact.sensor) {
        contact.touching = contact.touching || (contact.manifold.count > 0 &&
                                                contact.manifold.points[0].separation <= 0);
        return;
    }
    if (contact.hidden) {
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        PointImpulse& impulse = contact.impulse[i];
        impulse.largest = std::max(impulse.largest, impulse.impact);
        contact.total += impulse.impact;
        contact.touching = contact.touching || impulse.largest > 0 ||
                           contact.manifold.points[i].separation <= tolerances.slop;
    }
}

void recordContact(const Contact& contact, std::vector<CollisionRecord>& out) {
    if (!contact.touching) {
        if (contact.wasTouching) {
            out.push_back(endOf(contact));
        }
        return;
    }
    CollisionRecord& record = out.emplace_back(endOf(contact));
    record.phase = contact.wasTouching ? TouchPhase::Persist : TouchPhase::Begin;
    record.pointCount = static_cast<std::uint8_t>(contact.manifold.count);
    record.separation = contact.manifold.points[0].separation;
    record.approachSpeed = contact.approachSpeed;
    record.totalImpulse = contact.total;
    for (std::size_t i = 0; i < record.pointCount; ++i) {
        if (contact.impulse[i].largest > record.maxImpulse) {
            record.maxImpulse = contact.impulse[i].largest;
            record.point = contact.centerA + contact.manifold.points[i].armA;
        }
    }
}

} // namespace kodo::inline KODO_PRECISION
