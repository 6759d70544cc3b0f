// SPDX-License-Identifier: MIT
#include <kodo/base/bytes.hpp>
#include <support/draws.hpp>
#include <support/same_records.hpp>
#include <support/scenes.hpp>

#include <world/snapshot_scenes.hpp>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <tuple>

namespace kodo {
namespace {

using support::busyWorld;
using support::kDt;
using support::ownFields;
using support::run;
using support::sameRecords;

using support::Bytes;

/// Of a world with these fields of the user's own.
World reloaded(const World& world, const support::OwnFields& own = {}) {
    return fromBytes(toBytes(world), own);
}

/// Steps both and compares: what the engine calls the state, what it reports, and now and then
/// every stored field of it.
void expectToGoOnAlike(World& world, World& other, int steps) {
    for (int i = 0; i <= steps; ++i) {
        ASSERT_EQ(other.stateHash(), world.stateHash()) << "after " << i << " steps";
        ASSERT_TRUE(sameRecords(other, world)) << "after " << i << " steps";
        ASSERT_TRUE(i % 20 != 0 || toBytes(other) == toBytes(world)) << "after " << i << " steps";
        world.step(kDt);
        other.step(kDt);
    }
}

// What a step leaves for later, until somebody asks for it, is the same whether anybody does.
TEST(Snapshot, WhoAsksChangesNothing) {
    for (const StepSettings& settings : {StepSettings{}, thesis2006()}) {
        World asked = busyWorld(settings);
        World left = asked;
        for (int i = 0; i < 300; ++i) {
            asked.step(kDt);
            left.step(kDt);
            const std::size_t records = asked.collisions().size();
            if (i % 3 == 0) {
                ASSERT_FALSE(toBytes(asked).empty());
            }
            if (i % 7 == 0) {
                ASSERT_EQ(left.collisions().size(), records) << "step " << i;
            }
            if (i % 50 == 49) {
                ASSERT_EQ(asked.stateHash(), left.stateHash()) << "step " << i;
                ASSERT_TRUE(sameRecords(asked, left)) << "step " << i;
            }
        }
    }
}

StepSettings withShock() {
    StepSettings settings = thesis2006();
    settings.shockPasses = 3;
    return settings;
}

// R2: snapshot and restore are bit-exact, in the air, in the thick of a heap and at rest.
TEST(Snapshot, GoesOnAlikeFromAnyMoment) {
    for (const StepSettings& settings : {StepSettings{}, thesis2006(), withShock()}) {
        World world = busyWorld(settings);
        int steps = 0;
        for (const int moment : {0, 1, 70, 150, 400}) {
            run(world, moment - steps);
            steps = moment;
            SCOPED_TRACE(testing::Message() << "strategy " << static_cast<int>(settings.strategy)
                                            << ", saved after " << moment << " steps");
            World original = world;
            World loaded = reloaded(world, ownFields());
            expectToGoOnAlike(original, loaded, support::kSanitized ? 100 : 300);
        }
    }
}

// R2: so many contacts are put in order now and then, which decides the order they are solved in.
// A bar stirs them, so that many come in each step, and order is due within each hundred of them.
TEST(Snapshot, GoesOnAlikeWhileContactsArePutInOrder) {
    World world({.gravity = support::kEarth});
    world.add({.shape = Box{64, 1}, .position = {0, Real(-0.5)}, .flags = kLocked});
    for (const Real side : {Real(-17), Real(17)}) {
        world.add({.shape = Box{1, 80}, .position = {side, 40}, .flags = kLocked});
    }
    world.add({.shape = Box{20, 1}, .position = {0, 11}, .angularVelocity = 2, .flags = kLocked});
    support::RandomNumbers random(31);
    for (int i = 0; i < 1600; ++i) {
        const Vec2 place{static_cast<Real>(i % 40 - 20) * Real(0.8),
                         static_cast<Real>(i / 40) * Real(0.8) + 1};
        world.add(support::ballDef(place + random.point(0.05), Real(0.37)));
    }
    run(world, 150);
    ASSERT_GT(world.collisions().size(), Disorder::kMany);
    World original = world;
    World loaded = reloaded(world);
    expectToGoOnAlike(original, loaded, 150);
}

// R2: in a World of another length unit everything may be as large, as far and as fast in that.
TEST(Snapshot, GoesOnAlikeInAnotherLengthUnit) {
    for (const Real unit : {Real(1000), Real(1) / 1000}) {
        SCOPED_TRACE(unit);
        World world({.gravity = unit * support::kEarth, .lengthUnit = unit});
        BodyDef ball = support::ballDef({}, unit / 2);
        ball.density = 1 / (unit * unit);
        std::vector<BodyId> balls;
        for (int i = 0; i < 4; ++i) {
            ball.position = {static_cast<Real>(i) * 20 * unit, 0};
            ball.velocity = {0, kHighestSpeed / 4 * unit};
            balls.push_back(world.add(ball));
        }
        const Real most = kFarthest / 2 * unit;
        world.add(Spring{.ends = {.a = balls[0], .b = balls[1], .anchorA = {0, most}},
                         .length = most,
                         .hertz = 1,
                         .limits = Range{0, most}});
        world.add(Slider{.ends = {.a = balls[2], .b = balls[3]},
                         .axis = {1, 0},
                         .limits = Range{-most, most},
                         .motorSpeed = kHighestSpeed / 4 * unit,
                         .motorForce = unit});
        run(world, 2);
        World loaded = reloaded(world);
        expectToGoOnAlike(world, loaded, 20);
    }
}

// A wall that nothing stops comes at boxes that rest, touches or leaps at them, and pushes them
// along: whoever was read from bytes in any step of that goes on alike.
TEST(Snapshot, GoesOnAlikeWhileWhatRestsIsPushedByAMovingWall) {
    for (const Real speed : {Real(0.5), Real(6), Real(60), Real(300)}) {
        SCOPED_TRACE(speed);
        World world({.gravity = support::kEarth});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        world.add(support::boxDef({1, Real(0.5)}, 1, 1)); // touches it
        world.add(support::boxDef({Real(2.5), Real(0.5)}, 1, 1));
        const BodyId wall =
            world.add({.shape = Box{1, 3}, .position = {Real(-1.1), Real(1.6)}, .flags = kLocked});
        run(world, 100);
        ASSERT_NE(world[box].flags() & kResting, 0u);
        world[wall].setVelocity({speed, 0});
        for (int step = 0; step < 20; ++step) {
            World original = world;
            World loaded = reloaded(world);
            expectToGoOnAlike(original, loaded, 15);
            world.step(kDt);
        }
        EXPECT_EQ(world[box].flags() & kResting, 0u);
        EXPECT_GT(world[box].position().x, 0);
    }
}

// The scene is worth its name: a snapshot of it holds something of everything.
TEST(Snapshot, TheBusyWorldHasEverything) {
    World world = busyWorld();
    std::size_t broken = 0;
    for (int i = 0; i < 150; ++i) {
        world.step(kDt);
        broken += world.brokenJoints().size();
    }
    Flags met = 0;
    std::size_t resting = 0;
    for (const BodyId id : world.bodies()) {
        met |= world[id].flags();
        resting += (world[id].flags() & kResting) != 0 ? 1 : 0;
    }
    EXPECT_EQ(met & (kResting | kColliding | kOutside), kResting | kColliding | kOutside);
    EXPECT_GE(resting, 3u);
    EXPECT_GT(world.collisions().size(), 20u);
    EXPECT_EQ(world.joints().size() + broken, 7u);
    EXPECT_EQ(broken, 1u);
}

// Between two steps everything may be changed; what has been is part of the snapshot.
TEST(Snapshot, HoldsWhatWasChangedSinceTheLastStep) {
    support::RandomNumbers random(5); // fixed: a failure is repeatable
    World world = busyWorld();
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        run(world, 5);
        for (int change = 0; change < 3; ++change) {
            const std::vector<BodyId> bodies = world.bodies();
            const BodyId id = bodies[8 + random.below(bodies.size() - 8)];
            switch (random.below(7)) {
            case 0:
                world.remove(id);
                break;
            case 1:
                world.add(support::pieceDef(random, static_cast<int>(random.below(40))));
                break;
            case 2:
                world[id].applyForce(random.point(50));
                break;
            case 3:
                world[id].setMaterial(support::slippery());
                break;
            case 4:
                world.weld(bodies[8], Circle{Real(0.25), random.point(0.5)}, {}, 1);
                break;
            case 5:
                world[id].setPosition(random.point(5));
                break;
            default:
                world.clone(id, random.point(5));
            }
        }
        World original = world;
        World loaded = reloaded(world, ownFields());
        ASSERT_TRUE(toBytes(loaded) == toBytes(world));
        expectToGoOnAlike(original, loaded, 3);
    }
}

// W1: names given out after loading are those that the original gives out.
TEST(Snapshot, IdsAreReusedAlike) {
    support::RandomNumbers random(3); // fixed: a failure is repeatable
    World world = busyWorld();
    for (int i = 0; i < 12; ++i) {
        world.remove(world.bodies()[10 + random.below(20)]);
        world.remove(world.joints().empty() ? world.add(Mouse{world.bodies()[12]})
                                            : world.joints().front());
    }
    World loaded = reloaded(world, ownFields());
    for (int i = 0; i < 30; ++i) {
        const BodyDef def = support::pieceDef(random, i);
        const BodyId id = world.add(def);
        ASSERT_EQ(loaded.add(def), id);
        const JointDef hand = Mouse{id};
        ASSERT_EQ(loaded.add(hand), world.add(hand));
        if (i % 3 == 0) {
            world.remove(id);
            loaded.remove(id);
        }
    }
    EXPECT_EQ(loaded.stateHash(), world.stateHash());
}

// Who is looked at by the sweep goes by the thinnest of all bodies, which is found only when the
// list of who is awake is: a plank that comes to a peg that turns is stopped in both Worlds or in
// none. It goes farther in a step than contacts are foreseen, and less far than anybody looks.
TEST(Snapshot, GoesOnAlikeWhereSomethingThinTurns) {
    for (int i = 0; i < 16; ++i) {
        World world;
        BodyDef peg{.shape = Circle{Real(0.1)}, .flags = kLocked};
        peg.angularVelocity = 12;
        world.add(peg);
        BodyDef plank{.shape = Box{4, Real(0.2)}};
        plank.position = {0, Real(0.35) + Real(i) / 512};
        plank.velocity = {0, Real(-1.3)};
        world.add(plank);
        run(world, 2);
        World loaded = reloaded(world);
        run(world, 20);
        run(loaded, 20);
        EXPECT_EQ(loaded.stateHash(), world.stateHash()) << "start " << i;
    }
}

TEST(Snapshot, FormsThatAreSharedStayShared) {
    World world;
    Compound many;
    for (int i = 0; i < 100; ++i) {
        many.parts.emplace_back(Circle{1, {static_cast<Real>(i), 0}});
    }
    const BodyId first = world.add({.shape = many});
    const std::size_t one = toBytes(world).size();
    const BodyId second = world.clone(first, {0, 10});
    // Two bounds of eight numbers for each part, and no second list of parts, each of which takes
    // as many as one of them.
    EXPECT_LT(toBytes(world).size() - one, std::size_t{100} * (16 + 2) * sizeof(Real));
    const World loaded = reloaded(world);
    EXPECT_EQ(&loaded[first].part(7), &loaded[second].part(7));
    EXPECT_EQ(loaded[second].mass(), world[second].mass());
}

TEST(Snapshot, HoldsSettingsRegionAndTheResultsOfTheLastStep) {
    World world = busyWorld();
    while (world.brokenJoints().empty()) {
        world.step(kDt);
    }
    StepSettings settings = world.settings();
    settings.substeps = 7;
    world.setSettings(settings);
    const World loaded = reloaded(world, ownFields());
    EXPECT_EQ(loaded.settings(), settings);
    EXPECT_EQ(loaded.tolerances().slop, world.tolerances().slop);
    EXPECT_EQ(loaded.tolerances().grown, world.tolerances().grown);
    EXPECT_EQ(loaded.region(), world.region());
    EXPECT_EQ(loaded.stepCount(), world.stepCount());
    EXPECT_EQ(loaded.bodies(), world.bodies());
    EXPECT_EQ(loaded.bodyCount(), world.bodyCount());
    EXPECT_EQ(loaded.joints(), world.joints());
    EXPECT_EQ(loaded.contactVisits(), world.contactVisits());
    ASSERT_EQ(loaded.brokenJoints().size(), 1u);
    EXPECT_EQ(loaded.brokenJoints()[0].id, world.brokenJoints()[0].id);
    EXPECT_EQ(loaded.brokenJoints()[0].force, world.brokenJoints()[0].force);
    for (const JointId id : world.joints()) {
        EXPECT_EQ(loaded.jointForce(id), world.jointForce(id));
        EXPECT_EQ(loaded.jointTorque(id), world.jointTorque(id));
    }
    for (const BodyId id : world.bodies()) {
        EXPECT_EQ(loaded[id].userData(), world[id].userData());
        EXPECT_EQ(loaded[id].flags(), world[id].flags());
    }
}

// Zeros keep their sign, and what is not a number stays that.
TEST(Snapshot, KeepsEveryBitOfANumber) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    World world;
    const BodyId ball = world.add(support::ballDef({}, 1));
    world[ball].setVelocity({-Real(0), 0});
    world.addField({std::make_shared<Gravity>(Vec2{nan, -Real(0)})});
    World loaded = reloaded(world);
    EXPECT_TRUE(std::signbit(loaded[ball].velocity().x));
    EXPECT_FALSE(std::signbit(loaded[ball].velocity().y));
    const auto* gravity = dynamic_cast<const Gravity*>(loaded.fields()[0].field.get());
    ASSERT_NE(gravity, nullptr);
    EXPECT_TRUE(std::isnan(gravity->acceleration().x));
    EXPECT_TRUE(std::signbit(gravity->acceleration().y));
    loaded.step(kDt); // and that freezes the ball
    world.step(kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    World again = reloaded(world);
    EXPECT_EQ(std::vector(again.frozenBodies().begin(), again.frozenBodies().end()),
              std::vector<BodyId>{ball});
    expectToGoOnAlike(world, again, 3);
}

// Another process goes on as this one does.
TEST(Snapshot, AnotherProcessGoesOnAlike) {
    World world = busyWorld();
    run(world, 100);
    const Bytes bytes = toBytes(world);
    const std::string path = testing::TempDir() + "kodo_snapshot_" + std::to_string(sizeof(Real));
    std::ofstream file(path, std::ios::binary);
    for (const std::byte byte : bytes) {
        file.put(static_cast<char>(byte));
    }
    file.close();
    run(world, 200);
    char expected[18];
    std::snprintf(expected, sizeof expected, "%016" PRIx64 "\n", world.stateHash());

    std::FILE* other = popen(("'" KODO_CONTINUE_SNAPSHOT "' '" + path + "' 200").c_str(), "r");
    ASSERT_NE(other, nullptr);
    char printed[64] = "";
    EXPECT_NE(std::fgets(printed, sizeof printed, other), nullptr);
    EXPECT_EQ(pclose(other), 0);
    EXPECT_STREQ(printed, expected);
    std::remove(path.c_str());
}

/// Few bodies, and something in each list, but nothing that a solver has to compute: a body flies
/// through a sensor, two rest side by side, two hang together.
World fixedWorld() {
    World world({.settings = {.substeps = 2, .restSteps = 3}});
    world.addField({std::make_shared<Drag>(DragLaw{Real(0.25), Real(0.5)}), {kMatchAny, 1}});
    world.add({.shape = Circle{1}, .flags = kLocked | kSensor});
    world.add({.shape = Compound{{Box{1, 1}, Point{{Real(0.5), 0}}}},
               .velocity = {Real(0.5), 0},
               .userData = 7});
    world.add(support::boxDef({0, 10}, 1, 1));
    world.add(support::boxDef({1, 10}, 1, 1));
    const BodyId left = world.add(support::ballDef({5, 0}, Real(0.5)));
    const BodyId right = world.add(support::ballDef({7, 0}, Real(0.5)));
    world.add(Spring{{left, right}, 2, 2});
    world.remove(world.add({.shape = Polygon{{{0, 0}, {1, 0}, {0, 1}}}, .position = {5, 5}}));
    world.setRegion(Aabb{{-16, -16}, {16, 16}});
    run(world, 6, Real(1) / 64);
    return world;
}

// The bytes are the same on every machine, and no change of the format goes unnoticed: whoever
// makes one raises kFormat in world/snapshot.cpp.
TEST(Snapshot, TheBytesOfAFixedWorldAreThoseOfThisFormat) {
    const World world = fixedWorld();
    ASSERT_EQ(world.collisions().size(), 2u); // of the two parts with the sensor
    ASSERT_NE(world[world.bodies()[3]].flags() & kResting, 0u);
    const Bytes bytes = toBytes(world);
    const bool isFloat = sizeof(Real) == 4;
    EXPECT_EQ(bytes.size(), isFloat ? 2294u : 3994u);
    EXPECT_EQ(checksumOf(bytes), isFloat ? 0xc82f5f1b0a5494fdu : 0x9e39b5547bb25d2eu)
        << std::hex << checksumOf(bytes);
}

} // namespace
} // namespace kodo
