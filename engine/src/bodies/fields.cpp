// SPDX-License-Identifier: MIT
#include <kodo/mass.hpp>

#include "bodies/field_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Submerged submergedCircle(const ConvexShape& circle, const Transform& t, Vec2 surface, Vec2 up) {
    const Vec2 center = t * circle.vertices[0];
    const Real r = circle.radius;
    if (r == 0) {
        return {};
    }
    const Real cosine = std::clamp(dot(up, center - surface) / r, Real(-1), Real(1));
    const Real sine = std::sqrt(1 - cosine * cosine);
    const Real area = r * r * (atan2(sine, cosine) - sine * cosine);
    if (!(area > 0)) {
        return {};
    }
    const Real chord = r * sine;
    const Real depth = std::min(2 * chord * chord * chord / (3 * area), r);
    return {area, center - depth * up};
}

/// Area and centroid of a polygon as a triangle fan, added corner by corner.
class FanSum {
public:
    void add(Vec2 corner) {
        if (count_++ == 0) {
            first_ = corner;
        }
        const Vec2 arm = corner - first_;
        const Real twice = cross(last_, arm);
        twiceArea_ += twice;
        moment_ += twice * (last_ + arm);
        last_ = arm;
    }
    /// The part of a circle between its chord and its arc from u to v (unit, counter-clockwise, at
    /// most half a turn), around a centre. Area and moment are those of the sector without the
    /// triangle to the centre.
    void addCap(Vec2 center, Real radius, Vec2 u, Vec2 v) {
        const Mass sector = massOfSector(u, v, radius, Real(1));
        const Real triangle = radius * radius * cross(u, v) / 2;
        const Vec2 fromCenter = sector.mass * sector.center - triangle * radius / 3 * (u + v);
        const Real area = sector.mass - triangle;
        twiceArea_ += 2 * area;
        moment_ += 6 * (area * (center - first_) + fromCenter);
    }
    Submerged result() const {
        if (!(twiceArea_ > 0)) {
            return {};
        }
        return {twiceArea_ / 2, first_ + moment_ / (3 * twiceArea_)};
    }

private:
    Vec2 first_;
    Vec2 last_;
    Vec2 moment_;
    Real twiceArea_ = 0;
    int count_ = 0;
};

/// The surface of a fluid: a point of it and its upward normal.
struct Surface {
    Vec2 point;
    Vec2 up;

    Real heightOf(Vec2 p) const { return dot(up, p - point); }
};

/// The part of an arc under a surface: the directions in which the circle goes down into the water
/// and comes out of it, counter-clockwise. A convex outline crosses the surface only twice.
void addArc(FanSum& sum, Vec2 center, Real radius, Vec2 from, Vec2 to, const Surface& surface) {
    const Vec2 up = surface.up;
    const Real height = surface.heightOf(center) / radius; // in radii
    const auto addPiece = [&](Vec2 u, Vec2 v) {
        sum.add(center + radius * u);
        sum.add(center + radius * v);
        sum.addCap(center, radius, u, v);
    };
    const bool wetFrom = height + dot(up, from) < 0;
    const bool wetTo = height + dot(up, to) < 0;
    const Real half = std::sqrt(std::max(1 - height * height, Real(0)));
    const Vec2 in = -height * up + half * perp(up);
    const Vec2 out = -height * up - half * perp(up);
    const auto isOnArc = [&](Vec2 u) { return cross(from, u) >= 0 && cross(u, to) >= 0; };
    const bool both = half > 0 && isOnArc(in) && isOnArc(out);
    const bool inFirst = dot(from, in) > dot(from, out);
    if (wetFrom && wetTo && !(both && !inFirst)) {
        addPiece(from, to);
    } else if (!wetFrom && !wetTo && both && inFirst) {
        addPiece(in, out);
    } else {
        if (wetFrom) {
            addPiece(from, out);
        }
        if (wetTo) {
            addPiece(in, to);
        }
    }
}

/// Clips while summing [Ericson05, 8.3.4], so that no corner is stored.
Submerged submergedPolygon(const ConvexShape& polygon, const Transform& t, const Surface& surface) {
    FanSum sum;
    const std::size_t n = polygon.vertices.size();
    const Real radius = polygon.radius;
    Vec2 before = t.rotation * polygon.normals[n - 1];
    Vec2 from = t * polygon.vertices.back() + radius * before;
    Real heightFrom = surface.heightOf(from);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 vertex = t * polygon.vertices[i];
        const Vec2 to = vertex + radius * before;
        const Real heightTo = surface.heightOf(to);
        if ((heightFrom < 0) != (heightTo < 0)) {
            sum.add(from + (heightFrom / (heightFrom - heightTo)) * (to - from));
        }
        const Vec2 normal = t.rotation * polygon.normals[i];
        if (radius > 0) {
            addArc(sum, vertex, radius, before, normal, surface);
        } else if (heightTo < 0) {
            sum.add(to);
        }
        before = normal;
        from = vertex + radius * normal;
        heightFrom = surface.heightOf(from);
    }
    return sum.result();
}

