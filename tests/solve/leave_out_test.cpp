// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::kSolvers;
using support::Solver;

struct Named {
    const char* name;
    Feature feature;
};
constexpr Named kFeatures[] = {
    {"Friction", Feature::Friction},       {"RollingResistance", Feature::RollingResistance},
    {"Restitution", Feature::Restitution}, {"ContinuousCollision", Feature::ContinuousCollision},
    {"Records", Feature::Records},         {"Sleep", Feature::Sleep},
    {"Rotation", Feature::Rotation},       {"Collision", Feature::Collision},
};

std::ostream& operator<<(std::ostream& out, const Named& row) {
    return out << row.name;
}

StepSettings without(StepSettings settings, Feature feature) {
    settings.leaveOut |= feature;
    return settings;
}

WorldDef leavingOut(Feature feature, Vec2 gravity = support::kEarth) {
    return {.gravity = gravity, .settings = without({}, feature)};
}

/// Pose and velocity of a body, for bitwise comparison.
struct Bits {
    Vec2 position;
    Rot rotation;
    Vec2 velocity;
    Real spin;
    friend bool operator==(const Bits&, const Bits&) = default;
};

std::vector<Bits> bitsOf(const World& world) {
    std::vector<Bits> all;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        all.push_back({body.position(), body.rotation(), body.velocity(), body.angularVelocity()});
    }
    return all;
}

/// Columns of balls. All normals are vertical, so without friction no ball can rotate.
void addColumns(World& world, const Material& material) {
    for (int i = 0; i < 12; ++i) {
        const Vec2 place{static_cast<Real>(i % 4) * 2,
                         Real(0.6) + static_cast<Real>(i / 4) * Real(1.1)};
        world.add(support::ballDef(place, Real(0.5), material));
    }
}

/// Boxes and balls that slide and roll along the floor without touching each other.
void addRow(World& world, const Material& material) {
    for (int i = 0; i < 10; ++i) {
        const Real x = static_cast<Real>(2 * i);
        BodyDef def = i % 2 == 0 ? support::ballDef({x, Real(0.4)}, Real(0.4), material)
                                 : support::boxDef({x, Real(0.25)}, Real(0.8), Real(0.5), material);
        def.velocity = {Real(0.1) * static_cast<Real>(i), 0};
        world.add(def);
    }
}

void addHeap(World& world, const Material& material) {
    support::RandomNumbers random(33);
    for (int i = 0; i < 15; ++i) {
        BodyDef def = i % 2 == 0 ? support::ballDef({}, Real(0.4), material)
                                 : support::boxDef({}, Real(0.8), Real(0.5), material);
        def.position = {static_cast<Real>(i % 5) - 2,
                        Real(0.6) + Real(0.9) * static_cast<Real>(i / 5)};
        def.rotation = random.rotation();
        def.velocity = {random.between(-1, 1), random.between(-1, 0)};
        world.add(def);
    }
}

/// Chains and bodies that fall without touching anything.
void addFalling(World& world, const Material& material) {
    for (int i = 0; i < 20; ++i) {
        const Vec2 place{static_cast<Real>(i % 5) * 4, Real(100) + static_cast<Real>(i / 5) * 4};
        BodyDef def = i % 2 == 0 ? support::ballDef(place, Real(0.4), material)
                                 : support::boxDef(place, Real(0.8), Real(0.5), material);
        def.angularVelocity = static_cast<Real>(i);
        const BodyId body = world.add(def);
        def.position.x += 1;
        const JointEnds ends{body, world.add(def), {Real(0.5), 0}, {Real(-0.5), 0}};
        world.add(RevoluteJoint{.ends = ends});
    }
}

/// A scene in which a feature has no effect. Restitution also applies the impact impulses of
/// inelastic pairs, so without it nothing may collide. Continuous collision also finds the time of
/// a bounce.
World withoutUse(Feature feature, const StepSettings& settings) {
    World world({.gravity = {0, -1}, .settings = settings});
    const bool smooth = feature == Feature::Friction || feature == Feature::Rotation;
    const bool dull = feature == Feature::Restitution || feature == Feature::ContinuousCollision;
    Material material = withFriction(smooth ? Real(0) : Real(0.5), dull ? Real(0) : Real(0.4));
    const bool rolls = feature == Feature::RollingResistance || smooth;
    material.rollingResistance = rolls ? Real(0) : Real(0.05);
    support::addFloor(world, material);
    if (feature == Feature::Rotation) {
        addColumns(world, material);
    } else if (feature == Feature::Restitution) {
        addRow(world, material);
    } else if (feature == Feature::Collision) {
        addFalling(world, material);
    } else {
        addHeap(world, material);
    }
    return world;
}

class LeaveOutFeature : public testing::TestWithParam<Named> {};

