// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/one_sided.hpp>
#include <kodo/contacts/contact_update.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

// A point made by other features than before is the same one if it is within so many slops and
// within so much of the inner radius of the thinner part, and if the normal is the same, nearly.
constexpr Real kSamePlace = 16;
constexpr Real kSameShare = Real(0.5);
constexpr Real kSameNormal = Real(0.9); // at least, the cosine of its turn
constexpr int kNoPoint = -1;

/// m; how far the places of two points are from each other, on the body where that is less.
Real distanceOf(const ManifoldPoint& p, const ManifoldPoint& q) {
    return std::min(length(p.armA - q.armA), length(p.armB - q.armB));
}

/// Of each point of a new manifold, which of the old one it was, made by the same features.
std::array<int, 2> matchFeatures(const Manifold& manifold, const Manifold& old) {
    std::array<int, 2> former{kNoPoint, kNoPoint};
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(old.count); ++k) {
            if (manifold.points[i].feature == old.points[k].feature) {
                former[i] = static_cast<int>(k);
            }
        }
    }
    return former;
}

/// The same for points that no old feature made, by their places, the nearest first. Of two faces
/// that lie on each other the one or the other may carry the contact, which gives other features to
/// the same places. Not in an overlap of more than `near` (m), where it may mean that the shortest
/// way out is another by now; so a line, which is 0 thick, has features alone.
void matchPlaces(const Manifold& manifold, const Manifold& old, Real near,
                 std::array<int, 2>& former) {
    // By the new depth alone: only contacts that were lent know how deep the old one has become.
    if (dot(manifold.normal, old.normal) < kSameNormal || manifold.points[0].separation < -near) {
        return;
    }
    for (int round = 0; round < manifold.count; ++round) {
        std::size_t place = former.size();
        int match = kNoPoint;
        Real least = near;
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
            for (int k = 0; k < old.count; ++k) {
                if (former[i] != kNoPoint || former[0] == k || former[1] == k) {
                    continue; // as most are, by their features
                }
                const Real distance =
                    distanceOf(manifold.points[i], old.points[static_cast<std::size_t>(k)]);
                if (distance <= least) {
                    place = i;
                    match = k;
                    least = distance;
                }
            }
        }
        if (match != kNoPoint) {
            former[place] = match;
        }
    }
}

/// Takes a new manifold, and hands the impulses of the old points on to those that they became,
/// within `near` (m).
void replaceManifold(Contact& contact, const Manifold& manifold, Real near) {
    const Manifold& old = contact.manifold;
    if (old.count == 0 && manifold.count == 0) {
        contact.manifold = manifold;
        return;
    }
    std::array<int, 2> former = matchFeatures(manifold, old);
    matchPlaces(manifold, old, near, former);
    std::array<PointImpulse, 2> impulse{};
    for (std::size_t i = 0; i < impulse.size(); ++i) {
        if (former[i] != kNoPoint) {
            impulse[i].normal = contact.impulse[static_cast<std::size_t>(former[i])].normal;
        }
    }
    contact.impulse = impulse;
    contact.manifold = manifold;
    if (manifold.count == 0) {
        contact.friction = 0;
        contact.rolling = 0;
    }
}

// A manifold is kept until its bodies have gone so far against each other, in slops; of bodies that
// bounce off each other, hardly any way: a blow must lie in one line for both, or it turns them.
constexpr Real kKept = 8;
constexpr Real kKeptToBounce = Real(1) / 8;

/// Adds what two bodies went against each other in the last step. False if one of them was put
/// elsewhere, so that nothing is known any more.
bool addDrift(const Bodies& bodies, Contact& contact) {
    const std::uint32_t a = contact.key.bodyA;
    const std::uint32_t b = contact.key.bodyB;
    const Motion& motionA = bodies.motion[a];
    const Motion& motionB = bodies.motion[b];
    const Vec2 between = motionB.move - motionA.move;
    contact.drift += std::abs(between.x) + std::abs(between.y) +
                     std::abs(motionA.turn) * bodies.extent[a].swing +
                     std::abs(motionB.turn) * bodies.extent[b].swing;
    return contact.jumpsA == bodies.jumps[a] && contact.jumpsB == bodies.jumps[b];
}

/// Have two that were apart not gone far enough to be within the margin of each other by now?
bool staysApart(const Contact& contact, const Tolerances& tolerances) {
    const Manifold& manifold = contact.manifold;
    return manifold.count == 0 && contact.drift < manifold.points[0].separation - tolerances.margin;
}

/// Keeps a manifold while its bodies have not gone far against each other since it was found: only
/// the separations follow the last step, to first order in the turn. What is round and turns about
/// its middle has no lever, so its turn counts for nothing. This saves most of the work in a pile,
/// also in one that moves as a whole, and a point of contact that stays where it is steadies it.
/// Measures the approach by the same levers. False if it must be found anew.
bool carry(const Bodies& bodies, Contact& contact, const Tolerances& tolerances) {
    if (!contact.carried || isOutdated(contact.drift, contact.bounces, tolerances)) {
        return false;
    }
    const Motion& motionA = bodies.motion[contact.key.bodyA];
    const Motion& motionB = bodies.motion[contact.key.bodyB];
    const Vec2 n = contact.manifold.normal;
    const Real moved = dot(n, motionB.move - motionA.move);
    const Real speed = dot(n, motionB.velocity - motionA.velocity);
    contact.approachSpeed = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        ManifoldPoint& p = contact.manifold.points[i];
        const Real leverA = leverOf(p.armA, n);
        const Real leverB = leverOf(p.armB, n);
        p.separation += moved + (leverB * motionB.turn - leverA * motionA.turn);
        const Real apart =
            speed + (leverB * motionB.angularVelocity - leverA * motionA.angularVelocity);
        contact.approachSpeed = std::max(contact.approachSpeed, -apart);
    }
    return true;
}

