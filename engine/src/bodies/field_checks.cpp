// SPDX-License-Identifier: MIT
#include "bodies/field_checks.hpp"

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr Real kMostCoefficient = Real(1e18); // products with masses and speeds stay finite

std::optional<Problem> checkDrag(const DragLaw& law, Vec2 air, Real unit) {
    return firstOf({checkRange("field.linear", law.linear, 0, kMostCoefficient),
                    checkRange("field.quadratic", law.quadratic, 0, kMostCoefficient),
                    checkVelocity("field.air", air, unit)});
}

std::optional<Problem> checkWind(const Wind& wind, Real unit) {
    return firstOf({wind.region() ? checkBox("field.region", *wind.region()) : std::nullopt,
                    checkDrag(wind.law(), wind.velocity(), unit)});
}

std::optional<Problem> checkAttractor(const Attractor& attractor, Real unit) {
    return firstOf(
        {problemIf(attractor.law() > Attractor::Law::Linear, "field.law",
                   "must be one of the enumerators of Attractor::Law"),
         checkPosition("field.center", attractor.center(), unit),
         checkRange("field.strength", attractor.strength(), -kMostCoefficient, kMostCoefficient),
         checkRange("field.softening", attractor.softening(), 0, kMostCoefficient)});
}

std::optional<Problem> checkBuoyancy(const Buoyancy& buoyancy, Real unit) {
    return firstOf(
        {checkRange("field.density", buoyancy.fluid().density, 0, kMostCoefficient),
         checkRange("field.drag", buoyancy.fluid().drag, 0, kMostCoefficient),
         checkPosition("field.surface", buoyancy.surface(), unit),
         problemIf(buoyancy.gravity() == Vec2{}, "field.gravity",
                   "must not be zero: its direction defines the upward side of the fluid"),
         checkVelocity("field.gravity", buoyancy.gravity(), unit, "m/s^2")});
}

} // namespace

/// Not by dynamic_cast: a field of a user may be compiled without RTTI.
std::optional<Problem> checkField(const ForceField& field, Real lengthUnit) {
    switch (field.kind()) {
    case FieldKind::Own:
        break;
    case FieldKind::Gravity:
        return checkVelocity("field.acceleration",
                             static_cast<const Gravity&>(field).acceleration(), lengthUnit,
                             "m/s^2");
    case FieldKind::Drag: {
        const auto& drag = static_cast<const Drag&>(field);
        return checkDrag(drag.law(), drag.air(), lengthUnit);
    }
    case FieldKind::Wind:
        return checkWind(static_cast<const Wind&>(field), lengthUnit);
    case FieldKind::Attractor:
        return checkAttractor(static_cast<const Attractor&>(field), lengthUnit);
    case FieldKind::Buoyancy:
        return checkBuoyancy(static_cast<const Buoyancy&>(field), lengthUnit);
    }
    return std::nullopt;
}

} // namespace KODO_PRECISION
} // namespace kodo
