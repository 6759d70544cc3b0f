// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>
#include <kodo/filter.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional> // declares std::hash

namespace kodo {
inline namespace KODO_PRECISION {

struct Bodies;
class World;
class WorldImpl;

namespace detail {

/// Equal inputs give equal numbers; neighbouring ones differ in low and high bits.
constexpr std::size_t hashOf(std::uint32_t index, std::uint32_t generation) {
    const std::uint64_t both = std::uint64_t{generation} << 32 | index;
    const std::uint64_t mixed = both * 0x9e3779b97f4a7c15;
    return static_cast<std::size_t>(mixed ^ mixed >> 32);
}

} // namespace detail

/// Names a body of a World. It stays invalid for ever once the body is removed, also when the slot
/// is used again. Copies of a World accept its ids; a body that was added to one copy alone, or to
/// a World that has been assigned an earlier copy since, may have the id of another body there.
struct BodyId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0; // of the slot; 0 is never valid, so BodyId{} is the null id
    /// Stamp of the World that issued the id; its copies share it. 0 fits every World: ids read
    /// from a file, and those of a World from fromBytes().
    std::uint32_t world = 0;

    /// By slot and generation. The stamp of the World is not compared.
    friend constexpr bool operator==(BodyId a, BodyId b) {
        return a.index == b.index && a.generation == b.generation;
    }
    friend constexpr std::strong_ordering operator<=>(BodyId a, BodyId b) {
        const auto byIndex = a.index <=> b.index;
        return byIndex != 0 ? byIndex : a.generation <=> b.generation;
    }
};

/// How a body moves.
enum class BodyType : std::uint8_t {
    Dynamic,   // by forces, contacts and joints
    Kinematic, // by the velocity that it is given; infinite mass, so nothing pushes it
    Static,    // never; infinite mass
};

/// Against which bodies continuous collision checks a body. A pair is checked as the lower of both
/// modes says.
enum class ContinuousMode : std::uint8_t {
    Never,  // it may tunnel, and passes sensors unnoticed
    Static, // a pair with a body that nothing moves: static, kinematic, frozen, or locked
    All,
};

/// With less, the rim of a body would give way to its contacts. That of a disc is 1/2.
inline constexpr Real kMinInertiaShare = Real(1) / 256;

/// A mass that is set, instead of that from the shapes and their densities [Thesis06, 4.1.5].
struct MassDef {
    Real mass = 0; // kg, 1 / kMaxMass to kMaxMass
    /// m, in the frame of the shape; default: that of the shapes. A Point needs an inertia too.
    std::optional<Vec2> center{};
    /// kg m^2, about the centre of mass; at least kMinInertiaShare m r^2, r being the largest
    /// distance of a point from this centre. Default: that of the shapes, scaled to the mass.
    std::optional<Real> inertia{};
};

/// All that a body starts with.
struct BodyDef {
    Shape shape = Circle{Real(0.5)};
    Vec2 position{};               // m, world: origin of the shape's frame
    Rot rotation{};                // of the shape's frame
    Vec2 velocity{};               // m/s, of the centre of mass
    Real angularVelocity = 0;      // rad/s, counter-clockwise
    Material material{};           // of all parts; of a Chain, unless it has its own
    Real density = 1;              // kg/m^2; the mass follows from it and the shape
    std::optional<MassDef> mass{}; // instead of that mass
    Real linearDamping = 0;        // 1/s, 0 to kMaxDamping: v(t) = v exp(-c t) without forces
    Real angularDamping = 0;       // 1/s, likewise
    Real gravityScale = 1;         // of the forces of all Gravity fields; up to kMaxGravityScale
    ContinuousMode continuousMode = ContinuousMode::All;
    BodyType type = BodyType::Dynamic;
    Flags flags = 0;            // categories, a match mode, motion locks, kSensor, ...
    Flags required = 0;         // see CollisionFilter; refused without a match mode
    std::int32_t group = 0;     // see CollisionFilter
    std::uint64_t userData = 0; // the engine never reads it
};

/// Largest coordinate at which a body is added or placed, and largest coordinate of its shape (m,
/// times the length unit of the World). Beyond it the resolution of a Real is coarser than 1 % of
/// the unit. A body may move farther: setRegion() ends its simulation there.
inline constexpr Real kMaxCoordinate = sizeof(Real) == 4 ? Real(1e5) : Real(1e13);
inline constexpr Real kMaxSpeed = Real(1e7);        // m/s, times the length unit; or rad/s
inline constexpr Real kMaxDamping = Real(1e6);      // 1/s
inline constexpr Real kMaxGravityScale = Real(1e6); // size; negative scales lift
inline constexpr Real kMinDensity = Real(1e-9);     // kg/m^2
inline constexpr Real kMaxDensity = Real(1e9);      // kg/m^2
/// Masses (kg) of bodies and parts lie between 1 / kMaxMass and kMaxMass. Moments of inertia
/// (kg m^2) lie between the squares of these. So products of two stay finite.
inline constexpr Real kMaxMass = sizeof(Real) == 4 ? Real(1e18) : Real(1e100);

/// The reason why World::add() would refuse a definition, in a World with that length unit (m).
KODO_API std::optional<Problem> check(const BodyDef& def, Real lengthUnit = 1);

/// One convex part of a body.
struct Part {
    Primitive primitive{}; // as given, in the frame of the body's shape
    Material material{};
    Real density = 1; // kg/m^2
    /// In collisions and queries, instead of the filter and the kSensor of the body. Its flags are
    /// categories, a match mode and kSensor.
    std::optional<CollisionFilter> filter{};
    std::uint64_t userData = 0; // the engine never reads it
    ConvexShape convex{};       // the same shape relative to the body's centre of mass
};

/// Reads one body of a World. A light handle: it holds a pointer to the World's data and the id,
/// and checks the id at each use. Every function throws BadBodyId once the body is removed. The
/// handle must not be used after the World is destroyed, or replaced by one that is moved to it; it
/// stays valid while the World itself is moved, and when another World is copied to it.
class KODO_API BodyView {
public:
    /// For force fields and other code of the engine; users write world[id].
    BodyView(const Bodies& bodies, BodyId id);

