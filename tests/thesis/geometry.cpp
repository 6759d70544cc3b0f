// SPDX-License-Identifier: MIT
// Intersection without a World: hill climbing (fig. 3.4), the point outside (fig. 3.5), the time of
// a collision (fig. 4.4), sort and sweep (figs. 5.1, 5.2).
#include <kodo/geometry.hpp>
#include <kodo/step_stats.hpp>
#include <support/random_numbers.hpp>

#include "broad/sweep_and_prune.hpp"

#include <algorithm>
#include <cmath>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::Box;
using kodo::ConvexShape;
using kodo::Real;
using kodo::Rot;
using kodo::Transform;
using kodo::Vec2;

ConvexShape convexFor(const kodo::Primitive& primitive) {
    return kodo::convexShapeOf(primitive, {});
}

std::size_t next(std::size_t i, std::size_t count) {
    return (i + 1) % count;
}

/// Corners visited from the first one up to the farthest along a direction.
int climbLength(const std::vector<Vec2>& corners, Vec2 direction, std::size_t& end) {
    const std::size_t n = corners.size();
    const auto reach = [&](std::size_t i) { return dot(corners[i], direction); };
    int steps = 0;
    end = 0;
    const bool onwards = reach(1) >= reach(n - 1);
    for (;;) {
        const std::size_t beside = onwards ? next(end, n) : (end + n - 1) % n;
        if (reach(beside) <= reach(end)) {
            return steps;
        }
        end = beside;
        ++steps;
    }
}

void addClimb(std::vector<Experiment>& book) {
    Experiment one{"climb"};
    support::RandomNumbers random(34);
    int wrong = 0;
    int searches = 0;
    int plain = 0;
    int arranged = 0;
    std::size_t linear = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> points;
        for (int i = 0; i < 60; ++i) {
            points.push_back({random.between(-3, 3), random.between(-1, 1)});
        }
        const auto hull = std::get<kodo::Polygon>(kodo::convexHull(points));
        const kodo::Arranged better = kodo::arrange(hull);
        for (int turn = 0; turn < 16; ++turn) {
            const Vec2 way = random.rotation().xAxis();
            std::size_t end = 0;
            plain += climbLength(hull.corners, way, end);
            const auto farthest =
                std::max_element(hull.corners.begin(), hull.corners.end(),
                                 [&](Vec2 a, Vec2 b) { return dot(a, way) < dot(b, way); });
            wrong += dot(hull.corners[end], way) < dot(*farthest, way) ? 1 : 0;
            arranged += climbLength(better.polygon.corners, way, end);
            linear += hull.corners.size();
            ++searches;
        }
    }
    one.add("climbs that end beside the farthest corner", std::to_string(searches) + " climbs",
            wrong)
        .atMost(0, "one corner alone of a convex polygon is farther than both neighbours");
    one.add("corners visited in a climb", "convexHull()", 1.0 * plain / searches)
        .atMost(1.0 * static_cast<double>(linear) / searches,
                "the corners that a linear search visits");
    one.add("corners visited in a climb", "arrange()", 1.0 * arranged / searches)
        .atMost(1.0 * plain / searches, "its first corner is the sharpest, so the likeliest");
    book.push_back(one);
}

constexpr Real kPlate = Real(0.05); // m, thickness

/// Number of contact points of a box with a thin plate; `depth` is below the plate's upper face.
kodo::Manifold onPlate(Real degrees, Real depth, Transform& pose) {
    pose.rotation = Rot::fromAngle(degrees * Real(0.0174532925));
    Real lowest = 0;
    for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
        lowest = std::min(lowest, (pose.rotation * (Real(0.5) * corner)).y);
    }
    pose.position = {0, kPlate / 2 - depth - lowest};
    return kodo::collide(convexFor(Box{1, 1}), pose, convexFor(Box{8, kPlate}), {});
}

std::string drawPlate(Real degrees, Real depth) {
    Transform pose;
    const kodo::Manifold manifold = onPlate(degrees, depth, pose);
    kodo::SvgDraw picture({{Real(-1), Real(-0.7)}, {Real(1), Real(1.4)}}, 320);
    draw(convexFor(Box{8, kPlate}), {}, picture, {.line = {150, 160, 175}, .fill = {80, 90, 105}});
    draw(convexFor(Box{1, 1}), pose, picture,
         {.line = {120, 190, 255}, .fill = {60, 110, 180, 110}});
    for (int i = 0; i < manifold.count; ++i) {
        const Vec2 point = pose.position + manifold.points[static_cast<std::size_t>(i)].armA;
        picture.point(point, {.line = {255, 200, 80}});
        picture.arrow(point, point + Real(0.3) * manifold.normal, {.line = {255, 200, 80}});
    }
    return picture.document();
}

/// Bodies dropped on a thin plate, that come out below it.
int fallenThrough(kodo::StepSettings settings, int& dropped) {
    int through = 0;
    dropped = 0;
    for (const int speed : {2, 5, 10, 20, 50, 100, 200}) {
        for (const int degrees : {0, 20, 45}) {
            kodo::World world({.gravity = {0, -10}, .settings = settings});
            world.add({.shape = Box{100, kPlate}, .type = kodo::BodyType::Static});
            const kodo::BodyId box =
                world.add({.shape = Box{1, 1},
                           .position = {0, Real(2.3)},
                           .rotation = Rot::fromAngle(Real(degrees) * Real(0.0174532925)),
                           .velocity = {0, -Real(speed)}});
            for (int i = 0; i < 120; ++i) {
                world.step(Real(1) / 60);
            }
            through += world[box].center().y < 0 ? 1 : 0;
            ++dropped;
        }
    }
    return through;
}