// W3: a feature that is left out changes no bit where it has no effect. Friction: frictionless
// bodies. Continuous collision: slow bodies. Sleep: fewer steps than sleepSteps. Records: any
// scene. Collision: joints in the air. With both solvers.
TEST_P(LeaveOutFeature, ChangesNothingWhereItHasNoEffect) {
    for (StepSettings settings : {StepSettings{}, thesis2006()}) {
        settings.sleepSteps = 1000;
        const Feature feature = GetParam().feature;
        World with = withoutUse(feature, settings);
        World out = withoutUse(feature, without(settings, feature));
        std::size_t touches = 0;
        for (int step = 0; step < 100; ++step) {
            with.step(support::kDt);
            out.step(support::kDt);
            ASSERT_EQ(bitsOf(out), bitsOf(with)) << "step " << step;
            touches += with.collisions().size();
            if (feature != Feature::Rotation && feature != Feature::Sleep) {
                // The hash also includes inertias and calm steps, and the settings.
                const auto withBoth = [&](World world) {
                    world.setSettings(without(settings, feature));
                    world.setSettings(settings);
                    return world.stateHash();
                };
                ASSERT_EQ(withBoth(out), withBoth(with)) << "step " << step;
            }
        }
        if (feature == Feature::Collision) {
            EXPECT_EQ(touches, 0u);
        } else {
            EXPECT_GT(touches, 200u); // the scene has contacts
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Features, LeaveOutFeature, testing::ValuesIn(kFeatures),
                         [](const testing::TestParamInfo<Named>& row) {
                             return std::string(row.param.name);
                         });

// W3: a feature that is left out has no effect. Without friction a box slides for ever.
TEST(LeaveOut, WithoutFrictionABoxKeepsSliding) {
    World world(leavingOut(Feature::Friction));
    support::addFloor(world, withFriction(1));
    BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1, withFriction(1));
    def.velocity = {2, 0};
    const BodyId box = world.add(def);
    support::run(world, 120);
    EXPECT_EQ(world[box].velocity().x, 2);
}

TEST(LeaveOut, WithoutRestitutionNothingBounces) {
    World world(leavingOut(Feature::Restitution));
    support::addFloor(world, support::slippery(1));
    const BodyId ball = world.add(support::ballDef({0, 3}, Real(0.5), support::slippery(1)));
    Real fastest = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(support::kDt);
        fastest = std::max(fastest, world[ball].velocity().y);
    }
    EXPECT_LT(fastest, Real(0.05));
}

TEST(LeaveOut, WithoutRollingResistanceABallKeepsRolling) {
    World world(leavingOut(Feature::RollingResistance));
    Material material = withFriction(Real(0.8));
    material.rollingResistance = Real(0.5);
    support::addFloor(world, material);
    BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), material);
    def.velocity = {3, 0};
    def.angularVelocity = -6;
    const BodyId ball = world.add(def);
    support::run(world, 120);
    EXPECT_TRUE(support::near(world[ball].velocity().x, 3, Real(1e-3)));
}

// Without continuous collision a fast ball passes the wall between two steps. This shows that
// continuous collision is what stops it.
TEST(LeaveOut, WithoutContinuousCollisionABallTunnels) {
    for (const bool continuous : {true, false}) {
        WorldDef def = leavingOut(Feature::ContinuousCollision);
        def.gravity = {};
        def.settings.leaveOut = continuous ? Features() : def.settings.leaveOut;
        World world(def);
        support::addWall(world, 5, Real(0.02), support::slippery(1));
        BodyDef ball = support::ballDef({0, 0}, Real(0.1), support::slippery(1));
        ball.velocity = {400, 0};
        const BodyId id = world.add(ball);
        support::run(world, 2);
        EXPECT_EQ(world[id].velocity().x < 0, continuous);
    }
}

TEST(LeaveOut, WithoutSleepNoBodyFallsAsleep) {
    for (const bool sleeps : {true, false}) {
        WorldDef def = leavingOut(Feature::Sleep);
        def.settings.leaveOut = sleeps ? Features() : def.settings.leaveOut;
        World world(def);
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        support::run(world, 300);
        EXPECT_EQ((world[box].flags() & kAsleep) != 0, sleeps);
    }
}

TEST(LeaveOut, WithoutRecordsNoCollisionIsRecorded) {
    World world(leavingOut(Feature::Records));
    support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    support::run(world, 10);
    EXPECT_TRUE(world.collisions().empty());
    EXPECT_NE(world[box].flags() & kColliding, 0u);
}

