// SPDX-License-Identifier: MIT
#include <support/every_kind.hpp>
#include <support/every_shape.hpp>

#include <worlds/recipe.hpp>

#include <algorithm>
#include <cmath>

namespace worlds {
namespace {

using namespace kodo;
using support::RandomNumbers;

/// What bounds a world from below or all around.
enum class Ground { None, Floor, Plane, Heightmap, Chain, Room, Segment };
constexpr std::size_t kGrounds = 7;

class Generator {
public:
    explicit Generator(std::uint64_t seed) : random_(seed + 77000), rounds_(seed % 8 == 7) {}

    Recipe next() {
        setWorld();
        addGround();
        addBodies();
        if (!recipe_.rests) {
            addMovers();
            addPlatform();
        }
        addJoints();
        addEvents();
        return recipe_;
    }

private:
    bool oneIn(std::size_t count) { return random_.below(count) == 0; }
    int upTo(int most) {
        return static_cast<int>(random_.below(static_cast<std::size_t>(most) + 1));
    }
    /// Between 10^low and 10^high, evenly in the exponent.
    Real magnitude(double low, double high) {
        return static_cast<Real>(std::pow(10.0, static_cast<double>(random_.between(low, high))));
    }

    void setWorld() {
        ground_ = static_cast<Ground>(random_.below(kGrounds));
        recipe_.rests = ground_ != Ground::None && oneIn(4);
        const bool weightless = ground_ == Ground::None || (!recipe_.rests && oneIn(4));
        if (!weightless) {
            recipe_.world.gravity = {0, oneIn(3) ? -magnitude(0, 2) : Real(-10)};
        }
        StepSettings& settings = recipe_.world.settings;
        const int substeps = oneIn(2) ? 5 : 1 + upTo(7);
        settings.solver = SoftSettings{.substeps = substeps};
        if (oneIn(3)) {
            const int shockPasses = oneIn(2) ? 0 : 4;
            settings.solver =
                PropagationSettings{.substeps = 1 + substeps / 2, .shockPasses = shockPasses};
        }
        settings.sleepSteps = recipe_.rests ? 10 : 30;
        constexpr Feature kLeftOut[] = {Feature::Friction, Feature::RollingResistance,
                                        Feature::Restitution, Feature::Sleep, Feature::Rotation};
        if (!recipe_.rests && oneIn(5)) {
            settings.leaveOut = kLeftOut[random_.below(std::size(kLeftOut))];
        }
        constexpr int kRates[] = {60, 60, 60, 30, 120, 240};
        recipe_.dt = 1 / static_cast<Real>(kRates[random_.below(std::size(kRates))]);
        recipe_.steps = recipe_.rests ? 200 : 60 + upTo(60);
        recipe_.twin = static_cast<Twin>(random_.below(kTwins));
        recipe_.twinStep = upTo(recipe_.steps / 2);
        if (recipe_.twin == Twin::Threads) {
            const bool crowd = ground_ != Ground::Plane && oneIn(8);
            recipe_.tiles = crowd ? 60 : 1;
            recipe_.twin = crowd ? Twin::Threads : Twin::None;
            recipe_.steps = crowd ? 20 : recipe_.steps;
        }
        recipe_.drag = oneIn(6) ? random_.between(0, 1) : Real(0);
    }

    Material material() {
        const Real kinetic = random_.between(0, 1);
        const Real statically = kinetic + (oneIn(3) ? random_.between(0, 0.5) : Real(0));
        const Real restitution = recipe_.rests || oneIn(2) ? Real(0)
                                 : oneIn(4)                ? Real(1)
                                                           : random_.between(0, 1);
        const Real rolling = oneIn(4) ? random_.between(0, 0.2) : Real(0);
        return {statically, kinetic, restitution, rolling};
    }

    void addStatic(const Shape& shape, Vec2 position, Rot rotation = {}) {
        BodyDef def{.shape = shape, .position = position, .rotation = rotation};
        def.material = material();
        def.type = BodyType::Static;
        recipe_.bodies.push_back(def);
    }

