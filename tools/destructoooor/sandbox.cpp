// SPDX-License-Identifier: MIT
#include "sandbox.hpp"

#include <scenes/in_kodo.hpp>
#include <scenes/piles.hpp>

#include <algorithm>
#include <memory>

namespace destructoooor {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr Real kGone = 40;       // m from the origin; bodies beyond it are removed
constexpr Real kBurstRadius = 4; // m
constexpr Real kBurstSpeed = 12; // m/s, at the centre of the explosion
constexpr std::size_t kMostBodies = 400;

scenes::SceneDef definitionOf(Scene scene) {
    switch (scene) {
    case Scene::Tower:
        return scenes::stack(12);
    case Scene::Pyramid:
        return scenes::pyramid(12);
    case Scene::Pit:
        return scenes::pile(60);
    case Scene::Ground:
        break;
    }
    return {"ground", scenes::kDown, {scenes::ground(30)}};
}

kodo::Shape shapeOf(Primitive what, Real size, std::uint64_t key) {
    switch (what) {
    case Primitive::Box:
        return kodo::Box{size, size};
    case Primitive::Plank:
        return kodo::Box{3 * size, size / 4};
    case Primitive::Polygon: {
        scenes::Dice dice(key);
        const std::size_t corners = 3 + dice.below(5);
        const auto width = static_cast<double>(size);
        return std::get<kodo::Polygon>(
            scenes::toKodo(scenes::Part(scenes::randomPolygon(dice, corners, width, width))));
    }
    case Primitive::Circle:
        break;
    }
    return kodo::Circle{size / 2};
}

bool isLocked(const kodo::BodyView& body) {
    return body.type() != kodo::BodyType::Dynamic;
}

} // namespace

Sandbox::Sandbox() {
    // The lessons of the thesis need its solver; few iterations make the effects visible.
    settings_ = kodo::thesis2006();
    settings_.propagation().contactPasses = 5;
    restart(Scene::Tower);
}

void Sandbox::restart(Scene scene) {
    scene_ = scene;
    drops_ = 0;
    world_ = scenes::inKodo(definitionOf(scene), settings_).world;
    setGravity(gravity_);
    setMaterial(friction_, restitution_);
}

void Sandbox::drop(Primitive what, Vec2 place, Real size) {
    if (world_.bodyCount() < kMostBodies) {
        world_.add({.shape = shapeOf(what, size, ++drops_),
                    .position = place,
                    .material = kodo::withFriction(friction_, restitution_)});
    }
}

void Sandbox::burst(Vec2 place) {
    for (const kodo::BodyId id : world_.bodies()) {
        kodo::BodyRef body = world_[id];
        const Vec2 way = body.center() - place;
        const Real distance = length(way);
        if (!isLocked(body) && distance < kBurstRadius && distance > 0) {
            const Real share = 1 - distance / kBurstRadius;
            body.applyImpulse((body.mass() * kBurstSpeed * share / distance) * way);
        }
    }
}

void Sandbox::step() {
    world_.step(kStepSeconds);
    takeOutLost();
}

void Sandbox::takeOutLost() {
    for (const kodo::BodyId id : world_.bodies()) {
        const kodo::BodyView body = std::as_const(world_)[id];
        if (!isLocked(body) && length(body.center()) > kGone) {
            world_.remove(id);
        }
    }
}

void Sandbox::setSettings(const kodo::StepSettings& settings) {
    world_.setSettings(settings); // throws for what check() refuses
    settings_ = settings;
}

void Sandbox::setGravity(Real gravity) {
    gravity_ = gravity;
    world_.setFields({{std::make_shared<kodo::Gravity>(Vec2{0, -gravity}), {}}});
}

void Sandbox::setMaterial(Real friction, Real restitution) {
    friction_ = friction;
    restitution_ = restitution;
    for (const kodo::BodyId id : world_.bodies()) {
        world_[id].setMaterial(kodo::withFriction(friction, restitution));
    }
}

Measures Sandbox::measures() const {
    Measures found;
    for (const kodo::BodyId id : world_.bodies()) {
        const kodo::BodyView body = world_[id];
        if (isLocked(body)) {
            continue;
        }
        ++found.bodies;
        found.asleep += (body.flags() & kodo::kAsleep) != 0 ? 1 : 0;
        found.highest = std::max(found.highest, body.bounds().upper.y);
        found.fastest = std::max(found.fastest, length(body.velocity()));
    }
    for (const kodo::CollisionRecord& record : world_.collisions()) {
        if (record.phase != kodo::TouchPhase::End) {
            ++found.contacts;
            found.maxOverlap = std::max(found.maxOverlap, -record.separation);
        }
    }
    found.visits = stepStats(world_).contacts;
    return found;
}

} // namespace destructoooor