    BodyId id() const { return id_; }
    BodyType type() const;
    Vec2 position() const;             // m, world: origin of the shape's frame
    Rot rotation() const;              // of the shape's frame
    Transform transform() const;       // both: takes points of the shape's frame to the world
    Vec2 center() const;               // m, world: centre of mass
    Vec2 velocity() const;             // m/s, of the centre of mass
    Real angularVelocity() const;      // rad/s, counter-clockwise
    Vec2 velocityAt(Vec2 point) const; // m/s, of the body at a world point (m)

    Real mass() const;        // kg, also of a static or kinematic body
    Real inertia() const;     // kg m^2, about the centre of mass
    Vec2 localCenter() const; // m, in the frame of the shape: centre of mass
    bool hasSetMass() const;  // false: mass and inertia follow from shapes and densities
    Real area() const;        // m^2; overlapping parts count twice
    Flags flags() const;
    Flags required() const;
    std::int32_t group() const;
    std::uint64_t userData() const;
    bool isAsleep() const;
    Real linearDamping() const;  // 1/s
    Real angularDamping() const; // 1/s
    Real gravityScale() const;
    ContinuousMode continuousMode() const;

    // Between the world and the frame of the shape: points (m), and vectors, which only turn.
    Vec2 toWorld(Vec2 point) const { return transform() * point; }
    Vec2 toLocal(Vec2 point) const { return kodo::toLocal(transform(), point); }
    Vec2 toWorldVector(Vec2 vector) const { return rotation() * vector; }
    Vec2 toLocalVector(Vec2 vector) const { return rotation().inverse() * vector; }

    std::size_t partCount() const;
    /// Valid until the body is changed. Throws std::out_of_range.
    const Part& part(std::size_t index) const;
    /// The filter that counts for a part, with the engine's flags of the body.
    CollisionFilter filter(std::size_t part) const;
    /// Takes points of Part::convex to the world: the frame of the centre of mass.
    const Transform& massFrame() const;

