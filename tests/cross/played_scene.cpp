// SPDX-License-Identifier: MIT
#include "played_scene.hpp"

#include <scenes/in_kodo.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crosscheck {
namespace {

using kodo::Real;

constexpr double kSmallest = 0.05;            // m; Box2D's skin takes 1 cm of each side
constexpr std::size_t kMostCorners = 8;       // of Box2D
constexpr std::size_t kMostPaths = 20;        // drawn
constexpr kodo::Flags kMostCategory = 0xffff; // of Box2D

double number(Real value) {
    return static_cast<double>(value);
}
scenes::Vec2 plain(kodo::Vec2 v) {
    return {number(v.x), number(v.y)};
}

class Player {
public:
    Player(const scene_files::SceneFile& file, apart::TomlKeys& keys) : file_(file), keys_(keys) {}

    PlayedScene play() {
        made_.def.gravity = plain(file_.gravity);
        for (const scene_files::FileBody& body : file_.bodies) {
            places_.push_back(made_.def.bodies.size());
            std::holds_alternative<kodo::Chain>(body.def.shape) ? addChain(body) : addBody(body);
        }
        giveCategories();
        for (const scene_files::FileJoint& joint : file_.joints) {
            addJoint(joint);
        }
        return std::move(made_);
    }

private:
    /// A key that Box2D has no equal of, or this comparison does not play.
    void lacks(bool there, int line, const std::string& what) {
        if (there) {
            keys_.fail(line, what + " is not played in Box2D 2.4.1");
        }
    }

    scenes::Material material(const kodo::Material& own, int line) {
        lacks(own.staticFriction != own.kineticFriction, line, "static_friction");
        lacks(own.rollingResistance != 0, line, "rolling_resistance");
        lacks(own.frictionRule != kodo::MixRule::GeometricMean, line, "friction_rule");
        lacks(own.restitutionRule != kodo::MixRule::Minimum, line, "restitution_rule");
        return {number(own.kineticFriction), number(own.restitution), number(own.surfaceSpeed)};
    }

    /// A static line: the side that Box2D knows is the upper one, from left to right.
    void addChain(const scene_files::FileBody& body) {
        const auto& chain = std::get<kodo::Chain>(body.def.shape);
        lacks(body.def.type != kodo::BodyType::Static, body.line, "a chain that moves");
        lacks(chain.closed, body.line, "closed");
        lacks((body.def.flags & (kodo::kSensor | kodo::kDisabled)) != 0 || body.def.required != 0 ||
                  body.def.group != 0,
              body.line, "a chain with a filter");
        scenes::ChainDef def{{}, material(body.def.material, body.line)};
        for (const kodo::Vec2 point : chain.points) {
            def.points.push_back(
                plain(kodo::Transform{body.def.position, body.def.rotation} * point));
        }
        if (!chain.oneSided && def.points.size() > 1 &&
            def.points.back().x < def.points.front().x) {
            std::reverse(def.points.begin(), def.points.end());
        }
        made_.def.chains.push_back(std::move(def));
        places_.back() = std::numeric_limits<std::size_t>::max();
    }

    void addBody(const scene_files::FileBody& body) {
        const kodo::BodyDef& def = body.def;
        scenes::BodyDef made;
        const std::vector<kodo::Primitive> primitives = kodo::primitivesOf(def.shape);
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const int line = body.partLines[std::min(i, body.partLines.size() - 1)];
            made.parts.push_back(part(primitives[i], line));
        }
        lacks(!body.parts.empty(), body.line, "a part with a surface or filter of its own");
        lacks(def.mass.has_value(), body.line, "mass");
        lacks(def.linearDamping != 0 || def.angularDamping != 0, body.line, "damping");
        lacks(def.gravityScale != 0 && def.gravityScale != 1, body.line, "gravity_scale");
        lacks(def.continuousMode != kodo::ContinuousMode::All, body.line, "continuous_mode");
        lacks((def.flags & kodo::kLockMove) != 0, body.line, "lock_move");
        lacks((def.flags & kodo::kDisabled) != 0, body.line, "disabled");
        lacks(def.group != 0, body.line, "group");
        made.position = plain(def.position);
        made.rotation = {number(def.rotation.c), number(def.rotation.s)};
        made.velocity = plain(def.velocity);
        made.spin = number(def.angularVelocity);
        made.density = number(def.density);
        made.material = material(def.material, body.line);
        made.locked = def.type != kodo::BodyType::Dynamic;
        made.weightless = def.gravityScale == 0;
        made.upright = (def.flags & kodo::kLockRotate) != 0;
        made.sensor = (def.flags & kodo::kSensor) != 0;
        readFilter(body, made);
        const bool moves = made.spin != 0 || dot(made.velocity, made.velocity) > 0;
        if ((!made.locked || moves) && made_.drawn.size() < kMostPaths) {
            made_.drawn.push_back(made_.def.bodies.size());
        }
        made_.names.push_back(body.name);
        made_.def.bodies.push_back(std::move(made));
    }

