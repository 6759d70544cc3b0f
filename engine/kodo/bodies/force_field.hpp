// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

#include <memory>

namespace kodo::inline KODO_PRECISION {

/// What a field does to one body in one step. A force that brakes says so in `drag`, and is then
/// taken implicitly, so that it can slow a body down but never turn it back, however strong it is
/// and however long the step:
///
///   a = F / (m + dt drag),   alpha = T / (I + dt spinDrag)
///
/// which is one Euler step backwards in time for F(v) = F - drag (v - v_now).
struct Push {
    Vec2 force{};      // N, at the centre of mass, at the velocity of now
    Real torque = 0;   // N m, counter-clockwise
    Real drag = 0;     // N s/m, >= 0; by how much the force falls when the velocity rises
    Real spinDrag = 0; // N m s, >= 0; the same for torque and spin
};

/// A rule that pushes bodies: gravity, wind, a magnet. Write your own by deriving from it. It must
/// depend on its arguments alone, since a copy of a World shares it, a replay repeats it, and the
/// threads that help a step ask it at once; and it must not call the World that asks it.
class ForceField {
public:
    ForceField() = default;
    ForceField(const ForceField&) = delete;
    ForceField& operator=(const ForceField&) = delete;
    virtual ~ForceField() = default;

    /// Asked once a step of dt (s), before it, for every body that takes part and can be pushed,
    /// but a steady field not again until something has changed. A force that depends on the place
    /// of the body should be found at midStep. It must not throw: that would leave a step half
    /// done. A force that is no finite number stops the body for good instead; see
    /// World::frozenBodies. Bodies::acceleration is what is being found: it tells nothing yet.
    virtual Push at(const Bodies& bodies, std::uint32_t body, Real dt) const = 0;

    /// Does it push a body alike in each step, without drag, wherever that is and whatever it does,
    /// as long as its form and flags stay? Then it is not asked again until something has changed.
    virtual bool steady() const { return false; }
};

/// Where a body will be half way through a step of dt if nothing pushes it. A force found there
/// makes the step a leapfrog, x + v h / 2, v + h a, x + v h / 2: an orbit neither winds up nor out,
/// as it does with Euler's method [Thesis06, fig. 4.6].
Transform midStep(const Bodies& bodies, std::uint32_t body, Real dt);

/// Force = mass times acceleration, so that everything falls alike.
class Gravity final : public ForceField {
public:
    explicit Gravity(Vec2 acceleration) : acceleration_(acceleration) {} // m/s^2
    Push at(const Bodies& bodies, std::uint32_t body, Real dt) const override;
    bool steady() const override { return true; }
    Vec2 acceleration() const { return acceleration_; }

private:
    Vec2 acceleration_;
};

/// A field, and the bodies it is for: those whose user flags `which` accepts.
struct FieldEntry {
    std::shared_ptr<const ForceField> field;
    CollisionFilter which{};
};

} // namespace kodo::inline KODO_PRECISION