    Aabb bounds() const;             // m, world
    bool contains(Vec2 point) const; // world point (m), inside or on the edge

protected:
    std::uint32_t index() const; // checked

private:
    const Bodies* bodies_;
    BodyId id_;
};

/// Changes one body. Setters throw BadDefinition for bad values, and nothing has changed then. All
/// of them are legal between two steps, also while collisions() is being read; within a step they
/// throw std::logic_error, see World::step(). Lifetime: see BodyView.
class KODO_API BodyRef : public BodyView {
public:
    BodyRef(WorldImpl& world, BodyId id); // users write world[id]

    void setPosition(Vec2 position); // m, world: of the shape's frame; a teleport, without velocity
    void setRotation(Rot rotation);  // of the shape's frame, about its origin; a teleport too
    void setVelocity(Vec2 velocity); // m/s, of the centre of mass; refused for a static body
    void setAngularVelocity(Real radiansPerSecond); // counter-clockwise; refused for a static body
    /// Sets the velocities that bring the shape's frame to a pose in one step of dt (s). A
    /// kinematic body arrives, to rounding. The velocities stay set: call it before each step, or
    /// set them to zero.
    void moveTo(Vec2 position, Real dt);
    void moveTo(Vec2 position, Rot rotation, Real dt);

    // Forces act during the next step and are cleared then. Impulses act at once.
    void applyForce(Vec2 force);                 // N, at the centre of mass
    void applyForce(Vec2 force, Vec2 point);     // N, at a world point (m): adds torque
    void applyTorque(Real torque);               // N m, counter-clockwise
    void applyImpulse(Vec2 impulse);             // N s, at the centre of mass
    void applyImpulse(Vec2 impulse, Vec2 point); // N s, at a world point (m)
    void applyAngularImpulse(Real impulse);      // N m s, counter-clockwise

    /// Static sets the velocities to zero. Throws BadDefinition for a dynamic body with a plane.
    void setType(BodyType type);
    void setFlags(Flags flags); // status flags stay as they are
    void setRequired(Flags required);
    void setGroup(std::int32_t group);
    void setUserData(std::uint64_t userData);
    void setMaterial(const Material& material); // of all parts
    /// Changes a part, without `convex`: `Part own = body.part(0); own.filter = ...;
    /// body.setPart(0, own);`. All points keep their velocities. A set mass stays: then the shape
    /// must stay too. Throws std::out_of_range, or BadDefinition for what add() would refuse.
    void setPart(std::size_t index, const Part& part);
    void setLinearDamping(Real perSecond);
    void setAngularDamping(Real perSecond);
    void setGravityScale(Real scale);
    void setContinuousMode(ContinuousMode mode);

    /// Sets the mass (kg), also of a static or kinematic body, for which it counts once the body is
    /// dynamic. All points keep their velocities. World::weld() adds masses, set or not, and
    /// World::unweld() takes them off again. Refused for a body with a plane.
    void setMass(const MassDef& mass);
    void setMass(Real mass) { setMass(MassDef{mass, {}, {}}); }
    /// As it was before setMass(): that of the shapes. Refused for a body with a plane.
    void setMassFromDensity();

    /// Makes the body move as another one, of this or another World, with its own shapes [Thesis06,
    /// 4.1.8]. Copies pose, velocities, type, flags without status, `required`, group, damping,
    /// gravity scale, continuous mode, mass, centre of mass and moment of inertia; the material of
    /// each part, or of the last one for parts that the other has not. User data, forces and joints
    /// stay. Refused where a setter would refuse it; a body that is static, kinematic or locked
    /// then keeps a mass that it cannot copy.
    void copyFrom(const BodyView& other);

    /// Wakes the body, its island, and all that touches it or shares a joint with it; restarts the
    /// count of calm steps of what is awake. Setters do so too.
    void wake();
    /// Puts the island of the body to sleep: with zero velocity, until something wakes it. False,
    /// and nothing changes, if the island has a kNeverSleep, a kinematic body that moves or a
    /// surface speed, or if sleep is left out. Bodies that never took part in a step touch nothing
    /// yet, and wake where they do.
    bool sleep();

private:
    std::uint32_t changing(const char* call) const;

    WorldImpl* world_;
};

} // namespace KODO_PRECISION
} // namespace kodo

/// By slot and generation, as == compares.
template <>
struct std::hash<kodo::BodyId> {
    std::size_t operator()(kodo::BodyId id) const noexcept {
        return kodo::detail::hashOf(id.index, id.generation);
    }
};
