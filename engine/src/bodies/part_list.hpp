// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>
#include <kodo/measure.hpp>

#include "base/state_stream.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// A mass that was set, in place of the masses from density of consecutive parts.
struct SetMass {
    std::uint32_t firstPart = 0;
    std::uint32_t partCount = 0;
    Mass mass; // centre in the frame of the body's shape
};

/// How a body moves by itself; see BodyDef.
struct MotionRules {
    Real linearDamping = 0;  // 1/s
    Real angularDamping = 0; // 1/s
    Real gravityScale = 1;
    ContinuousMode continuousMode = ContinuousMode::All;
    friend bool operator==(const MotionRules&, const MotionRules&) = default;
};

/// What a part was as a body of its own, before World::weld(): it becomes that again when it is
/// taken off.
struct FormerBody {
    bool known = false;     // false: the part never was a body of its own
    CollisionFilter filter; // flags with the type bits, without status
    std::uint64_t userData = 0;
    MotionRules rules;
};

/// Checks material, density and filter of a part.
std::optional<Problem> checkRules(const Part& part);

/// What a definition says of a part.
void visitState(StateStream& stream, Part& part);

/// The parts of a body, and what weld() and unweld() keep of them.
struct PartList {
    std::vector<Part> parts;
    std::vector<SetMass> setMasses; // in the order of their parts, which they do not share
    std::vector<FormerBody> former; // by part; empty: none is known

    void visitState(StateStream& stream);
};

/// The parts of a valid definition: one for each primitive of its shape.
std::vector<Part> partsOf(const BodyDef& def);
/// The same with the mass that the definition sets.
PartList partListOf(const BodyDef& def);

/// Largest distance (m) of a point of the parts from a centre in their frame.
Real rimOf(std::span<const Part> parts, Vec2 center);

/// Mass of parts from their densities.
Mass massFromDensity(std::span<const Part> parts);
/// Mass of a list, with the masses that were set.
Mass massOf(const PartList& list);
/// The mass that a definition gives to parts with that mass from density.
Mass massOf(const MassDef& def, const Mass& fromDensity);
/// Replaces all masses of a list by one.
void setMass(PartList& list, const Mass& mass);

/// What a part was, or nothing known.
FormerBody formerBody(const PartList& list, std::size_t part);
/// Its type, flags, filter, user data and rules, as those of a body to be added.
BodyDef definitionOf(const FormerBody& body);
/// The rules of a definition.
inline MotionRules rulesOf(const BodyDef& def) {
    return {def.linearDamping, def.angularDamping, def.gravityScale, def.continuousMode};
}
/// Appends the parts of a body at their place in the frame of the list. Parts that were bodies
/// before stay what they were; the others become parts of `body`.
void append(PartList& list, const PartList& added, const Transform& place, const FormerBody& body);
/// Removes a part and returns it. A mass that was set for this part alone goes with it. One that
/// was set for several parts is divided in the proportion of their masses from density; the common
/// centre stays, and so does the moment of inertia about it if the shapes have no larger one.
PartList takePart(PartList& list, std::size_t part);

} // namespace KODO_PRECISION
} // namespace kodo
