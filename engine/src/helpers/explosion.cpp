// SPDX-License-Identifier: MIT
#include <kodo/explosion.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr int kRays = 32;                           // for each body
constexpr Real kHalfTurn = Real(3.141592653589793); // rad
constexpr CollisionFilter kSolid{.flags = kNoSensors};

void require(const Explosion& explosion) {
    const auto refuse = [](const char* field, const char* reason, Real value) {
        throw BadDefinition({field, reason + std::to_string(value)});
    };
    if (!(explosion.radius > 0 && explosion.radius <= kMaxCoordinate)) {
        refuse("radius", "must be greater than 0 and at most kMaxCoordinate, but is ",
               explosion.radius);
    }
    if (!(explosion.falloff >= 0 && explosion.falloff <= kMaxCoordinate)) {
        refuse("falloff", "must be at least 0 and at most kMaxCoordinate, but is ",
               explosion.falloff);
    }
    if (!(std::abs(explosion.impulse) <= kMaxMass)) { // also for NaN
        refuse("impulse", "must be at most kMaxMass in size, but is ", explosion.impulse);
    }
}

/// The angles (rad) that a body fills, seen from a point outside of it.
struct Sight {
    Vec2 middle;    // unit; direction of angle 0
    Real least = 4; // rad
    Real most = -4; // rad

    Sight(const BodyView& body, Vec2 from) : middle(normalize(body.bounds().center() - from)) {
        if (middle == Vec2{}) {
            middle = {1, 0};
        }
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            const ConvexShape& convex = body.part(i).convex;
            if ((body.filter(i).flags & kSensor) != 0) {
                continue;
            }
            for (const Vec2 vertex : convex.vertices) {
                const Vec2 way = body.massFrame() * vertex - from;
                const Real clear =
                    (std::max)(lengthSquared(way) - convex.radius * convex.radius, Real(0));
                const Real half = atan2(convex.radius, std::sqrt(clear));
                const Real angle = atan2(cross(middle, way), dot(middle, way));
                least = (std::min)(least, angle - half);
                most = (std::max)(most, angle + half);
            }
        }
        if (most - least > kHalfTurn) { // around the point
            middle = {1, 0};
            least = -kHalfTurn;
            most = kHalfTurn;
        }
    }
};

Real strength(const Explosion& explosion, Real distance) {
    const Real beyond = distance - explosion.radius;
    return beyond <= 0 ? 1 : beyond < explosion.falloff ? 1 - beyond / explosion.falloff : 0;
}

/// Pushes one body.
ExplosionHit push(const Explosion& explosion, World& world, BodyId id,
                  std::span<const BodyId> except) {
    BodyRef body = world[id];
    const Sight sight(body, explosion.center);
    const Real reach = explosion.radius + explosion.falloff;
    const Real between = (sight.most - sight.least) / kRays; // rad
    ExplosionHit hit{id, {}, {}, 0};
    Real angular = 0;     // N m s
    Real closest = reach; // m
    for (int i = 0; i < kRays; ++i) {
        const Real angle = sight.least + (static_cast<Real>(i) + Real(0.5)) * between;
        const Vec2 direction = Rot::fromAngle(angle) * sight.middle;
        const Vec2 from = explosion.center;
        const auto first = rayCast(world, from, from + reach * direction, kSolid, except);
        if (!first || first->body != id) {
            continue;
        }
        const Real distance = length(first->point - from);
        const Real width = distance * between;
        const Vec2 impulse = strength(explosion, distance) * explosion.impulse * width * direction;
        hit.impulse += impulse;
        hit.width += width;
        angular += cross(first->point - body.center(), impulse);
        if (distance <= closest) {
            closest = distance;
            hit.point = first->point;
        }
    }
    if (hit.width > 0) {
        body.applyImpulse(hit.impulse);
        body.applyAngularImpulse(angular);
    }
    return hit;
}

} // namespace

std::vector<ExplosionHit> explode(World& world, const Explosion& explosion) {
    require(explosion);
    const Circle disc{explosion.radius + explosion.falloff, {}};
    const Transform at{explosion.center, {}};
    const std::vector<BodyId> except = overlap(world, Point{}, at, kSolid); // no cover
    CollisionFilter which = explosion.which;
    which.flags |= kNoSensors;
    std::vector<ExplosionHit> hits;
    for (const BodyId id : overlap(world, disc, at, which, except)) {
        if (world[id].type() == BodyType::Dynamic) {
            const ExplosionHit hit = push(explosion, world, id, except);
            if (hit.width > 0) {
                hits.push_back(hit);
            }
        }
    }
    return hits;
}

} // namespace KODO_PRECISION
} // namespace kodo
