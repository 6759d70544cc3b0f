// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/convex.hpp>

#include <algorithm>
#include <limits>

namespace kodo::inline KODO_PRECISION {

/// How two outlines go against each other from now on, for as long as both go straight on and turn
/// evenly.
struct Course {
    static constexpr Real kNever = 2; // a share of a step that never comes

    Vec2 towards;     // m per step: how A goes as seen from B; world axes
    Real turnA = 0;   // rad per step
    Real turnB = 0;   // rad per step
    Real turning = 0; // m per step: as much at most as their turns bring them nearer
    Real length = 0;  // share of a step that it lasts
    Real target = 0;  // m: the gap that is of interest
};

/// What separating axes tell of a course: until when one of those that keep two outlines apart by
/// more than the target does so, and from when on another one will. If that comes first, they pass
/// each other. With the faces for axes, a target of 0, and where nothing turns, that is exactly
/// when polygons meet: `last` is the latest time at which the shadows of both on an axis begin to
/// overlap, and `first` the earliest at which they end to [Ericson05, 5.5.2].
struct Outlook {
    Real distance =
        -std::numeric_limits<Real>::infinity(); // m, now; of axes looked along, the best
    Real last = 0;               // share of a step from now; until then they are apart, at least
    Real first = Course::kNever; // from then on they are, to the end of the course

    bool passes(const Course& course) const { return last >= course.length || first < last; }

    /// Looks along an axis (world) from A towards B, which stays as it is: along it they come
    /// nearer no faster than by their motion and all that their turns add.
    void see(Vec2 axis, Real separation, const Course& course) {
        const Real closing = dot(axis, course.towards) + course.turning;
        const Real now = separation - course.target;
        const Real then = now - closing * course.length;
        distance = std::max(distance, separation);
        if (now > 0) {
            last = std::max(last, then > 0 ? course.length : now / closing);
        } else if (then > 0) {
            first = std::min(first, now / closing);
        }
    }
};

/// Of any two outlines, along all axes that their faces and corners have, until one is found that
/// keeps them apart all the time. One-sided lines have both sides here; two planes never meet.
Outlook outlookOf(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                  const Transform& b, const Course& course);

} // namespace kodo::inline KODO_PRECISION