// X5: parts of a step are left out.
// Without rotation a heap falls, slides and piles up, but no body rotates or gains spin.
TEST(LeaveOut, WithoutRotationNoBodyRotates) {
    for (const Solver strategy : kSolvers) {
        WorldDef def = leavingOut(Feature::Rotation);
        def.settings.solver = support::settingsOf(strategy).solver;
        World world(def);
        support::addHeap(world, 7, 30);
        const BodyId a = world.bodies()[5];
        const BodyId b = world.bodies()[6];
        world.add(DistanceJoint{.ends = {a, b, {Real(0.1), 0}, {}}, .length = 1, .hertz = 3});
        world[a].applyTorque(100);
        const std::vector<Bits> before = bitsOf(world);
        support::run(world, 200);
        const std::vector<Bits> after = bitsOf(world);
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(after[i].rotation, before[i].rotation) << i;
            EXPECT_EQ(after[i].spin, 0) << i;
        }
        EXPECT_LT(world[a].position().y, before[5].position.y);
    }
}

// An off-centre impact moves a bar as if it were a point: v = J / m.
TEST(LeaveOut, WithoutRotationAnOffCentreImpactOnlyTranslates) {
    World world(leavingOut(Feature::Rotation, {}));
    const BodyId bar = world.add(support::boxDef({}, 4, 1, support::slippery(1)));
    BodyDef ball = support::ballDef({Real(1.5), -3}, Real(0.5), support::slippery(1));
    ball.density = 4 / (std::numbers::pi_v<Real> / 4); // 4 kg, as the bar
    ball.velocity = {0, 4};
    const BodyId striker = world.add(ball);
    support::run(world, 60);
    const Real rounding = support::byPrecision(1e-5, 1e-12);
    EXPECT_TRUE(support::near(world[bar].velocity(), Vec2{0, 4}, rounding));
    EXPECT_TRUE(support::near(world[striker].velocity(), Vec2{0, 0}, rounding));
    EXPECT_EQ(world[bar].angularVelocity(), 0);
}

// Like kLockRotate: a set angular velocity persists, and nothing changes it.
TEST(LeaveOut, WithoutRotationASetAngularVelocityPersists) {
    World world(leavingOut(Feature::Rotation));
    support::addFloor(world, withFriction(1));
    const BodyId locked =
        world.add({.shape = Box{1, 1}, .position = {5, 5}, .type = BodyType::Kinematic});
    world[locked].setAngularVelocity(1);
    const BodyId ball = world.add(support::ballDef({0, Real(0.5)}, Real(0.5), withFriction(1)));
    world[ball].setAngularVelocity(-2);
    support::run(world, 60);
    EXPECT_EQ(world[locked].angularVelocity(), 1);
    EXPECT_EQ(world[ball].angularVelocity(), -2);
    EXPECT_TRUE(support::near(world[locked].rotation().angle(), 1.0L, Real(1e-4)));
}

// The feature may change between steps. When it is left out, all spin ends. When it is back, a box
// that stands on a corner wakes and falls over.
TEST(LeaveOut, RotationMayBeSwitchedBetweenSteps) {
    World world(leavingOut(Feature::Rotation));
    support::addFloor(world);
    BodyDef def = support::boxDef({0, Real(0.75)}, 1, 1);
    def.rotation = Rot::fromAngle(Real(0.7)); // a little less than pi/4
    const BodyId box = world.add(def);
    support::run(world, 200);
    ASSERT_NE(world[box].flags() & kAsleep, 0u);
    EXPECT_EQ(world[box].rotation(), normalize(Rot::fromAngle(Real(0.7))));
    world.setSettings({});
    EXPECT_EQ(world[box].flags() & kAsleep, 0u);
    support::run(world, 30);
    EXPECT_NE(world[box].angularVelocity(), 0);
    world.setSettings(without({}, Feature::Rotation));
    EXPECT_EQ(world[box].angularVelocity(), 0);
    const Rot now = world[box].rotation();
    support::run(world, 30);
    EXPECT_EQ(world[box].rotation(), now);
}

// A body that can only sleep because of a feature wakes when that feature is left out.
TEST(LeaveOut, ASleepingBoxOnASlopeSlidesOnceFrictionIsLeftOut) {
    World world({.gravity = support::kEarth});
    const Rot tilt = Rot::fromAngle(Real(-0.3));
    world.add({.shape = Box{40, 1},
               .position = Real(-0.5) * tilt.yAxis(),
               .rotation = tilt,
               .type = BodyType::Kinematic});
    BodyDef def = support::boxDef(Real(0.5) * tilt.yAxis(), 1, 1);
    def.rotation = tilt;
    const BodyId box = world.add(def);
    support::run(world, 120);
    ASSERT_NE(world[box].flags() & kAsleep, 0u);
    world.setSettings(without({}, Feature::Friction));
    support::run(world, 60);
    EXPECT_GT(world[box].velocity().x, 2); // g sin 0.3 = 2.96 m/s^2
}

} // namespace
} // namespace kodo