    void addGround() {
        switch (ground_) {
        case Ground::None:
            return;
        case Ground::Floor:
            addStatic(Box{90, 1}, {0, Real(-0.5)});
            return;
        case Ground::Plane:
            addStatic(Plane{}, {}, Rot::fromAngle(recipe_.rests ? 0 : random_.between(-0.3, 0.3)));
            return;
        case Ground::Heightmap:
            addHeightmap();
            return;
        case Ground::Chain:
            addChain();
            return;
        case Ground::Room:
            for (const Real side : {Real(-1), Real(1)}) {
                addStatic(Box{Real(0.2), 12}, {6 * side, 6});
                addStatic(Box{12, Real(0.2)}, {0, 6 + 6 * side});
            }
            return;
        case Ground::Segment:
            addStatic(Segment{{-40, 0}, {40, 0}}, {});
            return;
        }
    }

    std::vector<Real> heights(std::size_t count) {
        const double rough = oneIn(4) ? 0 : 0.4;
        std::vector<Real> heights(count);
        for (Real& height : heights) {
            height = random_.between(-rough, 0);
        }
        return heights;
    }

    void addHeightmap() {
        const Real spacing = random_.between(0.3, 2);
        const std::size_t count = static_cast<std::size_t>(80 / spacing);
        addStatic(Heightmap{{-40, 0}, spacing, heights(count)}, {});
    }

    /// Bent ground of one-sided segments. They go from left to right, so that their front is up.
    void addChain() {
        const std::size_t count = 12 + random_.below(30);
        const std::vector<Real> up = heights(count);
        const Real spacing = 80 / static_cast<Real>(count - 1);
        const auto at = [&](std::size_t i) {
            return Vec2{static_cast<Real>(i) * spacing - 40, up[i]};
        };
        Chain chain{.oneSided = true};
        for (std::size_t i = 0; i < count; ++i) {
            chain.points.push_back(at(i));
        }
        addStatic(chain, {});
    }

    /// A convex part of a dynamic body, about 2 `size` across.
    Primitive part(Real size) {
        constexpr support::AnyKind kKinds[] = {
            support::AnyKind::Circle, support::AnyKind::Box,     support::AnyKind::Box,
            support::AnyKind::Circle, support::AnyKind::Polygon, support::AnyKind::Polygon,
            support::AnyKind::Point,  support::AnyKind::Segment};
        const std::size_t few = recipe_.rests ? 6 : std::size(kKinds);
        const Primitive plain =
            support::scaled(support::randomPrimitive(random_, kKinds[random_.below(few)]), size);
        return rounds_ ? rounded(plain) : plain;
    }

    /// A capsule instead of a circle, and a box with round corners, of the same extents.
    static Primitive rounded(const Primitive& plain) {
        if (const auto* circle = std::get_if<Circle>(&plain)) {
            const Vec2 half{circle->radius / 2, 0};
            return Capsule{circle->center - half, circle->center + half, circle->radius / 2};
        }
        if (const auto* box = std::get_if<Box>(&plain)) {
            Box round = *box;
            round.radius = std::min(box->width, box->height) / 8;
            round.width -= 2 * round.radius;
            round.height -= 2 * round.radius;
            return round;
        }
        return plain;
    }

    Shape shape(Real size) {
        if (oneIn(3)) {
            Compound compound;
            for (std::size_t parts = 2 + random_.below(2); parts > 0; --parts) {
                compound.parts.push_back(part(size / 2));
            }
            return compound;
        }
        if (oneIn(3)) { // common shapes at rest on faces
            return oneIn(2) ? Shape(Circle{size}) : Shape(Box{2 * size, size});
        }
        return shapeOf(part(size));
    }

    /// m; largest distance of a point of the shape from its origin.
    static Real reachOf(const Shape& shape) {
        Real reach = 0;
        for (const Primitive& primitive : primitivesOf(shape)) {
            reach = std::max(reach, convexShapeOf(primitive, {}).boundingRadius);
        }
        return reach;
    }