void addPlate(std::vector<Experiment>& book) {
    Experiment one{"plate"};
    for (const int degrees : {5, 20, 45}) {
        for (const Real depth : {Real(0.03), Real(0.15), Real(0.3)}) {
            Transform pose;
            const kodo::Manifold manifold = onPlate(Real(degrees), depth, pose);
            const Vec2 point = pose.position + manifold.points[0].armA;
            const Real off = kodo::distance(convexFor(Box{8, kPlate}), {}, point).distance;
            const std::string what = "turned by " + std::to_string(degrees) + "°, corner " +
                                     std::to_string(static_cast<int>(std::lround(depth * 100))) +
                                     " cm deep";
            Row& row = one.add("contact points, " + what, "collide()", manifold.count);
            if (depth > kPlate) {
                row.near(1, 0, "a point outside the plate is single");
                one.add("first point outside the plate, " + what, "collide()",
                        static_cast<double>(off), "m");
            } else {
                row.atLeast(1, "the corner is within the plate: an ordinary contact");
            }
        }
    }
    int dropped = 0;
    for (const Profile& profile : profiles()) {
        const int through = fallenThrough(profile.settings, dropped);
        one.add("of " + std::to_string(dropped) + " drops fall through", profile.name, through)
            .atMost(0, "continuous collision treats the tunnelling itself");
    }
    kodo::StepSettings old = profiles()[0].settings;
    old.leaveOut |= kodo::Feature::ContinuousCollision;
    one.add("of " + std::to_string(dropped) + " drops fall through",
            "thesis2006(), ContinuousCollision left out", fallenThrough(old, dropped))
        .atLeast(1, "at 200 m/s a box of 1 m moves 3.3 m in a step");
    one.pictures.push_back({"Kodo's contact, corner within the plate", drawPlate(20, Real(0.03))});
    one.pictures.push_back({"Kodo's contact, corner through the plate", drawPlate(20, Real(0.3))});
    book.push_back(one);
}

void addBisection(std::vector<Experiment>& book) {
    Experiment one{"bisection"};
    const ConvexShape ball = convexFor(kodo::Circle{Real(0.1)});
    const ConvexShape wall = convexFor(Box{1, 4});
    const Transform wallAt{{Real(1.7), 0}, {}};
    const Vec2 way{Real(100) / 60, 0}; // a step at 100 m/s
    const double exact = (1.7 - 0.5 - 0.1) / (100.0 / 60);
    Chart chart{"Error of the time of collision, as a share of the step", "intersection tests",
                "error", true};
    chart.curves.push_back({"bisection", {}});
    double low = 0;
    double high = 1;
    int tests = 0;
    while (high - low > 1e-6) {
        const double middle = (low + high) / 2;
        const Transform at{static_cast<Real>(middle) * way, {}};
        (kodo::collide(ball, at, wall, wallAt).count > 0 ? high : low) = middle;
        chart.curves[0].points.push_back({static_cast<double>(++tests), high - low});
    }
    one.add("intersection tests for a millionth of the step", "bisection", tests)
        .near(20, 0, "2^-20 is the first power below 1e-6");
    const auto hit = kodo::shapeCast(ball, {}, way, wall, wallAt);
    one.add("error of the time of collision, share of the step", "shapeCast(), one call",
            hit ? std::fabs(static_cast<double>(hit->fraction) - exact) : 1)
        .atMost(1e-6, "closed form; rounding of float");
    one.charts.push_back(chart);
    book.push_back(one);
}

void addSweep(std::vector<Experiment>& book) {
    Experiment one{"sweep"};
    const auto testsOf = [](bool upright, std::size_t threshold) {
        std::vector<kodo::Octagon> bounds;
        for (int i = 0; i < 10; ++i) {
            const Vec2 place = upright ? Vec2{0, Real(2 * i)} : Vec2{Real(2 * i), 0};
            const Vec2 half{Real(0.5), Real(0.5)};
            bounds.push_back(kodo::Octagon::of(kodo::Aabb{place - half, place + half}));
        }
        kodo::SweepAndPrune sweep(threshold);
        sweep.pairs(bounds);
        return static_cast<double>(sweep.testCount());
    };
    one.add("tests of ten bodies in a flat row", "all pairs", testsOf(false, 10))
        .near(45, 0, "10 * 9 / 2");
    one.add("tests of ten bodies in a flat row", "sort and sweep", testsOf(false, 0))
        .atMost(0, "the axis with more cells tagged is that of the row");
    one.add("tests of ten bodies in an upright row", "sort and sweep", testsOf(true, 0))
        .atMost(0, "the axis is swapped");
    kodo::World world;
    for (int i = 0; i < 10; ++i) {
        world.add({.shape = Box{1, 1}, .position = {Real(2 * i), 0}, .velocity = {0, -1}});
    }
    world.step(Real(1) / 60);
    const auto before = kodo::stepStats(world).pairWork;
    world.step(Real(1) / 60);
    one.add("pairs of tree nodes compared in a step", "Kodo, trees of bounds",
            static_cast<double>(kodo::stepStats(world).pairWork - before))
        .atMost(45, "not more than all pairs");
    one.pictures.push_back({"The flat row", kodo::svg(world, {.bounds = true})});
    book.push_back(one);
}

} // namespace

void addGeometry(std::vector<Experiment>& book) {
    addClimb(book);
    addPlate(book);
    addBisection(book);
    addSweep(book);
}

} // namespace thesis
