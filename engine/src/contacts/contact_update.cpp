// SPDX-License-Identifier: MIT
#include "contacts/contact_update.hpp"

#include <kodo/geometry.hpp>

#include "bodies/part_filter.hpp"
#include "collide/one_sided.hpp"
#include "collide/time_of_impact.hpp"
#include "contacts/line_side.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// A point with other features matches an old point if all three hold:
constexpr Real kSamePlace = 16;         // slops, largest distance
constexpr Real kSameShare = Real(0.5);  // of the core radius of the thinner part, largest distance
constexpr Real kSameNormal = Real(0.9); // least cosine between the normals
constexpr int kNoPoint = 2;

/// Distance of two points (m), measured on the body where it is smaller.
Real distanceOf(const ManifoldPoint& p, const ManifoldPoint& q) {
    return std::min(length(p.armA - q.armA), length(p.armB - q.armB));
}

/// Index of the old point with the same feature, for each new point.
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

/// Matches the remaining points by distance, nearest first. The reference face of two parallel
/// faces may change, which gives the same points other features. Overlaps deeper than `near` (m)
/// are excluded: there a new feature may mean another direction of least overlap. A segment has
/// core radius 0 and matches by feature alone.
void matchPlaces(const Manifold& manifold, const Manifold& old, Real near,
                 std::array<int, 2>& former) {
    // The overlap after the step decides, not that before it.
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
                    continue; // already matched, mostly by feature
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

/// Replaces the manifold. Matched points within `near` (m) take over the impulses of the old ones.
/// Sums of the step, which a record tells, stay with the pair.
void replaceManifold(Contact& contact, const ContactLane& lane, const Manifold& manifold,
                     Real near) {
    const Manifold& old = contact.manifold;
    lane.setSeparations(manifold);
    std::array<int, 2> former = matchFeatures(manifold, old);
    matchPlaces(manifold, old, near, former);
    const auto carry = [&](Real& first, Real& second) {
        const Real before[] = {first, second, 0};
        first = before[former[0]];
        second = before[former[1]];
        return before[0] + before[1] - (first + second); // of points that are gone
    };
    carry(lane.impulse(0), lane.impulse(1));
    lane.impact(0) += std::max(carry(lane.impact(0), lane.impact(1)), Real(0));
    lane.largest(0) = std::max(lane.largest(0), carry(lane.largest(0), lane.largest(1)));
    contact.manifold = manifold;
    if (manifold.count == 0) {
        lane.stopSliding();
        lane.friction() = lane.rolling() = 0;
    }
}

// Slops of relative displacement up to which the manifold of two shapes thinner than the slop is
// kept: a point that was beyond the margin must be found before it has passed to the other side.
// And of lines: a point must not pass their ends.
constexpr Real kKeptIfThin = 1;
// Slops of distance at which the paths of two bodies count as touching. Positions in float resolve
// it up to 128 m from the origin.
constexpr Real kTouches = Real(1) / 256;

/// True for a contact of one point that is not at an arc.
bool onOneCorner(const Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    return contact.manifold.count == 1 && !bodies.convex(bodyA, partA).isRound() &&
           !bodies.convex(bodyB, partB).isRound();
}

/// Relative displacement (m) up to which a manifold of one corner is kept: a quarter of the shorter
/// lever. That of a body near its balance changes by more than itself within a slop.
Real keptOnCorner(const Contact& contact, const Bodies& bodies, Real slop) {
    const ManifoldPoint& p = contact.manifold.points[0];
    const auto leverIfFree = [&](std::uint32_t body, Vec2 arm) {
        return bodies.motion[body].invInertia > 0 ? std::abs(leverOf(arm, contact.manifold.normal))
                                                  : std::numeric_limits<Real>::max();
    };
    const Real lever =
        std::min(leverIfFree(contact.key.bodyA, p.armA), leverIfFree(contact.key.bodyB, p.armB));
    return std::min(lever / 4, kKeptWay * slop);
}

/// Adds the relative displacement of the last step.
void addDisplacement(const Bodies& bodies, const Contact& contact, const ContactLane& lane) {
    const std::uint32_t a = contact.key.bodyA;
    const std::uint32_t b = contact.key.bodyB;
    const BodyVelocity& motionA = bodies.motion[a];
    const BodyVelocity& motionB = bodies.motion[b];
    const Vec2 between = motionB.deltaPosition - motionA.deltaPosition;
    lane.relativeDisplacement() += std::abs(between.x) + std::abs(between.y) +
                                   std::abs(motionA.deltaAngle) * bodies.extent[a].rotationReach +
                                   std::abs(motionB.deltaAngle) * bodies.extent[b].rotationReach;
}

/// True if two separated parts have not moved far enough to be within the margin.
bool staysApart(const Contact& contact, const ContactLane& lane, const Tolerances& tolerances) {
    const Manifold& manifold = contact.manifold;
    return manifold.count == 0 &&
           lane.relativeDisplacement() < manifold.points[0].separation - tolerances.margin;
}

/// Updates the separations of a manifold, to first order in the rotation. The manifold is kept
/// while the relative displacement of its bodies is small. A circle that rotates about its centre
/// has no lever, so its rotation changes no separation. In a pile this saves most collision tests,
/// also while the pile moves as a whole, and fixed contact points stabilise it. Measures the
/// approach speed with the same levers. advanceLanes() does the same for contacts in the passes.
void advanceContact(const Bodies& bodies, const Contact& contact, const ContactLane& lane) {
    addDisplacement(bodies, contact, lane);
    const BodyVelocity& motionA = bodies.motion[contact.key.bodyA];
    const BodyVelocity& motionB = bodies.motion[contact.key.bodyB];
    const Vec2 n = contact.manifold.normal;
    const Real moved = dot(n, motionB.deltaPosition - motionA.deltaPosition);
    const Real speed = dot(n, motionB.velocity - motionA.velocity);
    lane.approachSpeed() = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        const ManifoldPoint& p = contact.manifold.points[i];
        const Real leverA = leverOf(p.armA, n);
        const Real leverB = leverOf(p.armB, n);
        lane.separation(i) += moved + (leverB * motionB.deltaAngle - leverA * motionA.deltaAngle);
        const Real apart =
            speed + (leverB * motionB.angularVelocity - leverA * motionA.angularVelocity);
        lane.approachSpeed() = std::max(lane.approachSpeed(), -apart);
    }
}

