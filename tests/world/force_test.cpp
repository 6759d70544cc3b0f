// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <memory>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kDt;
using support::kEpsilon;
using support::near;

// R3: F = m a for one step; then the force is cleared.
TEST(Force, ActsForOneStep) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2)); // 4 kg
    world[box].applyForce({8, -4});
    world[box].applyForce({4, 0});
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{3 * kDt, -1 * kDt}, 4 * kEpsilon));
    const Vec2 velocity = world[box].velocity();
    world.step(kDt);
    EXPECT_EQ(world[box].velocity(), velocity);
}

/// A state in which forces cannot move a body, and the return from it without a teleport.
struct Bound {
    const char* name;
    void (*bind)(World&, BodyId);
    void (*release)(World&, BodyId);
};
const Bound kBound[] = {
    {"locked", [](World& w, BodyId id) { w[id].setType(BodyType::Kinematic); },
     [](World& w, BodyId id) { w[id].setType(BodyType::Dynamic); }},
    {"outside the region",
     [](World& w, BodyId) {
         w.setRegion(Aabb{{50, 50}, {60, 60}});
     },
     [](World& w, BodyId) { w.setRegion(std::nullopt); }},
    {"frozen",
     [](World& w, BodyId id) {
         w[id].applyForce({std::numeric_limits<Real>::max() / 2, 0});
         w.step(kDt);
     },
     [](World& w, BodyId id) { w[id].setVelocity({}); }},
    {"locked, but moving",
     [](World& w, BodyId id) {
         w[id].setType(BodyType::Kinematic);
         w[id].setVelocity({0, 1});
     },
     [](World& w, BodyId id) {
         w[id].setType(BodyType::Dynamic);
         w[id].setVelocity({});
     }},
};

// Forces on kinematic, frozen or outside bodies are cleared at the end of the step. They do not
// accumulate until the body can move again.
TEST(Force, IsClearedByAStepInWhichItCouldNotAct) {
    for (const Bound& bound : kBound) {
        SCOPED_TRACE(bound.name);
        World world;
        const BodyId box = world.add(boxDef({}, 2, 2));
        bound.bind(world, box);
        for (int i = 0; i < 10; ++i) {
            world[box].applyForce({6, 0}, {0, 1});
            world[box].applyTorque(3);
            world.applyForceToAll({6, 0});
            world.applyTorqueToAll(3);
            world.step(kDt);
        }
        bound.release(world, box);
        world.step(kDt);
        EXPECT_EQ(world[box].velocity(), Vec2{});
        EXPECT_EQ(world[box].angularVelocity(), 0);
        world[box].applyForce({4, 0});
        world.step(kDt);
        EXPECT_TRUE(near(world[box].velocity(), Vec2{kDt, 0}, 4 * kEpsilon));
    }
}

// The state of the body at the step decides, not its state at the call.
TEST(Force, ActsIfTheBodyIsDynamicAtTheStep) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2)); // 4 kg
    world[box].setType(BodyType::Kinematic);
    world[box].applyForce({4, 0});
    world[box].setType(BodyType::Dynamic);
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{kDt, 0}, 4 * kEpsilon));
    world[box].setVelocity({});
    world[box].applyForce({4, 0});
    world[box].setType(BodyType::Kinematic);
    world.step(kDt);
    world[box].setType(BodyType::Dynamic);
    world.step(kDt);
    EXPECT_EQ(world[box].velocity(), Vec2{});
}

// A snapshot between the call and the step contains the force; the next step clears it.
TEST(Force, IsPartOfASnapshot) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2));
    world[box].setType(BodyType::Kinematic);
    world[box].applyForce({4, 0});
    World read = fromBytes(toBytes(world));
    EXPECT_EQ(read.stateHash(), world.stateHash());
    read.step(kDt);
    read[box].setType(BodyType::Dynamic);
    read.step(kDt);
    EXPECT_EQ(read[box].velocity(), Vec2{});
}

// A force on static ground has no effect: the box on it stays asleep.
TEST(Force, OnStaticGroundWakesNoBody) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    support::run(world, 120);
    ASSERT_NE(world[box].flags() & kAsleep, 0u);
    world[floor].applyForce({0, 1000});
    world.step(kDt);
    EXPECT_NE(world[box].flags() & kAsleep, 0u);
}