    void addBodies() {
        const std::size_t count = recipe_.rests ? 1 + random_.below(4) : 1 + random_.below(8);
        const Real floor = ground_ == Ground::None    ? Real(-4)
                           : ground_ == Ground::Plane ? Real(2.6)
                                                      : Real(1.3);
        const bool heavy = oneIn(3);
        const bool spread = !recipe_.rests || oneIn(2);
        Real top = 0; // m, of the column of a world at rest
        for (std::size_t i = 0; i < count; ++i) {
            BodyDef def;
            const Real column = spread ? static_cast<Real>(i % 3) - 1 : Real(0);
            const Real row = spread ? static_cast<Real>(i / 3) : static_cast<Real>(i);
            def.position = {Real(3.2) * column, floor + Real(2.8) * row};
            const Real size = random_.between(0.15, 0.6);
            def.shape = shape(size);
            def.rotation = recipe_.rests && oneIn(2) ? Rot{} : random_.rotation();
            if (!recipe_.rests) {
                def.velocity = random_.point(oneIn(6) ? 60 : 6);
                def.angularVelocity = oneIn(2) ? Real(0) : random_.between(-8, 8);
            } else {
                const Real reach = reachOf(def.shape);
                def.position.y = (spread ? 0 : top) + reach + Real(0.01);
                top = def.position.y + reach;
            }
            def.density = heavy ? magnitude(-1.5, 1.5) : random_.between(0.5, 2);
            def.material = material();
            if (oneIn(5)) {
                constexpr Flags kFlags[] = {kLockRotate, kLockMove, kNeverSleep, kSensor, kSensor};
                def.flags = kFlags[random_.below(recipe_.rests ? 1 : std::size(kFlags))];
            }
            if ((def.flags & kLockMove) != 0) { // it would be driven like a kinematic body
                def.velocity = {};
            }
            if ((def.flags & kLockRotate) != 0 || std::holds_alternative<Point>(def.shape) ||
                recipe_.world.settings.leaveOut.has(Feature::Rotation)) {
                def.angularVelocity = 0;
            }
            recipe_.bodies.push_back(def);
        }
    }

    void addMovers() {
        for (int movers = oneIn(3) ? 1 + upTo(1) : 0; movers > 0; --movers) {
            BodyDef def;
            const Real size = random_.between(0.4, 1.5);
            const Shape shapes[] = {Box{2 * size, Real(0.2)}, Box{size, size}, Circle{size / 2},
                                    Segment{{-size, 0}, {size, 0}}};
            def.shape = shapes[random_.below(std::size(shapes))];
            def.position = {random_.between(-5, 5), random_.between(9, 12)};
            def.rotation = random_.rotation();
            def.velocity = {random_.between(-3, 3), random_.between(-14, 0)};
            def.angularVelocity = oneIn(2) ? Real(0) : random_.between(-6, 6);
            def.material = material();
            def.type = BodyType::Kinematic;
            recipe_.bodies.push_back(def);
            const std::size_t mover = recipe_.bodies.size() - 1;
            const int step = 10 + upTo(30);
            recipe_.events.push_back({step, Event::Kind::Drive, mover, 0, -def.velocity, 0});
        }
    }

    /// A static obstacle in mid-air.
    void addPlatform() {
        if (!oneIn(4)) {
            return;
        }
        const Segment ledge{{Real(-1.5), 0}, {Real(1.5), 0}, oneIn(2)};
        const Shape shapes[] = {ledge, Box{2, Real(0.1)}, Circle{Real(0.4)}};
        const Real x = random_.between(-6, 6);
        addStatic(shapes[random_.below(std::size(shapes))], {x, Real(-1.6)});
        recipe_.bodies.back().position.y = ground_ == Ground::None ? Real(-6) : Real(10.5);
    }

