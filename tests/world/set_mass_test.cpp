// SPDX-License-Identifier: MIT
// X3: mass, centre of mass and moment of inertia that are set, instead of those from density.
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <functional>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::kEpsilon;
using support::near;
using support::nearShare;
using support::run;
using support::Totals;
using support::totalsOf;

// X3: the mass alone scales the moment of inertia, and the centre stays where it was.
TEST(SetMass, OfANumberScalesTheInertia) {
    World world;
    const BodyId id = world.add(boxDef({3, 4}, 2, 1)); // 2 kg, 2 * 5 / 12 kg m^2
    EXPECT_FALSE(world[id].hasSetMass());
    world[id].setMass(12);
    EXPECT_TRUE(world[id].hasSetMass());
    EXPECT_EQ(world[id].mass(), 12);
    EXPECT_TRUE(near(world[id].inertia(), 5, 8 * kEpsilon));
    EXPECT_EQ(world[id].center(), (Vec2{3, 4}));
    EXPECT_EQ(world[id].area(), 2);
    EXPECT_EQ(world[id].part(0).density, 1);
}

TEST(SetMass, OfCentreAndInertiaIsReadBackExactly) {
    World world;
    const BodyId id = world.add({.shape = Box{2, 1},
                                 .position = {10, 20},
                                 .rotation = {0, 1},
                                 .velocity = {1, 2},
                                 .angularVelocity = 3});
    world[id].setMass({.mass = 5, .center = Vec2{Real(0.5), 0}, .inertia = Real(0.7)});
    EXPECT_EQ(world[id].mass(), 5);
    EXPECT_EQ(world[id].inertia(), Real(0.7));
    EXPECT_EQ(world[id].localCenter(), (Vec2{Real(0.5), 0}));
    EXPECT_EQ(world[id].center(), (Vec2{10, Real(20.5)}));
    EXPECT_EQ(world[id].position(), (Vec2{10, 20})); // the frame does not move
    // All points keep their velocities: that of the old centre is still {1, 2}.
    EXPECT_EQ(world[id].velocityAt({10, 20}), (Vec2{1, 2}));
    EXPECT_EQ(world[id].velocity(), (Vec2{Real(-0.5), 2}));
    EXPECT_EQ(world[id].angularVelocity(), 3);
}

TEST(SetMass, InADefinitionIsThatOfTheSetter) {
    const MassDef mass{.mass = 5, .center = Vec2{Real(0.25), 0}, .inertia = 2};
    World world;
    BodyDef def = boxDef({1, 2}, 2, 1);
    const BodyId later = world.add(def);
    def.mass = mass;
    const BodyId once = world.add(def);
    const BodyId twice = world.add(def); // shares its geometry
    def.mass->inertia = 3;
    const BodyId other = world.add(def);
    world[later].setMass(mass);
    for (const BodyId id : {once, twice, other}) {
        EXPECT_EQ(world[id].mass(), 5);
        EXPECT_EQ(world[id].inertia(), id == other ? 3 : 2);
        EXPECT_EQ(world[id].center(), world[later].center());
        EXPECT_EQ(world[id].bounds(), world[later].bounds());
    }
}

TEST(SetMass, FromDensityGoesBack) {
    World world;
    const BodyId id = world.add(boxDef({}, 2, 1));
    const std::uint64_t before = world.stateHash();
    const Real inertia = world[id].inertia();
    world[id].setMass({.mass = 5, .center = Vec2{1, 1}});
    EXPECT_NE(world.stateHash(), before);
    world[id].setMassFromDensity();
    EXPECT_FALSE(world[id].hasSetMass());
    EXPECT_EQ(world[id].mass(), 2);
    EXPECT_EQ(world[id].inertia(), inertia);
    EXPECT_EQ(world[id].center(), Vec2{});
}

// X3: impulses, forces and torques act on the mass that was set, and gravity accelerates it alike.
TEST(SetMass, DecidesWhatForcesDo) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = {0, -10}, .settings = support::settingsOf(solver)});
        BodyDef def = ballDef({}, 1);
        def.mass = MassDef{.mass = 4, .inertia = 8};
        const BodyId id = world.add(def);
        world[id].applyImpulse({8, 0});
        EXPECT_EQ(world[id].velocity(), (Vec2{2, 0}));
        world[id].applyTorque(480);
        world[id].applyForce({0, 240});
        world.step(kDt);
        EXPECT_TRUE(near(world[id].angularVelocity(), 1, 16 * kEpsilon));
        EXPECT_TRUE(near(world[id].velocity().y, 50.0L / 60, 16 * kEpsilon));
    }
}

