// SPDX-License-Identifier: MIT
#include <kodo/bodies/form.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

Mass massOf(const Part& part) {
    return std::visit([&](const auto& kind) { return massOf(kind, part.density); }, part.primitive);
}

Circle movedShape(const Circle& circle, const Transform& t) {
    return {circle.radius, t * circle.center};
}

Box movedShape(const Box& box, const Transform& t) {
    return {box.width, box.height, t * box.center, normalize(t.rotation * box.rotation)};
}

Polygon movedShape(const Polygon& polygon, const Transform& t) {
    Polygon result = polygon;
    for (Vec2& corner : result.corners) {
        corner = t * corner;
    }
    return result;
}

} // namespace

std::vector<Part> partsOf(const BodyDef& def) {
    std::vector<Part> parts;
    const auto add = [&](const Primitive& primitive) {
        parts.push_back(Part{primitive, def.material, def.density});
    };
    if (const auto* compound = std::get_if<Compound>(&def.shape)) {
        for (const Primitive& primitive : compound->parts) {
            add(primitive);
        }
    } else if (const auto* circle = std::get_if<Circle>(&def.shape)) {
        add(*circle);
    } else if (const auto* box = std::get_if<Box>(&def.shape)) {
        add(*box);
    } else if (const auto* polygon = std::get_if<Polygon>(&def.shape)) {
        add(*polygon);
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
        form->area += massOf(part).mass / part.density;
    }
    form->parts = std::move(parts);
    return form;
}

Primitive moved(const Primitive& primitive, const Transform& transform) {
    return std::visit([&](const auto& kind) { return Primitive(movedShape(kind, transform)); },
                      primitive);
}

} // namespace kodo::inline KODO_PRECISION
