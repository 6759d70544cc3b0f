// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <utility>

#include "scene_lines.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {

using kodo::Real;
using kodo::Vec2;

namespace {

void writeShape(Lines& lines, const kodo::Circle& circle) {
    lines.add("circle", textOf(circle.radius));
    if (circle.center != Vec2{}) {
        lines.add("at", textOf(circle.center));
    }
}
void writeRadius(Lines& lines, Real radius) {
    if (radius != 0) {
        lines.add("radius", textOf(radius));
    }
}
void writeShape(Lines& lines, const kodo::Box& box) {
    lines.add("box", textOf(Vec2{box.width, box.height}));
    if (box.center != Vec2{}) {
        lines.add("at", textOf(box.center));
    }
    if (box.rotation.c != 1 || box.rotation.s != 0) {
        lines.add("turn", textOf(Vec2{box.rotation.c, box.rotation.s}));
    }
    writeRadius(lines, box.radius);
}
void writeShape(Lines& lines, const kodo::Polygon& polygon) {
    lines.add("polygon", textOf(polygon.corners));
    writeRadius(lines, polygon.radius);
}
void writeShape(Lines& lines, const kodo::Point& point) {
    lines.add("point", textOf(point.position));
}
void writeShape(Lines& lines, const kodo::Segment& segment) {
    lines.add("segment", textOf(std::vector{segment.from, segment.to}));
    lines.flag("one_sided", segment.oneSided);
    writeRadius(lines, segment.radius);
}
void writeShape(Lines& lines, const kodo::Plane& plane) {
    lines.add("plane", textOf(plane.normal));
    lines.add("offset", textOf(plane.offset));
}
void writeShape(Lines& lines, const kodo::Capsule& capsule) {
    lines.add("capsule", textOf(std::vector{capsule.from, capsule.to}));
    lines.add("radius", textOf(capsule.radius));
}

void writeMaterial(Lines& lines, const kodo::Material& material, const kodo::Material& usual) {
    if (material == usual) {
        return;
    }
    lines.add("friction", textOf(material.kineticFriction));
    if (material.staticFriction != material.kineticFriction) {
        lines.add("static_friction", textOf(material.staticFriction));
    }
    lines.add("restitution", textOf(material.restitution));
    if (material.rollingResistance != usual.rollingResistance) {
        lines.add("rolling_resistance", textOf(material.rollingResistance));
    }
    if (material.surfaceSpeed != usual.surfaceSpeed) {
        lines.add("surface_speed", textOf(material.surfaceSpeed));
    }
    if (material.frictionRule != usual.frictionRule) {
        lines.add("friction_rule",
                  inQuotes(kMixRules[static_cast<std::size_t>(material.frictionRule)]));
    }
    if (material.restitutionRule != usual.restitutionRule) {
        lines.add("restitution_rule",
                  inQuotes(kMixRules[static_cast<std::size_t>(material.restitutionRule)]));
    }
}

void writeFilter(Lines& lines, const kodo::CollisionFilter& filter, bool always) {
    if (always || (filter.flags & kodo::kUserFlags) != 0) {
        lines.add("categories", categoryList(filter.flags));
    }
    writeMatch(lines, filter);
    lines.flag("sensor", (filter.flags & kodo::kSensor) != 0);
}

/// The points of a body whose parts are linked segments; empty if they are something else.
std::vector<Vec2> chainOf(const kodo::BodyView& body) {
    std::vector<Vec2> points;
    const auto segmentOf = [&](std::size_t i) {
        return std::get_if<kodo::Segment>(&body.part(i).primitive);
    };
    const kodo::Segment* const first = segmentOf(0);
    if (first == nullptr) {
        return {};
    }
    points.push_back(first->from);
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const kodo::Segment* const one = segmentOf(i);
        if (one == nullptr || one->from != points.back() || one->oneSided != first->oneSided ||
            one->radius != 0 || body.part(i).filter ||
            body.part(i).material != body.part(0).material ||
            body.part(i).density != body.part(0).density) {
            return {};
        }
        points.push_back(one->to);
    }
    return points;
}

void writeParts(Lines& lines, const kodo::BodyView& body) {
    const std::vector<Vec2> chain = chainOf(body);
    if (!chain.empty()) {
        const bool closed = chain.size() > 3 && chain.front() == chain.back();
        lines.add("chain", textOf(closed ? std::vector(chain.begin(), chain.end() - 1) : chain));
        lines.flag("closed", closed);
        lines.flag("one_sided", std::get<kodo::Segment>(body.part(0).primitive).oneSided);
        return;
    }
    const kodo::Part& first = body.part(0);
    if (body.partCount() == 1 && !first.filter) {
        std::visit([&](const auto& shape) { writeShape(lines, shape); }, first.primitive);
        return;
    }
    std::string all;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const kodo::Part& part = body.part(i);
        Lines one(", ");
        std::visit([&](const auto& shape) { writeShape(one, shape); }, part.primitive);
        writeMaterial(one, part.material, first.material);
        if (part.density != first.density) {
            one.add("density", textOf(part.density));
        }
        if (part.filter) {
            writeFilter(one, *part.filter, true);
        }
        all += (all.empty() ? "    { " : ",\n    { ") + one.made() + " }";
    }
    lines.add("parts", "[\n" + all + ",\n]");
}

