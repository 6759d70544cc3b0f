// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::near;

/// Factors of all lengths and masses of a scene. Times are unchanged, so velocities and
/// accelerations scale with the length, and forces with both.
struct Scale {
    Real length = 1;
    Real mass = 1;
};

/// Builds a World in another scale.
class Builder {
public:
    Builder(const Scale& scale, const StepSettings& settings)
        : scale_(scale),
          world({.gravity = scale.length * support::kEarth,
                 .lengthUnit = scale.length,
                 .settings = settings}) {}

    BodyId add(BodyDef def, const Primitive& primitive) {
        std::visit([&](const auto& kind) { def.shape = kind; },
                   support::scaled(primitive, scale_.length));
        def.position *= scale_.length;
        def.velocity *= scale_.length;
        def.density *= scale_.mass / (scale_.length * scale_.length);
        return world.add(def);
    }
    JointEnds ends(BodyId a, BodyId b, Vec2 anchorA, Vec2 anchorB) const {
        return {a, b, scale_.length * anchorA, scale_.length * anchorB};
    }
    Real length(Real value) const { return scale_.length * value; }
    Real force(Real value) const { return scale_.mass * scale_.length * value; }
    Real torque(Real value) const { return scale_.length * force(value); }

private:
    Scale scale_;

public:
    World world;
};

/// A heap of all kinds of shapes between two walls, hit by a fast ball.
void addHeap(Builder& build) {
    support::RandomNumbers random(77);
    build.add({.position = {0, Real(-0.5)}, .type = BodyType::Static}, Box{40, 1});
    for (const Real x : {Real(-5), Real(5)}) {
        build.add({.position = {x, 10}, .type = BodyType::Static}, Box{1, 20});
    }
    for (int i = 0; i < 30; ++i) {
        BodyDef def;
        def.position = {random.between(-3, 3), 1 + static_cast<Real>(i) / 2};
        def.rotation = random.rotation();
        def.velocity = random.point(2);
        def.material.restitution = i % 3 == 0 ? Real(0.5) : Real(0);
        def.material.rollingResistance = Real(0.02);
        const support::Kind kind = support::kAllKinds[i % 3];
        build.add(def, support::scaled(support::randomPrimitive(random, kind), Real(0.5)));
    }
    build.add({.position = {0, 40}, .velocity = {0, -150}}, Circle{Real(0.2)});
}

/// One joint of each kind, beside the heap.
void addJoints(Builder& build) {
    const auto pair = [&](Real x) {
        const BodyId hook = build.add({.position = {x, 8}, .type = BodyType::Static}, Box{1, 1});
        const BodyId body = build.add({.position = {x + 1, 6}}, Box{1, Real(0.5)});
        return std::pair(hook, body);
    };
    const auto ends = [&](Real x) {
        const auto [hook, body] = pair(x);
        return build.ends(hook, body, {Real(0.5), -1}, {Real(-0.5), 1});
    };
    build.world.add(RevoluteJoint{.ends = ends(8), .limits = Range{-1, 1}});
    build.world.add(
        RevoluteJoint{.ends = ends(12), .motorSpeed = 3, .motorTorque = build.torque(20)});
    build.world.add(FixedJoint{.ends = ends(16)});
    build.world.add(DistanceJoint{.ends = ends(20),
                                  .length = build.length(1),
                                  .hertz = 2,
                                  .damping = Real(0.1),
                                  .limits = Range{build.length(Real(0.5)), build.length(2)}});
    build.world.add(PrismaticJoint{.ends = ends(24),
                                   .axis = {0, 1},
                                   .limits = Range{build.length(-2), build.length(1)},
                                   .motorSpeed = build.length(1),
                                   .motorForce = build.force(20)});
    build.world.add(
        MotorJoint{.ends = ends(28), .force = build.force(30), .torque = build.torque(5)});
    const auto [hook, held] = pair(32);
    build.world.add(MouseJoint{
        .body = held, .target = build.length(1) * Vec2{30, 9}, .force = build.force(100)});
    JointEnds weak = build.ends(hook, held, {}, {});
    weak.breakForce = build.force(30);
    build.world.add(FixedJoint{.ends = weak});
}

/// Expects the same bits except for the exponent. Values below 1e-24 may differ: decaying values
/// become denormal and round differently.
void expectScaled(Vec2 own, Vec2 other, Real scale) {
    constexpr Real kNothing = Real(1e-24);
    for (const auto& [mine, its] : {std::pair(own.x, other.x), std::pair(own.y, other.y)}) {
        if (mine != scale * its) {
            ASSERT_LT(std::abs(mine) / scale, kNothing);
            ASSERT_LT(std::abs(its), kNothing);
        }
    }
}

