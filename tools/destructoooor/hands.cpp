// SPDX-License-Identifier: MIT
#include "hands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace destructoooor {

namespace {

constexpr Real kTouch = Real(0.02);    // m, radius of what a hand touches
constexpr Real kSamePoint = Real(0.1); // m, corners that a hand cannot tell apart
constexpr Real kSliver = Real(0.002);  // m^2; smaller pieces vanish
constexpr Real kMotorTorque = 2000;    // N m
constexpr int kRimCorners = 16;        // of a circle that is split

kodo::Polygon regularPolygon(std::size_t corners, Real radius) {
    kodo::Polygon polygon;
    for (std::size_t i = 0; i < corners; ++i) {
        const Real angle = 2 * std::numbers::pi_v<Real> * Real(i) / Real(corners);
        polygon.corners.push_back(radius * kodo::Rot::fromAngle(angle).xAxis());
    }
    return polygon;
}

kodo::Shape shapeOf(Thing what, Real size, std::uint64_t seed) {
    switch (what) {
    case Thing::Ball:
        return kodo::Circle{size / 2};
    case Thing::Polygon:
        return regularPolygon(3 + seed * 5 % 4, size / 2);
    case Thing::Plank:
        return kodo::Box{3 * size, size / 4};
    case Thing::Capsule:
        return kodo::Capsule{{-size / 2, 0}, {size / 2, 0}, size / 4};
    case Thing::Cross:
        return kodo::Compound{{kodo::Box{size, size / 3}, kodo::Box{size / 3, size}}};
    case Thing::Box:
        break;
    }
    return kodo::Box{size, size};
}

/// Bodies at a point that are not static, in the order of their ids.
std::vector<BodyId> movableAt(const kodo::World& world, Vec2 point) {
    std::vector<BodyId> found = kodo::overlap(world, kodo::Circle{kTouch}, {point, {}});
    std::erase_if(found, [&](BodyId id) { return world[id].type() != kodo::BodyType::Dynamic; });
    return found;
}

/// The outline of a part in the world, with round corners as chords.
std::vector<Vec2> outlineOf(const kodo::Part& part, const kodo::Transform& frame) {
    std::vector<Vec2> points;
    for (const Vec2 vertex : part.convex.vertices) {
        if (part.convex.radius == 0) {
            points.push_back(frame * vertex);
            continue;
        }
        for (const Vec2 rim : regularPolygon(kRimCorners, part.convex.radius).corners) {
            points.push_back(frame * (vertex + rim));
        }
    }
    const auto hull = kodo::convexHull(points);
    const auto* const polygon = std::get_if<kodo::Polygon>(&hull);
    return polygon != nullptr ? polygon->corners : std::vector<Vec2>{};
}

/// The piece of a convex outline on the side of the normal; empty for a sliver.
std::vector<Vec2> clipped(std::span<const Vec2> outline, Vec2 point, Vec2 normal) {
    std::vector<Vec2> piece;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        const Real heightA = kodo::dot(normal, a - point);
        const Real heightB = kodo::dot(normal, b - point);
        if (heightA >= 0) {
            piece.push_back(a);
        }
        if ((heightA > 0 && heightB < 0) || (heightA < 0 && heightB > 0)) {
            piece.push_back(a + heightA / (heightA - heightB) * (b - a));
        }
    }
    Real area = 0;
    for (std::size_t i = 2; i < piece.size(); ++i) {
        area += kodo::cross(piece[i - 1] - piece[0], piece[i] - piece[0]) / 2;
    }
    return area > kSliver ? piece : std::vector<Vec2>{};
}

/// The parts of a body on one side of a line, in axes of the world about `origin`.
kodo::Compound sideOf(const kodo::BodyView& body, Vec2 point, Vec2 normal, Vec2 origin) {
    kodo::Compound side;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        std::vector<Vec2> corners =
            clipped(outlineOf(body.part(i), body.massFrame()), point, normal);
        for (Vec2& corner : corners) {
            corner -= origin;
        }
        const auto hull = kodo::convexHull(corners);
        if (const auto* const polygon = std::get_if<kodo::Polygon>(&hull)) {
            side.parts.push_back(*polygon);
        }
    }
    return side;
}

/// An outline without points that repeat the one before, around its end.
std::vector<Vec2> distinct(std::span<const Vec2> outline) {
    std::vector<Vec2> points;
    for (const Vec2 point : outline) {
        if (points.empty() || kodo::length(point - points.back()) > kSamePoint) {
            points.push_back(point);
        }
    }
    while (points.size() > 1 && kodo::length(points.back() - points.front()) <= kSamePoint) {
        points.pop_back();
    }
    return points;
}

