// SPDX-License-Identifier: MIT
// The scenes of conserve_kodo.cpp in Box2D 3, if KODO_BENCH_BOX2D3 names one; else
// conserve_no_box2d3.cpp is compiled. Fields are forces that are applied before each step.
#include <scenes/in_box2d3.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "conserve.hpp"

namespace conserve::v3 {
namespace {

using box2d3::b2BodyId;
using box2d3::b2Vec2;
using scenes::Vec2;
using scenes::v3::toBox2d;

const scenes::Material kElastic{0, 1, 0};

Vec2 wide(b2Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

class Scene {
public:
    Scene(const Run& run, Vec2 gravity) {
        box2d3::b2WorldDef def = scenes::v3::worldOf(gravity);
        def.enableSleep = false;
        def.restitutionThreshold = 0;
        const auto push = run.numbers.find("pushSpeed");
        def.contactSpeed =
            push == run.numbers.end() ? def.contactSpeed : static_cast<float>(push->second);
        world = box2d3::b2CreateWorld(&def);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() { box2d3::b2DestroyWorld(world); }

    b2BodyId add(const scenes::BodyDef& def) {
        const b2BodyId body = scenes::v3::addToBox2d(world, def, false);
        if (!def.locked) {
            bodies.push_back(body);
        }
        return body;
    }

    void pin(b2BodyId a, b2BodyId b, Vec2 onA, Vec2 onB) {
        box2d3::b2RevoluteJointDef def = box2d3::b2DefaultRevoluteJointDef();
        def.base.bodyIdA = a;
        def.base.bodyIdB = b;
        def.base.localFrameA.p = toBox2d(onA);
        def.base.localFrameB.p = toBox2d(onB);
        pins.push_back(box2d3::b2CreateRevoluteJoint(world, &def));
    }

    double mass() const {
        double sum = 0;
        for (const b2BodyId body : bodies) {
            sum += static_cast<double>(box2d3::b2Body_GetMass(body));
        }
        return sum;
    }

    box2d3::b2WorldId world{};
    std::vector<b2BodyId> bodies{}; // dynamic ones
    std::vector<box2d3::b2JointId> pins{};
    std::function<double(Vec2)> potential{};  // J/kg
    std::function<Vec2(Vec2)> acceleration{}; // m/s^2, of a field
    double energyScale = 1;                   // J
    double momentumScale = 0;                 // kg m/s; 0: not conserved
    double angularScale = 0;                  // kg m^2/s; 0: not conserved
    std::string errorName = "energy, largest change";
};

struct Sums {
    double energy = 0;
    Vec2 momentum{};
    double angular = 0;
};

Sums sumsOf(const Scene& scene) {
    Sums sums;
    for (const b2BodyId body : scene.bodies) {
        const auto m = static_cast<double>(box2d3::b2Body_GetMass(body));
        const auto inertia = static_cast<double>(box2d3::b2Body_GetRotationalInertia(body));
        const auto w = static_cast<double>(box2d3::b2Body_GetAngularVelocity(body));
        const Vec2 v = wide(box2d3::b2Body_GetLinearVelocity(body));
        const Vec2 p = wide(box2d3::b2Body_GetWorldCenter(body));
        sums.energy += m * dot(v, v) / 2 + inertia * w * w / 2;
        sums.energy += scene.potential ? m * scene.potential(p) : 0;
        sums.momentum = sums.momentum + m * v;
        sums.angular += m * cross(p, v) + inertia * w;
    }
    return sums;
}

double height(Vec2 p) {
    return 10 * p.y;
}

void gas(Scene& scene) {
    scenes::BodyDef frame;
    for (const double side : {-1.0, 1.0}) {
        frame.parts.push_back(scenes::Box{11, 1, {0, side * 5.5}});
        frame.parts.push_back(scenes::Box{1, 11, {side * 5.5, 0}});
    }
    frame.material = kElastic;
    frame.density = 0.5;
    scene.add(frame);
    for (int i = 0; i < 60; ++i) {
        const double angle = 2.4 * i;
        const double speed = 1 + 0.05 * i;
        scenes::BodyDef disc = scenes::ball(0.25, {i % 8 - 3.5, i / 8 - 3.5}, kElastic);
        disc.velocity = {speed * std::cos(angle), speed * std::sin(angle)};
        scene.add(disc);
    }
    scene.energyScale = sumsOf(scene).energy;
    scene.momentumScale = std::sqrt(2 * scene.energyScale * 12);
    scene.angularScale = scene.momentumScale * 2;
}

void orbit(Scene& scene) {
    scenes::BodyDef disc = scenes::ball(0.25, {5, 0});
    disc.velocity = {0, 3};
    scene.add(disc);
    scene.acceleration = [](Vec2 p) {
        const double r2 = dot(p, p) + 1e-4;
        return (-100 / (r2 * std::sqrt(r2))) * p;
    };
    scene.potential = [](Vec2 p) { return -100 / std::sqrt(dot(p, p) + 1e-4); };
    scene.energyScale = scene.mass() * 20;
    scene.angularScale = scene.mass() * 15;
}

void chainOf(Scene& scene, double ratio, int links, bool bars) {
    scenes::BodyDef post = scenes::ball(0.1, {});
    post.locked = true;
    post.sensor = true; // links pass through it
    b2BodyId before = scene.add(post);
    Vec2 anchor{};
    for (int i = 0; i < links; ++i) {
        const Vec2 at{i + (bars ? 0.5 : 1), 0};
        scenes::BodyDef def = bars ? scenes::box(1, 0.1, at) : scenes::ball(0.2, at);
        def.density = i + 1 == links ? ratio : 1;
        const b2BodyId link = scene.add(def);
        scene.pin(before, link, anchor, {bars ? -0.5 : -1, 0});
        before = link;
        anchor = {bars ? 0.5 : 0, 0};
    }
    scene.potential = height;
    scene.energyScale = scene.mass() * 10 * links / 2;
}

/// The heightmap of Kodo's scene as a chain from right to left: its front is up.
void valley(Scene& scene) {
    std::vector<b2Vec2> points;
    for (int i = 401; i >= -1; --i) {
        const double x = -20 + 0.1 * i;
        points.push_back(toBox2d(Vec2{x, 0.05 * x * x}));
    }
    scenes::BodyDef smooth = scenes::ball(0.25, {-8, 3.52}, {0, 0, 0});
    const box2d3::b2ShapeDef shape = scenes::v3::shapeDefOf(smooth, false);
    box2d3::b2ChainDef def = box2d3::b2DefaultChainDef();
    def.points = points.data();
    def.count = static_cast<int>(points.size());
    def.materials = &shape.material;
    def.materialCount = 1;
    const box2d3::b2BodyDef ground = box2d3::b2DefaultBodyDef();
    box2d3::b2CreateChain(box2d3::b2CreateBody(scene.world, &ground), &def);
    scene.add(smooth);
    scene.potential = height;
    scene.energyScale = scene.mass() * 32;
}

void crowd(Scene& scene, const Run& run) {
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.4 * i;
        scene.add(scenes::box(0.5, 0.5, {0.15 * std::cos(angle), 0.15 * std::sin(angle)}));
    }
    const auto at = run.numbers.find("pushSpeed");
    const double push = at == run.numbers.end() ? 3 : at->second;
    scene.energyScale = 40 * 0.25 * push * push / 2;
    scene.momentumScale = 40 * 0.25 * push;
    scene.angularScale = 40 * 0.25 * push * 0.5;
    scene.errorName = "largest energy, as share of that at pushSpeed";
}

void tower(Scene& scene, double ratio) {
    scene.add(scenes::ground(40));
    for (int i = 0; i < 10; ++i) {
        scenes::BodyDef box = scenes::box(1, 1, {0, 0.5 + i});
        box.density = i == 9 ? ratio : 1;
        scene.add(box);
    }
    scene.potential = height;
    scene.energyScale = (9 + ratio) * 10;
}

void net(Scene& scene) {
    constexpr int kSide = 8;
    std::vector<b2BodyId> knots;
    for (int i = 0; i < kSide * kSide; ++i) {
        scenes::BodyDef knot = scenes::ball(0.2, {i % kSide * 1.0, -(i / kSide) * 1.0});
        knot.locked = i == 0 || i == kSide - 1;
        knots.push_back(scene.add(knot));
    }
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (i % kSide + 1 < kSide) {
            scene.pin(knots[at], knots[at + 1], {0.5, 0}, {-0.5, 0});
        }
        if (i / kSide + 1 < kSide) {
            scene.pin(knots[at], knots[at + kSide], {0, -0.5}, {0, 0.5});
        }
    }
    scene.potential = height;
    scene.energyScale = scene.mass() * 10 * kSide;
}

void make(Scene& scene, const Run& run) {
    if (run.scene == "gas") {
        gas(scene);
    } else if (run.scene == "orbit") {
        orbit(scene);
    } else if (run.scene == "double pendulum") {
        chainOf(scene, run.ratio, 2, true);
    } else if (run.scene == "heavy chain") {
        chainOf(scene, run.ratio, 10, false);
    } else if (run.scene == "valley") {
        valley(scene);
    } else if (run.scene == "crowd") {
        crowd(scene, run);
    } else if (run.scene == "net") {
        net(scene);
    } else {
        tower(scene, run.ratio);
    }
}

/// As for Kodo: what energy does not tell.
double errorOf(const Run& run, const Scene& scene, std::string& name) {
    if (run.scene == "net") {
        name = "widest gap (mm)";
        double widest = 0;
        for (const box2d3::b2JointId pin : scene.pins) {
            widest = std::max(widest,
                              1000 * static_cast<double>(box2d3::b2Joint_GetLinearSeparation(pin)));
        }
        return widest;
    }
    if (run.scene == "mass ratio") {
        name = "compression (share)";
        return std::abs(9.5 - wide(box2d3::b2Body_GetPosition(scene.bodies[9])).y) / 9.5;
    }
    return -1;
}

void step(const Scene& scene, float dt, int substeps) {
    if (scene.acceleration) {
        for (const b2BodyId body : scene.bodies) {
            const Vec2 a = scene.acceleration(wide(box2d3::b2Body_GetWorldCenter(body)));
            const auto mass = static_cast<double>(box2d3::b2Body_GetMass(body));
            box2d3::b2Body_ApplyForceToCenter(body, toBox2d(mass * a), true);
        }
    }
    box2d3::b2World_Step(scene.world, dt, substeps);
}

} // namespace

bool isBuilt() {
    return true;
}

Series play(const Run& run) {
    const bool still = run.scene == "gas" || run.scene == "orbit" || run.scene == "crowd";
    Scene scene(run, still ? Vec2{} : scenes::kDown);
    make(scene, run);
    const auto given = run.numbers.find("substeps");
    const int substeps = given == run.numbers.end() ? 4 : static_cast<int>(given->second);
    return measure(
        run, {scene.energyScale, scene.momentumScale, scene.angularScale, scene.errorName},
        [&] { step(scene, static_cast<float>(run.dt), substeps); },
        [&] {
            const Sums sums = sumsOf(scene);
            return Totals{sums.energy, sums.momentum.x, sums.momentum.y, sums.angular};
        },
        [&](std::string& name) { return errorOf(run, scene, name); });
}

} // namespace conserve::v3