// X3: a head-on hit without restitution moves on with the mean velocity by set masses.
TEST(SetMass, DecidesWhatAHitDoes) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.settings = support::settingsOf(solver)});
        BodyDef def = ballDef({}, Real(0.5), support::slippery());
        def.velocity = {6, 0};
        def.mass = MassDef{.mass = 1};
        const BodyId light = world.add(def);
        def.position = {2, 0};
        def.velocity = {};
        def.mass = MassDef{.mass = 5};
        const BodyId heavy = world.add(def);
        run(world, 60);
        EXPECT_TRUE(near(world[light].velocity().x, 1, byPrecision(1e-4, 1e-6)));
        EXPECT_TRUE(near(world[heavy].velocity().x, 1, byPrecision(1e-4, 1e-6)));
    }
}

// X3: a body turns about the centre that was set; that centre moves straight.
TEST(SetMass, ABodyTurnsAboutTheCentreThatWasSet) {
    World world;
    BodyDef def = boxDef({}, 2, 1);
    def.velocity = {1, 0};
    def.angularVelocity = 5;
    def.mass = MassDef{.mass = 3, .center = Vec2{Real(0.75), 0}};
    const BodyId id = world.add(def);
    run(world, 60);
    EXPECT_TRUE(near(world[id].center(), Vec2{Real(1.75), 0}, byPrecision(1e-5, 1e-13)));
    const Vec2 arm = world[id].position() - world[id].center();
    EXPECT_TRUE(near(length(arm), Real(0.75), byPrecision(1e-6, 1e-14)));
    EXPECT_GT(std::abs(arm.y), Real(0.3)); // 5 rad, from -0.75 m on the x axis
}

// X3: a disc with a low centre of mass is a tumbler: it comes to rest with this centre below.
TEST(SetMass, ADiscWithALowCentreRollsUpright) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = {0, -10}, .settings = support::settingsOf(solver)});
        support::addFloor(world);
        BodyDef def = ballDef({0, 1}, 1);
        def.rotation = Rot::fromAngle(1);
        def.material.rollingResistance = Real(0.05);
        const BodyId id = world.add(def);
        world[id].setMass({.mass = 3, .center = Vec2{0, Real(-0.5)}});
        run(world, 1200);
        // Rolling resistance holds it up to an angle of 0.05 / 0.5.
        EXPECT_LT(std::abs(world[id].rotation().angle()), Real(0.11));
        EXPECT_LT(length(world[id].velocity()), Real(0.01));
    }
}

// X3: static and kinematic bodies keep a set mass for the time when they are dynamic.
TEST(SetMass, OfAStaticBodyCountsOnceItIsDynamic) {
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
        World world;
        BodyDef def = boxDef({}, 1, 1);
        def.type = type;
        const BodyId id = world.add(def);
        world[id].setMass(7);
        EXPECT_EQ(world[id].mass(), 7);
        world[id].applyImpulse({14, 0});
        EXPECT_EQ(world[id].velocity(), Vec2{});
        world[id].setType(BodyType::Dynamic);
        EXPECT_EQ(world[id].mass(), 7);
        world[id].applyImpulse({14, 0});
        EXPECT_EQ(world[id].velocity(), (Vec2{2, 0}));
    }
}

TEST(SetMass, SurvivesOtherSetters) {
    World world;
    const BodyId id = world.add(boxDef({}, 1, 1));
    world[id].setMass({.mass = 7, .inertia = 3});
    world[id].setMaterial(support::slippery());
    world[id].setFlags(kLockRotate);
    world[id].setFlags(0);
    world[id].setRotation({0, 1});
    StepSettings settings = world.settings();
    settings.leaveOut = Feature::Rotation;
    world.setSettings(settings);
    world.setSettings({});
    EXPECT_EQ(world[id].mass(), 7);
    EXPECT_EQ(world[id].inertia(), 3);
    world[id].applyTorque(180);
    world.step(kDt);
    EXPECT_TRUE(near(world[id].angularVelocity(), 1, 16 * kEpsilon));
}