// R3, [Thesis06, eq. 4.6]: a force at a point adds the torque r x F.
TEST(Force, AtAPointAddsTorque) {
    World world;
    const BodyId box = world.add(boxDef({10, 10}, 2, 2)); // I = 4 * 8 / 12
    world[box].applyForce({0, 6}, {11, 10});
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{0, Real(1.5) * kDt}, 4 * kEpsilon));
    EXPECT_TRUE(near(world[box].angularVelocity(), 6 / (32.0L / 12) * static_cast<long double>(kDt),
                     4 * kEpsilon));
}

TEST(Force, TorqueChangesTheAngularVelocityOnly) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2));
    world[box].applyTorque(8);
    world.step(kDt);
    EXPECT_EQ(world[box].velocity(), Vec2{});
    EXPECT_TRUE(near(world[box].angularVelocity(), 3 * kDt, 4 * kEpsilon));
}

// R3: dv = J / m, dw = r x J / I, at once.
TEST(Force, AnImpulseActsAtOnce) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2));
    world[box].applyImpulse({0, 8});
    EXPECT_EQ(world[box].velocity(), (Vec2{0, 2}));
    world[box].applyImpulse({4, 0}, {0, 1});
    EXPECT_EQ(world[box].velocity(), (Vec2{1, 2}));
    EXPECT_TRUE(near(world[box].angularVelocity(), -1.5L, 4 * kEpsilon));
}

// R3: an impulse J at any point adds J to the momentum and r x J to the angular momentum.
TEST(Force, RandomImpulsesAddUp) {
    constexpr std::uint64_t kSeed = 121;
    support::RandomNumbers random(kSeed);
    World world;
    const BodyId box = world.add(boxDef({1, 2}, 3, 1));
    BasicVec2<long double> momentum;
    long double spin = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec2 impulse = random.point(1);
        const Vec2 point = random.point(3);
        world[box].applyImpulse(impulse, point);
        momentum += BasicVec2<long double>{static_cast<long double>(impulse.x),
                                           static_cast<long double>(impulse.y)};
        spin += static_cast<long double>(cross(point, impulse));
    }
    const support::Totals totals = support::totalsOf(world);
    // 100 impulses of up to 4 N s m, each rounded.
    EXPECT_TRUE(near(totals.momentum, momentum, 200 * kEpsilon)) << "seed " << kSeed;
    EXPECT_TRUE(near(totals.spin, spin, 800 * kEpsilon)) << "seed " << kSeed;
}

// W2: gravity is an ordinary force field, the first in the list.
TEST(Force, GravityIsTheFirstField) {
    World world({.gravity = {0, -10}});
    ASSERT_EQ(world.fields().size(), 1u);
    const BodyId light = world.add(ballDef({}, Real(0.1)));
    const BodyId heavy = world.add(ballDef({50, 0}, 3));
    support::run(world, 60);
    EXPECT_TRUE(near(world[light].velocity(), Vec2{0, -10}, 100 * kEpsilon));
    EXPECT_TRUE(near(world[heavy].velocity(), Vec2{0, -10}, 100 * kEpsilon));
    EXPECT_TRUE(World().fields().empty());
}

// W2: a field restricted by a filter.
TEST(Force, AFieldActsOnBodiesItsFilterAccepts) {
    World world;
    world.addField({std::make_shared<Gravity>(Vec2{0, -6}), {kMatchAny, 0b10}});
    BodyDef def = ballDef({}, 1);
    def.flags = 0b01;
    const BodyId spared = world.add(def);
    def.position.x = 10;
    def.flags = 0b11;
    const BodyId pulled = world.add(def);
    world.step(kDt);
    EXPECT_EQ(world[spared].velocity(), Vec2{});
    EXPECT_TRUE(near(world[pulled].velocity(), Vec2{0, -6 * kDt}, 4 * kEpsilon));
}

/// A force along x that grows with the mass squared, and a torque.
class OddField final : public ForceField {
public:
    FieldForce at(const BodyView& body, Real) const override {
        const Real mass = body.mass();
        return {{mass * mass, 0}, 3};
    }
};

