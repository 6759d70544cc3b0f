// SPDX-License-Identifier: MIT
#pragma once

#include <support/random_numbers.hpp>

#include <worlds/recipe.hpp>

#include <cmath>
#include <numbers>

namespace worlds {

inline constexpr double kPi = std::numbers::pi;

/// Builds a scene in double, so that each precision gets the same one.
class OrdinaryBuilder {
public:
    using Vec = kodo::BasicVec2<double>;
    using Index = std::size_t;

    // Categories. Bodies without a mask collide with all others.
    static constexpr kodo::Flags kSolid = 1;
    static constexpr kodo::Flags kMachine = 2;
    static constexpr kodo::Flags kWheel = 4;
    static constexpr kodo::Flags kHull = 8;
    static constexpr kodo::Flags kNothing = 16; // a mask of what does not exist

    explicit OrdinaryBuilder(std::uint64_t seed);

    double between(double low, double high) {
        return static_cast<double>(random_.between(low, high));
    }
    int between(int low, int high) {
        return low + static_cast<int>(random_.below(static_cast<std::size_t>(high - low + 1)));
    }
    bool oneIn(std::size_t count) { return random_.below(count) == 0; }

    /// Of the heaviest body to the lightest one; 1 to 100.
    double ratio() const { return ratio_; }
    Recipe& recipe() { return recipe_; }
    kodo::BodyDef& body(Index index) { return recipe_.bodies[index]; }

    static kodo::Shape box(double width, double height, Vec center = {}, double angle = 0);
    static kodo::Shape disc(double radius);
    /// Several boxes as one shape.
    static kodo::Shape joined(const std::vector<kodo::Shape>& boxes);

    Index add(const kodo::Shape& shape, Vec position, double density = 1, double angle = 0);
    Index addStatic(const kodo::Shape& shape, Vec position, double angle = 0);
    /// A wide floor with its surface at y = 0, and walls at -halfWidth and halfWidth unless it is
    /// 0.
    Index addFloor(double halfWidth = 0);
    /// kg/m^2, for a body `times` as heavy as another one.
    double densityFor(const kodo::Shape& shape, Index other, double times) const;
    double massOf(Index index) const; // kg
    /// Sets the category, and collides with the categories of `mask` alone.
    void filter(Index index, kodo::Flags category, kodo::Flags mask);
    void setMotion(Index index, Vec velocity, double spin = 0);
    void setRestitution(double restitution);

    kodo::RevoluteJoint pin(Index a, Index b, Vec point) const;
    void addPin(Index a, Index b, Vec point) { add(pin(a, b, point)); }
    void addLimitedPin(Index a, Index b, Vec point, double lower, double upper);
    void addMotor(Index a, Index b, Vec point, double speed, double torque);
    void addWeld(Index a, Index b, Vec point);
    /// b slides along the axis (unit, world) through the point.
    kodo::PrismaticJoint slider(Index a, Index b, Vec point, Vec axis) const;
    void addRope(Index a, Index b, Vec from, Vec to); // as long as the points are apart
    void addRod(Index a, Index b, Vec from, Vec to);
    void addSpring(Index a, Index b, Vec from, Vec to, double hertz, double damping);
    void add(const kodo::JointDef& joint) { recipe_.joints.push_back(joint); }

    /// Links from a point (m) of a body, each `length` long (m), in a direction (rad). Returns the
    /// last one; `end` is moved to its far end.
    Index addLinks(Index body, Vec& end, int count, double length, double angle);

private:
    kodo::JointEnds ends(Index a, Index b, Vec onA, Vec onB) const;
    double angleOf(Index index) const;

    support::RandomNumbers random_;
    Recipe recipe_;
    double ratio_ = 1;
    double friction_ = 0.6;
};

inline kodo::BasicVec2<double> atAngle(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

// ordinary_figures.cpp
void throwRagdolls(OrdinaryBuilder& b);
void wedgeRagdolls(OrdinaryBuilder& b);
void addSoftRing(OrdinaryBuilder& b);
void addCradle(OrdinaryBuilder& b);
void addSeeSaw(OrdinaryBuilder& b);
void addDoors(OrdinaryBuilder& b);
void addFlail(OrdinaryBuilder& b);
// ordinary_ropes.cpp
void addBridge(OrdinaryBuilder& b);
void addCrane(OrdinaryBuilder& b);
void addWreckingBall(OrdinaryBuilder& b);
void addRopeLadder(OrdinaryBuilder& b);
void addTrebuchet(OrdinaryBuilder& b);
void addBigWheel(OrdinaryBuilder& b);
// ordinary_machines.cpp
void addCar(OrdinaryBuilder& b);
void addPiston(OrdinaryBuilder& b);
void addTank(OrdinaryBuilder& b);
void addRobotArm(OrdinaryBuilder& b);
void addWalker(OrdinaryBuilder& b);
void addScissorLift(OrdinaryBuilder& b);

} // namespace worlds
