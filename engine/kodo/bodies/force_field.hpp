// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

#include <memory>

namespace kodo::inline KODO_PRECISION {

/// What a field does to one body in one step.
struct Push {
    Vec2 force{};    // N, at the centre of mass
    Real torque = 0; // N m, counter-clockwise
};

/// A rule that pushes bodies: gravity, wind, a magnet. Write your own by deriving from it. It must
/// depend on its arguments alone, since a copy of a World shares it and a replay repeats it.
class ForceField {
public:
    ForceField() = default;
    ForceField(const ForceField&) = delete;
    ForceField& operator=(const ForceField&) = delete;
    virtual ~ForceField() = default;

    /// Asked once a step for every body that can be pushed.
    virtual Push at(const Bodies& bodies, std::uint32_t body) const = 0;
};

/// Force = mass times acceleration, so that everything falls alike.
class Gravity final : public ForceField {
public:
    explicit Gravity(Vec2 acceleration) : acceleration_(acceleration) {} // m/s^2
    Push at(const Bodies& bodies, std::uint32_t body) const override;

private:
    Vec2 acceleration_;
};

/// A field, and the bodies it is for: those whose user flags `which` accepts.
struct FieldEntry {
    std::shared_ptr<const ForceField> field;
    CollisionFilter which{};
};

} // namespace kodo::inline KODO_PRECISION
