// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/outlook.hpp>
#include <kodo/math/lanes.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

/// Corners of an outline; behind them is anything.
struct Corners {
    alignas(kLaneBytes) std::array<Real, Convex::kFew> x;
    alignas(kLaneBytes) std::array<Real, Convex::kFew> y;

    void put(std::size_t first, const Couple& corners) {
        store(&x[first], corners.x);
        store(&y[first], corners.y);
    }
};

/// The corners of an outline, as seen from another one that turns.
struct View {
    explicit View(const Convex& convex) : count(convex.vertices.size()), radius(convex.radius) {}

    std::size_t count; // of corners
    Real radius;       // m, around each
    Corners now;
    Corners then; // at the end of the course, if each goes straight on
    Real bend;    // m: as far at most as they leave their straight lines
    Vec2 towards; // m per step: how who looks goes as seen from them
};

Real sumOf(Vec2 v) { // no less than its length
    return std::abs(v.x) + std::abs(v.y);
}

/// What A sees of B on their course. A turns by a, B by b, and a corner r of B, whose centre is at
/// d and goes by u, is at
///
///   q(t) = R(-a t) (d + u t) + R((b - a) t) r,   q'(0) = u - a x d + (b - a) x r,
///   |q''| <= a^2 |d + u t| + 2 |a| |u| + (b - a)^2 |r|,
///
/// so until t it leaves the straight line of its first moment by half of that times t^2, at most.
KODO_LANES_INLINE View viewOf(const Transform& a, const Convex& shapeB, const Transform& b,
                              const Course& course) {
    const Transform ab = between(a, b);
    const Real turn = course.turnA;
    const Real other = course.turnB;
    const Real length = course.length;
    View view(shapeB);
    view.towards = unrotate(a.rotation, course.towards);
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
                          (other - turn) * (other - turn) * shapeB.swing();
    view.bend = strength * length * length / 2;
    return view;
}

/// Outlook, side by side.
struct OutlookAside {
    Lanes distance = all(-std::numeric_limits<Real>::infinity());
    Lanes last = {};
    Lanes first = all(Course::kNever);

    Outlook best() const {
        Outlook outlook;
        for (int i = 0; i < kLanes; ++i) {
            outlook.distance = std::max(outlook.distance, distance[i]);
            outlook.last = std::max(outlook.last, last[i]);
            outlook.first = std::min(outlook.first, first[i]);
        }
        return outlook;
    }
};

/// The lowest of all corners along some axes.
KODO_LANES_INLINE Lanes lowest(const Couple& axis, const Corners& corners, std::size_t count) {
    Lanes least = all(std::numeric_limits<Real>::infinity());
    for (std::size_t i = 0; i < count; ++i) {
        least = smaller(axis.x * all(corners.x[i]) + axis.y * all(corners.y[i]), least);
    }
    return least;
}

/// Looks along kLanes faces at a time, each of which turns with its outline. The lowest of corners
/// that go straight is no lower than the chord f between now and the end of the course, L, tells:
///
///   height(s L) >= (1 - s) f(0) + s (f(L) - bend),   0 <= s <= 1,   since s^2 <= s.
///
/// Nor do they come nearer than an axis tells that stays as it is: see Outlook::see. True if one of
/// the faces keeps the two apart all the time.
KODO_LANES_INLINE bool seeFaces(OutlookAside& outlook, const Convex& a, const View& view,
                                const Course& course) {
    constexpr Real kNone = -std::numeric_limits<Real>::infinity();
    const std::size_t faces = a.normals.size();
    Lanes number;
    for (int i = 0; i < kLanes; ++i) {
        number[i] = static_cast<Real>(i);
    }
    for (std::size_t at = 0; at < faces; at += kLanes) {
        const Couple normal = loadPairs(&a.normals[at].x);
        const Couple on = loadPairs(&a.vertices[at].x);
        const Lanes surface = normal.x * on.x + normal.y * on.y + all(view.radius);
        const Lanes above = lowest(normal, view.now, view.count) - surface;
        const Lanes after = lowest(normal, view.then, view.count) - surface - all(view.bend);
        const Lanes closing =
            normal.x * all(view.towards.x) + normal.y * all(view.towards.y) + all(course.turning);
        const auto isFace = number < all(static_cast<Real>(faces - at));
        const Lanes distance = isFace ? above : all(kNone);
        const Lanes least = isFace ? larger(after, above - closing * all(course.length)) : distance;
        const Lanes now = distance - all(course.target);
        const Lanes then = least - all(course.target);
        const Lanes crossing = all(course.length) * (now / (now - then));
        const Lanes until = then > Lanes{} ? all(course.length) : crossing;
        const auto comes = (now <= Lanes{}) & (then > Lanes{});
        outlook.distance = larger(distance, outlook.distance);
        outlook.last = larger(now > Lanes{} ? until : Lanes{}, outlook.last);
        outlook.first = smaller(comes ? crossing : all(Course::kNever), outlook.first);
    }
    bool apart = false;
    for (int i = 0; i < kLanes; ++i) {
        apart |= outlook.last[i] >= course.length;
    }
    return apart;
}

bool hasFaces(const Convex& shape) {
    return shape.kind == OutlineKind::Sided || shape.isLine();
}

/// Does it have corners, and no more than View takes?
bool isFew(const Convex& shape) {
    return !shape.isPlane() && shape.vertices.size() <= Convex::kFew;
}

/// As B sees it.
Course reversed(Course course) {
    course.towards = -course.towards;
    std::swap(course.turnA, course.turnB);
    return course;
}

} // namespace

Outlook outlookOf(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                  const Transform& b, const Course& course) {
    OutlookAside aside;
    if (isFew(shapeA) && isFew(shapeB)) {
        if (hasFaces(shapeA) && seeFaces(aside, shapeA, viewOf(a, shapeB, b, course), course)) {
            return aside.best();
        }
        if (hasFaces(shapeB) &&
            seeFaces(aside, shapeB, viewOf(b, shapeA, a, reversed(course)), course)) {
            return aside.best();
        }
        if (shapeA.kind == OutlineKind::Sided && shapeB.kind == OutlineKind::Sided) {
            return aside.best();
        }
    }
    Outlook outlook = aside.best();
    const Separation best = separation(shapeA, a, shapeB, b);
    outlook.see(best.axis, best.distance, course);
    return outlook;
}

} // namespace kodo::inline KODO_PRECISION