/// What is wrong with an outline, as a sentence that counts its points from 1.
std::string sentenceOf(const kodo::Problem& problem) {
    std::string sentence = problem.field + " " + problem.reason + ".";
    constexpr std::string_view kIndexed = "outline[";
    for (std::size_t at = 0; (at = sentence.find(kIndexed, at)) != std::string::npos;) {
        const std::size_t digits = at + kIndexed.size();
        const std::size_t end = sentence.find(']', digits);
        const int number = std::stoi(sentence.substr(digits, end - digits)) + 1;
        sentence.replace(at, end + 1 - at,
                         (at == 0 ? "Point " : "point ") + std::to_string(number));
    }
    return sentence.starts_with("outline") ? "The " + sentence : sentence;
}

BodyId addSide(kodo::World& world, const kodo::Compound& side, BodyId whole, Vec2 origin) {
    const kodo::BodyView old = std::as_const(world)[whole];
    const kodo::Part& part = old.part(0);
    const BodyId id = world.add({.shape = side,
                                 .position = origin,
                                 .angularVelocity = old.angularVelocity(),
                                 .material = part.material,
                                 .density = part.density,
                                 .flags = old.flags() & ~kodo::kStatusFlags,
                                 .required = old.required()});
    world[id].setVelocity(old.velocityAt(world[id].center()));
    return id;
}

/// Lets a joint of `whole` hold one of its halves, where its anchor is.
void moveJoint(kodo::World& world, kodo::JointId joint, BodyId whole,
               std::pair<BodyId, BodyId> halves, Vec2 point, Vec2 normal) {
    kodo::JointDef def = world.joint(joint);
    const kodo::Transform frame = world[whole].transform();
    const auto moveEnd = [&](BodyId& end, Vec2& anchor) {
        if (end == whole) {
            const Vec2 place = frame * anchor;
            end = kodo::dot(normal, place - point) >= 0 ? halves.first : halves.second;
            anchor = kodo::toLocal(std::as_const(world)[end].transform(), place);
        }
    };
    std::visit(
        [&](auto& one) {
            if constexpr (requires { one.ends; }) {
                moveEnd(one.ends.a, one.ends.anchorA);
                moveEnd(one.ends.b, one.ends.anchorB);
                if constexpr (requires { one.reference; }) {
                    // The halves start unrotated, so the angle of b relative to a is another one.
                    const Real turned = std::atan2(frame.rotation.s, frame.rotation.c);
                    one.reference += (one.ends.a == halves.first || one.ends.a == halves.second)
                                         ? turned
                                         : Real(0);
                    one.reference -= (one.ends.b == halves.first || one.ends.b == halves.second)
                                         ? turned
                                         : Real(0);
                }
            } else {
                moveEnd(one.body, one.anchor);
            }
        },
        def);
    world.remove(joint);
    if (kodo::firstBody(def) != kodo::secondBody(def) ||
        std::holds_alternative<kodo::MouseJoint>(def)) {
        std::visit([&](const auto& one) { world.add(one); }, def);
    }
}

} // namespace

BodyId drop(kodo::World& world, Thing what, Vec2 place, Real size, const kodo::Material& material,
            std::uint64_t seed) {
    return world.add({.shape = shapeOf(what, size, seed), .position = place, .material = material});
}

std::variant<BodyId, std::string> draw(kodo::World& world, std::span<const Vec2> outline) {
    std::vector<Vec2> local = distinct(outline);
    Vec2 middle{};
    for (const Vec2 point : local) {
        middle += point / Real(local.size());
    }
    for (Vec2& point : local) {
        point -= middle;
    }
    const auto shape = kodo::decompose(local);
    if (const auto* const problem = std::get_if<kodo::Problem>(&shape)) {
        return sentenceOf(*problem);
    }
    return world.add({.shape = std::get<kodo::Compound>(shape), .position = middle});
}

std::optional<BodyId> bodyAt(const kodo::World& world, Vec2 point) {
    const std::vector<BodyId> found = movableAt(world, point);
    return found.empty() ? std::nullopt : std::optional(found.back());
}