// X3: clones, copies and bytes hold a set mass, and the state hash tells it from others.
TEST(SetMass, IsHeldByClonesCopiesBytesAndTheHash) {
    World world({.gravity = support::kEarth});
    const BodyId floor = support::addFloor(world);
    const BodyId id = world.add(boxDef({0, 2}, 2, 1));
    const MassDef mass{.mass = 7, .center = Vec2{Real(0.25), Real(0.125)}, .inertia = 3};
    std::vector<std::uint64_t> hashes{world.stateHash()};
    for (const MassDef& each : {mass, MassDef{.mass = 8, .center = mass.center, .inertia = 3},
                                MassDef{.mass = 7, .inertia = 3},
                                MassDef{.mass = 7, .center = mass.center, .inertia = 4}}) {
        world[id].setMass(each);
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), world.stateHash()), 0);
        hashes.push_back(world.stateHash());
    }
    world[id].setMass(mass);
    for (const Real heavy : {Real(100), Real(200)}) { // static: it counts once it is dynamic
        world[floor].setMass(heavy);
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), world.stateHash()), 0);
        hashes.push_back(world.stateHash());
    }
    const BodyId other = world.clone(id, {5, 2});
    World copy = world;
    World loaded = fromBytes(toBytes(world));
    for (int i = 0; i < 100; ++i) {
        for (World* each : {&world, &copy, &loaded}) {
            each->step(kDt);
            for (const BodyId body : {id, other}) {
                ASSERT_EQ((*each)[body].mass(), 7);
                ASSERT_EQ((*each)[body].inertia(), 3);
                ASSERT_EQ((*each)[body].localCenter(), *mass.center);
            }
        }
        ASSERT_EQ(copy.stateHash(), world.stateHash());
        ASSERT_EQ(loaded.stateHash(), world.stateHash());
    }
    loaded[id].setMassFromDensity();
    EXPECT_EQ(loaded[id].mass(), 2);
}

// X3: a mass that is not in the range of all masses is refused by name, and nothing changes.
TEST(SetMass, RefusesWhatNoBodyCanHave) {
    World world;
    const BodyId id = world.add(boxDef({}, 2, 1));
    const BodyId point = world.add({.shape = Point{}});
    const BodyId ground = world.add({.shape = Plane{}, .type = BodyType::Static});
    const Real big = sizeof(Real) == 4 ? Real(1e37) : Real(1e201);
    struct Row {
        const char* field;
        MassDef mass;
    };
    const Row rows[] = {
        {"mass", {}},
        {"mass", {.mass = 0}},
        {"mass", {.mass = -1}},
        {"mass", {.mass = support::kNan}},
        {"mass", {.mass = support::kInf}},
        {"mass", {.mass = 2 * kMaxMass}},
        {"mass", {.mass = Real(0.4) / kMaxMass}},
        {"mass.center", {.mass = 1, .center = Vec2{support::kNan, 0}}},
        {"mass.center", {.mass = 1, .center = Vec2{0, 2 * kMaxCoordinate}}},
        {"mass.inertia", {.mass = 1, .inertia = 0}},
        {"mass.inertia", {.mass = 1, .inertia = -1}},
        {"mass.inertia", {.mass = 1, .inertia = support::kNan}},
        {"mass.inertia", {.mass = 1, .inertia = big}},
        // With the rim at 1.118 m from the centre, a 256th of 1.25 kg m^2 is the least.
        {"mass.inertia", {.mass = 1, .inertia = Real(1.24) / 256}},
        {"mass", {.mass = 1, .center = Vec2{100, 0}}},
    };
    const std::uint64_t before = world.stateHash();
    const auto fieldOf = [](const std::function<void()>& call) -> std::string {
        try {
            call();
            return "accepted";
        } catch (const BadDefinition& bad) {
            return bad.problem().field;
        }
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(testing::Message() << row.field << " of " << row.mass.mass << " kg");
        EXPECT_EQ(fieldOf([&] { world[id].setMass(row.mass); }), row.field);
        BodyDef def = boxDef({}, 2, 1);
        def.mass = row.mass;
        ASSERT_TRUE(check(def));
        EXPECT_EQ(check(def)->field, row.field);
    }
    EXPECT_EQ(fieldOf([&] { world[ground].setMass(1); }), "mass");
    EXPECT_EQ(fieldOf([&] { world[point].setMass({.mass = 1, .inertia = 0}); }), "mass.inertia");
    EXPECT_EQ(world.stateHash(), before);
    EXPECT_NO_THROW(world[point].setMass(3)); // a particle: its moment of inertia stays 0
    EXPECT_EQ(world[point].inertia(), 0);
    EXPECT_NO_THROW(world[id].setMass(kMaxMass));
    EXPECT_NO_THROW(world[id].setMass(2 / kMaxMass));
    EXPECT_NO_THROW(world[id].setMass({.mass = 1, .inertia = Real(1.26) / 256}));
}