/// Compares all poses, velocities and flags.
void expectSameBits(const World& world, const World& metres, Real scale) {
    const std::vector<BodyId> ids = metres.bodies();
    ASSERT_EQ(world.bodies(), ids);
    for (const BodyId id : ids) {
        const BodyView own = world[BodyId{id.index, id.generation}];
        const BodyView other = metres[id];
        SCOPED_TRACE(testing::Message() << "body " << id.index);
        ASSERT_NO_FATAL_FAILURE(expectScaled(own.center(), other.center(), scale));
        ASSERT_NO_FATAL_FAILURE(expectScaled(own.velocity(), other.velocity(), scale));
        const Vec2 spins{own.angularVelocity(), 0};
        ASSERT_NO_FATAL_FAILURE(expectScaled(spins, {other.angularVelocity(), 0}, 1));
        const Rot q = own.rotation();
        ASSERT_NO_FATAL_FAILURE(
            expectScaled({q.c, q.s}, {other.rotation().c, other.rotation().s}, 1));
        ASSERT_EQ(own.flags(), other.flags());
    }
}

void expectSameRecords(const World& world, const World& metres, const Scale& scale) {
    ASSERT_EQ(world.collisions().size(), metres.collisions().size());
    for (std::size_t i = 0; i < world.collisions().size(); ++i) {
        const CollisionRecord& own = world.collisions()[i];
        const CollisionRecord& other = metres.collisions()[i];
        ASSERT_EQ(own.phase, other.phase);
        ASSERT_NO_FATAL_FAILURE(expectScaled(own.point, other.point, scale.length));
        ASSERT_EQ(own.separation, scale.length * other.separation);
        const Vec2 impulses{own.maxImpulse, own.totalImpulse};
        ASSERT_NO_FATAL_FAILURE(expectScaled(impulses, {other.maxImpulse, other.totalImpulse},
                                             scale.mass * scale.length));
    }
}

/// The engine contains no hidden unit. If lengths and masses are scaled by powers of two, every
/// number changes its exponent only.
void expectScalesExactly(const Scale& scale, const StepSettings& settings) {
    Builder metres({}, settings);
    Builder other(scale, settings);
    for (Builder* build : {&metres, &other}) {
        addHeap(*build);
        addJoints(*build);
    }
    for (int step = 0; step < (support::kSanitized ? 80 : 240); ++step) {
        metres.world.step(support::kDt);
        other.world.step(support::kDt);
        SCOPED_TRACE(testing::Message() << "after step " << step);
        ASSERT_NO_FATAL_FAILURE(expectSameBits(other.world, metres.world, scale.length));
        ASSERT_NO_FATAL_FAILURE(expectSameRecords(other.world, metres.world, scale));
    }
}

constexpr Scale kPowersOfTwo[] = {{2, 1},        {Real(1) / 8, Real(1) / 64},      {1024, 1},
                                  {1, 4096},     {Real(1) / 1024, Real(1) / 1024}, {65536, 64},
                                  {524288, 4096}};

TEST(LengthUnit, APowerOfTwoGivesTheSameBits) {
    for (const Scale& scale : kPowersOfTwo) {
        SCOPED_TRACE(testing::Message() << scale.length << " m, " << scale.mass << " kg");
        expectScalesExactly(scale, {});
    }
}

TEST(LengthUnit, APowerOfTwoGivesTheSameBitsUnderPropagation) {
    StepSettings settings = thesis2006();
    settings.propagation().shockPasses = 3;
    for (const Scale& scale : kPowersOfTwo) {
        SCOPED_TRACE(testing::Message() << scale.length << " m, " << scale.mass << " kg");
        expectScalesExactly(scale, settings);
    }
}

struct Unit {
    const char* name;
    double perMetre;
};
constexpr Unit kUnits[] = {
    {"millimetres", 1000}, {"metres", 1}, {"kilometres", 0.001}, {"pixels", 50}};
constexpr Unit kExtremeUnits[] = {{"micrometres", 1e6}, {"megametres", 1e-6}};

/// A World in the given unit with a static floor.
Builder inUnit(const Unit& unit) {
    Builder build({static_cast<Real>(unit.perMetre), 1}, {});
    build.add({.position = {0, Real(-0.5)}, .type = BodyType::Static}, Box{60, 1});
    return build;
}

