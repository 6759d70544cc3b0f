// SPDX-License-Identifier: MIT
// Integration: Euler's spiral (fig. 4.6), step rates (4.2.2.4), local space (figs. 4.1, 4.2).
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;
using kodo::World;

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurnRate = kPi; // rad/s: a turn takes 2 s
constexpr double kStiffness = kTurnRate * kTurnRate;
constexpr Vec2 kStart{1, 0};

/// Eq. 4.8 on both equations of motion: the pull is that of the place before the step.
void stepOfEuler(World& world, BodyId id, Real h) {
    const Vec2 pull = static_cast<Real>(-kStiffness) * world[id].position();
    world.step(h); // without a force: x + h v
    world[id].setVelocity(world[id].velocity() + h * pull);
}

struct Orbit {
    double last = 1;  // m, radius at the end
    double worst = 0; // m, largest difference of the radius from 1
    Curve radius{};
    std::vector<Vec2> path{};
};

Orbit orbitOf(World& world, BodyId id, int rate, double seconds,
              const std::function<void(World&, BodyId, Real)>& step) {
    Orbit orbit;
    const int steps = static_cast<int>(seconds * rate);
    for (int i = 1; i <= steps; ++i) {
        step(world, id, Real(1) / static_cast<Real>(rate));
        const Vec2 place = world[id].position();
        orbit.last = static_cast<double>(length(place));
        orbit.worst = std::max(orbit.worst, std::fabs(orbit.last - 1));
        orbit.path.push_back(place);
        if (i % std::max(1, steps / 200) == 0) {
            orbit.radius.points.push_back({static_cast<double>(i) / rate, orbit.last});
        }
    }
    return orbit;
}

void plainStep(World& world, BodyId, Real h) {
    world.step(h);
}

BodyId addBody(World& world) {
    return world.add({.shape = kodo::Circle{Real(0.1)},
                      .position = kStart,
                      .velocity = {0, static_cast<Real>(kTurnRate)}});
}

Orbit byEuler(const Profile& profile, int rate, double seconds) {
    World world({.settings = profile.settings});
    const BodyId id = addBody(world);
    return orbitOf(world, id, rate, seconds, stepOfEuler);
}

Orbit byField(const Profile& profile, int rate, double seconds) {
    World world({.settings = profile.settings});
    world.addField({std::make_shared<kodo::Attractor>(kodo::Attractor::Law::Linear, Vec2{},
                                                      static_cast<Real>(kStiffness))});
    const BodyId id = addBody(world);
    return orbitOf(world, id, rate, seconds, plainStep);
}

Orbit byRod(const Profile& profile, int rate, double seconds) {
    World world({.settings = profile.settings});
    const BodyId hub =
        world.add({.shape = kodo::Circle{Real(0.05)}, .type = kodo::BodyType::Static});
    const BodyId id = addBody(world);
    world.add(kodo::DistanceJoint{.ends = {.a = hub, .b = id}, .limits = kodo::Range{1, 1}});
    return orbitOf(world, id, rate, seconds, plainStep);
}

std::string drawn(const std::vector<Vec2>& path) {
    kodo::SvgDraw picture({{-4, -4}, {4, 4}}, 320);
    for (std::size_t i = 1; i < path.size(); ++i) {
        picture.line(path[i - 1], path[i], {.line = {120, 190, 255}, .width = Real(1.2)});
    }
    picture.point({}, {.line = {255, 200, 80}});
    return picture.document();
}

void addSpiral(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"euler"};
    const double seconds = extent.of(20, 6);
    const int rate = 60;
    const Profile thesis = profiles()[0];
    const double square = kStiffness / rate / rate;
    const double growth = std::pow(1 + square, seconds * rate / 2);
    Orbit euler = byEuler(thesis, rate, seconds);
    one.add("radius after " + std::to_string(static_cast<int>(seconds)) + " s of a circle of 1 m",
            "Euler, eq. 4.8", euler.last, "m")
        .near(growth, 0.01 * growth,
              "each step multiplies it by sqrt(1 + (h w)^2), exactly; 1 % for float");
    Chart chart{"Radius over time, steps of 1/60 s", "time (s)", "radius (m)"};
    euler.radius.name = "Euler, eq. 4.8";
    chart.curves.push_back(euler.radius);
    one.pictures.push_back({"Euler's method, eq. 4.8", drawn(euler.path)});
    for (const Profile& profile : profiles()) {
        const std::string name = profile.name;
        Orbit field = byField(profile, rate, seconds);
        one.add("largest change of the radius, force field", name, field.worst, "m")
            .atMost(1.05 * square / 8,
                    "leapfrog: no growth; its circle is off by (h w)^2 / 8; 5 % for float");
        one.add("largest change of the radius, rod (distance joint)", name,
                byRod(profile, rate, seconds).worst, "m")
            .atMost(0.2 * kTurnRate / rate, "a fifth of the way of one step, 1 m h w");
        field.radius.name = name;
        chart.curves.push_back(field.radius);
        if (name == thesis.name) {
            one.pictures.push_back({"thesis2006(), the same pull as a field", drawn(field.path)});
        }
    }
    one.charts.push_back(chart);
    book.push_back(one);
}

