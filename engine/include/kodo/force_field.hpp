// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <cstdint>
#include <memory>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Force and torque of a field on one body in one step. A force that depends on the velocity gives
/// its slope as `drag`, and is integrated implicitly: it slows a body down but never reverses it,
/// however strong it is and however long the step.
///
///   a = F / (m + dt drag),   alpha = T / (I + dt spinDrag)
///
/// which is one backward Euler step for F(v) = F - drag (v - v_now). Contact forces do not enter
/// it: a body at rest under a load is held by m / (m + dt drag) of F.
struct FieldForce {
    Vec2 force{};      // N, at the centre of mass, at the present velocity
    Real torque = 0;   // N m, counter-clockwise
    Real drag = 0;     // N s/m, >= 0; decrease of the force per velocity
    Real spinDrag = 0; // N m s, >= 0; decrease of the torque per angular velocity
};

/// Which of the engine's own fields a field is; Own: a class of the user.
enum class FieldKind : std::uint8_t { Own, Gravity, Drag, Wind, Attractor, Buoyancy };

/// A rule that exerts forces on bodies: gravity, wind, a magnet. Derive from it for one of your
/// own. It must depend on its arguments alone: copies of a World share it, replays repeat it, and
/// several threads call it at once. It must not change the World that calls it: see World::step().
class KODO_API ForceField {
public:
    ForceField();
    ForceField(const ForceField&) = delete;
    ForceField& operator=(const ForceField&) = delete;
    virtual ~ForceField();

    /// Called once per step of dt (s) for each awake dynamic body, before the solver. Find a force
    /// that depends on the position at midStep(). Must not throw. A body whose force is not finite
    /// is stopped, see World::frozenBodies().
    virtual FieldForce at(const BodyView& body, Real dt) const = 0;

    /// True if the force depends on mass, shape and flags of the body alone. at() is then called
    /// again only after a change of the body.
    virtual bool steady() const { return false; }
    /// Not virtual, so that a class compiled without RTTI is known as Own.
    FieldKind kind() const { return kind_; }

private:
    friend class Gravity;
    friend class Drag;
    friend class Wind;
    friend class Attractor;
    friend class Buoyancy;
    explicit ForceField(FieldKind kind);

    FieldKind kind_ = FieldKind::Own;
};

/// Pose of the centre of mass after half a step of dt (s) without forces. A force found there makes
/// the step a leapfrog,
///
///   x + v h / 2,   v + h a,   x + v h / 2
///
/// so an orbit neither spirals in nor out, as it does with Euler's method [Thesis06, fig. 4.6].
KODO_API Transform midStep(const BodyView& body, Real dt);

/// Force = mass * acceleration.
class KODO_API Gravity final : public ForceField {
public:
    /// acceleration: m/s^2.
    explicit Gravity(Vec2 acceleration)
        : ForceField(FieldKind::Gravity), acceleration_(acceleration) {}
    FieldForce at(const BodyView& body, Real dt) const override;
    bool steady() const override { return true; }
    Vec2 acceleration() const { return acceleration_; }

private:
    Vec2 acceleration_;
};

/// Coefficients of the drag of a fluid, per width d (m) of the disc with the area of the body.
struct DragLaw {
    Real linear = 0;    // N per m/s and per m of width; slow and viscous flow
    Real quadratic = 0; // N per (m/s)^2 and per m of width; fast flow
};

/// Drag of a fluid that moves with one velocity everywhere.
///
///   F = -(linear + quadratic |u|) d u,   u = v - air
///   T = -(linear + quadratic r |w|) d r^2 w,   r = d / 2
class KODO_API Drag final : public ForceField {
public:
    /// air: m/s.
    explicit Drag(DragLaw law, Vec2 air = {}) : ForceField(FieldKind::Drag), law_(law), air_(air) {}
    FieldForce at(const BodyView& body, Real dt) const override;
    DragLaw law() const { return law_; }
    Vec2 air() const { return air_; }

private:
    DragLaw law_;
    Vec2 air_;
};

