// SPDX-License-Identifier: MIT
#include <worlds/judges.hpp>
#include <worlds/ordinary.hpp>
#include <worlds/ordinary_builder.hpp>

#include <iterator>
#include <stdexcept>

namespace worlds {

using Vec = OrdinaryBuilder::Vec;

using namespace kodo;

namespace {

struct Family {
    const char* name;
    void (*build)(OrdinaryBuilder&);
};
constexpr Family kFamilies[] = {
    {"ragdolls, thrown", throwRagdolls},
    {"ragdolls, wedged", wedgeRagdolls},
    {"cars", addCar},
    {"bridges", addBridge},
    {"cranes", addCrane},
    {"wrecking balls", addWreckingBall},
    {"doors", addDoors},
    {"pistons", addPiston},
    {"tank tracks", addTank},
    {"soft rings", addSoftRing},
    {"rope ladders", addRopeLadder},
    {"trebuchets", addTrebuchet},
    {"cradles", addCradle},
    {"big wheels", addBigWheel},
    {"see-saws", addSeeSaw},
    {"robot arms", addRobotArm},
    {"walkers", addWalker},
    {"flails", addFlail},
    {"scissor lifts", addScissorLift},
};
constexpr std::size_t kFamilyCount = std::size(kFamilies);

Vec2 toReal(Vec v) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y)};
}
Real toReal(double value) {
    return static_cast<Real>(value);
}

/// kg, of a shape with density 1.
double areaOf(const Shape& shape) {
    const World world = [&] {
        World one;
        one.add({.shape = shape});
        return one;
    }();
    return static_cast<double>(world[world.bodies()[0]].mass());
}

} // namespace

std::span<const char* const> ordinaryFamilies() {
    static const std::vector<const char*> names = [] {
        std::vector<const char*> all;
        for (const Family& family : kFamilies) {
            all.push_back(family.name);
        }
        return all;
    }();
    return names;
}

std::size_t ordinaryFamily(std::uint64_t seed) {
    return static_cast<std::size_t>(seed % kFamilyCount);
}

Recipe ordinaryRecipe(std::uint64_t seed) {
    const Family& family = kFamilies[ordinaryFamily(seed)];
    OrdinaryBuilder builder(seed);
    family.build(builder);
    Recipe recipe = builder.recipe();
    if (!startsSound(build(recipe).world, Pairs::Colliding)) {
        throw std::logic_error(std::string(family.name) + ", seed " + std::to_string(seed) +
                               ": bodies overlap at the start");
    }
    return recipe;
}

OrdinaryBuilder::OrdinaryBuilder(std::uint64_t seed) : random_(seed + 52000) {
    constexpr int kRates[] = {30, 40, 50, 60, 60, 60, 90, 120, 144, 240};
    const int rate = kRates[random_.below(std::size(kRates))];
    ratio_ = std::pow(10, between(0.0, 2.0));
    friction_ = between(0.3, 0.9);
    recipe_.dt = 1 / static_cast<Real>(rate);
    recipe_.steps = static_cast<int>(kOrdinarySeconds * rate);
    recipe_.world.gravity = {0, -10};
}

Shape OrdinaryBuilder::box(double width, double height, Vec center, double angle) {
    return Box{toReal(width), toReal(height), toReal(center), Rot::fromAngle(toReal(angle))};
}
Shape OrdinaryBuilder::disc(double radius) {
    return Circle{toReal(radius)};
}
Shape OrdinaryBuilder::joined(const std::vector<Shape>& boxes) {
    Compound all;
    for (const Shape& one : boxes) {
        all.parts.push_back(std::get<Box>(one));
    }
    return all;
}

OrdinaryBuilder::Index OrdinaryBuilder::add(const Shape& shape, Vec position, double density,
                                            double angle) {
    BodyDef def{.shape = shape,
                .position = toReal(position),
                .rotation = Rot::fromAngle(toReal(angle)),
                .material = withFriction(toReal(friction_)),
                .density = toReal(density),
                .flags = kSolid};
    recipe_.bodies.push_back(def);
    return recipe_.bodies.size() - 1;
}

OrdinaryBuilder::Index OrdinaryBuilder::addStatic(const Shape& shape, Vec position, double angle) {
    const Index index = add(shape, position, 1, angle);
    body(index).type = BodyType::Static;
    return index;
}