    static Vec2 inFrame(const BodyDef& def, Vec2 p) {
        return unrotate(def.rotation, p - def.position);
    }

    void addJoints() {
        const std::size_t first = ground_ == Ground::Room ? 4 : ground_ == Ground::None ? 0 : 1;
        if (recipe_.tiles > 1 || !oneIn(recipe_.rests ? 6 : 3)) {
            return;
        }
        for (std::size_t b = first + 1; b < recipe_.bodies.size(); ++b) {
            const std::size_t a = oneIn(4) ? first : b - 1;
            const bool needless = recipe_.bodies[a].type != BodyType::Dynamic &&
                                  recipe_.bodies[b].type != BodyType::Dynamic;
            if (a != b && !needless && !oneIn(3)) {
                addJoint(a, b);
            }
        }
    }

    /// A taut rope over two points above the bodies.
    PulleyJoint pulleyOf(const JointEnds& ends, const BodyDef& a, const BodyDef& b) {
        const Vec2 above{0, random_.between(1, 4)};
        const Real ratio = random_.between(0.3, 3);
        return {ends, a.position + above, b.position + above, (1 + ratio) * above.y, ratio};
    }
    static FilterJoint filterOf(JointEnds ends) {
        ends.collide = false;
        ends.breakForce = ends.breakTorque = kUnbreakable; // it has no load
        return {ends};
    }

    void addJoint(std::size_t a, std::size_t b) {
        const BodyDef& one = recipe_.bodies[a];
        const BodyDef& other = recipe_.bodies[b];
        Vec2 middle = Real(0.5) * (one.position + other.position);
        if (oneIn(20)) {
            middle += random_.point(4); // anchors far outside both bodies
        }
        JointEnds ends{{static_cast<std::uint32_t>(a), 1, 0},
                       {static_cast<std::uint32_t>(b), 1, 0}};
        ends.anchorA = inFrame(one, middle);
        ends.anchorB = inFrame(other, middle);
        ends.collide = oneIn(2);
        ends.breakForce = oneIn(6) ? magnitude(0, 3) : kUnbreakable;
        const Real angle = (other.rotation * one.rotation.inverse()).angle();
        JointEnds apart = ends;
        apart.anchorA = {};
        apart.anchorB = {};
        const Real length = kodo::length(other.position - one.position);
        const Real low = random_.between(-1.5, 0);
        const Real speed = random_.between(-6, 6);
        const Real force = magnitude(-1, 2);
        const Real hertz = magnitude(-1, 1);
        const support::EveryKind<JointDef> kinds{
            RevoluteJoint{.ends = ends, .reference = angle},
            RevoluteJoint{.ends = ends, .reference = angle, .limits = Range{low, low + 2}},
            RevoluteJoint{.ends = ends, .motorSpeed = speed, .motorTorque = force},
            FixedJoint{.ends = ends, .reference = angle},
            DistanceJoint{.ends = apart,
                          .length = Real(1.2) * length,
                          .hertz = hertz,
                          .damping = oneIn(2) ? Real(0) : random_.between(0, 1)},
            DistanceJoint{.ends = apart, .limits = Range{0, length}},
            DistanceJoint{.ends = apart, .limits = Range{length, length}},
            PrismaticJoint{.ends = ends, .reference = angle, .limits = Range{low, 1}},
            PrismaticJoint{
                .ends = ends, .reference = angle, .motorSpeed = speed, .motorForce = force},
            MotorJoint{.ends = ends, .reference = angle, .force = force, .torque = force},
            MouseJoint{.body = ends.b, .target = middle, .force = force},
            RevoluteJoint{.ends = ends, .target = 4 * low, .hertz = hertz},
            RevoluteJoint{.ends = ends,
                          .limits = Range{6 * low, 9},
                          .motorSpeed = speed,
                          .motorTorque = force},
            FixedJoint{.ends = ends, .reference = angle, .hertz = hertz},
            DistanceJoint{.ends = apart, .motorSpeed = speed, .motorForce = force},
            PrismaticJoint{.ends = ends, .reference = angle, .target = low, .hertz = hertz},
            MotorJoint{.ends = ends, .force = force, .torque = force, .hertz = 0},
            WheelJoint{.ends = ends,
                       .limits = Range{low, 1},
                       .hertz = hertz,
                       .motorSpeed = speed,
                       .motorTorque = force},
            pulleyOf(apart, one, other),
            GearJoint{.ends = ends, .ratio = speed},
            GearJoint{.ends = ends, .ratio = low - 1, .rack = Vec2{1, 0}},
            filterOf(ends)};
        recipe_.joints.push_back(kinds.list[random_.below(kinds.list.size())]);
    }