/// Gives concentric circles a normal of their own. They have none, and several circles on one point
/// would all separate along one line. The normal is rotated by a multiple of the golden angle, by
/// the crowdRank of the second body. Circles are concentric, up to rounding, if the overlap equals
/// the sum of the radii.
void spreadConcentric(Manifold& manifold, const Bodies& bodies, const ContactKey& key) {
    const ConvexShape& a = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& b = bodies.convex(key.bodyB, key.partB);
    ManifoldPoint& point = manifold.points[0];
    if (!a.isRound() || !b.isRound() || manifold.count == 0 ||
        point.separation != -(a.radius + b.radius)) {
        return;
    }
    constexpr Real kGoldenAngle = Real(2.39996323); // rad
    constexpr std::uint32_t kSides = 32; // angles up to 77 rad: sines are exact up to 100
    const std::uint32_t rank = bodies.record[key.bodyB].crowdRank;
    const Vec2 normal =
        Rot::fromAngle(kGoldenAngle * static_cast<Real>(rank % kSides)) * manifold.normal;
    const Vec2 shift = (a.radius + point.separation / 2) * (normal - manifold.normal);
    manifold.normal = normal;
    point.armA += shift;
    point.armB += shift;
}

/// Displacement (m) of the second body under which the manifold of two bodies on one point is
/// found; 0 for others. There, all directions of separation are equally good, and bodies that all
/// take the same would build a tower. So each gets a place of its own, within two slops, by its
/// crowdRank: fractions of multiples of the powers of the plastic number, which fill a square
/// evenly.
Vec2 spreadOf(const Bodies& bodies, const ContactKey& key, Real slop) {
    const Vec2 between = bodies.pose[key.bodyB].position - bodies.pose[key.bodyA].position;
    if (lengthSquared(between) > slop * slop || bodies.locked(key.bodyA) ||
        bodies.locked(key.bodyB)) {
        return {};
    }
    const auto fraction = [](std::uint32_t rank, std::uint32_t factor) {
        return static_cast<Real>(static_cast<std::int32_t>((rank * factor) >> 8)) / (1 << 24);
    };
    const std::uint32_t rankA = bodies.record[key.bodyA].crowdRank;
    const std::uint32_t rankB = bodies.record[key.bodyB].crowdRank;
    constexpr std::uint32_t kFirst = 3242174889;  // 2^32 / 1.3247
    constexpr std::uint32_t kSecond = 2447445414; // 2^32 / 1.3247^2
    return 2 * slop *
           Vec2{fraction(rankB, kFirst) - fraction(rankA, kFirst),
                fraction(rankB, kSecond) - fraction(rankA, kSecond)};
}