// X3: a floor holds a box at the limits of mass and moment of inertia.
TEST(SetMass, ABoxAtItsLimitsStaysOnTheFloor) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real mass : {Real(1e-12), Real(1), kMaxMass}) {
            for (const Real share : {kMinInertiaShare, Real(1), Real(1e6)}) {
                World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
                support::addFloor(world);
                BodyDef def = boxDef({0, 1}, 2, 1);
                def.rotation = Rot::fromAngle(Real(0.3));
                const Real inertia = Real(1.3) * share * mass; // 1.25 m^2 to the corners
                def.mass = MassDef{.mass = mass, .inertia = inertia};
                const BodyId id = world.add(def);
                run(world, 60);
                EXPECT_TRUE(near(world[id].position().y, Real(0.65), Real(0.2)))
                    << mass << " kg, " << inertia << " kg m^2";
                EXPECT_TRUE(world.frozenBodies().empty());
            }
        }
    }
}

/// A body of several parts, and one that is welded to it, with masses set as the bits say.
struct WeldPair {
    World world;
    BodyId into;
    BodyId part;

    explicit WeldPair(int bits) {
        BodyDef def{.shape = Compound{{Box{1, 1}, Circle{Real(0.5), {1, 0}}}},
                    .rotation = Rot::fromAngle(Real(0.3)),
                    .velocity = {1, 2},
                    .angularVelocity = 2};
        into = world.add(def);
        def.shape = Compound{{Box{1, 2}, Circle{Real(0.25), {0, 1}}}};
        def.position = {2, 1};
        def.rotation = Rot::fromAngle(-1);
        def.velocity = {-1, 0};
        part = world.add(def);
        if ((bits & 1) != 0) {
            world[into].setMass({.mass = 6, .center = Vec2{0, Real(0.25)}, .inertia = 2});
        }
        if ((bits & 2) != 0) {
            world[part].setMass({.mass = 9, .center = Vec2{Real(0.125), 0}, .inertia = 5});
        }
    }
};

// X3: weld adds the set mass to that of the other body and keeps both momenta.
TEST(SetMass, IsAddedByAWeld) {
    for (int bits = 0; bits < 4; ++bits) {
        SCOPED_TRACE(bits);
        WeldPair pair(bits);
        const Totals before = totalsOf(pair.world);
        const Real sum = pair.world[pair.into].mass() + pair.world[pair.part].mass();
        pair.world.weld(pair.into, pair.part);
        EXPECT_EQ(pair.world[pair.into].hasSetMass(), bits != 0);
        EXPECT_TRUE(nearShare(pair.world[pair.into].mass(), sum, 4 * kEpsilon));
        const Totals after = totalsOf(pair.world);
        EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(2e-5, 1e-13)));
        EXPECT_TRUE(near(after.spin, before.spin, byPrecision(1e-4, 1e-12)));
    }
}

// X3, X7: a single part is taken off with the mass that was set for it, and the rest has its own.
TEST(SetMass, IsTakenOffByAnUnweld) {
    World world;
    const BodyId into = world.add(boxDef({}, 1, 1));
    const BodyId wheel = world.add(ballDef({2, 0}, Real(0.5)));
    world[wheel].setMass({.mass = 9, .center = Vec2{Real(0.125), 0}, .inertia = 5});
    world.weld(into, Box{1, 1, {0, 1}}, {}, 1);
    const Real mass = world[into].mass();
    const Real inertia = world[into].inertia();
    const std::size_t place = world.weld(into, wheel);
    EXPECT_EQ(place, 2u);
    EXPECT_EQ(world[into].mass(), mass + 9);
    const BodyId other = world.unweld(into, 0); // not the wheel, whose index is 1 now
    EXPECT_EQ(world[other].mass(), 1);
    EXPECT_FALSE(world[other].hasSetMass());
    const BodyId freed = world.unweld(into, 1);
    EXPECT_EQ(world[freed].mass(), 9);
    EXPECT_EQ(world[freed].inertia(), 5);
    EXPECT_TRUE(near(world[freed].center(), Vec2{Real(2.125), 0}, 8 * kEpsilon));
    EXPECT_EQ(world[into].mass(), mass - 1);
    EXPECT_FALSE(world[into].hasSetMass());
    EXPECT_LT(world[into].inertia(), inertia);
}