/// A number some steps of rounding beside it.
Real beside(Real value, int steps) {
    const Real end =
        steps < 0 ? -std::numeric_limits<Real>::infinity() : std::numeric_limits<Real>::infinity();
    for (int i = 0; i < std::abs(steps); ++i) {
        value = std::nextafter(value, end);
    }
    return value;
}

constexpr int kNear = 3; // steps of rounding

/// The definition that makes World::add() give this rotation: it normalises.
kodo::Rot rotationFor(kodo::Rot wanted) {
    for (int ring = 0; ring <= kNear; ++ring) {
        for (int i = -ring; i <= ring; ++i) {
            for (int k = -ring; k <= ring; ++k) {
                const kodo::Rot tried{beside(wanted.c, i), beside(wanted.s, k)};
                const kodo::Rot made = kodo::normalize(tried);
                if (made.c == wanted.c && made.s == wanted.s) {
                    return tried;
                }
            }
        }
    }
    return wanted;
}
/// The same for one coordinate of the position: it adds the way to the centre of mass.
Real positionFor(Real position, Real way, Real center) {
    for (int ring = 0; ring <= kNear; ++ring) {
        for (const int steps : {ring, -ring}) {
            if (beside(position, steps) + way == center) {
                return beside(position, steps);
            }
        }
    }
    return position;
}

void writePlace(Lines& lines, const kodo::BodyView& body) {
    const kodo::Rot rotation = rotationFor(body.rotation());
    const Vec2 way = body.rotation() * body.localCenter();
    lines.add("position", textOf(Vec2{positionFor(body.position().x, way.x, body.center().x),
                                      positionFor(body.position().y, way.y, body.center().y)}));
    if (rotation.c == 1 && rotation.s == 0) {
        return;
    }
    const Real angle = rotation.angle();
    const kodo::Rot made = kodo::normalize(kodo::Rot::fromAngle(angle));
    if (made.c == body.rotation().c && made.s == body.rotation().s) {
        lines.add("angle", textOf(angle));
    } else {
        lines.add("rotation", textOf(Vec2{rotation.c, rotation.s}));
    }
}

} // namespace

void writeMatch(Lines& lines, const kodo::CollisionFilter& filter) {
    for (std::size_t i = 0; i < kMatches.size(); ++i) {
        if ((filter.flags & kodo::kMatchNone << i) != 0) {
            lines.add("collides", inQuotes(kMatches[i]));
        }
    }
    if (filter.required != 0) {
        lines.add("with", categoryList(filter.required));
    }
    if (filter.group != 0) {
        lines.add("group", std::to_string(filter.group));
    }
}

std::string bodyText(const kodo::BodyView& body, const std::string& name) {
    Lines lines("\n");
    lines.add("name", inQuotes(name));
    const bool dynamic = body.type() == kodo::BodyType::Dynamic;
    if (!dynamic) {
        lines.add("type", inQuotes(kBodyTypes[static_cast<std::size_t>(body.type())]));
    }
    writeParts(lines, body);
    writePlace(lines, body);
    kodo::BodyDef def;
    def.velocity = body.velocity();
    def.angularVelocity = body.angularVelocity();
    def.linearDamping = body.linearDamping();
    def.angularDamping = body.angularDamping();
    def.density = body.part(0).density;
    bodyKeys(lines, std::as_const(def));
    lines.take("density", std::as_const(def), &kodo::BodyDef::density);
    if (body.hasSetMass() && dynamic) {
        lines.add("mass", textOf(body.mass()));
        lines.add("mass_center", textOf(body.localCenter()));
        lines.add("inertia", textOf(body.inertia()));
    }
    writeMaterial(lines, body.part(0).material, {});
    if (dynamic) {
        lines.flag("weightless", body.gravityScale() == 0);
        if (body.gravityScale() != 1 && body.gravityScale() != 0) {
            lines.add("gravity_scale", textOf(body.gravityScale()));
        }
        lines.flag("upright", (body.flags() & kodo::kLockRotate) != 0);
        lines.flag("lock_move", (body.flags() & kodo::kLockMove) != 0);
    }
    if (body.continuousMode() != kodo::ContinuousMode::All) {
        lines.add("continuous_mode",
                  inQuotes(kContinuousModes[static_cast<std::size_t>(body.continuousMode())]));
    }
    lines.flag("never_sleep", (body.flags() & kodo::kNeverSleep) != 0);
    lines.flag("disabled", (body.flags() & kodo::kDisabled) != 0);
    writeFilter(lines, {body.flags(), body.required(), body.group()}, false);
    return "\n[[body]]\n" + lines.made() + "\n";
}

} // namespace KODO_PRECISION
} // namespace scene_files
