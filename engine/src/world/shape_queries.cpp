// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>

#include "collide/time_of_impact.hpp"
#include "world/query_checks.hpp"
#include "world/query_scope.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// A cast without its shape.
struct CastPath {
    Transform start;
    Vec2 displacement; // m
    Real angle;        // rad
    StartOverlap atStart;

    Transform at(Real fraction) const {
        return {start.position + fraction * displacement, turned(start.rotation, fraction * angle)};
    }
};

std::optional<CastHit> startHit(const CastPath& path, const ConvexShape& moving,
                                const ConvexShape& target, const Transform& pose, Real slop) {
    if (path.atStart == StartOverlap::Ignore || target.oneSided || moving.oneSided) {
        return std::nullopt;
    }
    CastHit hit{0, {}, distance(target, pose, moving, path.start).onA};
    if (path.atStart == StartOverlap::Normal) {
        const Manifold touch = collide(target, pose, moving, path.start, slop);
        hit.normal = touch.count > 0 ? touch.normal : Vec2{};
        if (dot(path.displacement, hit.normal) > 0) {
            return std::nullopt;
        }
    }
    return hit;
}

/// A shape that turns, apart from the target at the start.
std::optional<CastHit> turningHit(const CastPath& path, const ConvexShape& moving,
                                  const ConvexShape& target, const Transform& pose, Real near) {
    constexpr Real kMostAngle = Real(0.5); // rad of one search; each adapts to its direction
    constexpr int kMostSearches = 1000;
    const Real most = std::min(Real(1), kMostAngle / std::abs(path.angle));
    const MotionPath still{pose, {}};
    Real done = 0;
    for (int search = 0; search < kMostSearches && done < 1; ++search) {
        const Real share = std::min(most, 1 - done);
        const MotionPath part{path.at(done), share * path.displacement, share * path.angle};
        const Real time = timeOfImpact(moving, part, target, still, near);
        done += share * std::min(time, Real(1));
        if (time < 1) {
            const ClosestPoints gap = distance(target, pose, moving, path.at(done));
            if (gap.distance <= 2 * near) {
                return CastHit{done, gap.normal, gap.onA};
            }
        }
    }
    return std::nullopt;
}

std::optional<CastHit> hitOn(const CastPath& path, const ConvexShape& moving,
                             const ConvexShape& target, const Transform& pose, Real slop) {
    if (path.angle == 0 && path.atStart == StartOverlap::Report) {
        return shapeCast(moving, path.start, path.displacement, target, pose);
    }
    const Real gap = distance(target, pose, moving, path.start).distance;
    if (gap <= (path.angle == 0 ? 0 : slop / 512)) {
        return startHit(path, moving, target, pose, slop);
    }
    if (path.angle == 0) {
        return shapeCast(moving, path.start, path.displacement, target, pose);
    }
    return turningHit(path, moving, target, pose, std::min(slop / 8, gap / 2));
}

/// Moves the point of a hit on a flat contact to its middle. Either end of it touches, and the end
/// that is found would depend on the direction.
void toMiddle(QueryHit& hit, const Manifold& touch, const Transform& pose) {
    if (touch.count == 2 && dot(touch.normal, hit.normal) > Real(0.999)) {
        hit.point = pose.position + Real(0.5) * (touch.points[0].armA + touch.points[1].armA);
    }
}

std::optional<QueryHit> firstHit(const World& world, std::span<const ConvexShape> convexes,
                                 const CastPath& cast, CollisionFilter which,
                                 std::span<const BodyId> except) {
    std::optional<QueryHit> best;
    const QueryScope scope(world, which, except);
    const Real slop = world.tolerances().slop;
    for (const ConvexShape& convex : convexes) {
        Aabb box = boundsOf(convex, cast.start);
        if (cast.angle != 0 && !convex.isPlane()) {
            box =
                Aabb{cast.start.position, cast.start.position}.grown(convex.boundingRadius + slop);
        }
        const PathEntry path(box.center(), box.center() + cast.displacement,
                             Real(0.5) * box.extent());
        scope.forParts([&](const Aabb& other) { return path(other, limitOf(best)); },
                       [&](std::uint32_t body, std::uint32_t part) {
                           const Transform& pose = scope.pose(body);
                           const ConvexShape& target = scope.convex(body, part);
                           const auto hit = hitOn(cast, convex, target, pose, slop);
                           if (hit &&
                               keepFirst(best, {scope.idOf(body), static_cast<std::uint16_t>(part),
                                                hit->fraction, hit->point, hit->normal})) {
                               const Transform at = cast.at(hit->fraction);
                               toMiddle(*best, collide(target, pose, convex, at, slop / 16), pose);
                           }
                       });
    }
    return best;
}

/// m; a lower bound of the distance of two boxes.
Real gapOf(const Aabb& a, const Aabb& b) {
    return length(Vec2{std::max({a.lower.x - b.upper.x, b.lower.x - a.upper.x, Real(0)}),
                       std::max({a.lower.y - b.upper.y, b.lower.y - a.upper.y, Real(0)})});
}

} // namespace

