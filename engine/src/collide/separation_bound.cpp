// SPDX-License-Identifier: MIT
#include "collide/separation_bound.hpp"

#include <kodo/geometry.hpp>

#include "math/lanes.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Corners of a shape; entries beyond their number are undefined.
struct Corners {
    alignas(kLaneBytes) std::array<Real, ConvexShape::kFew> x;
    alignas(kLaneBytes) std::array<Real, ConvexShape::kFew> y;

    void put(std::size_t first, const Couple& corners) {
        store(&x[first], corners.x);
        store(&y[first], corners.y);
    }
};

/// Corners of a shape B and their motion, in the rotating frame of shape A.
struct View {
    explicit View(const ConvexShape& convex)
        : count(convex.vertices.size()), radius(convex.radius) {}

    std::size_t count; // number of corners
    Real radius;       // m, around each corner
    Corners now;
    Corners then; // at the end of the path, if each moves straight
    Real bend;    // m, upper bound of the deviation from these straight lines
    Vec2 towards; // m per step: velocity of A relative to B
};

Real sumOf(Vec2 v) { // at least the length of v
    return std::abs(v.x) + std::abs(v.y);
}

/// B in the frame of A along their path. A rotates by a and B by b per step. Let r be a corner of B
/// relative to the centre of B, which is at d and moves by u. The corner is at
///
///   q(t) = R(-a t) (d + u t) + R((b - a) t) r,   q'(0) = u - a x d + (b - a) x r,
///   |q''| <= a^2 |d + u t| + 2 |a| |u| + (b - a)^2 |r|,
///
/// so at time t it deviates from its initial tangent by at most half of that times t^2.
KODO_LANES_INLINE View viewOf(const Transform& a, const ConvexShape& shapeB, const Transform& b,
                              const RelativePath& path) {
    const Transform ab = between(a, b);
    const Real turn = path.deltaAngleA;
    const Real other = path.deltaAngleB;
    const Real length = path.length;
    View view(shapeB);
    view.towards = unrotate(a.rotation, path.towards);
    const auto [c, s] = ab.rotation;
    for (std::size_t i = 0; i < view.count; i += kLanes) {
        const Couple corner = loadPairs(&shapeB.vertices[i].x);
        const Couple arm{all(c) * corner.x - all(s) * corner.y,
                         all(s) * corner.x + all(c) * corner.y};
        const Couple seen{arm.x + all(ab.position.x), arm.y + all(ab.position.y)};
        const Couple speed{all(turn) * seen.y - all(other) * arm.y - all(view.towards.x),
                           all(other) * arm.x - all(turn) * seen.x - all(view.towards.y)};
        view.now.put(i, seen);
        view.then.put(i, {seen.x + all(length) * speed.x, seen.y + all(length) * speed.y});
    }
    const Real way = sumOf(view.towards);
    const Real turned = std::abs(turn);
    const Real strength = turned * (turned * (sumOf(ab.position) + way * length) + 2 * way) +
                          (other - turn) * (other - turn) * shapeB.rotationReach();
    view.bend = strength * length * length / 2;
    return view;
}

/// SeparationBound in lanes.
struct SeparationBoundLanes {
    Lanes distance = all(-std::numeric_limits<Real>::infinity());
    Lanes last = {};
    Lanes first = all(RelativePath::kNever);

    SeparationBound best() const {
        SeparationBound separationBound;
        for (int i = 0; i < kLanes; ++i) {
            separationBound.distance = std::max(separationBound.distance, distance[i]);
            separationBound.last = std::max(separationBound.last, last[i]);
            separationBound.first = std::min(separationBound.first, first[i]);
        }
        return separationBound;
    }
};

/// Lowest projection of all corners on each axis.
KODO_LANES_INLINE Lanes lowest(const Couple& axis, const Corners& corners, std::size_t count) {
    Lanes least = all(std::numeric_limits<Real>::infinity());
    for (std::size_t i = 0; i < count; ++i) {
        least = smaller(axis.x * all(corners.x[i]) + axis.y * all(corners.y[i]), least);
    }
    return least;
}