/// Resets the fields that belong to one step.
void beginStep(Contact& contact, const ContactLane& lane) {
    contact.hidden = false;
    if (contact.sensor) {
        contact.touching = false;
    }
    lane.clearStep();
}

/// Largest approach speed (m/s) of the points of a manifold; at least 0.
Real approachOf(const Manifold& manifold, const BodyVelocity& a, const BodyVelocity& b) {
    Real most = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint& p = manifold.points[static_cast<std::size_t>(i)];
        const Vec2 relative = velocityAt(b, p.armB) - velocityAt(a, p.armA);
        most = std::max(most, -dot(manifold.normal, relative));
    }
    return most;
}

/// Distance (m) along one-sided lines within which the pair may come in this step.
Real reachOf(const Bodies& bodies, const ContactKey& key, Real dt) {
    constexpr Real kMore = Real(1.25); // the pair may accelerate
    return kMore * dt *
           length(bodies.motion[key.bodyB].velocity - bodies.motion[key.bodyA].velocity);
}

} // namespace

void findContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                 const Tolerances& tolerances, Real dt) {
    lane.updateSeparations(contact.manifold); // how deep the side of a line is kept
    const ContactKey& key = contact.key;
    // m; keeps the reference face of parallel faces constant despite rounding.
    const Real preference = tolerances.slop / 8;
    const Vec2 spread = spreadOf(bodies, key, tolerances.slop);
    const Transform& poseB = bodies.pose[key.bodyB];
    const ContactLimits limits{tolerances.margin, preference, reachOf(bodies, key, dt)};
    const std::optional<JointedLine> line = jointedLineOf(bodies, key);
    Manifold manifold;
    if (line && spread == Vec2{}) {
        const JointedSide side = jointedSideOf(bodies, contact, *line, tolerances.margin);
        manifold = collideOnSide(bodies, key, *line, side, limits);
        contact.side = static_cast<std::int8_t>(side.side);
    } else {
        manifold = collideAhead(bodies.convex(key.bodyA, key.partA), bodies.pose[key.bodyA],
                                bodies.convex(key.bodyB, key.partB),
                                {poseB.position + spread, poseB.rotation}, limits);
    }
    if (spread != Vec2{}) {
        for (ManifoldPoint& point : manifold.points) {
            point.armB += spread;
            point.separation -= dot(manifold.normal, spread);
        }
    }
    spreadConcentric(manifold, bodies, key);
    contact.passing = letPass(contact.passing, manifold);
    const auto [thinner, thicker] = std::minmax(bodies.convex(key.bodyA, key.partA).coreRadius,
                                                bodies.convex(key.bodyB, key.partB).coreRadius);
    removePassingPoints(manifold, contact, bodies, tolerances, dt);
    const bool passes = removePassing(manifold, contact, bodies, {bodies.pose[key.bodyA], poseB},
                                      tolerances.slop, dt);
    replaceManifold(contact, lane, manifold,
                    std::min(kSamePlace * tolerances.slop, kSameShare * thinner));
    const bool ofLine = bodies.convex(key.bodyA, key.partA).isLine() ||
                        bodies.convex(key.bodyB, key.partB).isLine();
    const Real kept = thicker < tolerances.slop || ofLine ? kKeptIfThin * tolerances.slop
                      : onOneCorner(contact, bodies)
                          ? keptOnCorner(contact, bodies, tolerances.slop)
                          : kKeptWay * tolerances.slop;
    lane.relativeDisplacement() = kKeptWay * tolerances.slop - kept;
    if (passes) {
        lane.expire();
    }
    contact.teleportCounts[0] = bodies.teleportCount[key.bodyA];
    contact.teleportCounts[1] = bodies.teleportCount[key.bodyB];
}

