// SPDX-License-Identifier: MIT
#include "bodies/part_list.hpp"

#include "bodies/body_checks.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Mass massOf(const Part& part) {
    return std::visit([&](const auto& kind) { return massOf(kind, part.density); }, part.primitive);
}

Mass scaled(const Mass& mass, Real by) {
    return {by * mass.mass, mass.center, by * mass.inertia};
}

/// A share of a set mass, with at least the least moment of inertia that a definition may set.
Mass withFirmRim(Mass share, std::span<const Part> parts) {
    const Real rim = rimOf(parts, share.center);
    share.inertia = std::max(share.inertia, 2 * kMinInertiaShare * share.mass * rim * rim);
    return share;
}

/// Divides a set mass between one of its parts and the others. Mass: by density. Both centres are
/// as far from those of the shapes as that of the set mass, so the common centre stays. What the
/// moment of inertia exceeds that of the shapes by is divided in the proportion of theirs. So both
/// move on as the whole body does, with its momenta and its energy.
std::pair<Mass, Mass> divide(const Mass& set, std::span<const Part> parts, std::size_t part) {
    const Mass whole = massFromDensity(parts);
    const Real ratio = set.mass / whole.mass;
    std::vector<Part> others(parts.begin(), parts.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(part));
    Mass taken = scaled(massOf(parts[part]), ratio);
    Mass rest = scaled(massFromDensity(others), ratio);

    const Real excess = set.inertia - ratio * whole.inertia;
    if (excess > 0) {
        const Real inertias = taken.inertia + rest.inertia; // 0: two particles
        const Real share = inertias > 0 ? taken.inertia / inertias : taken.mass / set.mass;
        taken.inertia += share * excess;
        rest.inertia += (1 - share) * excess;
    }
    const Vec2 shift = set.center - whole.center;
    // A weld turns the centre with the parts; rounding errors are no shift.
    const Real rounding = 32 * std::numeric_limits<Real>::epsilon() *
                          (length(whole.center) + rimOf(parts, whole.center));
    if (lengthSquared(shift) > rounding * rounding) {
        taken.center += shift;
        rest.center += shift;
        taken = withFirmRim(taken, parts.subspan(part, 1));
        rest = withFirmRim(rest, others);
    }
    return {taken, rest};
}

} // namespace

Real rimOf(std::span<const Part> parts, Vec2 center) {
    Real rim = 0;
    for (const Part& part : parts) {
        rim = std::max(rim, convexShapeOf(part.primitive, center).boundingRadius);
    }
    return rim;
}

std::vector<Part> partsOf(const BodyDef& def) {
    std::vector<Part> parts;
    for (Primitive& primitive : primitivesOf(def.shape)) {
        parts.push_back(Part{std::move(primitive), def.material, def.density});
    }
    if (const auto* chain = std::get_if<Chain>(&def.shape)) {
        for (std::size_t i = 0; i < chain->materials.size(); ++i) {
            parts[i].material = chain->materials[i];
        }
    }
    return parts;
}

PartList partListOf(const BodyDef& def) {
    PartList list{partsOf(def), {}, {}};
    if (def.mass) {
        setMass(list, massOf(*def.mass, massFromDensity(list.parts)));
    }
    return list;
}

Mass massFromDensity(std::span<const Part> parts) {
    Mass sum = massOf(parts[0]);
    for (const Part& part : parts.subspan(1)) {
        sum = combine(sum, massOf(part));
    }
    return sum;
}

Mass massOf(const PartList& list) {
    Mass sum;
    auto set = list.setMasses.begin();
    for (std::size_t i = 0; i < list.parts.size();) {
        const bool isSet = set != list.setMasses.end() && set->firstPart == i;
        const Mass mass = isSet ? set->mass : massOf(list.parts[i]);
        sum = i == 0 ? mass : combine(sum, mass);
        i += isSet ? (set++)->partCount : 1u;
    }
    return sum;
}

Mass massOf(const MassDef& def, const Mass& fromDensity) {
    const Mass whole = scaled(fromDensity, def.mass / fromDensity.mass);
    return {def.mass, def.center.value_or(whole.center), def.inertia.value_or(whole.inertia)};
}

void setMass(PartList& list, const Mass& mass) {
    list.setMasses = {{0, static_cast<std::uint32_t>(list.parts.size()), mass}};
}

FormerBody formerBody(const PartList& list, std::size_t part) {
    return list.former.empty() ? FormerBody{} : list.former[part];
}

BodyDef definitionOf(const FormerBody& body) {
    BodyDef def;
    def.type = typeOf(body.filter.flags);
    def.flags = body.filter.flags;
    def.required = body.filter.required;
    def.group = body.filter.group;
    def.userData = body.userData;
    def.linearDamping = body.rules.linearDamping;
    def.angularDamping = body.rules.angularDamping;
    def.gravityScale = body.rules.gravityScale;
    def.continuousMode = body.rules.continuousMode;
    return def;
}

void append(PartList& list, const PartList& added, const Transform& place, const FormerBody& body) {
    const std::size_t before = list.parts.size();
    for (const Part& part : added.parts) {
        list.parts.push_back(part);
        list.parts.back().primitive = moved(part.primitive, place);
    }
    for (SetMass set : added.setMasses) {
        set.firstPart += static_cast<std::uint32_t>(before);
        set.mass.center = place * set.mass.center;
        list.setMasses.push_back(set);
    }
    list.former.resize(before);
    for (std::size_t i = 0; i < added.parts.size(); ++i) {
        const FormerBody own = formerBody(added, i);
        list.former.push_back(own.known ? own : body);
    }
}

PartList takePart(PartList& list, std::size_t part) {
    PartList taken{{list.parts[part]}, {}, {}};
    std::vector<SetMass> kept;
    for (const SetMass& set : list.setMasses) {
        if (part < set.firstPart) {
            kept.push_back({set.firstPart - 1, set.partCount, set.mass});
        } else if (part - set.firstPart >= set.partCount) {
            kept.push_back(set);
        } else if (set.partCount == 1) {
            setMass(taken, set.mass);
        } else {
            const std::span<const Part> all(list.parts);
            const auto [own, rest] =
                divide(set.mass, all.subspan(set.firstPart, set.partCount), part - set.firstPart);
            setMass(taken, own);
            kept.push_back({set.firstPart, set.partCount - 1, rest});
        }
    }
    list.setMasses = std::move(kept);
    list.parts.erase(list.parts.begin() + static_cast<std::ptrdiff_t>(part));
    if (!list.former.empty()) {
        list.former.erase(list.former.begin() + static_cast<std::ptrdiff_t>(part));
    }
    return taken;
}

} // namespace KODO_PRECISION
} // namespace kodo