void explode(kodo::World& world, Vec2 place, Real radius, Real speed) {
    for (const BodyId id : kodo::overlap(world, kodo::Circle{radius}, {place, {}})) {
        kodo::BodyRef body = world[id];
        const Vec2 way = body.center() - place;
        const Real distance = kodo::length(way);
        if (body.type() == kodo::BodyType::Dynamic && distance < radius && distance > 0) {
            const Real share = 1 - distance / radius;
            body.applyImpulse((body.mass() * speed * share / distance) * way);
        }
    }
}

std::optional<std::pair<BodyId, BodyId>> split(kodo::World& world, BodyId body, Vec2 point,
                                               Vec2 normal) {
    const Vec2 origin = world[body].center();
    const kodo::Compound front = sideOf(std::as_const(world)[body], point, normal, origin);
    const kodo::Compound back = sideOf(std::as_const(world)[body], point, -normal, origin);
    if (front.parts.empty() || back.parts.empty()) {
        return std::nullopt;
    }
    const std::pair halves{addSide(world, front, body, origin), addSide(world, back, body, origin)};
    for (const kodo::JointId joint : world.joints()) {
        const kodo::JointDef& def = world.joint(joint);
        if (kodo::firstBody(def) == body || kodo::secondBody(def) == body) {
            moveJoint(world, joint, body, halves, point, normal);
        }
    }
    world.remove(body);
    return halves;
}

int cut(kodo::World& world, Vec2 from, Vec2 to) {
    const Vec2 way = to - from;
    if (kodo::length(way) < kTouch) {
        return 0;
    }
    std::vector<BodyId> bodies;
    for (const kodo::QueryHit& hit : kodo::rayCastAll(world, from, to)) {
        if (world[hit.body].type() == kodo::BodyType::Dynamic &&
            std::find(bodies.begin(), bodies.end(), hit.body) == bodies.end()) {
            bodies.push_back(hit.body);
        }
    }
    return static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [&](BodyId id) {
        return split(world, id, from, kodo::perp(kodo::normalize(way))).has_value();
    }));
}

void shatter(kodo::World& world, BodyId body, Vec2 point) {
    std::vector<BodyId> pieces{body};
    for (int round = 0; round < 3; ++round) {
        std::vector<BodyId> next;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Real angle = Real(0.4) + Real(round) + Real(0.5) * Real(i);
            const Vec2 through = round == 0 ? point : std::as_const(world)[pieces[i]].center();
            const auto halves =
                split(world, pieces[i], through, kodo::Rot::fromAngle(angle).yAxis());
            if (halves) {
                next.insert(next.end(), {halves->first, halves->second});
            } else {
                next.push_back(pieces[i]);
            }
        }
        pieces = std::move(next);
    }
}

BodyId addPost(kodo::World& world, Vec2 place) {
    return world.add({.shape = kodo::Circle{Real(0.1)},
                      .position = place,
                      .type = kodo::BodyType::Static,
                      .flags = kodo::kDisabled});
}

bool pinAt(kodo::World& world, Vec2 point, Real motorSpeed) {
    const std::vector<BodyId> found = movableAt(world, point);
    if (found.empty()) {
        return false;
    }
    kodo::RevoluteJoint joint;
    joint.ends.b = found.back();
    joint.ends.a = found.size() > 1 ? found[found.size() - 2] : addPost(world, point);
    joint.ends.anchorA = kodo::toLocal(std::as_const(world)[joint.ends.a].transform(), point);
    joint.ends.anchorB = kodo::toLocal(std::as_const(world)[joint.ends.b].transform(), point);
    joint.motorSpeed = motorSpeed;
    joint.motorTorque = motorSpeed != 0 ? kMotorTorque : 0;
    world.add(joint);
    return true;
}

bool tie(kodo::World& world, Vec2 from, Vec2 to, Real hertz) {
    const std::optional<BodyId> a = bodyAt(world, from);
    const std::optional<BodyId> b = bodyAt(world, to);
    const Real distance = kodo::length(to - from);
    if ((!a && !b) || a == b || distance < kTouch) {
        return false;
    }
    kodo::DistanceJoint joint;
    joint.ends.a = a ? *a : addPost(world, from);
    joint.ends.b = b ? *b : addPost(world, to);
    joint.ends.anchorA = kodo::toLocal(std::as_const(world)[joint.ends.a].transform(), from);
    joint.ends.anchorB = kodo::toLocal(std::as_const(world)[joint.ends.b].transform(), to);
    joint.ends.collide = true;
    joint.length = distance;
    joint.hertz = hertz;
    joint.damping = Real(0.1);
    if (hertz == 0) {
        joint.limits = kodo::Range{0, distance};
    }
    world.add(joint);
    return true;
}

} // namespace destructoooor