std::optional<QueryHit> shapeCast(const World& world, const Shape& shape, const Transform& start,
                                  Vec2 displacement, CollisionFilter which,
                                  std::span<const BodyId> except) {
    const std::vector<ConvexShape> convexes = requireShape(world, shape, "start", start);
    requireDisplacement(world, convexes, start, displacement);
    return firstHit(world, convexes, {start, displacement, 0, StartOverlap::Report}, which, except);
}

std::optional<QueryHit> shapeCast(const World& world, const ShapeCast& cast, CollisionFilter which,
                                  std::span<const BodyId> except) {
    const std::vector<ConvexShape> convexes = requireShape(world, cast.shape, "start", cast.start);
    requireDisplacement(world, convexes, cast.start, cast.displacement);
    refuse(checkRange("angle", cast.angle, -kMaxCastAngle, kMaxCastAngle, "rad"));
    return firstHit(world, convexes, {cast.start, cast.displacement, cast.angle, cast.atStart},
                    which, except);
}

std::vector<QueryContact> collide(const World& world, const Shape& shape, const Transform& at,
                                  Real margin, CollisionFilter which,
                                  std::span<const BodyId> except) {
    std::vector<QueryContact> found;
    const std::vector<ConvexShape> convexes = requireShape(world, shape, "at", at);
    refuse(checkNotNegative("margin", margin, "m"));
    const QueryScope scope(world, which, except);
    for (const ConvexShape& convex : convexes) {
        const Aabb box = withRounding(boundsOf(convex, at).grown(margin));
        scope.forPartsIn(box, [&](std::uint32_t body, std::uint32_t part) {
            const Transform& pose = scope.pose(body);
            const Manifold touch = collide(scope.convex(body, part), pose, convex, at, margin);
            if (touch.count > 0) {
                const ManifoldPoint& point = touch.points[0];
                found.push_back({scope.idOf(body), static_cast<std::uint16_t>(part),
                                 pose.position + point.armA, touch.normal, point.separation});
            }
        });
    }
    std::sort(found.begin(), found.end(), // total order: two of one part are swapped if equal
              [](const QueryContact& a, const QueryContact& b) {
                  return std::tie(a.body, a.part, a.separation, a.point.x, a.point.y) <
                         std::tie(b.body, b.part, b.separation, b.point.x, b.point.y);
              });
    const auto isOfSamePart = [](const QueryContact& a, const QueryContact& b) {
        return a.body == b.body && a.part == b.part;
    };
    found.erase(std::unique(found.begin(), found.end(), isOfSamePart), found.end());
    return found;
}

QueryPoint closestPoint(const BodyView& body, Vec2 point) {
    refuse(checkFinite("point", point));
    const Transform& pose = body.massFrame();
    std::optional<QueryPoint> best;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const ConvexShape& convex = body.part(i).convex;
        if (best && gapOf(boundsOf(convex, pose), {point, point}) > best->distance) {
            continue;
        }
        const ClosestPoints near = distance(convex, pose, point);
        if (!best || near.distance < best->distance) {
            best = {body.id(), static_cast<std::uint16_t>(i), near.onA, near.normal, near.distance};
        }
    }
    return *best;
}

ClosestPoints distance(const BodyView& a, const BodyView& b) {
    std::optional<ClosestPoints> best;
    for (std::size_t i = 0; i < a.partCount(); ++i) {
        const ConvexShape& convexA = a.part(i).convex;
        const Aabb box = boundsOf(convexA, a.massFrame());
        for (std::size_t k = 0; k < b.partCount(); ++k) {
            const ConvexShape& convexB = b.part(k).convex;
            if (best && gapOf(box, boundsOf(convexB, b.massFrame())) > best->distance) {
                continue;
            }
            const ClosestPoints near = distance(convexA, a.massFrame(), convexB, b.massFrame());
            best = !best || near.distance < best->distance ? near : *best;
        }
    }
    return *best;
}

std::vector<BodyId> touching(const World& world, BodyId id) {
    const WorldImpl& impl = world.impl();
    requireAlive(impl.bodyData(), id);
    std::vector<BodyId> found;
    const auto keep = [&](const Contact& contact) {
        const std::uint32_t a = contact.key.bodyA;
        const std::uint32_t b = contact.key.bodyB;
        if (contact.wasTouching && (a == id.index || b == id.index)) {
            found.push_back(impl.bodyData().idAt(a == id.index ? b : a));
        }
    };
    const ContactStore& store = impl.contacts_.store();
    store.lists().forEach(id.index, [&](std::uint32_t slot) { keep(store.contacts()[slot]); });
    impl.sleep_.forEachContactNear(impl.bodyData(), id.index, keep);
    impl.region_.parked().forEach(keep);
    sortUnique(found);
    return found;
}

} // namespace KODO_PRECISION
} // namespace kodo
