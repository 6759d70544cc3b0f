// SPDX-License-Identifier: MIT
// Compiled twice, against both libraries.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "conserve.hpp"

namespace conserve::KODO_PRECISION {
namespace {

using kodo::BodyId;
using kodo::BodyType;
using kodo::Real;
using kodo::Vec2;

Real real(double value) {
    return static_cast<Real>(value);
}
double number(Real value) {
    return static_cast<double>(value);
}

/// A World with what is needed to measure it.
struct Scene {
    kodo::World world;
    std::vector<BodyId> bodies{};            // dynamic ones
    std::function<double(Vec2)> potential{}; // J/kg
    double energyScale = 1;                  // J
    double momentumScale = 0;                // kg m/s; 0: not conserved
    double angularScale = 0;                 // kg m^2/s; 0: not conserved
    std::string errorName = "energy, largest change";
};

Totals sumsOf(const Scene& scene) {
    Totals sums;
    for (const BodyId id : scene.bodies) {
        const kodo::BodyView body = std::as_const(scene.world)[id];
        const double m = number(body.mass());
        const double vx = number(body.velocity().x);
        const double vy = number(body.velocity().y);
        const double w = number(body.angularVelocity());
        const double x = number(body.center().x);
        const double y = number(body.center().y);
        const double inertia = number(body.inertia());
        sums.energy += m * (vx * vx + vy * vy) / 2 + inertia * w * w / 2;
        sums.energy += scene.potential ? m * scene.potential(body.center()) : 0;
        sums.px += m * vx;
        sums.py += m * vy;
        sums.angular += m * (x * vy - y * vx) + inertia * w;
    }
    return sums;
}

kodo::StepSettings settingsOf(const Run& run) {
    kodo::StepSettings settings = run.propagation ? kodo::thesis2006() : kodo::balanced();
    settings.leaveOut = kodo::Feature::Sleep;
    const auto get = [&](const char* name, auto& value) {
        if (const auto at = run.numbers.find(name); at != run.numbers.end()) {
            value = static_cast<std::decay_t<decltype(value)>>(at->second);
        }
    };
    const auto common = [&](auto& solver) {
        get("substeps", solver.substeps);
        get("jointHertz", solver.jointHertz);
        get("jointDamping", solver.jointDamping);
        get("pushSpeed", solver.pushSpeed);
        get("impactPasses", solver.impactPasses);
    };
    if (run.propagation) {
        common(settings.propagation());
        get("contactPasses", settings.propagation().contactPasses);
        get("shockPasses", settings.propagation().shockPasses);
    } else {
        common(settings.soft());
        get("contactHertz", settings.soft().contactHertz);
    }
    return settings;
}

kodo::World worldOf(const Run& run, Vec2 gravity) {
    return kodo::World({.gravity = gravity, .settings = settingsOf(run)});
}

double height(Vec2 p) {
    return 10 * number(p.y);
}

constexpr kodo::Material kElastic{.staticFriction = 0, .kineticFriction = 0, .restitution = 1};

/// 60 elastic discs in a free frame of four bars: nothing acts from outside.
Scene gas(const Run& run) {
    Scene scene{worldOf(run, {})};
    kodo::Compound frame;
    for (const Real side : {Real(-1), Real(1)}) {
        frame.parts.push_back(kodo::Box{11, 1, {0, side * Real(5.5)}});
        frame.parts.push_back(kodo::Box{1, 11, {side * Real(5.5), 0}});
    }
    scene.bodies.push_back(
        scene.world.add({.shape = frame, .material = kElastic, .density = Real(0.5)}));
    for (int i = 0; i < 60; ++i) {
        const double angle = 2.4 * i;
        const double speed = 1 + 0.05 * i;
        scene.bodies.push_back(scene.world.add(
            {.shape = kodo::Circle{Real(0.25)},
             .position = {real(i % 8 - 3.5), real(i / 8 - 3.5)},
             .velocity = {real(speed * std::cos(angle)), real(speed * std::sin(angle))},
             .material = kElastic}));
    }
    scene.energyScale = sumsOf(scene).energy;
    scene.momentumScale = std::sqrt(2 * scene.energyScale * 12);
    scene.angularScale = scene.momentumScale * 2;
    return scene;
}

/// An eccentric orbit about an attractor, 5 m in radius and one turn in 7 s at the start.
Scene orbit(const Run& run) {
    Scene scene{worldOf(run, {})};
    scene.world.addField({std::make_shared<kodo::Attractor>(kodo::Attractor::Law::InverseSquare,
                                                            Vec2{}, Real(100), Real(0.01)),
                          {}});
    scene.bodies.push_back(scene.world.add(
        {.shape = kodo::Circle{Real(0.25)}, .position = {5, 0}, .velocity = {0, 3}}));
    scene.potential = [](Vec2 p) {
        const double r2 = number(p.x) * number(p.x) + number(p.y) * number(p.y);
        return -100 / std::sqrt(r2 + 1e-4);
    };
    const double mass = number(std::as_const(scene.world)[scene.bodies[0]].mass());
    scene.energyScale = mass * 20;
    scene.angularScale = mass * 15;
    return scene;
}

/// Links hang from a static body in a row, let go level. The last one is `ratio` times as dense.
Scene chainOf(const Run& run, int links, bool bars) {
    Scene scene{worldOf(run, {0, -10})};
    BodyId before = scene.world.add({.shape = kodo::Circle{Real(0.1)},
                                     .type = BodyType::Static,
                                     .flags = kodo::kDisabled}); // links pass through it
    Vec2 anchor{};
    double mass = 0;
    for (int i = 0; i < links; ++i) {
        kodo::BodyDef def{.position = {real(i + (bars ? 0.5 : 1)), 0}};
        def.shape =
            bars ? kodo::Shape(kodo::Box{1, Real(0.1)}) : kodo::Shape(kodo::Circle{Real(0.2)});
        def.density = i + 1 == links ? real(run.ratio) : Real(1);
        const BodyId link = scene.world.add(def);
        const Vec2 back{bars ? Real(-0.5) : Real(-1), 0};
        scene.world.add(kodo::RevoluteJoint{
            .ends = {.a = before, .b = link, .anchorA = anchor, .anchorB = back}});
        scene.bodies.push_back(link);
        mass += number(std::as_const(scene.world)[link].mass());
        before = link;
        anchor = {bars ? Real(0.5) : Real(0), 0};
    }
    scene.potential = height;
    scene.energyScale = mass * 10 * links / 2;
    return scene;
}

/// A disc in a parabolic valley y = 0.05 x^2 without friction.
Scene valley(const Run& run) {
    Scene scene{worldOf(run, {0, -10})};
    kodo::Heightmap map{{-20, 0}, Real(0.1), {}};
    for (int i = 0; i <= 400; ++i) {
        const double x = -20 + 0.1 * i;
        map.heights.push_back(real(0.05 * x * x));
    }
    const kodo::Material smooth{.staticFriction = 0, .kineticFriction = 0};
    scene.world.add({.shape = map, .material = smooth, .type = BodyType::Static});
    scene.bodies.push_back(scene.world.add(
        {.shape = kodo::Circle{Real(0.25)}, .position = {-8, Real(3.52)}, .material = smooth}));
    scene.potential = height;
    scene.energyScale = number(std::as_const(scene.world)[scene.bodies[0]].mass()) * 32;
    return scene;
}

/// 40 boxes on one place in empty space. What separates them may give each pushSpeed at most.
Scene crowd(const Run& run) {
    Scene scene{worldOf(run, {})};
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.4 * i;
        scene.bodies.push_back(scene.world.add(
            {.shape = kodo::Box{Real(0.5), Real(0.5)},
             .position = {real(0.15 * std::cos(angle)), real(0.15 * std::sin(angle))}}));
    }
    const auto at = run.numbers.find("pushSpeed");
    const double push = at == run.numbers.end() ? 3 : at->second;
    const double mass = 40 * 0.25;
    scene.energyScale = mass * push * push / 2;
    scene.momentumScale = mass * push;
    scene.angularScale = mass * push * 0.5;
    scene.errorName = "largest energy, as share of that at pushSpeed";
    return scene;
}

/// A box of `ratio` times the density on nine light ones.
Scene tower(const Run& run) {
    Scene scene{worldOf(run, {0, -10})};
    scene.world.add({.shape = kodo::Box{40, 2}, .position = {0, -1}, .type = BodyType::Static});
    double mass = 9;
    for (int i = 0; i < 10; ++i) {
        scene.bodies.push_back(scene.world.add({.shape = kodo::Box{1, 1},
                                                .position = {0, real(0.5 + i)},
                                                .density = i == 9 ? real(run.ratio) : Real(1)}));
    }
    mass += run.ratio;
    scene.potential = height;
    scene.energyScale = mass * 10; // a fall of 1 m
    return scene;
}

/// A net of 8 x 8 discs with pins between neighbours, held at two corners.
Scene net(const Run& run) {
    Scene scene{worldOf(run, {0, -10})};
    constexpr int kSide = 8;
    double mass = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const bool held = i == 0 || i == kSide - 1;
        const BodyId id = scene.world.add({.shape = kodo::Circle{Real(0.2)},
                                           .position = {real(i % kSide), real(-(i / kSide))},
                                           .type = held ? BodyType::Static : BodyType::Dynamic});
        scene.bodies.push_back(id);
        mass += held ? 0 : number(std::as_const(scene.world)[id].mass());
    }
    const auto pin = [&](int a, int b, Vec2 half) {
        scene.world.add(kodo::RevoluteJoint{.ends = {.a = scene.bodies[static_cast<std::size_t>(a)],
                                                     .b = scene.bodies[static_cast<std::size_t>(b)],
                                                     .anchorA = half,
                                                     .anchorB = -half}});
    };
    for (int i = 0; i < kSide * kSide; ++i) {
        if (i % kSide + 1 < kSide) {
            pin(i, i + 1, {Real(0.5), 0});
        }
        if (i / kSide + 1 < kSide) {
            pin(i, i + kSide, {0, Real(-0.5)});
        }
    }
    scene.potential = height;
    scene.energyScale = mass * 10 * kSide;
    return scene;
}

