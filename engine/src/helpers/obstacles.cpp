// SPDX-License-Identifier: MIT
#include "helpers/obstacles.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

Obstacles::Obstacles(const World& world, const Mover& mover)
    : world_(world),
      mover_(mover),
      limit_(Rot::fromAngle(mover.slopeLimit)),
      convex_(convexShapeOf(mover.shape, {})),
      cast_{.shape = shapeOf(mover.shape),
            .start = {mover.position, {}},
            .atStart = StartOverlap::Normal},
      which_{mover.which.flags | kNoSensors, mover.which.required, mover.which.group},
      except_{mover.body} {}

void Obstacles::findNear(Real reach) {
    isAlone_ =
        overlap(world_, boundsOf(convex_, cast_.start).grown(reach), which_, except_).empty();
}

std::optional<QueryHit> Obstacles::cast(Vec2 way) {
    if (isAlone_ || way == Vec2{}) {
        return std::nullopt;
    }
    cast_.displacement = way;
    auto hit = shapeCast(world_, cast_, which_, except_);
    if (hit && hit->normal == Vec2{}) {
        hit->normal = -normalize(way);
    }
    return hit;
}

std::optional<QueryHit> Obstacles::advance(Vec2 way, Real& moved) {
    const Real most = length(way);
    moved = 0;
    if (!(most > 0)) {
        return std::nullopt;
    }
    const Vec2 direction = way / most;
    const Real reach = most + 2 * mover_.skin;
    const auto hit = cast(reach * direction);
    moved = most;
    if (hit) {
        const Real closing = (std::max)(-dot(direction, hit->normal), kLeastClosing);
        moved = (std::max)(reach * hit->fraction - mover_.skin / closing, Real(0));
    }
    if (moved >= most) {
        moved = most;
        setAt(at() + way);
        return std::nullopt;
    }
    setAt(at() + moved * direction);
    return hit;
}

std::vector<QueryContact> Obstacles::touches(Real margin) const {
    return isAlone_ ? std::vector<QueryContact>{}
                    : collide(world_, cast_.shape, cast_.start, margin, which_, except_);
}

std::optional<Vec2> Obstacles::groundOf(const QueryHit& hit) const {
    const Real lift = dot(hit.normal, mover_.up);
    if (isFlat(hit.normal)) {
        return hit.normal;
    }
    if (lift < kLeastClosing) {
        return std::nullopt;
    }
    const Vec2 beside = hit.point - mover_.skin * normalize(hit.normal - lift * mover_.up);
    const Vec2 above = 2 * mover_.skin * mover_.up;
    const auto below = rayCast(world_, beside + above, beside - above, which_, except_);
    const bool isGround = below && below->body == hit.body && isFlat(below->normal);
    return isGround ? std::optional(below->normal) : std::nullopt;
}

Real Obstacles::lowest() const {
    const Rot upright{mover_.up.y, mover_.up.x}; // takes `up` to {0, 1}
    return boundsOf(convex_, {{}, upright}).lower.y;
}

} // namespace KODO_PRECISION
} // namespace kodo
