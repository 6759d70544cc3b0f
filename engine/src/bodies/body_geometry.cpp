// SPDX-License-Identifier: MIT
#include "bodies/body_geometry.hpp"

#include <kodo/measure.hpp>

#include "base/checks.hpp"
#include "bodies/line_links.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Largest absolute coordinate (m) of a primitive in its frame; of a plane, its distance from the
/// origin.
Real extentOf(const Primitive& primitive) {
    return std::visit(
        [](const auto& kind) -> Real {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, Plane>) {
                return std::abs(kind.offset);
            } else {
                const Aabb box = boundsOf(kind);
                return std::max({box.upper.x, box.upper.y, -box.lower.x, -box.lower.y});
            }
        },
        primitive);
}

bool hasPlane(std::span<const Part> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [](const Part& part) { return needsLock(part.primitive); });
}

/// checkRange() with a message about a property of the shape.
std::optional<Problem> checkOfShape(const char* what, Real value, Real low, Real high,
                                    const char* unit) {
    auto problem = checkRange("shape", value, low, high, unit);
    if (problem) {
        problem->reason = std::string("its ") + what + " " + problem->reason;
    }
    return problem;
}

} // namespace

std::optional<Problem> checkRules(const Part& part) {
    return firstOf({check(part.material), checkDensity(part.density),
                    part.filter ? checkPartFilter(*part.filter) : std::nullopt});
}

std::optional<Problem> checkMass(const Mass& mass) {
    if (auto problem = checkOfShape("mass", mass.mass, 1 / kMaxMass, kMaxMass, "kg")) {
        return problem;
    }
    if (mass.inertia == 0) {
        return std::nullopt; // a particle
    }
    constexpr Real kMost = kMaxMass * kMaxMass;
    return checkOfShape("moment of inertia", mass.inertia, 1 / kMost, kMost, "kg m^2");
}

std::optional<Problem> checkExtent(const Primitive& primitive, Real lengthUnit) {
    const Real most = kMaxCoordinate * lengthUnit;
    const Real extent = extentOf(primitive);
    if (!(extent <= most)) { // also for NaN
        return Problem{"shape", "must lie within " + textOf(most) +
                                    " m of the origin of its frame, but reaches to " +
                                    textOf(extent) +
                                    ": a larger WorldDef::lengthUnit permits more"};
    }
    return std::nullopt;
}

// Largest inverse mass (1/kg) that a set mass may give the rim of a body: r^2 / I.
constexpr Real kFirm = 1024 * kMaxMass;

bool hasFirmRim(const BodyGeometry& geometry) {
    const Real rim = geometry.boundingRadius;
    return geometry.setMasses.empty() || geometry.mass.inertia == 0 || hasPlane(geometry.parts) ||
           rim * rim <= kFirm * geometry.mass.inertia;
}

std::optional<Problem> checkHasMass(std::span<const Part> parts) {
    return problemIf(hasPlane(parts), "mass",
                     "must not be set for a body with a plane, which has no mass");
}

std::optional<Problem> checkMassDef(const MassDef& def, std::span<const Part> parts,
                                    Real lengthUnit, Real leastShare) {
    if (auto problem = checkHasMass(parts)) {
        return problem;
    }
    if (auto problem = checkRange("mass", def.mass, 1 / kMaxMass, kMaxMass, "kg")) {
        problem->reason +=
            def.mass == 0 ? ": BodyType::Static makes a body immovable, at any mass" : "";
        return problem;
    }
    if (def.center) {
        if (auto problem = checkPosition("mass.center", *def.center, lengthUnit)) {
            return problem;
        }
    }
    const Mass fromDensity = massFromDensity(parts);
    const Mass mass = massOf(def, fromDensity);
    if (mass.inertia == 0 && !def.inertia && mass.center != fromDensity.center) {
        return Problem{"mass.center", "must be the point of a particle, which has no lever arm: "
                                      "set an inertia too, or leave it out"};
    }
    constexpr Real kMost = kMaxMass * kMaxMass;
    const Real rim = rimOf(parts, mass.center);
    Real least = std::max(1 / kMost, 2 * rim * rim / kFirm); // twice: for rounding
    if (def.center || def.inertia) {
        least = std::max(least, leastShare * def.mass * rim * rim);
    }
    if (def.inertia) {
        auto problem = checkRange("mass.inertia", *def.inertia, least, kMost, "kg m^2");
        if (problem && *def.inertia == 0) {
            problem->reason += ": kLockRotate stops the rotation of a body";
        } else if (problem && *def.inertia < least) {
            problem->reason += ": see kMinInertiaShare; leave it out to get that of the shapes";
        }
        return problem;
    }
    auto problem = mass.inertia == 0 ? std::nullopt // a particle
                                     : checkRange("mass", mass.inertia, least, kMost, "kg m^2");
    if (problem) {
        problem->reason = "gives a moment of inertia that " + problem->reason + ": set it too";
    }
    return problem;
}

std::optional<Problem> checkParts(std::span<const Part> parts, Real lengthUnit) {
    Mass sum;
    for (const Part& part : parts) {
        if (auto problem = checkExtent(part.primitive, lengthUnit)) {
            return problem;
        }
        if (needsLock(part.primitive)) {
            continue; // has no mass
        }
        const Mass mass = massFromDensity({&part, 1});
        if (auto problem = checkMass(mass)) {
            return problem;
        }
        sum = combine(sum, mass);
    }
    return sum.mass > 0 ? checkMass(sum) : std::nullopt;
}

std::shared_ptr<const BodyGeometry> makeGeometry(PartList list) {
    auto geometry = std::make_shared<BodyGeometry>();
    static_cast<PartList&>(*geometry) = std::move(list);
    std::vector<Part>& parts = geometry->parts;
    geometry->mass = massOf(*geometry);
    geometry->coreRadius = std::numeric_limits<Real>::max();
    for (Part& part : parts) {
        part.convex = convexShapeOf(part.primitive, geometry->mass.center);
        geometry->boundingRadius = std::max(geometry->boundingRadius, part.convex.boundingRadius);
        geometry->rotationReach = std::max(geometry->rotationReach, part.convex.rotationReach());
        geometry->coreRadius = std::min(geometry->coreRadius, part.convex.coreRadius);
        geometry->filters = geometry->filters || part.filter.has_value();
        geometry->area += std::visit([](const auto& kind) { return areaOf(kind); }, part.primitive);
    }
    linkLines(parts);
    return geometry;
}

} // namespace KODO_PRECISION
} // namespace kodo