    void readFilter(const scene_files::FileBody& body, scenes::BodyDef& made) {
        const kodo::Flags own = body.def.flags & kodo::kUserFlags;
        const kodo::Flags wanted = body.def.required;
        const kodo::Flags match = body.def.flags & kodo::kMatchModes;
        lacks((wanted & kodo::kDefaultCategory) != 0, body.line, "the default category");
        lacks((own | (wanted & kodo::kUserFlags)) > kMostCategory, body.line,
              "a category above 15");
        lacks(match != 0 && match != kodo::kMatchAny, body.line, "collides other than any");
        made.category = static_cast<std::uint16_t>(own);
        made.mask = static_cast<std::uint16_t>(wanted);
    }

    /// Where one body has a filter, all need a category: one that no filter names.
    void giveCategories() {
        unsigned used = scenes::kHeavy; // of bodies under gravity, in Kodo
        bool filters = false;
        for (const scenes::BodyDef& body : made_.def.bodies) {
            used |= static_cast<unsigned>(body.category | body.mask);
            filters = filters || body.mask != 0;
        }
        unsigned unnamed = 1;
        while ((used & unnamed) != 0) {
            unnamed <<= 1;
        }
        lacks(filters && unnamed > kMostCategory, 0, "a scene with filters of all categories");
        for (scenes::BodyDef& body : made_.def.bodies) {
            if (filters && body.category == 0) {
                body.category = static_cast<std::uint16_t>(unnamed);
            }
        }
    }

    scenes::Part part(const kodo::Primitive& primitive, int line) {
        if (const auto* circle = std::get_if<kodo::Circle>(&primitive)) {
            small(2 * number(circle->radius), line);
            return scenes::Circle{number(circle->radius), plain(circle->center)};
        }
        if (const auto* capsule = std::get_if<kodo::Capsule>(&primitive)) {
            small(2 * number(capsule->radius), line);
            return scenes::Capsule{plain(capsule->from), plain(capsule->to),
                                   number(capsule->radius)};
        }
        if (const auto* box = std::get_if<kodo::Box>(&primitive)) {
            lacks(box->radius != 0, line, "radius of a box");
            small(number(std::min(box->width, box->height)), line);
            const scenes::Box made{number(box->width), number(box->height), plain(box->center)};
            if (box->rotation == kodo::Rot{}) {
                return made;
            }
            scenes::Polygon turned{cornersOf(made)};
            const scenes::Rot turn{number(box->rotation.c), number(box->rotation.s)};
            for (scenes::Vec2& corner : turned.corners) {
                corner = made.center + turn * (corner - made.center);
            }
            return turned;
        }
        if (const auto* polygon = std::get_if<kodo::Polygon>(&primitive)) {
            return partOf(*polygon, line);
        }
        lacks(true, line, "a segment, plane or point");
        return scenes::Circle{1};
    }