// X3: of a mass that was set for several parts, each takes its share by density. With the mass
// alone, both momenta stay.
TEST(SetMass, OfSeveralPartsIsDividedByDensity) {
    World world;
    const Compound pair{{Box{1, 1, {-1, 0}}, Box{1, 3, {1, 0}}}};
    const BodyId whole = world.add({.shape = pair, .velocity = {1, 2}, .angularVelocity = 3});
    world[whole].setMass(20);
    const Totals before = totalsOf(world);
    const BodyId freed = world.unweld(whole, 0);
    EXPECT_TRUE(nearShare(world[freed].mass(), 5, 4 * kEpsilon));
    EXPECT_TRUE(nearShare(world[whole].mass(), 15, 4 * kEpsilon));
    EXPECT_TRUE(nearShare(world[whole].inertia(), 15 * 10 / 12.0L, 8 * kEpsilon));
    EXPECT_TRUE(world[freed].hasSetMass() && world[whole].hasSetMass());
    const Totals after = totalsOf(world);
    EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(1e-4, 1e-12)));
    EXPECT_TRUE(near(after.spin, before.spin, byPrecision(2e-4, 1e-12)));
    world[whole].setMassFromDensity();
    EXPECT_EQ(world[whole].mass(), 3);
}

// X3: a thousand welds and unwelds restore all set masses.
TEST(SetMass, IsRestoredByAThousandWelds) {
    World world;
    const BodyId into = world.add(boxDef({}, 2, 1));
    world[into].setMass({.mass = 3, .center = Vec2{Real(0.25), 0}, .inertia = 1});
    BodyId part = world.add(ballDef({2, 0}, Real(0.5)));
    world[part].setMass({.mass = 9, .inertia = 5});
    for (int i = 0; i < 1000; ++i) {
        part = world.unweld(into, world.weld(into, part));
    }
    EXPECT_EQ(world[into].mass(), 3);
    EXPECT_EQ(world[into].inertia(), 1);
    EXPECT_EQ(world[into].localCenter(), (Vec2{Real(0.25), 0}));
    EXPECT_EQ(world[part].mass(), 9);
    EXPECT_EQ(world[part].inertia(), 5);
    EXPECT_TRUE(near(world[part].center(), Vec2{2, 0}, byPrecision(1e-4, 1e-12)));
}

// X3: a joint holds where it was, though the centre of mass moves.
TEST(SetMass, KeepsTheAnchorsOfJoints) {
    World world({.gravity = support::kEarth});
    const BodyId post = world.add({.shape = Box{1, 1}, .type = BodyType::Static});
    const BodyId bob = world.add(boxDef({1, 0}, 2, Real(0.5)));
    world.add(RevoluteJoint{.ends = {.a = post, .b = bob, .anchorB = {-1, 0}}});
    run(world, 20);
    world[bob].setMass({.mass = 5, .center = Vec2{Real(-0.5), 0}});
    for (int i = 0; i < 120; ++i) {
        world.step(kDt);
        ASSERT_LT(length(world[bob].transform() * Vec2{-1, 0}), Real(0.01));
    }
}

// Each mass that is accepted can be read back from bytes, also where it is so small that the moment
// of inertia of a welded point is hardly a number.
TEST(SetMass, ThatIsAcceptedIsReadFromBytes) {
    int accepted = 0;
    for (double mass = 1; mass >= 1e-18; mass /= 10) {
        World world;
        const BodyId body = world.add({.shape = Point{}});
        world.weld(body, Segment{{0, 0}, {1, 0}}, Material{}, Real(1e-3));
        try {
            world[body].setMass(static_cast<Real>(mass));
        } catch (const BadDefinition&) {
            continue;
        }
        ++accepted;
        EXPECT_EQ(fromBytes(toBytes(world)).stateHash(), world.stateHash()) << mass << " kg";
    }
    EXPECT_GT(accepted, 10);
}

} // namespace
} // namespace kodo
