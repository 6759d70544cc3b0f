// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

namespace kodo::inline KODO_PRECISION {

class World;

/// Reads one body of a World. A light handle: get it from World::operator[], use it, let it go.
class BodyView {
public:
    BodyView(const World& world, BodyId id);

    BodyId id() const { return id_; }
    Vec2 position() const;             // m, world: origin of the shape's frame
    Rot rotation() const;              // of the shape's frame
    Vec2 center() const;               // m, world: centre of mass
    Vec2 velocity() const;             // m/s, of the centre of mass
    Real angularVelocity() const;      // rad/s, counter-clockwise
    Vec2 velocityAt(Vec2 point) const; // m/s, of the body's point that is there (m, world)

    Real mass() const;    // kg, whether locked or not
    Real inertia() const; // kg m^2, about the centre of mass
    Real area() const;    // m^2; overlapping parts count twice
    Flags flags() const;
    std::uint16_t required() const;
    std::uint64_t userData() const;

    std::size_t partCount() const;
    const Part& part(std::size_t index) const; // throws std::out_of_range
    /// Takes a point of part(i).convex to the world: the frame of the centre of mass.
    const Transform& placement() const;

    Aabb bounds() const;             // m, world
    bool contains(Vec2 point) const; // world point, inside or on the edge

protected:
    std::uint32_t index() const { return id_.index; }
    const Bodies& bodies() const;

private:
    const World* world_;
    BodyId id_;
};

/// Changes one body. All setters check what they are given and throw BadDefinition, having changed
/// nothing; all work between steps, also while a step's collisions are being handled.
class BodyRef : public BodyView {
public:
    BodyRef(World& world, BodyId id);

    void setPosition(Vec2 position); // m, world: of the shape's frame; a jump, not a motion
    void setRotation(Rot rotation);  // of the shape's frame, about its origin; a jump as well
    void setVelocity(Vec2 velocity); // m/s, of the centre of mass
    void setAngularVelocity(Real radiansPerSecond); // counter-clockwise
    /// Sets the velocities that bring the shape's frame there in one step of dt (s). A locked body
    /// arrives to rounding, whatever is in its way, and hits it with its true speed. The velocity
    /// stays set: call again, or set it to zero.
    void moveTo(Vec2 position, Real dt);
    void moveTo(Vec2 position, Rot rotation, Real dt);

    // Forces act during the next step and are then forgotten, also by what it cannot push; impulses
    // act at once.
    void applyForce(Vec2 force);             // N, at the centre of mass
    void applyForce(Vec2 force, Vec2 point); // at a world point: adds torque
    void applyTorque(Real torque);           // N m, counter-clockwise
    void applyImpulse(Vec2 impulse);         // N s, at the centre of mass
    void applyImpulse(Vec2 impulse, Vec2 point);

    void setFlags(Flags flags); // those that only the engine sets stay as they are
    void setRequired(std::uint16_t required);
    void setUserData(std::uint64_t userData);
    void setMaterial(const Material& material); // of all parts

private:
    Motion& motion();
    Real unit() const; // m, of length
    void changed();    // its place, build or filter: contacts and what leans on it must know
    void thaw();
    void wake();
    void pushed();                       // its velocity
    void pushFrom(Vec2 arm, Vec2 force); // m, from the centre of mass
    void strikeFrom(Vec2 arm, Vec2 impulse);

    World* world_;
};

} // namespace kodo::inline KODO_PRECISION