/// Two circles on one point have no direction of their own to part in, and all of a crowd on one
/// point would part along one line. So theirs goes by the number of the second body, in turns of
/// the golden angle, which spreads them to all sides. Just those have exactly the sum of the radii
/// for a depth; with centres closer than a rounding of it, which side is which means nothing
/// either.
void spreadConcentric(Manifold& manifold, const Convex& a, const Convex& b, std::uint32_t number) {
    ManifoldPoint& point = manifold.points[0];
    if (!a.isRound() || !b.isRound() || manifold.count == 0 ||
        point.separation != -(a.radius + b.radius)) {
        return;
    }
    constexpr Real kGoldenAngle = Real(2.39996323); // rad
    constexpr std::uint32_t kSides = 32; // turns of up to 77 rad: sines are exact up to 100
    const Vec2 normal =
        Rot::fromAngle(kGoldenAngle * static_cast<Real>(number % kSides)) * manifold.normal;
    const Vec2 shift = (a.radius + point.separation / 2) * (normal - manifold.normal);
    manifold.normal = normal;
    point.armA += shift;
    point.armB += shift;
}

/// What belongs to one step begins anew.
void beginStep(Contact& contact) {
    contact.hidden = false;
    if (contact.sensor) {
        contact.touching = false;
    }
    if (contact.struck) {
        forgetBlows(contact);
    }
}

} // namespace

void findContact(Contact& contact, const Bodies& bodies, const Tolerances& tolerances) {
    const ContactKey& key = contact.key;
    // Which face carries a contact of parallel faces must not flicker with rounding.
    const Real preference = tolerances.slop / 8;
    Manifold manifold = collide(bodies.outline(key.bodyA, key.partA), bodies.pose[key.bodyA],
                                bodies.outline(key.bodyB, key.partB), bodies.pose[key.bodyB],
                                tolerances.margin, preference);
    spreadConcentric(manifold, bodies.outline(key.bodyA, key.partA),
                     bodies.outline(key.bodyB, key.partB), key.bodyB);
    contact.passing = letPass(contact.passing, manifold);
    const Real thinner = std::min(bodies.outline(key.bodyA, key.partA).inside,
                                  bodies.outline(key.bodyB, key.partB).inside);
    replaceManifold(contact, manifold,
                    std::min(kSamePlace * tolerances.slop, kSameShare * thinner));
    contact.drift = 0;
    contact.jumpsA = bodies.jumps[key.bodyA];
    contact.jumpsB = bodies.jumps[key.bodyB];
}

void measureApproach(Contact& contact, const Bodies& bodies) {
    const Motion& a = bodies.motion[contact.key.bodyA];
    const Motion& b = bodies.motion[contact.key.bodyB];
    contact.approachSpeed = 0;
    for (int i = 0; i < contact.manifold.count; ++i) {
        const ManifoldPoint& p = contact.manifold.points[static_cast<std::size_t>(i)];
        const Vec2 relative = velocityAt(b, p.armB) - velocityAt(a, p.armA);
        contact.approachSpeed =
            std::max(contact.approachSpeed, -dot(contact.manifold.normal, relative));
    }
}

void forgetBlows(Contact& contact) {
    contact.struck = false;
    contact.total = 0;
    for (PointImpulse& impulse : contact.impulse) {
        impulse.impact = 0;
        impulse.largest = 0;
    }
}

void describeContact(Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    contact.a = bodies.idAt(bodyA);
    contact.b = bodies.idAt(bodyB);
    contact.sensor = ((bodies.filter[bodyA].flags | bodies.filter[bodyB].flags) & kSensor) != 0;
    contact.material =
        mix(bodies.parts[bodyA][partA].material, bodies.parts[bodyB][partB].material);
    contact.bounces = contact.material.restitution > 0;
}

bool isOutdated(Real drift, bool bounces, const Tolerances& tolerances) {
    return drift > (bounces ? kKeptToBounce : kKept) * tolerances.slop;
}

bool followContact(Contact& contact, const Bodies& bodies, const Tolerances& tolerances,
                   bool wentOn) {
    beginStep(contact);
    contact.near = true;
    contact.centerA = bodies.pose[contact.key.bodyA].position;
    if (wentOn) {
        contact.carried = !isOutdated(contact.drift, contact.bounces, tolerances);
        return contact.carried;
    }
    const bool known = addDrift(bodies, contact);
    contact.carried = known && carry(bodies, contact, tolerances);
    return contact.carried || (known && staysApart(contact, tolerances));
}

bool isSound(const Contact& contact) {
    const Manifold& manifold = contact.manifold;
    bool placed = isFinite(contact.centerA) && isFinite(manifold.normal);
    for (const ManifoldPoint& p : manifold.points) {
        placed = placed && isFinite(p.armA) && isFinite(p.armB) && std::isfinite(p.separation);
    }
    return placed && std::isfinite(contact.impulse[0].normal + contact.impulse[1].normal +
                                   contact.friction + contact.rolling + contact.total);
}

void clearContact(Contact& contact) {
    beginStep(contact);
    forgetBlows(contact);
    contact.approachSpeed = 0;
    contact.touching = false;
    contact.near = false;
    contact.manifold.count = 0;
    contact.manifold.points[0].separation = 0; // how far apart is not known
    contact.impulse = {};
    contact.friction = 0;
    contact.rolling = 0;
    contact.carried = false;
    contact.passing = false;
    contact.row = {}; // what its lane holds is to be forgotten, too
}

} // namespace kodo::inline KODO_PRECISION
