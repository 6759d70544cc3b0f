// SPDX-License-Identifier: MIT
#include <kodo/bodies/form.hpp>
#include <kodo/shapes/measure.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

Mass massOf(const Part& part) {
    return std::visit([&](const auto& kind) { return massOf(kind, part.density); }, part.primitive);
}

} // namespace

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
        form->inside = std::min(form->inside, part.convex.inside);
        form->area += std::visit([](const auto& kind) { return areaOf(kind); }, part.primitive);
    }
    form->parts = std::move(parts);
    return form;
}

} // namespace kodo::inline KODO_PRECISION
