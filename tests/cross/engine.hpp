// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>
#include <scenes/scene_mass.hpp>

#include <cstddef>
#include <memory>

namespace crosscheck {

using scenes::Mass;

/// State of a body's centre of mass, common to both engines, in SI units.
struct State {
    scenes::Vec2 position;
    double angle = 0; // rad, -pi..pi
    scenes::Vec2 velocity;
    double spin = 0; // rad/s
};

/// A joint between two bodies of a scene. Points are in world coordinates (m) at the start.
struct Link {
    enum class Kind { RevoluteJoint, FixedJoint, DistanceJoint };

    Kind kind = Kind::RevoluteJoint;
    std::size_t a = 0;
    std::size_t b = 0;
    scenes::Vec2 point{};   // anchor of both; DistanceJoint: anchor of a
    scenes::Vec2 pointB{};  // DistanceJoint: anchor of b; the distance of both is the rest length
    double motorSpeed = 0;  // rad/s, of b relative to a; RevoluteJoint only
    double motorTorque = 0; // N m, maximum
    double hertz = 0;       // DistanceJoint: frequency with the masses of both bodies
    double damping = 0;     // DistanceJoint: damping ratio; 1 is critical
};

/// A scene in one engine. Bodies are identified by their index in the scene.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual void step(double dt) = 0;
    /// Must be called before the first step. The two bodies no longer collide.
    virtual void join(const Link& link) = 0;
    virtual State state(std::size_t body) const = 0;
    /// Normal impulse (N s) between two bodies in the last step, summed over all points.
    virtual double impulse(std::size_t a, std::size_t b) const = 0;
};

/// Kodo with default settings but without sleep.
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene);

/// Box2D 2.4.1 with its default 8 velocity and 3 position iterations. These differences to Kodo are
/// removed:
///
///   mixing     restitution uses Kodo's rule, the minimum, instead of the maximum; friction is
///              the geometric mean in both
///   skin       polygons are inset by b2_polygonRadius, so that a box with its skin has its
///              nominal size, with corners rounded by 1 cm; the mass is the nominal one
///   sleep      off
///   bounce     the speed (m/s) below which restitution is 0 is an argument, 1 by default
///
/// These remain: the overlap of resting polygons by the slop of 5 mm; semi-implicit Euler without
/// half-step term; overlap of dynamic bodies for up to one step before a bounce.
std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold = 1);

} // namespace crosscheck