OrdinaryBuilder::Index OrdinaryBuilder::addFloor(double halfWidth) {
    const Index floor = addStatic(box(400, 2), {0, -1});
    for (const double side : {-1.0, 1.0}) {
        if (halfWidth > 0) {
            addStatic(box(1, 20), {side * (halfWidth + 0.5), 10});
        }
    }
    return floor;
}

double OrdinaryBuilder::massOf(Index index) const {
    const BodyDef& def = recipe_.bodies[index];
    return static_cast<double>(def.density) * areaOf(def.shape);
}

double OrdinaryBuilder::densityFor(const Shape& shape, Index other, double times) const {
    return times * massOf(other) / areaOf(shape);
}

void OrdinaryBuilder::filter(Index index, Flags category, Flags mask) {
    body(index).flags = category | kMatchAny;
    body(index).required = static_cast<std::uint16_t>(mask);
}

void OrdinaryBuilder::setMotion(Index index, Vec velocity, double spin) {
    body(index).velocity = toReal(velocity);
    body(index).angularVelocity = toReal(spin);
}

void OrdinaryBuilder::setRestitution(double restitution) {
    for (BodyDef& def : recipe_.bodies) {
        def.material.restitution = toReal(restitution);
    }
}

double OrdinaryBuilder::angleOf(Index index) const {
    return toDouble(recipe_.bodies[index].rotation).angle();
}

JointEnds OrdinaryBuilder::ends(Index a, Index b, Vec onA, Vec onB) const {
    const auto inFrame = [&](Index index, Vec point) {
        const BodyDef& def = recipe_.bodies[index];
        return toReal(unrotate(toDouble(def.rotation), point - toDouble(def.position)));
    };
    JointEnds ends{{static_cast<std::uint32_t>(a), 1, 0}, {static_cast<std::uint32_t>(b), 1, 0}};
    ends.anchorA = inFrame(a, onA);
    ends.anchorB = inFrame(b, onB);
    return ends;
}

RevoluteJoint OrdinaryBuilder::pin(Index a, Index b, Vec point) const {
    return {.ends = ends(a, b, point, point), .reference = toReal(angleOf(b) - angleOf(a))};
}
void OrdinaryBuilder::addLimitedPin(Index a, Index b, Vec point, double lower, double upper) {
    RevoluteJoint joint = pin(a, b, point);
    joint.limits = Range{toReal(lower), toReal(upper)};
    add(joint);
}
void OrdinaryBuilder::addMotor(Index a, Index b, Vec point, double speed, double torque) {
    RevoluteJoint joint = pin(a, b, point);
    joint.motorSpeed = toReal(speed);
    joint.motorTorque = toReal(torque);
    add(joint);
}
void OrdinaryBuilder::addWeld(Index a, Index b, Vec point) {
    add(FixedJoint{ends(a, b, point, point), toReal(angleOf(b) - angleOf(a))});
}
PrismaticJoint OrdinaryBuilder::slider(Index a, Index b, Vec point, Vec axis) const {
    PrismaticJoint joint{.ends = ends(a, b, point, point)};
    joint.axis = toReal(unrotate(toDouble(recipe_.bodies[a].rotation), axis));
    joint.reference = toReal(angleOf(b) - angleOf(a));
    return joint;
}

void OrdinaryBuilder::addRope(Index a, Index b, Vec from, Vec to) {
    const Real long_ = toReal(length(to - from));
    add(DistanceJoint{.ends = ends(a, b, from, to), .limits = Range{0, long_}});
}
void OrdinaryBuilder::addRod(Index a, Index b, Vec from, Vec to) {
    const Real long_ = toReal(length(to - from));
    add(DistanceJoint{.ends = ends(a, b, from, to), .limits = Range{long_, long_}});
}
void OrdinaryBuilder::addSpring(Index a, Index b, Vec from, Vec to, double hertz, double damping) {
    add(DistanceJoint{.ends = ends(a, b, from, to),
                      .length = toReal(length(to - from)),
                      .hertz = toReal(hertz),
                      .damping = toReal(damping)});
}

OrdinaryBuilder::Index OrdinaryBuilder::addLinks(Index body, Vec& end, int count, double length,
                                                 double angle) {
    const double thickness = 0.2 * length;
    Index last = body;
    for (int i = 0; i < count; ++i) {
        const Vec middle = end + length / 2 * atAngle(angle);
        const Index link = add(box(length, thickness), middle, 1, angle);
        addPin(last, link, end);
        end += length * atAngle(angle);
        last = link;
    }
    return last;
}

} // namespace worlds