/// A field as the arguments of its constructor, returned by the given functions.
template <typename Field, typename... Values>
void visitField(StateStream& stream, std::shared_ptr<const ForceField>& field,
                Values (Field::*... get)() const) {
    std::tuple<Values...> values;
    if (!stream.reads()) {
        const auto& own = static_cast<const Field&>(*field);
        values = {(own.*get)()...};
    }
    std::apply([&](auto&... each) { stream(each...); }, values);
    if (stream.reads()) {
        field = std::apply(
            [](const auto&... value) { return std::make_shared<const Field>(value...); }, values);
    }
}

} // namespace

FieldForce Drag::at(const BodyView& body, Real) const {
    const Real width = 2 * std::sqrt(body.area() / std::numbers::pi_v<Real>);
    const Real radius = width / 2;
    const Vec2 u = body.velocity() - air_;
    const Real w = body.angularVelocity();
    FieldForce push;
    push.drag = (law_.linear + law_.quadratic * length(u)) * width;
    push.spinDrag = (law_.linear + law_.quadratic * radius * std::abs(w)) * width * radius * radius;
    push.force = -push.drag * u;
    push.torque = -push.spinDrag * w;
    return push;
}

FieldForce Wind::at(const BodyView& body, Real dt) const {
    if (region_ && !region_->contains(body.center())) {
        return {};
    }
    return drag_.at(body, dt);
}

FieldForce Attractor::at(const BodyView& body, Real dt) const {
    const Vec2 d = center_ - body.center() - dt / 2 * body.velocity();
    const Real mass = body.mass();
    if (law_ == Law::Linear) {
        return {mass * strength_ * d};
    }
    const Real distance = std::sqrt(lengthSquared(d) + softening_ * softening_);
    if (distance == 0) { // at the centre, without softening
        return {};
    }
    return {mass * strength_ / (distance * distance * distance) * d};
}

Submerged submerged(const ConvexShape& convex, const Transform& t, Vec2 surface, Vec2 up) {
    return convex.isRound() ? submergedCircle(convex, t, surface, up)
                            : submergedPolygon(convex, t, {surface, up});
}

FieldForce Buoyancy::at(const BodyView& body, Real dt) const {
    const Transform pose = midStep(body, dt);
    FieldForce push;
    const Vec2 velocity = body.velocity();
    const Real spin = body.angularVelocity();
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const Submerged wet = submerged(body.part(i).convex, pose, surface_, up_);
        if (wet.area == 0) {
            continue;
        }
        const Vec2 arm = wet.centroid - pose.position;
        const Real drag = fluid_.drag * wet.area;
        const Vec2 force =
            -(fluid_.density * wet.area) * gravity_ - drag * (velocity + cross(spin, arm));
        // Rotation about the centroid is damped as for a disc of the same area.
        const Real spinDrag = drag * wet.area / (2 * std::numbers::pi_v<Real>);
        push.force += force;
        push.torque += cross(arm, force) - spinDrag * spin;
        push.drag += drag;
        push.spinDrag += spinDrag + drag * lengthSquared(arm);
    }
    return push;
}

void visitState(StateStream& stream, FieldEntry& entry, OwnFields& ownFields) {
    auto& [field, which] = entry;
    FieldKind kind = field ? field->kind() : FieldKind::Own;
    stream(kind);
    switch (kind) {
    case FieldKind::Own:
        if (stream.reads()) {
            require(!ownFields.empty(),
                    "fewer user-defined force fields were given than the snapshot needs: give them "
                    "to fromBytes(), in the order of World::fields()");
            require(ownFields.front() != nullptr, "a given force field is null");
            field = ownFields.front();
            ownFields = ownFields.subspan(1);
        }
        break;
    case FieldKind::Gravity:
        visitField(stream, field, &Gravity::acceleration);
        break;
    case FieldKind::Drag:
        visitField(stream, field, &Drag::law, &Drag::air);
        break;
    case FieldKind::Wind:
        visitField(stream, field, &Wind::law, &Wind::velocity, &Wind::region);
        break;
    case FieldKind::Attractor:
        visitField(stream, field, &Attractor::law, &Attractor::center, &Attractor::strength,
                   &Attractor::softening);
        break;
    case FieldKind::Buoyancy:
        visitField(stream, field, &Buoyancy::fluid, &Buoyancy::surface, &Buoyancy::gravity);
        break;
    default:
        require(false, "the kind of a force field is unknown");
    }
    stream(which);
}

} // namespace KODO_PRECISION
} // namespace kodo