/// A force so large that its square is infinite.
class StrongField final : public ForceField {
public:
    explicit StrongField(Real force) : force_(force) {}
    FieldForce at(const BodyView&, Real) const override { return {.force = {force_, 0}}; }

private:
    Real force_;
};

// Two opposite fields leave a body unchanged, although the squares of their forces are infinite.
TEST(Force, FieldsThatCancelOutLeaveABodyUnchanged) {
    const Real strong = std::numeric_limits<Real>::max() / 2;
    World world;
    world.addField({std::make_shared<StrongField>(strong)});
    world.addField({std::make_shared<StrongField>(-strong)});
    const BodyId flying = world.add(boxDef({0, 5}, 2, 2));
    const BodyId lying = world.add(boxDef({0, 0}, 2, 2));
    const BodyId onTop = world.add(boxDef({0, 2}, 2, 2)); // in contact, so it is solved in substeps
    for (int step = 0; step < 3; ++step) {
        world.step(kDt);
    }
    EXPECT_TRUE(world.frozenBodies().empty());
    for (const BodyId body : {flying, lying, onTop}) {
        EXPECT_EQ(world[body].mass(), 4);
        EXPECT_EQ(world[body].velocity(), Vec2{});
        EXPECT_EQ(world[body].angularVelocity(), 0);
    }
    world[lying].setVelocity({1, 0});
    world.step(kDt);
    EXPECT_GT(world[lying].position().x, 0);
}

// W2: a user-defined field acts beside the others.
TEST(Force, AUserDefinedFieldActs) {
    World world({.gravity = support::kEarth});
    world.addField({std::make_shared<OddField>()});
    const BodyId box = world.add(boxDef({}, 2, 2));
    world.step(kDt);
    EXPECT_TRUE(near(world[box].velocity(), Vec2{4 * kDt, -10 * kDt}, 4 * kEpsilon));
    EXPECT_TRUE(near(world[box].angularVelocity(), 3 * kDt * Real(12) / 32, 4 * kEpsilon));
}

// Forces and impulses act beyond kMaxCoordinate, which limits only positions that are set.
TEST(Force, ActsBeyondTheCoordinateLimit) {
    World world;
    const BodyId near = world.add(ballDef({}, 1));
    BodyDef def = ballDef({kMaxCoordinate, 0}, 1);
    def.velocity = {kMaxSpeed / 2, 0}; // below the limit, since an impulse adds to it
    const BodyId far = world.add(def);
    world.step(1);
    ASSERT_GT(world[far].position().x, kMaxCoordinate);
    world.applyForceToAll({0, 3});
    for (const BodyId id : {near, far}) {
        world[id].applyImpulse({0, 5});
    }
    world.step(kDt);
    EXPECT_GT(world[near].velocity().y, 0);
    EXPECT_EQ(world[far].velocity().y, world[near].velocity().y);
}

// W2: a force on all bodies, or on those that a filter accepts.
TEST(Force, OnAllBodiesActsOnThoseItsFilterAccepts) {
    World world;
    BodyDef def = boxDef({}, 1, 1);
    def.flags = 1;
    const BodyId one = world.add(def);
    def.position.x = 5;
    def.flags = 2;
    const BodyId two = world.add(def);
    world.applyForceToAll({6, 0});
    world.applyForceToAll({6, 0}, {kMatchAny, 2});
    world.applyTorqueToAll(1, {kMatchAny, 1});
    world.step(kDt);
    EXPECT_TRUE(near(world[one].velocity().x, 6 * kDt, 4 * kEpsilon));
    EXPECT_TRUE(near(world[two].velocity().x, 12 * kDt, 4 * kEpsilon));
    EXPECT_TRUE(near(world[one].angularVelocity(), 6 * kDt, 4 * kEpsilon));
    EXPECT_EQ(world[two].angularVelocity(), 0);
}

// A copied World shares the immutable fields, and nothing else.
TEST(Force, ACopiedWorldSharesItsFieldsOnly) {
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(ballDef({}, 1));
    World copy = world;
    copy.addField({std::make_shared<Gravity>(Vec2{0, 10})});
    world.step(kDt);
    copy.step(kDt);
    EXPECT_LT(world[ball].velocity().y, 0);
    EXPECT_EQ(copy[ball].velocity().y, 0);
}

} // namespace
} // namespace kodo
