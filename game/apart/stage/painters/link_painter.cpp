// SPDX-License-Identifier: MIT
// Joints of a level.
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::size_t kRopeParts = 8;
constexpr std::size_t kCoils = 14; // straight pieces of a spring

/// The ends of a joint in the picture.
struct Ends {
    Vec2 a;
    Vec2 b;
};

Vec2 shownAt(const Moment& moment, kodo::BodyId id, Vec2 anchor) {
    const kodo::BodyView body = moment.game.world()[id];
    return moment.placeOf(id) * toLocal(body.massFrame(), body.transform() * anchor);
}

Ends endsOf(const Moment& moment, const kodo::JointEnds& ends) {
    return {shownAt(moment, ends.a, ends.anchorA), shownAt(moment, ends.b, ends.anchorB)};
}

void paintEnd(Canvas& canvas, Vec2 place, Real radius) {
    canvas.disc(place, radius, lighter(palette::kMachine, 0.4f), darker(palette::kMachine, 0.35f));
    canvas.ring(place, radius, Real(0.04), palette::kInk);
}

/// A slack rope sags as a parabola of its length: length = d + 8 sag^2 / (3 d).
void paintRope(Canvas& canvas, const Ends& ends, Real length, Color color) {
    const Vec2 way = ends.b - ends.a;
    const Real distance = std::max(kodo::length(way), Real(0.05));
    const Real sag = std::sqrt(std::max(length - distance, Real(0)) * distance * 3 / 8);
    std::array<Vec2, kRopeParts + 1> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Real t = static_cast<Real>(i) / kRopeParts;
        places[i] = ends.a + t * way - Vec2{0, 4 * t * (1 - t) * sag};
    }
    canvas.ribbon(places, Real(0.14), palette::kInk);
    canvas.ribbon(places, Real(0.08), color);
    paintEnd(canvas, ends.a, Real(0.11));
    paintEnd(canvas, ends.b, Real(0.11));
}

void paintSpring(Canvas& canvas, const Ends& ends, Color color) {
    const Vec2 way = ends.b - ends.a;
    const Vec2 side = Real(0.22) * normalize(perp(way));
    std::array<Vec2, kCoils + 1> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Real t = static_cast<Real>(i) / kCoils;
        const bool end = i == 0 || i == kCoils;
        const Real wave = end ? Real(0) : i % 2 == 0 ? Real(1) : Real(-1);
        places[i] = ends.a + t * way + wave * side;
    }
    canvas.ribbon(places, Real(0.08), color);
    paintEnd(canvas, ends.a, Real(0.11));
    paintEnd(canvas, ends.b, Real(0.11));
}

void paintLink(Canvas& canvas, const Moment& moment, const Link& link) {
    const kodo::JointDef& def = moment.game.world().joint(link.joint);
    const Color rope{222, 196, 150};
    if (const auto* line = std::get_if<kodo::DistanceJoint>(&def)) {
        const Ends ends = endsOf(moment, line->ends);
        if (link.kind == LinkKind::Rope) {
            paintRope(canvas, ends, line->limits ? line->limits->upper : 0, rope);
        } else {
            paintSpring(canvas, ends, lighter(palette::kMachine, 0.2f));
        }
    } else if (const auto* slider = std::get_if<kodo::PrismaticJoint>(&def)) {
        const Ends ends = endsOf(moment, slider->ends);
        const Vec2 axis = moment.placeOf(slider->ends.a).rotation * slider->axis;
        const kodo::Range range = slider->limits.value_or(kodo::Range{-24, 24});
        canvas.line(ends.a + range.lower * axis, ends.a + range.upper * axis, Real(0.1),
                    faded(palette::kMachine, 0.6f));
        paintEnd(canvas, ends.b, Real(0.12));
    } else if (const auto* pin = std::get_if<kodo::RevoluteJoint>(&def)) {
        const Vec2 place = shownAt(moment, pin->ends.b, pin->ends.anchorB);
        const kodo::BodyView held = moment.game.world()[pin->ends.b];
        if (!held.contains(held.transform() * pin->ends.anchorB)) { // on an arm
            const Vec2 middle = moment.placeOf(pin->ends.b).position;
            canvas.line(place, middle, Real(0.2), palette::kInk);
            canvas.line(place, middle, Real(0.13), palette::kMachine);
        }
        paintEnd(canvas, place, Real(0.13));
        if (link.kind == LinkKind::Motor) {
            const Vec2 along = moment.placeOf(pin->ends.b).rotation * Vec2{Real(0.21), 0};
            canvas.disc(place, Real(0.3), lighter(palette::kAccent, 0.35f),
                        darker(palette::kAccent, 0.25f));
            canvas.line(place - along, place + along, Real(0.1), palette::kInk);
        }
    }
}

} // namespace

void paintLinks(Canvas& canvas, const Moment& moment) {
    for (const Link& link : moment.game.links()) {
        if (isBuilt(moment, link.place)) {
            paintLink(canvas, moment, link);
        }
    }
}

} // namespace apart
