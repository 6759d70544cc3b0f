// SPDX-License-Identifier: MIT
#include <support/every_kind.hpp>

#include <worlds/invariance.hpp>

#include <algorithm>
#include <type_traits>

namespace worlds {

using namespace kodo;

namespace {

constexpr Real kLengthScale = 4;
constexpr Real kMassScale = 8;
constexpr Real kHeavyScale = 1e6;

// Below are rules for the members of these kinds of joints.
static_assert(
    support::kHasEveryKind<JointDef, RevoluteJoint, FixedJoint, DistanceJoint, PrismaticJoint,
                           MotorJoint, MouseJoint, WheelJoint, PulleyJoint, GearJoint, FilterJoint>,
    "give the new joint its rules in mirror() and enlarge()");

// Mirrored shapes. The order of corners and points is reversed, so that the outside stays outside.

Vec2 mirrored(Vec2 v) {
    return {-v.x, v.y};
}
Rot mirrored(Rot q) {
    return {q.c, -q.s};
}
Range mirrored(Range range) {
    return {-range.upper, -range.lower};
}

void mirror(Circle& circle) {
    circle.center = mirrored(circle.center);
}
void mirror(Capsule& capsule) {
    capsule.from = mirrored(capsule.from);
    capsule.to = mirrored(capsule.to);
}
void mirror(Box& box) {
    box.center = mirrored(box.center);
    box.rotation = mirrored(box.rotation);
}
void mirror(Polygon& polygon) {
    std::reverse(polygon.corners.begin(), polygon.corners.end());
    for (Vec2& corner : polygon.corners) {
        corner = mirrored(corner);
    }
}
void mirror(Point& point) {
    point.position = mirrored(point.position);
}
void mirror(Segment& segment) {
    segment.from = mirrored(segment.from);
    segment.to = mirrored(segment.to);
    std::swap(segment.from, segment.to);
}
void mirror(Plane& plane) {
    plane.normal = mirrored(plane.normal);
}
void mirror(Heightmap& map) {
    const Real width = map.spacing * static_cast<Real>(map.heights.size() - 1);
    map.origin.x = -(map.origin.x + width);
    std::reverse(map.heights.begin(), map.heights.end());
}
void mirror(Chain& chain) {
    std::reverse(chain.points.begin(), chain.points.end());
    std::reverse(chain.materials.begin(), chain.materials.end());
    for (Vec2& point : chain.points) {
        point = mirrored(point);
    }
    for (Material& material : chain.materials) {
        material.surfaceSpeed = -material.surfaceSpeed;
    }
}
void mirror(Compound& compound) {
    for (Primitive& part : compound.parts) {
        std::visit([](auto& own) { mirror(own); }, part);
    }
}

void mirror(BodyDef& def) {
    std::visit([](auto& own) { mirror(own); }, def.shape);
    def.position = mirrored(def.position);
    def.rotation = mirrored(def.rotation);
    def.velocity = mirrored(def.velocity);
    def.angularVelocity = -def.angularVelocity;
    def.material.surfaceSpeed = -def.material.surfaceSpeed;
}

void mirror(JointDef& def) {
    std::visit(
        [](auto& joint) {
            if constexpr (requires { joint.ends; }) {
                joint.ends.anchorA = mirrored(joint.ends.anchorA);
                joint.ends.anchorB = mirrored(joint.ends.anchorB);
            } else {
                joint.anchor = mirrored(joint.anchor);
                joint.target = mirrored(joint.target);
            }
            if constexpr (requires { joint.reference; }) {
                joint.reference = -joint.reference;
            }
            if constexpr (requires { joint.axis; }) {
                joint.axis = mirrored(joint.axis);
            }
            using Joint = std::decay_t<decltype(joint)>;
            if constexpr (std::is_same_v<Joint, RevoluteJoint>) {
                joint.motorSpeed = -joint.motorSpeed;
                joint.target = -joint.target;
                joint.ratchet = -joint.ratchet;
                joint.limits = joint.limits ? std::optional(mirrored(*joint.limits)) : std::nullopt;
            }
            if constexpr (std::is_same_v<Joint, WheelJoint>) {
                joint.motorSpeed = -joint.motorSpeed;
            }
            if constexpr (std::is_same_v<Joint, PulleyJoint>) {
                joint.groundA = mirrored(joint.groundA);
                joint.groundB = mirrored(joint.groundB);
            }
            if constexpr (std::is_same_v<Joint, GearJoint>) {
                if (joint.rack) { // the same way, for the other angle
                    joint.rack = mirrored(*joint.rack);
                    joint.ratio = -joint.ratio;
                }
            }
        },
        def);
}

void mirror(Recipe& recipe) {
    recipe.world.gravity = mirrored(recipe.world.gravity);
    for (BodyDef& def : recipe.bodies) {
        mirror(def);
    }
    for (JointDef& def : recipe.joints) {
        mirror(def);
    }
}

// Scaled by powers of two: each number of the step is multiplied by one.

void scale(Real& value, Real by) {
    value *= by;
}
void scale(Vec2& v, Real by) {
    v = by * v;
}
void scale(std::optional<Range>& range, Real by) {
    if (range) {
        range = Range{by * range->lower, by * range->upper};
    }
}

void enlarge(Circle& circle, Real by) {
    scale(circle.radius, by);
    scale(circle.center, by);
}
void enlarge(Capsule& capsule, Real by) {
    scale(capsule.from, by);
    scale(capsule.to, by);
    scale(capsule.radius, by);
}
void enlarge(Box& box, Real by) {
    scale(box.width, by);
    scale(box.height, by);
    scale(box.center, by);
    scale(box.radius, by);
}
void enlarge(Polygon& polygon, Real by) {
    for (Vec2& corner : polygon.corners) {
        scale(corner, by);
    }
    scale(polygon.radius, by);
}
void enlarge(Point& point, Real by) {
    scale(point.position, by);
}
void enlarge(Segment& segment, Real by) {
    scale(segment.from, by);
    scale(segment.to, by);
    scale(segment.radius, by);
}
void enlarge(Plane& plane, Real by) {
    scale(plane.offset, by);
}
void enlarge(Heightmap& map, Real by) {
    scale(map.origin, by);
    scale(map.spacing, by);
    for (Real& height : map.heights) {
        scale(height, by);
    }
}
void enlarge(Chain& chain, Real by) {
    for (Vec2& point : chain.points) {
        scale(point, by);
    }
    for (Material& material : chain.materials) {
        scale(material.surfaceSpeed, by);
    }
}
void enlarge(Compound& compound, Real by) {
    for (Primitive& part : compound.parts) {
        std::visit([&](auto& own) { enlarge(own, by); }, part);
    }
}

/// What the density of a part is multiplied by the square of a length for: 2 for an area, 1 for a
/// line, 0 for a point.
int dimensionOf(const Primitive& part) {
    const auto* segment = std::get_if<Segment>(&part);
    return std::holds_alternative<Point>(part)          ? 0
           : segment != nullptr && segment->radius == 0 ? 1
                                                        : 2;
}

/// Multiplies forces and torques.
void strengthen(JointDef& def, Real force, Real torque) {
    std::visit(
        [&](auto& joint) {
            if constexpr (requires { joint.ends; }) {
                scale(joint.ends.breakForce, force);
                scale(joint.ends.breakTorque, torque);
            }
            if constexpr (requires { joint.force; }) {
                scale(joint.force, force);
            }
            if constexpr (requires { joint.torque; }) {
                scale(joint.torque, torque);
            }
            if constexpr (requires { joint.motorForce; }) {
                scale(joint.motorForce, force);
            }
            if constexpr (requires { joint.motorTorque; }) {
                scale(joint.motorTorque, torque);
            }
        },
        def);
}

void enlarge(JointDef& def, Real by) {
    std::visit(
        [&](auto& joint) {
            if constexpr (requires { joint.ends; }) {
                scale(joint.ends.anchorA, by);
                scale(joint.ends.anchorB, by);
            } else {
                scale(joint.anchor, by);
                scale(joint.target, by);
            }
            using Joint = std::decay_t<decltype(joint)>;
            if constexpr (std::is_same_v<Joint, DistanceJoint>) {
                scale(joint.length, by);
                scale(joint.limits, by);
                scale(joint.motorSpeed, by);
            }
            if constexpr (std::is_same_v<Joint, PrismaticJoint>) {
                scale(joint.motorSpeed, by);
                scale(joint.limits, by);
                scale(joint.target, by);
            }
            if constexpr (std::is_same_v<Joint, WheelJoint>) {
                scale(joint.limits, by);
            }
            if constexpr (std::is_same_v<Joint, PulleyJoint>) {
                scale(joint.groundA, by);
                scale(joint.groundB, by);
                scale(joint.length, by);
            }
            if constexpr (std::is_same_v<Joint, GearJoint>) {
                scale(joint.ratio, joint.rack ? by : Real(1));
            }
        },
        def);
}

/// False if parts of one body would scale differently.
bool enlarge(Recipe& recipe, Real by) {
    scale(recipe.world.gravity, by);
    scale(recipe.world.lengthUnit, by);
    for (BodyDef& def : recipe.bodies) {
        const std::vector<Primitive> parts = primitivesOf(def.shape);
        const int dimension = dimensionOf(parts[0]);
        for (const Primitive& part : parts) {
            if (dimensionOf(part) != dimension) {
                return false;
            }
        }
        for (int i = dimension; i < 2; ++i) { // the mass grows as that of an area
            scale(def.density, by);
        }
        std::visit([&](auto& own) { enlarge(own, by); }, def.shape);
        scale(def.position, by);
        scale(def.velocity, by);
        scale(def.material.surfaceSpeed, by);
    }
    for (JointDef& def : recipe.joints) {
        enlarge(def, by);
        strengthen(def, by * by * by, by * by * by * by);
    }
    return true;
}

void addMass(Recipe& recipe, Real by) {
    for (BodyDef& def : recipe.bodies) {
        scale(def.density, by);
    }
    for (JointDef& def : recipe.joints) {
        strengthen(def, by, by);
    }
}

void reverse(Recipe& recipe, std::vector<std::size_t>& places) {
    const std::size_t last = recipe.bodies.size() - 1;
    std::reverse(recipe.bodies.begin(), recipe.bodies.end());
    std::reverse(recipe.joints.begin(), recipe.joints.end());
    std::reverse(places.begin(), places.end());
    const auto place = [&](BodyId& id) { id.index = static_cast<std::uint32_t>(last) - id.index; };
    for (JointDef& def : recipe.joints) {
        std::visit(
            [&](auto& joint) {
                if constexpr (requires { joint.ends; }) {
                    place(joint.ends.a);
                    place(joint.ends.b);
                } else {
                    place(joint.body);
                }
            },
            def);
    }
}

bool hasTarget(const Recipe& recipe) {
    return std::any_of(recipe.joints.begin(), recipe.joints.end(),
                       [](const JointDef& def) { return std::holds_alternative<MouseJoint>(def); });
}
bool has(const Recipe& recipe, BodyType type) {
    return std::any_of(recipe.bodies.begin(), recipe.bodies.end(),
                       [&](const BodyDef& def) { return def.type == type; });
}

/// The frame of the first kinematic body, or another one.
bool boost(Changed& result) {
    Recipe& recipe = result.recipe;
    if (hasTarget(recipe) ||
        std::any_of(recipe.bodies.begin(), recipe.bodies.end(),
                    [](const BodyDef& def) { return (def.flags & kLockMove) != 0; })) {
        return false;
    }
    Vec2 by{8, -4};
    for (const BodyDef& def : recipe.bodies) {
        if (def.type == BodyType::Kinematic && def.velocity != Vec2{}) {
            by = -def.velocity;
            break;
        }
    }
    result.boost = toDouble(by);
    for (BodyDef& def : recipe.bodies) {
        def.velocity += by;
        def.type = def.type == BodyType::Static ? BodyType::Kinematic : def.type;
    }
    return true;
}

bool makeHeavy(Recipe& recipe) {
    const bool alone = recipe.joints.empty() && !has(recipe, BodyType::Static) &&
                       has(recipe, BodyType::Kinematic) && recipe.world.gravity == Vec2{};
    for (BodyDef& def : recipe.bodies) {
        if (def.type == BodyType::Kinematic) {
            def.type = BodyType::Dynamic;
            scale(def.density, kHeavyScale);
        }
    }
    return alone;
}

} // namespace

const char* nameOf(Invariance invariance) {
    constexpr const char* kNames[] = {"boost",  "mirror", "at rest", "order",
                                      "length", "mass",   "heavy"};
    return kNames[static_cast<std::size_t>(invariance)];
}

std::optional<Changed> changed(const Recipe& recipe, Invariance invariance) {
    Changed result{recipe, invariance, {}, {}};
    for (std::size_t i = 0; i < recipe.bodies.size(); ++i) {
        result.places.push_back(i);
    }
    bool applies = true;
    switch (invariance) {
    case Invariance::Boost:
        applies = boost(result);
        break;
    case Invariance::Mirror:
        mirror(result.recipe);
        break;
    case Invariance::AtRest:
        applies = has(recipe, BodyType::Static);
        for (BodyDef& def : result.recipe.bodies) {
            def.type = def.type == BodyType::Static ? BodyType::Kinematic : def.type;
        }
        break;
    case Invariance::Order:
        reverse(result.recipe, result.places);
        break;
    case Invariance::Length:
        applies = enlarge(result.recipe, kLengthScale);
        break;
    case Invariance::Mass:
        addMass(result.recipe, kMassScale);
        break;
    case Invariance::Heavy:
        applies = makeHeavy(result.recipe);
        break;
    }
    return applies ? std::optional(result) : std::nullopt;
}

Motion Changed::original(const OrdinaryEngine& changed, std::size_t body, double time) const {
    Motion motion = changed.motion(places[body]);
    if (invariance == Invariance::Mirror) {
        motion.position.x = -motion.position.x;
        motion.rotation = motion.rotation.inverse();
        motion.velocity.x = -motion.velocity.x;
        motion.spin = -motion.spin;
    }
    if (invariance == Invariance::Length) {
        const double back = 1 / static_cast<double>(kLengthScale);
        motion.position = back * motion.position;
        motion.velocity = back * motion.velocity;
    }
    motion.position = motion.position - time * boost;
    motion.velocity = motion.velocity - boost;
    return motion;
}

} // namespace worlds