/// m, error of the place after `seconds` of free fall.
double fallError(const Profile& profile, int rate, double seconds) {
    World world({.gravity = {0, -10}, .settings = profile.settings});
    const BodyId id = world.add({.shape = kodo::Circle{Real(0.1)}});
    for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
        world.step(Real(1) / static_cast<Real>(rate));
    }
    return std::fabs(static_cast<double>(world[id].position().y) + 5 * seconds * seconds);
}

void addRates(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"rates"};
    const double seconds = extent.of(10, 4);
    Chart spiral{"Growth of the orbit in a turn, against the step", "steps a second", "growth",
                 true};
    spiral.curves.push_back({"Euler, eq. 4.8", {}});
    for (const int rate : {30, 60, 120, 240, 480}) {
        const Profile thesis = profiles()[0];
        const double turn = std::pow(byEuler(thesis, rate, seconds).last, 2 / seconds) - 1;
        const double exact = std::pow(1 + kStiffness / rate / rate, rate) - 1;
        one.add("growth of the orbit in a turn at " + std::to_string(rate) + " Hz",
                "Euler, eq. 4.8", turn)
            .near(exact, 0.03 * exact, "(1 + (h w)^2)^n - 1 in the n pairs of steps of a turn");
        spiral.curves[0].points.push_back({static_cast<double>(rate), turn});
    }
    one.charts.push_back(spiral);
    for (const Profile& profile : profiles()) {
        for (const int rate : {30, 60, 240}) {
            one.add("error of a fall of 1 s at " + std::to_string(rate) + " Hz", profile.name,
                    fallError(profile, rate, 1), "m")
                .atMost(1e-5, "x + v h + g h^2 / 2 is exact for a constant force; float");
        }
    }
    book.push_back(one);
}

void addLocalSpace(std::vector<Experiment>& book) {
    Experiment one{"local"};
    for (const Profile& profile : profiles()) {
        World world({.settings = profile.settings});
        const BodyId id = world.add({.shape = kodo::Box{2, 1},
                                     .velocity = {Real(0.3), Real(-0.2)},
                                     .angularVelocity = Real(0.5)});
        const Vec2 corner{1, Real(0.5)};
        const Vec2 before = world[id].toWorld(corner);
        const Vec2 told = world[id].velocityAt(before);
        const Real h = Real(1) / 1024;
        world.step(h);
        const Vec2 moved = (world[id].toWorld(corner) - before) / h;
        one.add("corner's way in a step over h, against eq. 4.5", profile.name,
                static_cast<double>(length(moved - told)), "m/s")
            .atMost(1e-3, "v + w r: the arc differs by h w^2 r / 2 = 1.4e-4, float by 5e-4");
        World locked({.settings = profile.settings});
        const BodyId held = locked.add({.shape = kodo::Box{2, 1}, .flags = kodo::kLockRotate});
        const BodyId turned =
            locked.add({.shape = kodo::Box{2, 1}, .position = {5, 0}, .flags = kodo::kLockMove});
        locked[held].applyImpulse({1, 1}, {1, Real(0.5)});
        locked[turned].applyImpulse({0, 1}, {6, 0});
        locked.step(h);
        one.add("spin of a body with LOCK_ROTATE", profile.name,
                static_cast<double>(std::fabs(locked[held].angularVelocity())), "rad/s")
            .atMost(0, "infinite moment of inertia");
        one.add("speed of a body with LOCK_MOVE", profile.name,
                static_cast<double>(length(locked[turned].velocity())), "m/s")
            .atMost(0, "infinite mass; it turns alone");
        one.add("its spin", profile.name, static_cast<double>(locked[turned].angularVelocity()),
                "rad/s")
            .near(1.0 / (2 * (4 + 1) / 12.0), 1e-4, "J r / I, with I = m (4 + 1) / 12 and m = 2");
    }
    book.push_back(one);
}

} // namespace

void addMotion(std::vector<Experiment>& book, Extent extent) {
    addLocalSpace(book);
    addSpiral(book, extent);
    addRates(book, extent);
}

} // namespace thesis