/// Drag of a fluid within a region. A body is inside by its centre of mass.
class KODO_API Wind final : public ForceField {
public:
    /// velocity: m/s; region: m, world; std::nullopt: everywhere.
    Wind(DragLaw law, Vec2 velocity, std::optional<Aabb> region = {})
        : ForceField(FieldKind::Wind), drag_(law, velocity), region_(region) {}
    FieldForce at(const BodyView& body, Real dt) const override;
    DragLaw law() const { return drag_.law(); }
    Vec2 velocity() const { return drag_.air(); }
    std::optional<Aabb> region() const { return region_; }

private:
    Drag drag_;
    std::optional<Aabb> region_;
};

/// Acceleration towards a point, equal for all masses; a negative strength repels. With
/// d = centre - x:
///
///   InverseSquare:  a = strength d / (|d|^2 + softening^2)^(3/2),  strength in m^3/s^2
///   Linear:         a = strength d,                                strength in 1/s^2
///
/// The softening (m) limits the first one to strength / softening^2. With the second one, all
/// bodies oscillate with the period 2 pi / sqrt(strength), while strength dt^2 < 4: beyond that
/// the steps of dt (s) are too long, and the energy grows without bound.
class KODO_API Attractor final : public ForceField {
public:
    enum class Law : std::uint8_t { InverseSquare, Linear };

    /// center: m, world.
    Attractor(Law law, Vec2 center, Real strength, Real softening = 0)
        : ForceField(FieldKind::Attractor),
          law_(law),
          center_(center),
          strength_(strength),
          softening_(softening) {}
    FieldForce at(const BodyView& body, Real dt) const override;
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

/// Part of a convex shape below a line.
struct Submerged {
    Real area = 0; // m^2
    Vec2 centroid; // m, world; meaningless if the area is 0
};

/// The part of a convex shape at pose t with dot(up, x - surface) < 0, exactly. `up` is a unit
/// vector. A polygon is clipped, and the arcs of its round corners too. A circle of radius r with
/// its centre c below the line leaves
///
///   A = r^2 (p - sin p cos p),  centroid 2 (r sin p)^3 / (3 A) below the centre,  cos p = -c / r
KODO_API Submerged submerged(const ConvexShape& convex, const Transform& t, Vec2 surface, Vec2 up);

/// A fluid at rest below a surface. A body floats where it displaces its own mass (Archimedes).
/// Overlapping parts of a body count twice, as they do in its mass.
///
///   F = -density A g - drag A v,  at the centroid of the submerged part, whose area is A
///
/// A body of density rho and width w at the surface bobs at a squared angular frequency of
/// density g w / (rho A). Steps of dt (s) must keep that below 4 / dt^2: small light bodies need
/// short ones.
class KODO_API Buoyancy final : public ForceField {
public:
    struct Fluid {
        Real density = 1; // kg/m^2
        Real drag = 0;    // kg/(m^2 s): N per m/s and m^2
    };
    /// The surface is perpendicular to `gravity` (m/s^2) and contains `surface` (m, world).
    Buoyancy(Fluid fluid, Vec2 surface, Vec2 gravity)
        : ForceField(FieldKind::Buoyancy),
          fluid_(fluid),
          surface_(surface),
          gravity_(gravity),
          up_(-normalize(gravity)) {}
    FieldForce at(const BodyView& body, Real dt) const override;
    Fluid fluid() const { return fluid_; }
    Vec2 surface() const { return surface_; }
    Vec2 gravity() const { return gravity_; }

private:
    Fluid fluid_;
    Vec2 surface_;
    Vec2 gravity_;
    Vec2 up_;
};

/// A field, and the bodies it acts on: those whose user flags `which` accepts.
struct FieldEntry {
    std::shared_ptr<const ForceField> field{};
    CollisionFilter which{};
};

} // namespace KODO_PRECISION
} // namespace kodo
