// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>
#include <scenes/scene_mass.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace crosscheck {

using scenes::Mass;

/// State of a body's centre of mass, common to both engines, in SI units.
struct State {
    scenes::Vec2 position;
    double angle = 0; // rad, -pi..pi
    scenes::Vec2 velocity;
    double spin = 0; // rad/s
};

/// Of an angle (rad) or a way (m), 0 at `reference`.
struct Limits {
    double lower = 0;
    double upper = 0;
};

/// A joint between two bodies of a scene. Points are in world coordinates (m) at the start.
struct Link {
    enum class Kind {
        RevoluteJoint,
        FixedJoint,
        DistanceJoint,
        RopeJoint,
        PrismaticJoint,
        MouseJoint
    };

    Kind kind = Kind::RevoluteJoint;
    std::size_t a = 0;
    std::size_t b = 0;
    scenes::Vec2 point{};    // anchor of both; DistanceJoint and RopeJoint: anchor of a
    scenes::Vec2 pointB{};   // DistanceJoint: anchor of b; the distance of both is the rest length;
                             // RopeJoint: anchor of b; the distance is the largest;
                             // MouseJoint: where the anchor of b is pulled to; a is any body
    double motorSpeed = 0;   // rad/s, of b relative to a; PrismaticJoint: m/s along the axis
    double motorTorque = 0;  // N m, maximum; PrismaticJoint, MouseJoint: N
    double hertz = 0;        // DistanceJoint: frequency with the masses of both bodies; 0: a rod;
                             // MouseJoint: frequency with the mass of b
    double damping = 0;      // DistanceJoint, MouseJoint: damping ratio; 1 is critical
    double breakForce = 0;   // N; a larger force, as mean of a step, breaks the joint; 0: none does
    scenes::Vec2 axis{0, 1}; // PrismaticJoint: unit, world
    std::optional<Limits> limits{};    // RevoluteJoint: rad; PrismaticJoint: m
    std::optional<double> reference{}; // rad, angle of b relative to a that counts as 0; by default
                                       // that of the start, which must be 0
    std::optional<double> length{};    // m, instead of the distance of both anchors
};

/// Two parts in contact in the last step; a < b.
struct Touch {
    std::size_t a = 0;
    std::size_t partA = 0;
    std::size_t b = 0;
    std::size_t partB = 0;
    double impulse = 0; // N s, normal, summed over the points
};

/// Where a ray meets a body.
struct RayFound {
    std::size_t body = 0;
    double fraction = 0; // 0 to 1 of the ray
};

/// A scene in one engine. Bodies are identified by their index in the scene.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual void step(double dt) = 0;
    /// The two bodies no longer collide. Joints are numbered from 0.
    virtual void join(const Link& link) = 0;
    /// Makes a part a body of its own, which gets the next index. Momentum is kept.
    virtual void split(std::size_t body, std::size_t part) = 0;
    virtual State state(std::size_t body) const = 0;
    /// Pairs that touched in the last step, sensors included.
    virtual std::vector<Touch> touches() const = 0;
    /// Force (N) of a joint on its body b, as mean of the last step.
    virtual scenes::Vec2 jointForce(std::size_t joint) const = 0;
    virtual bool isBroken(std::size_t joint) const = 0;
    virtual bool isAsleep(std::size_t body) const = 0;
    /// The first body on a ray.
    virtual std::optional<RayFound> rayCast(scenes::Vec2 from, scenes::Vec2 to) const = 0;
    /// The first body that a disc or a box meets on its way, without turning. The part is relative
    /// to the points.
    virtual std::optional<RayFound> shapeCast(const scenes::Part& shape, scenes::Vec2 from,
                                              scenes::Vec2 to) const = 0;
    /// The bodies that overlap or touch a box, in order.
    virtual std::vector<std::size_t> overlap(scenes::Vec2 low, scenes::Vec2 high) const = 0;

    /// Normal impulse (N s) between two bodies in the last step, summed over all points.
    double impulse(std::size_t a, std::size_t b) const;
    bool touching(std::size_t a, std::size_t b) const;
};

/// Settings of Kodo. The records of thesis2006() lack the loads of lower levels of a pile, which
/// its shock passes treat as static; so tests judge it without them too.
enum class Profile { Balanced, Accurate, Thesis, ThesisWithoutShock };

/// Kodo with the settings of a profile. Sleep is off unless the scene needs it, since sleeping
/// bodies report no impulses.
namespace f32 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, Profile profile);
}
namespace f64 {
std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, Profile profile);
}

/// Box2D 2.4.1 with its default 8 velocity and 3 position iterations. These differences to Kodo are
/// removed:
///
///   mixing     restitution uses Kodo's rule, the minimum, instead of the maximum; friction is
///              the geometric mean in both
///   skin       polygons are inset by b2_polygonRadius, so that a box with its skin has its
///              nominal size, with corners rounded by 1 cm; the mass is the nominal one
///   sleep      off, unless the scene needs it
///   bounce     the speed (m/s) below which restitution is 0 is an argument, 1 by default
///
/// These remain: the overlap of resting polygons by the slop of 5 mm; semi-implicit Euler without
/// half-step term; overlap of dynamic bodies for up to one step before a bounce.
std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold = 1);

/// Box2D 3 with its defaults and four substeps; mixing, mass, sleep and bounce as above. Polygons
/// need no inset: they have no skin. A joint's force is that of the last substep. Throws
/// std::invalid_argument, which says why, for a scene that it cannot play, and std::logic_error
/// where the build has no Box2D 3.
std::unique_ptr<Engine> makeBox2d3(const scenes::SceneDef& scene, double bounceThreshold = 1);
bool hasBox2d3();

} // namespace crosscheck
