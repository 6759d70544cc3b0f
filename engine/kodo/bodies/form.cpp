// SPDX-License-Identifier: MIT
#include <kodo/bodies/form.hpp>
#include <kodo/shapes/measure.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

namespace kodo::inline KODO_PRECISION {
namespace {

Mass massOf(const Part& part) {
    return std::visit([&](const auto& kind) { return massOf(kind, part.density); }, part.primitive);
}

/// How far (m) a primitive reaches from the origin of its frame, along one of the axes at least.
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

/// checkRange of something that a shape has, told as a sentence about the shape.
std::optional<Problem> checkOfShape(const char* what, Real value, Real low, Real high) {
    auto problem = checkRange("shape", value, low, high);
    if (problem) {
        problem->reason = std::string("its ") + what + " " + problem->reason;
    }
    return problem;
}

} // namespace

std::optional<Problem> checkMass(const Mass& mass) {
    if (auto problem = checkOfShape("mass (kg)", mass.mass, 1 / kHeaviest, kHeaviest)) {
        return problem;
    }
    if (mass.inertia == 0) {
        return std::nullopt; // a particle
    }
    constexpr Real kMost = kHeaviest * kHeaviest;
    return checkOfShape("moment of inertia (kg m^2)", mass.inertia, 1 / kMost, kMost);
}

std::optional<Problem> checkBuild(std::span<const Part> parts, Real lengthUnit) {
    Mass sum;
    for (const Part& part : parts) {
        const Real extent = extentOf(part.primitive);
        if (auto problem = checkOfShape("reach (m)", extent, 0, kFarthest * lengthUnit)) {
            return problem;
        }
        if (needsLock(part.primitive)) {
            continue; // has no mass
        }
        const Mass mass = massOf(part);
        if (auto problem = checkMass(mass)) {
            return problem;
        }
        sum = combine(sum, mass);
    }
    return sum.mass > 0 ? checkMass(sum) : std::nullopt;
}

std::vector<Part> partsOf(const BodyDef& def) {
    std::vector<Part> parts;
    for (Primitive& primitive : primitivesOf(def.shape)) {
        parts.push_back(Part{std::move(primitive), def.material, def.density});
    }
    return parts;
}

std::shared_ptr<const Form> makeForm(std::vector<Part> parts) {
    auto form = std::make_shared<Form>();
    form->mass = massOf(parts[0]);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        form->mass = combine(form->mass, massOf(parts[i]));
    }
    form->inside = std::numeric_limits<Real>::max();
    for (Part& part : parts) {
        part.convex = convexOf(part.primitive, form->mass.center);
        form->reach = std::max(form->reach, part.convex.reach);
        form->swing = std::max(form->swing, part.convex.swing());
        form->inside = std::min(form->inside, part.convex.inside);
        form->area += std::visit([](const auto& kind) { return areaOf(kind); }, part.primitive);
    }
    form->parts = std::move(parts);
    return form;
}

} // namespace kodo::inline KODO_PRECISION