    scenes::Part partOf(const kodo::Polygon& polygon, int line) {
        lacks(polygon.radius != 0, line, "radius of a polygon");
        lacks(polygon.corners.size() > kMostCorners, line, "a polygon of more than 8 corners");
        scenes::Polygon made;
        for (const kodo::Vec2 corner : polygon.corners) {
            made.corners.push_back(plain(corner));
        }
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < made.corners.size(); ++i) {
            const scenes::Vec2 start = made.corners[i];
            const scenes::Vec2 edge = made.corners[(i + 1) % made.corners.size()] - start;
            double width = 0;
            for (const scenes::Vec2 corner : made.corners) {
                width = std::max(width, cross(edge, corner - start) / sizeOf(edge));
            }
            least = std::min(least, width);
        }
        small(least, line);
        return made;
    }

    void small(double width, int line) {
        if (!(width >= kSmallest)) {
            keys_.fail(line, "a shape must be at least 0.05 wide, for Box2D");
        }
    }

    void addJoint(const scene_files::FileJoint& joint) {
        Link link;
        if (const auto* mouse = std::get_if<kodo::MouseJoint>(&joint.def)) {
            link.kind = Link::Kind::MouseJoint;
            link.b = placeOf(mouse->body, joint.line);
            link.a = link.b == 0 ? 1 : 0;
            lacks(made_.def.bodies.size() < 2, joint.line, "a mouse without a second body");
            link.point = inWorld(mouse->body, mouse->anchor);
            link.pointB = plain(mouse->target);
            link.motorTorque = number(mouse->force);
            link.hertz = number(mouse->hertz);
            link.damping = number(mouse->damping);
            made_.links.push_back(link);
            return;
        }
        std::visit(
            [&](const auto& def) {
                if constexpr (requires { def.ends; }) {
                    addBetween(def, joint.line, link);
                }
            },
            joint.def);
        made_.links.push_back(link);
    }

    template <typename Joint>
    void addBetween(const Joint& def, int line, Link& link) {
        link.a = placeOf(def.ends.a, line);
        link.b = placeOf(def.ends.b, line);
        link.point = inWorld(def.ends.a, def.ends.anchorA);
        link.pointB = inWorld(def.ends.b, def.ends.anchorB);
        lacks(def.ends.collide, line, "collide");
        lacks(def.ends.breakTorque != kodo::kUnbreakable, line, "break_torque");
        if (def.ends.breakForce != kodo::kUnbreakable) {
            link.breakForce = number(def.ends.breakForce);
        }
        if constexpr (requires { def.reference; }) {
            link.reference = number(def.reference);
        }
        if constexpr (requires { def.limits; }) {
            if (def.limits) {
                link.limits = Limits{number(def.limits->lower), number(def.limits->upper)};
            }
        }
        fill(def, line, link);
    }

    void fill(const kodo::RevoluteJoint& def, int line, Link& link) {
        lacks(def.hertz != 0, line, "hertz of a revolute joint");
        lacks(def.ratchet != 0, line, "a ratchet");
        link.kind = Link::Kind::RevoluteJoint;
        link.motorSpeed = number(def.motorSpeed);
        link.motorTorque = number(def.motorTorque);
    }
    void fill(const kodo::FixedJoint& def, int line, Link& link) {
        lacks(def.hertz != 0, line, "hertz of a fixed joint");
        link.kind = Link::Kind::FixedJoint;
    }
    void fill(const kodo::PrismaticJoint& def, int line, Link& link) {
        lacks(def.hertz != 0, line, "hertz of a prismatic joint");
        link.kind = Link::Kind::PrismaticJoint;
        link.motorSpeed = number(def.motorSpeed);
        link.motorTorque = number(def.motorForce);
        link.axis = plain(file_.bodies[def.ends.a.index].def.rotation * def.axis);
    }
    void fill(const kodo::DistanceJoint& def, int line, Link& link) {
        link.length = number(def.length);
        link.hertz = number(def.hertz);
        link.damping = number(def.damping);
        link.kind = Link::Kind::DistanceJoint;
        const bool rod = def.limits == kodo::Range{def.length, def.length};
        const bool rope = def.limits == kodo::Range{0, def.length};
        lacks(def.motorForce != 0, line, "a winch");
        lacks(def.hertz != 0 && def.limits, line, "a spring with limits");
        lacks(def.hertz == 0 && !rod && !rope, line, "limits other than those of a rod or a rope");
        if (def.hertz == 0 && rope) {
            link.kind = Link::Kind::RopeJoint;
        }
        link.limits = {};
    }
    template <typename Joint>
    void fill(const Joint&, int line, Link&) {
        lacks(true, line, "this kind of joint");
    }

    std::size_t placeOf(kodo::BodyId id, int line) {
        const std::size_t place = id.index < places_.size() ? places_[id.index] : 0;
        if (place >= made_.def.bodies.size()) {
            lacks(true, line, "a joint of a chain");
            return 0;
        }
        return place;
    }
    scenes::Vec2 inWorld(kodo::BodyId id, kodo::Vec2 point) const {
        if (id.index >= file_.bodies.size()) {
            return {};
        }
        const kodo::BodyDef& def = file_.bodies[id.index].def;
        return plain(kodo::Transform{def.position, def.rotation} * point);
    }

    const scene_files::SceneFile& file_;
    apart::TomlKeys& keys_;
    PlayedScene made_;
    std::vector<std::size_t> places_; // of each body of the file in def.bodies; or none
};

} // namespace

PlayedScene playedScene(const scene_files::SceneFile& file, apart::TomlKeys& keys) {
    return Player(file, keys).play();
}

} // namespace crosscheck