/// Largest gap (mm) of a joint.
double widestGap(const kodo::World& world) {
    double widest = 0;
    for (const kodo::JointId id : world.joints()) {
        const auto* pin = std::get_if<kodo::RevoluteJoint>(&world.joint(id));
        const Vec2 gap = world[pin->ends.b].transform() * pin->ends.anchorB -
                         world[pin->ends.a].transform() * pin->ends.anchorA;
        widest = std::max(widest, 1000 * number(length(gap)));
    }
    return widest;
}

Scene make(const Run& run) {
    if (run.scene == "gas") {
        return gas(run);
    }
    if (run.scene == "orbit") {
        return orbit(run);
    }
    if (run.scene == "double pendulum") {
        return chainOf(run, 2, true);
    }
    if (run.scene == "heavy chain") {
        return chainOf(run, 10, false);
    }
    if (run.scene == "valley") {
        return valley(run);
    }
    if (run.scene == "crowd") {
        return crowd(run);
    }
    return run.scene == "net" ? net(run) : tower(run);
}

/// The error of a state that energy does not tell: how far a tower sinks, how wide a net opens.
double errorOf(const Run& run, Scene& scene, std::string& name) {
    if (run.scene == "net") {
        name = "widest gap (mm)";
        return widestGap(scene.world);
    }
    if (run.scene == "mass ratio") {
        name = "compression (share)";
        const kodo::BodyView top = std::as_const(scene.world)[scene.bodies[9]];
        return std::abs(9.5 - number(top.position().y)) / 9.5;
    }
    return -1;
}

} // namespace

Series play(const Run& run) {
    Scene scene = make(run);
    return measure(
        run, {scene.energyScale, scene.momentumScale, scene.angularScale, scene.errorName},
        [&] { scene.world.step(real(run.dt)); }, [&] { return sumsOf(scene); },
        [&](std::string& name) { return errorOf(run, scene, name); });
}

} // namespace conserve::KODO_PRECISION
