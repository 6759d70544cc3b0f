// SPDX-License-Identifier: MIT
#include "bodies/part_list.hpp"

#include <algorithm>
#include <cstddef>
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

} // namespace

std::vector<Part> partsOf(const BodyDef& def) {
    std::vector<Part> parts;
    for (Primitive& primitive : primitivesOf(def.shape)) {
        parts.push_back(Part{std::move(primitive), def.material, def.density});
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

void append(PartList& list, const PartList& added, const Transform& place, const FormerBody& body) {
    const std::size_t before = list.parts.size();
    for (const Part& part : added.parts) {
        list.parts.push_back({moved(part.primitive, place), part.material, part.density});
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
            const auto first = list.parts.begin() + set.firstPart;
            std::vector<Part> rest(first, first + set.partCount);
            const Real ratio = set.mass.mass / massFromDensity(rest).mass;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(part - set.firstPart));
            setMass(taken, scaled(massOf(list.parts[part]), ratio));
            kept.push_back(
                {set.firstPart, set.partCount - 1, scaled(massFromDensity(rest), ratio)});
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