// The speed limit scales with the unit. A body falls for 3 s in the smallest and the largest unit
// and has the exact speed.
TEST(LengthUnit, AFallHasTheExactSpeedInTheSmallestAndTheLargestUnit) {
    for (const Unit& unit : kExtremeUnits) {
        SCOPED_TRACE(unit.name);
        const auto mass = static_cast<Real>(unit.perMetre); // so that no density is out of range
        Builder build({static_cast<Real>(unit.perMetre), mass * mass}, {});
        const BodyId ball = build.add({.velocity = {0, -90}}, Circle{Real(0.5)});
        for (int i = 0; i < 180; ++i) {
            build.world.step(support::kDt);
            ASSERT_TRUE(build.world.frozenBodies().empty()) << "step " << i;
        }
        // 180 sums, each rounded by at most half an ulp.
        EXPECT_TRUE(support::nearShare(build.world[ball].velocity().y / build.length(1), -120.0L,
                                       90 * support::kEpsilon));
        build.world[ball].setVelocity({build.length(kMaxSpeed), 0});
        EXPECT_THROW(build.world[ball].setVelocity({build.length(Real(1.01) * kMaxSpeed), 0}),
                     BadDefinition);
        EXPECT_THROW(build.world[ball].setAngularVelocity(Real(1.01) * kMaxSpeed),
                     BadDefinition); // angles have no unit of length
    }
}

// Results do not depend on the unit, except for rounding. Units that are not powers of two round
// every number, by about 1e-7 in float.
TEST(LengthUnit, AStackStandsInEveryUnit) {
    for (const Unit& unit : kUnits) {
        SCOPED_TRACE(unit.name);
        Builder build = inUnit(unit);
        BodyId top;
        for (int i = 0; i < 5; ++i) {
            top = build.add({.position = {0, Real(0.5) + static_cast<Real>(i)}}, Box{1, 1});
        }
        support::run(build.world, 300);
        const Vec2 place = build.world[top].position() / build.length(1);
        EXPECT_TRUE(near(place, Vec2{0, Real(4.5)}, Real(0.02)));
        EXPECT_NE(build.world[top].flags() & kAsleep, 0u);
    }
}

TEST(LengthUnit, ABoxSlidesAsFarInEveryUnit) {
    for (const Unit& unit : kUnits) {
        SCOPED_TRACE(unit.name);
        Builder build = inUnit(unit);
        const BodyId box = build.add(
            {.position = {0, Real(0.25)}, .velocity = {5, 0}, .material = withFriction(Real(0.6))},
            Box{1, Real(0.5)});
        support::run(build.world, 120);
        // v^2 / (2 mu g); 1 % as in tests/laws.
        EXPECT_TRUE(near(build.world[box].position().x / build.length(1), 25 / 12.0, 0.021));
    }
}

TEST(LengthUnit, ABallBouncesAsHighInEveryUnit) {
    for (const Unit& unit : kUnits) {
        SCOPED_TRACE(unit.name);
        Builder build({static_cast<Real>(unit.perMetre), 1}, {});
        const Material lossless = support::slippery(1);
        build.add({.position = {0, Real(-0.5)}, .material = lossless, .type = BodyType::Static},
                  Box{9, 1});
        const BodyId ball =
            build.add({.position = {0, 3}, .material = lossless}, Circle{Real(0.5)});
        Real highest = 0;
        for (int i = 0; i < 240; ++i) {
            build.world.step(support::kDt);
            highest = i > 60 ? std::max(highest, build.world[ball].position().y) : 0;
        }
        EXPECT_TRUE(near(highest / build.length(1), 3.0L, 0.03));
    }
}

// The angle after 2 s, within 1e-3 rad.
TEST(LengthUnit, APendulumReachesTheSameAngleInEveryUnit) {
    std::vector<Real> angles;
    for (const Unit& unit : kUnits) {
        Builder build = inUnit(unit);
        const BodyId hook =
            build.add({.position = {0, 9}, .type = BodyType::Static}, Circle{Real(0.1)});
        const BodyId ball = build.add({.position = {2, 9}}, Circle{Real(0.2)});
        build.world.add(RevoluteJoint{.ends = build.ends(hook, ball, {}, {-2, 0})});
        support::run(build.world, 120);
        angles.push_back(build.world[ball].rotation().angle());
        EXPECT_TRUE(near(angles.back(), angles.front(), Real(1e-3))) << unit.name;
    }
}

} // namespace
} // namespace kodo
