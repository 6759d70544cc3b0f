// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/force_field.hpp>

#include <optional>

namespace kodo::inline KODO_PRECISION {

/// How a fluid brakes what moves through it, by the width d (m) of the disc that has the body's
/// area. Slow and viscous: linear. Fast: quadratic.
struct DragLaw {
    Real linear = 0;    // N per m/s and per m of width
    Real quadratic = 0; // N per (m/s)^2 and per m of width
};

/// Air that rests, or moves with one velocity everywhere: a wind.
///
///   F = -(linear + quadratic |u|) d u,   u = v - air
///   T = -(linear + quadratic r |w|) d r^2 w,   r = d / 2
class Drag : public ForceField {
public:
    explicit Drag(DragLaw law, Vec2 air = {}) : law_(law), air_(air) {} // air: m/s
    Push at(const Bodies& bodies, std::uint32_t body, Real dt) const override;
    DragLaw law() const { return law_; }
    Vec2 air() const { return air_; }

private:
    DragLaw law_;
    Vec2 air_;
};

/// Air that moves within `region` and is not felt outside of it. A body is in or out by its centre.
class Wind final : public ForceField {
public:
    /// velocity: m/s; region: m, world, or everywhere.
    Wind(DragLaw law, Vec2 velocity, std::optional<Aabb> region = {})
        : drag_(law, velocity), region_(region) {}
    Push at(const Bodies& bodies, std::uint32_t body, Real dt) const override;
    DragLaw law() const { return drag_.law(); }
    Vec2 velocity() const { return drag_.air(); }
    std::optional<Aabb> region() const { return region_; }

private:
    Drag drag_;
    std::optional<Aabb> region_;
};

/// Pulls everything towards a point, heavy and light alike; with a negative strength it repels.
/// With d = centre - x:
///
///   InverseSquare:  a = strength d / (|d|^2 + softening^2)^(3/2),  strength in m^3/s^2
///   Linear:         a = strength d,                                strength in 1/s^2
///
/// The softening (m) keeps the first finite near the centre: below strength / softening^2. A linear
/// pull makes everything swing with one period, 2 pi / sqrt(strength).
class Attractor final : public ForceField {
public:
    enum class Law : std::uint8_t { InverseSquare, Linear };

    /// center: m, world.
    Attractor(Law law, Vec2 center, Real strength, Real softening = 0)
        : law_(law), center_(center), strength_(strength), softening_(softening) {}
    Push at(const Bodies& bodies, std::uint32_t body, Real dt) const override;
    Law law() const { return law_; }
    Vec2 center() const { return center_; }
    Real strength() const { return strength_; }
    Real softening() const { return softening_; }

private:
    Law law_;
    Vec2 center_;
    Real strength_;
    Real softening_;
};

/// What of an outline lies below a line.
struct Submerged {
    Real area = 0; // m^2
    Vec2 centroid; // m, world; nothing when the area is 0
};

/// The part of an outline placed at t where dot(up, x - surface) < 0, exactly. `up` is a unit
/// vector. A polygon is clipped; of a circle of radius r with its centre c below the line remains
///
///   A = r^2 (p - sin p cos p),  centroid 2 (r sin p)^3 / (3 A) below the centre,  cos p = -c / r
Submerged submerged(const Convex& convex, const Transform& t, Vec2 surface, Vec2 up);

/// A fluid at rest below a surface through a point: water. A body floats where it displaces its own
/// mass (Archimedes); overlapping parts of a compound count twice here as they do in its mass.
///
///   F = -density A g - drag A v,  at the centroid of the part below the surface, whose area is A
class Buoyancy final : public ForceField {
public:
    /// What it is a surface of.
    struct Fluid {
        Real density = 1; // kg/m^2
        Real drag = 0;    // kg/(m^2 s): N per m/s and m^2
    };
    /// The surface lies across `gravity` (m/s^2), through `surface` (m, world).
    Buoyancy(Fluid fluid, Vec2 surface, Vec2 gravity)
        : fluid_(fluid), surface_(surface), gravity_(gravity), up_(-normalize(gravity)) {}
    Push at(const Bodies& bodies, std::uint32_t body, Real dt) const override;
    Fluid fluid() const { return fluid_; }
    Vec2 surface() const { return surface_; }
    Vec2 gravity() const { return gravity_; }

private:
    Fluid fluid_;
    Vec2 surface_;
    Vec2 gravity_;
    Vec2 up_;
};

} // namespace kodo::inline KODO_PRECISION