bool mayGainPoint(const Bodies& bodies, const Contact& contact) {
    return contact.manifold.count == 0 || onOneCorner(contact, bodies);
}

void measureApproach(const Contact& contact, const ContactLane& lane, const Bodies& bodies) {
    lane.approachSpeed() = approachOf(contact.manifold, bodies.motion[contact.key.bodyA],
                                      bodies.motion[contact.key.bodyB]);
}

void describeContact(Contact& contact, const Bodies& bodies) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    contact.a = bodies.idAt(bodyA);
    contact.b = bodies.idAt(bodyB);
    const Flags flags = filterOf(bodies, bodyA, partA).flags | filterOf(bodies, bodyB, partB).flags;
    contact.sensor = (flags & kSensor) != 0;
    contact.material =
        mix(bodies.parts[bodyA][partA].material, bodies.parts[bodyB][partB].material);
    contact.bounces = contact.material.restitution > 0;
}

bool removePassing(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                   const std::array<Transform, 2>& poses, Real slop, Real dt) {
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const ConvexShape& shapeA = bodies.convex(bodyA, partA);
    const ConvexShape& shapeB = bodies.convex(bodyB, partB);
    const BodyVelocity& a = bodies.motion[bodyA];
    const BodyVelocity& b = bodies.motion[bodyB];
    const Real gap = leastOf(separationsOf(manifold), manifold.count);
    const Real speed = approachOf(manifold, a, b);
    // A line has no interior: its contact alone keeps a body on its side.
    if (contact.sensor || shapeA.isLine() || shapeB.isLine() || !arrives(gap, speed, slop, dt)) {
        return false;
    }
    // On a parabola s - v t + c t^2, a touch comes by 2 s / v if at all.
    const Real time = std::max(kActs * dt, gap > slop ? Real(0) : 2 * gap / speed);
    const auto pathOf = [&](const Transform& pose, const BodyVelocity& motion) {
        return MotionPath{pose, time * motion.velocity, time * motion.angularVelocity};
    };
    const MotionPath pathA = pathOf(poses[0], a);
    const MotionPath pathB = pathOf(poses[1], b);
    const Real target = kTouches * slop;
    if (separation(shapeA, pathA.at(1), shapeB, pathB.at(1)).distance > target && // cheaper
        timeOfImpact(shapeA, pathA, shapeB, pathB, target) >= 1) {
        manifold = apart(gap);
        return true;
    }
    return false;
}

bool isKnown(const Bodies& bodies, const Contact& contact) {
    return contact.teleportCounts[0] == bodies.teleportCount[contact.key.bodyA] &&
           contact.teleportCounts[1] == bodies.teleportCount[contact.key.bodyB];
}

bool followContact(Contact& contact, const ContactLane& lane, const Bodies& bodies,
                   const Tolerances& tolerances, Real dt, bool inPasses) {
    beginStep(contact, lane);
    contact.near = true;
    contact.centerA = bodies.pose[contact.key.bodyA].position;
    if (!inPasses) {
        advanceContact(bodies, contact, lane);
    }
    const bool known = isKnown(bodies, contact);
    contact.filled =
        contact.filled && known &&
        !isOutdated(lane.relativeDisplacement(),
                    contact.bounces || arrives(leastOf({lane.separation(0), lane.separation(1)},
                                                       contact.manifold.count),
                                               lane.approachSpeed(), tolerances.slop, dt),
                    tolerances);
    return contact.filled || (known && staysApart(contact, lane, tolerances));
}

void clearContact(Contact& contact, const ContactLane& lane) {
    beginStep(contact, lane);
    lane.approachSpeed() = 0;
    lane.separation(0) = 0;
    lane.clearImpulses();
    lane.stopSliding();
    contact.touching = false;
    contact.near = false;
    contact.manifold.count = 0;
    contact.manifold.points[0].separation = 0; // unknown
    contact.filled = false;
    contact.passing = false;
}

} // namespace KODO_PRECISION
} // namespace kodo