    void addEvents() {
        if (recipe_.tiles > 1 || !oneIn(3)) {
            return;
        }
        const std::size_t one = random_.below(recipe_.bodies.size());
        const std::size_t other = random_.below(recipe_.bodies.size());
        const int step = 10 + upTo(recipe_.steps / 2);
        const bool rigid = recipe_.bodies[one].type == BodyType::Dynamic &&
                           recipe_.bodies[other].type == BodyType::Dynamic;
        if (rigid && one != other && oneIn(2)) {
            recipe_.events.push_back({step, Event::Kind::Weld, one, other, {}, 0});
        } else if (!(recipe_.rests && one == 0)) {
            recipe_.events.push_back({step, Event::Kind::Remove, one, 0, {}, 0});
        }
    }

    RandomNumbers random_;
    bool rounds_; // shapes have round corners
    Recipe recipe_;
    Ground ground_ = Ground::None;
};

void close(JointEnds& ends, const Recipe& recipe) {
    const BodyDef& a = recipe.bodies[ends.a.index];
    const BodyDef& b = recipe.bodies[ends.b.index];
    const Vec2 anchor = a.position + a.rotation * ends.anchorA;
    ends.anchorB = unrotate(b.rotation, anchor - b.position);
}

} // namespace

void closeJoints(Recipe& recipe) {
    for (JointDef& def : recipe.joints) {
        if (auto* const distance = std::get_if<DistanceJoint>(&def)) {
            const BodyDef& a = recipe.bodies[distance->ends.a.index];
            const BodyDef& b = recipe.bodies[distance->ends.b.index];
            const Real length = kodo::length(b.position - a.position);
            distance->ends.anchorA = {};
            distance->ends.anchorB = {};
            if (distance->limits) {
                distance->limits->upper = length;
                distance->limits->lower = distance->limits->lower > 0 ? length : 0;
            }
            continue;
        }
        std::visit(
            [&](auto& joint) {
                if constexpr (requires { joint.ends; }) {
                    close(joint.ends, recipe);
                    const Rot q = recipe.bodies[joint.ends.b.index].rotation *
                                  recipe.bodies[joint.ends.a.index].rotation.inverse();
                    if constexpr (requires { joint.reference; }) {
                        joint.reference = q.angle();
                    }
                }
            },
            def);
    }
}

std::string kindOf(const Recipe& recipe) {
    bool thin = false;
    bool driven = false;
    for (const BodyDef& body : recipe.bodies) {
        driven = driven || body.type == BodyType::Kinematic;
        for (const Primitive& part : primitivesOf(body.shape)) {
            const bool isThin =
                std::holds_alternative<Point>(part) || std::holds_alternative<Segment>(part);
            thin = thin || (isThin && body.type != BodyType::Static);
        }
    }
    std::string kind;
    const auto add = [&](bool has, const char* word) {
        kind += has ? (kind.empty() ? "" : " ") + std::string(word) : "";
    };
    add(!recipe.joints.empty(), "joints");
    add(thin, "thin");
    add(std::holds_alternative<PropagationSettings>(recipe.world.settings.solver), "thesis");
    add(driven, "driven");
    return kind.empty() ? "plain" : kind;
}

Recipe randomRecipe(std::uint64_t seed) {
    return Generator(seed).next();
}

} // namespace worlds