/// Bounds for kLanes faces at a time, each rotating with its shape. The lowest projection of
/// corners that move straight is concave in time. It is at least the chord of f between now and the
/// end L of the path:
///
///   height(s L) >= (1 - s) f(0) + s (f(L) - bend),   0 <= s <= 1,   since s^2 <= s.
///
/// The bound of a fixed axis holds as well, see SeparationBound::see(). True if a face separates
/// the shapes over the whole path.
KODO_LANES_INLINE bool seeFaces(SeparationBoundLanes& separationBound, const ConvexShape& a,
                                const View& view, const RelativePath& path) {
    constexpr Real kNone = -std::numeric_limits<Real>::infinity();
    const std::size_t faces = a.normals.size();
    Lanes number;
    for (int i = 0; i < kLanes; ++i) {
        number[i] = static_cast<Real>(i);
    }
    for (std::size_t at = 0; at < faces; at += kLanes) {
        const Couple normal = loadPairs(&a.normals[at].x);
        const Couple on = loadPairs(&a.vertices[at].x);
        const Lanes surface = normal.x * on.x + normal.y * on.y + all(view.radius + a.radius);
        const Lanes above = lowest(normal, view.now, view.count) - surface;
        const Lanes after = lowest(normal, view.then, view.count) - surface - all(view.bend);
        const Lanes closing =
            normal.x * all(view.towards.x) + normal.y * all(view.towards.y) + all(path.turning);
        const auto isFace = number < all(static_cast<Real>(faces - at));
        const Lanes distance = isFace ? above : all(kNone);
        const Lanes least = isFace ? larger(after, above - closing * all(path.length)) : distance;
        const Lanes now = distance - all(path.target);
        const Lanes then = least - all(path.target);
        const Lanes crossing = all(path.length) * (now / (now - then));
        const Lanes until = then > Lanes{} ? all(path.length) : crossing;
        const auto comes = (now <= Lanes{}) & (then > Lanes{});
        separationBound.distance = larger(distance, separationBound.distance);
        separationBound.last = larger(now > Lanes{} ? until : Lanes{}, separationBound.last);
        separationBound.first =
            smaller(comes ? crossing : all(RelativePath::kNever), separationBound.first);
    }
    bool apart = false;
    for (int i = 0; i < kLanes; ++i) {
        apart |= separationBound.last[i] >= path.length;
    }
    return apart;
}

bool hasFaces(const ConvexShape& shape) {
    return !shape.isRound();
}

/// True if a shape has no more corners than View stores.
bool isFew(const ConvexShape& shape) {
    return shape.vertices.size() <= ConvexShape::kFew;
}

/// The path with A and B swapped.
RelativePath reversed(RelativePath path) {
    path.towards = -path.towards;
    std::swap(path.deltaAngleA, path.deltaAngleB);
    return path;
}

} // namespace

SeparationBound separationBoundOf(const ConvexShape& shapeA, const Transform& a,
                                  const ConvexShape& shapeB, const Transform& b,
                                  const RelativePath& path) {
    SeparationBoundLanes aside;
    if (isFew(shapeA) && isFew(shapeB)) {
        if (hasFaces(shapeA) && !shapeB.isPlane() &&
            seeFaces(aside, shapeA, viewOf(a, shapeB, b, path), path)) {
            return aside.best();
        }
        if (hasFaces(shapeB) && !shapeA.isPlane() &&
            seeFaces(aside, shapeB, viewOf(b, shapeA, a, reversed(path)), path)) {
            return aside.best();
        }
        if (shapeA.kind == ConvexKind::Polygonal && shapeB.kind == ConvexKind::Polygonal &&
            shapeA.radius + shapeB.radius == 0) {
            return aside.best();
        }
    }
    SeparationBound separationBound = aside.best();
    const Separation best = separation(shapeA, a, shapeB, b);
    separationBound.see(best.axis, best.distance, path);
    return separationBound;
}

} // namespace KODO_PRECISION
} // namespace kodo
