// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>
#include <scenes/scene_mass.hpp>

#include <cstddef>
#include <memory>

namespace crosscheck {

using scenes::Mass;

/// One body as both engines tell it: the centre of mass, in SI units.
struct State {
    scenes::Vec2 position;
    double angle = 0; // rad, -pi..pi
    scenes::Vec2 velocity;
    double spin = 0; // rad/s
};

/// A scene in some engine. Bodies are named by their place in the scene.
/// What holds two bodies of a scene together. Points are in the world (m), where the bodies start.
struct Link {
    enum class Kind { Pin, Weld, Spring };

    Kind kind = Kind::Pin;
    std::size_t a = 0;
    std::size_t b = 0;
    scenes::Vec2 point{};   // of both; of a Spring: on a
    scenes::Vec2 pointB{};  // of a Spring: on b. Its length at rest is their distance
    double motorSpeed = 0;  // rad/s, of a Pin: of b relative to a
    double motorTorque = 0; // N m at most
    double hertz = 0;       // of a Spring, with the masses of both
    double damping = 0;     // its damping ratio; 1 is critical
};

class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual void step(double dt) = 0;
    /// To be called before the first step. The two bodies do not touch each other any more.
    virtual void join(const Link& link) = 0;
    virtual State state(std::size_t body) const = 0;
    /// N s along the normal between two bodies in the last step, all points.
    virtual double impulse(std::size_t a, std::size_t b) const = 0;
};

/// Kodo with its default settings, but nothing is put to rest.
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene);

/// Box2D 2.4.1 with its default 8 velocity and 3 position iterations, and these differences undone:
///
///   mixing     pairs get Kodo's friction (both take the geometric mean) and the smaller
///              restitution, where Box2D takes the larger
///   skin       polygons are inset by b2_polygonRadius, so that with its skin a box touches where
///              its corners say (its corners stay rounded by 1 cm); the mass is the nominal one
///   sleep      off
///   bounce     the speed (m/s) below which it does not bounce is an argument, 1 by default
///
/// What stays: the slop of 5 mm that resting polygons sink in; semi-implicit Euler without the
/// half-step term; dynamic bodies that overlap for up to a step before they bounce.
std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold = 1);

} // namespace crosscheck
