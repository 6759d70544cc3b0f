// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/same_records.hpp>
#include <support/scenes.hpp>

#include "base/reorder_policy.hpp"
#include "base/state_stream.hpp"

#include <world/snapshot_scenes.hpp>

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <tuple>

namespace kodo {
namespace {

using support::RandomNumbers;

using support::busyWorld;
using support::kDt;
using support::ownFields;
using support::run;
using support::sameRecords;

using support::Bytes;

/// The World restored from its bytes, with these user-defined fields.
World reloaded(const World& world, const support::OwnFields& own = {}) {
    return fromBytes(toBytes(world), own);
}

/// Steps both Worlds. Compares state hash and records after each step, and all bytes after every
/// 20th.
void expectToGoOnAlike(World& world, World& other, int steps) {
    for (int i = 0; i <= steps; ++i) {
        SCOPED_TRACE(testing::Message() << "after " << i << " steps");
        ASSERT_EQ(other.stateHash(), world.stateHash());
        ASSERT_TRUE(i % 10 != 0 || sameRecords(other, world));
        ASSERT_TRUE(i % 20 != 0 || toBytes(other) == toBytes(world));
        world.step(kDt);
        other.step(kDt);
    }
}

// Results that are computed on demand do not depend on whether they are read.
TEST(Snapshot, ReadingResultsChangesNothing) {
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
    settings.propagation().shockPasses = 3;
    return settings;
}

// R2: restoring is bit-exact, in free flight, in a heap and at rest.
TEST(Snapshot, ContinuesWithTheSameBitsFromAnyStep) {
    for (const StepSettings& settings : {StepSettings{}, thesis2006(), withShock()}) {
        World world = busyWorld(settings);
        int steps = 0;
        for (const int moment : {0, 1, 70, 150, 400}) {
            run(world, moment - steps);
            steps = moment;
            SCOPED_TRACE(testing::Message() << "solver " << settings.solver.index()
                                            << ", saved after " << moment << " steps");
            World original = world;
            World loaded = reloaded(world, ownFields());
            expectToGoOnAlike(original, loaded, support::kSanitized ? 15 : 160);
        }
    }
}

/// A heap of bodies of so many parts that colours of contacts run out.
World crowdedWorld(std::uint64_t seed) {
    RandomNumbers random(seed);
    World world({.gravity = support::kEarth});
    world.add({.shape = Plane{{0, 1}, -2}, .type = BodyType::Static});
    const auto partsOf = [&](int count) {
        Compound compound;
        for (int i = 0; i < count; ++i) {
            const Vec2 place = random.point(1);
            const Real size = random.between(0.2, 1);
            compound.parts.push_back(i % 2 == 0
                                         ? Primitive(Box{size, random.between(0.2, 1), place})
                                         : Primitive(Circle{size / 2, place}));
        }
        return compound;
    };
    for (int i = 0; i < 5; ++i) {
        const bool kinematic = i < 3;
        world.add({.shape = partsOf(kinematic ? 6 : 50),
                   .position = kinematic ? Vec2{Real(2 * i - 2), random.between(-2, -1)}
                                         : Vec2{Real(3 * i - 10), random.between(1, 3)},
                   .velocity = random.point(kinematic ? 1 : 9),
                   .angularVelocity = random.between(-6, 6),
                   .type = kinematic ? BodyType::Kinematic : BodyType::Dynamic});
    }
    for (int i = 0; i < 8; ++i) {
        world.add({.shape = Circle{random.between(0.1, 0.4)},
                   .position = random.point(3),
                   .velocity = random.point(5)});
    }
    return world;
}

// R2: contacts without a colour are solved in the order of their keys, whatever came and went.
TEST(Snapshot, ContinuesWithTheSameBitsInACrowd) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        World world = crowdedWorld(seed);
        for (int step = 0; step < 12; ++step) {
            World loaded = fromBytes(toBytes(world));
            run(loaded, 1);
            run(world, 1);
            ASSERT_EQ(loaded.stateHash(), world.stateHash()) << "seed " << seed << ", " << step;
        }
    }
}

// R2: from time to time many contacts are reordered, which decides the order of solving. A rotating
// bar adds many contacts per step, so a reorder is due within each 100 steps.
TEST(Snapshot, ContinuesWithTheSameBitsWhileContactsAreReordered) {
    World world({.gravity = support::kEarth});
    world.add({.shape = Box{64, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Kinematic});
    for (const Real side : {Real(-17), Real(17)}) {
        world.add({.shape = Box{1, 80}, .position = {side, 40}, .type = BodyType::Kinematic});
    }
    world.add({.shape = Box{20, 1},
               .position = {0, 11},
               .angularVelocity = 2,
               .type = BodyType::Kinematic});
    support::RandomNumbers random(31);
    for (int i = 0; i < 1600; ++i) {
        const Vec2 place{static_cast<Real>(i % 40 - 20) * Real(0.8),
                         static_cast<Real>(i / 40) * Real(0.8) + 1};
        world.add(support::ballDef(place + random.point(0.05), Real(0.37)));
    }
    run(world, 150);
    ASSERT_GT(world.collisions().size(), ReorderPolicy::kMany);
    World original = world;
    World loaded = reloaded(world);
    expectToGoOnAlike(original, loaded, 100);
}

// R2: sizes, positions and speeds scale with the length unit, and so do their limits.
TEST(Snapshot, ContinuesWithTheSameBitsInAnotherLengthUnit) {
    for (const Real unit : {Real(1000), Real(1) / 1000}) {
        SCOPED_TRACE(unit);
        World world({.gravity = unit * support::kEarth, .lengthUnit = unit});
        BodyDef ball = support::ballDef({}, unit / 2);
        ball.density = 1 / (unit * unit);
        std::vector<BodyId> balls;
        for (int i = 0; i < 4; ++i) {
            ball.position = {static_cast<Real>(i) * 20 * unit, 0};
            ball.velocity = {0, kMaxSpeed / 4 * unit};
            balls.push_back(world.add(ball));
        }
        const Real most = kMaxCoordinate / 2 * unit;
        world.add(DistanceJoint{.ends = {.a = balls[0], .b = balls[1], .anchorA = {0, most}},
                                .length = most,
                                .hertz = 1,
                                .limits = Range{0, most}});
        world.add(PrismaticJoint{.ends = {.a = balls[2], .b = balls[3]},
                                 .axis = {1, 0},
                                 .limits = Range{-most, most},
                                 .motorSpeed = kMaxSpeed / 4 * unit,
                                 .motorForce = unit});
        run(world, 2);
        World loaded = reloaded(world);
        expectToGoOnAlike(world, loaded, 20);
    }
}

// A kinematic wall reaches sleeping boxes, at once or step by step, and pushes them along.
// Snapshots of every step continue with the same bits.
TEST(Snapshot, ContinuesWithTheSameBitsWhileAWallPushesSleepingBodies) {
    for (const Real speed : {Real(0.5), Real(6), Real(60), Real(300)}) {
        SCOPED_TRACE(speed);
        World world({.gravity = support::kEarth});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        world.add(support::boxDef({1, Real(0.5)}, 1, 1)); // touches it
        world.add(support::boxDef({Real(2.5), Real(0.5)}, 1, 1));
        const BodyId wall = world.add(
            {.shape = Box{1, 3}, .position = {Real(-1.1), Real(1.6)}, .type = BodyType::Kinematic});
        run(world, 100);
        ASSERT_NE(world[box].flags() & kAsleep, 0u);
        world[wall].setVelocity({speed, 0});
        for (int step = 0; step < 20; ++step) {
            World original = world;
            World loaded = reloaded(world);
            expectToGoOnAlike(original, loaded, 15);
            world.step(kDt);
        }
        EXPECT_EQ(world[box].flags() & kAsleep, 0u);
        EXPECT_GT(world[box].position().x, 0);
    }
}

// The scene covers every feature that a snapshot contains.
TEST(Snapshot, TheBusyWorldCoversEveryFeature) {
    World world = busyWorld();
    std::size_t broken = 0;
    std::size_t records = 0;
    for (int i = 0; i < 150; ++i) {
        world.step(kDt);
        records = std::max(records, world.collisions().size());
        broken += world.brokenJoints().size();
    }
    Flags met = 0;
    std::size_t asleep = 0;
    for (const BodyId id : world.bodies()) {
        met |= world[id].flags();
        asleep += (world[id].flags() & kAsleep) != 0 ? 1 : 0;
    }
    EXPECT_EQ(met & (kAsleep | kColliding | kOutside), kAsleep | kColliding | kOutside);
    EXPECT_GE(asleep, 3u);
    EXPECT_GT(records, 20u);
    EXPECT_EQ(world.joints().size() + broken, 17u);
    EXPECT_EQ(broken, 1u);
}

TEST(Snapshot, HoldsChangesMadeSinceTheLastStep) {
    support::RandomNumbers random(5); // fixed: failures are reproducible
    World world = busyWorld();
    for (int round = 0; round < (support::kSanitized ? 12 : 60); ++round) {
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

// W1: ids issued after loading equal those of the original.
TEST(Snapshot, ReusesIdsInTheSameOrder) {
    support::RandomNumbers random(3); // fixed: failures are reproducible
    World world = busyWorld();
    for (int i = 0; i < 12; ++i) {
        world.remove(world.bodies()[10 + random.below(20)]);
        world.remove(world.joints().empty() ? world.add(MouseJoint{world.bodies()[12], {}, {}, 1})
                                            : world.joints().front());
    }
    World loaded = reloaded(world, ownFields());
    for (int i = 0; i < 30; ++i) {
        const BodyDef def = support::pieceDef(random, i);
        const BodyId id = world.add(def);
        ASSERT_EQ(loaded.add(def), id);
        const JointDef hand = MouseJoint{id, {}, {}, 1};
        ASSERT_EQ(loaded.add(hand), world.add(hand));
        if (i % 3 == 0) {
            world.remove(id);
            loaded.remove(id);
        }
    }
    EXPECT_EQ(loaded.stateHash(), world.stateHash());
}

// Continuous collision skips bodies by the core radius of the thinnest body. A plank approaches a
// rotating peg. Per step it moves farther than the speculative margin, but less than the tested
// distance. A thinner body far away changes nothing.
TEST(Snapshot, ContinuesWithTheSameBitsBesideAThinRotatingBody) {
    for (int i = 0; i < 16; ++i) {
        World world;
        BodyDef peg{.shape = Circle{Real(0.1)}, .type = BodyType::Kinematic};
        peg.angularVelocity = 12;
        world.add(peg);
        BodyDef plank{.shape = Box{4, Real(0.2)}};
        plank.position = {0, Real(0.35) + Real(i) / 512};
        plank.velocity = {0, Real(-1.3)};
        const BodyId falling = world.add(plank);
        run(world, 2);
        World loaded = reloaded(world);
        World withNeedle = world;
        withNeedle.add({.shape = Box{1, Real(1e-3)}, .position = {1000, 0}});
        run(world, 20);
        run(loaded, 20);
        run(withNeedle, 20);
        EXPECT_EQ(loaded.stateHash(), world.stateHash()) << "start " << i;
        EXPECT_EQ(withNeedle[falling].position(), world[falling].position()) << "start " << i;
    }
}

TEST(Snapshot, SharedBodyGeometryStaysShared) {
    World world;
    Compound many;
    for (int i = 0; i < 100; ++i) {
        many.parts.emplace_back(Circle{1, {static_cast<Real>(i), 0}});
    }
    const BodyId first = world.add({.shape = many});
    const std::size_t one = toBytes(world).size();
    const BodyId second = world.clone(first, {0, 10});
    // Each part adds two bounds of eight numbers. A second copy of the part would add as much as
    // one of these.
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
    settings.soft().substeps = 7;
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
    EXPECT_EQ(stepStats(loaded).contacts, stepStats(world).contacts);
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

// Zeros keep their sign, and frozen bodies stay listed.
TEST(Snapshot, KeepsEveryBitOfANumber) {
    World world;
    const BodyId ball = world.add(support::ballDef({}, 1));
    world[ball].setVelocity({-Real(0), 0});
    world.addField({std::make_shared<Gravity>(Vec2{1000, -Real(0)})});
    World loaded = reloaded(world);
    EXPECT_TRUE(std::signbit(loaded[ball].velocity().x));
    EXPECT_FALSE(std::signbit(loaded[ball].velocity().y));
    const auto* gravity = dynamic_cast<const Gravity*>(loaded.fields()[0].field.get());
    ASSERT_NE(gravity, nullptr);
    EXPECT_EQ(gravity->acceleration().x, 1000);
    EXPECT_TRUE(std::signbit(gravity->acceleration().y));
    for (World* each : {&loaded, &world}) {
        (*each)[ball].setVelocity({kMaxSpeed, 0});
        each->step(kDt); // beyond kMaxSpeed: freezes the ball
    }
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    World again = reloaded(world);
    EXPECT_EQ(std::vector(again.frozenBodies().begin(), again.frozenBodies().end()),
              std::vector<BodyId>{ball});
    expectToGoOnAlike(world, again, 3);
}

TEST(Snapshot, AnotherProcessContinuesWithTheSameBits) {
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

// Bodies with a joint become static, and another one lies on both: no memory of what they were.
TEST(Snapshot, ContinuesAfterJointedBodiesBecameStatic) {
    for (const StepSettings& profile : {balanced(), thesis2006()}) {
        for (int k = 0; k < 20; ++k) {
            World world({.gravity = support::kEarth, .settings = profile});
            const BodyId box =
                world.add(support::boxDef({Real(-0.5), Real(0.3)}, Real(0.6), Real(0.6)));
            const BodyId ball = world.add(support::ballDef({Real(0.5), Real(0.3)}, Real(0.3)));
            BodyDef lid = support::boxDef({Real(0.02 * k - 0.2), Real(0.95)}, Real(0.9), Real(0.5));
            lid.rotation = Rot::fromAngle(Real(0.03 * k));
            world.add(lid);
            world.add(RevoluteJoint{
                .ends = {
                    .a = ball, .b = box, .anchorA = world[ball].toLocal({Real(-0.5), Real(0.3)})}});
            run(world, 1);
            world[box].setType(BodyType::Static);
            run(world, 1);
            world[ball].setType(BodyType::Static);
            run(world, 2 + k);
            World loaded = fromBytes(toBytes(world));
            run(world, 5);
            run(loaded, 5);
            EXPECT_EQ(loaded.stateHash(), world.stateHash()) << k;
        }
    }
}

/// Few bodies, at least one entry in every list, and no work for the solver. One body passes a
/// sensor, two sleep side by side, two share a joint.
World fixedWorld() {
    World world({.settings = {.solver = SoftSettings{.substeps = 2}, .sleepSteps = 3}});
    world.addField({std::make_shared<Drag>(DragLaw{Real(0.25), Real(0.5)}), {kMatchAny, 1}});
    world.add({.shape = Circle{1}, .type = BodyType::Kinematic, .flags = kSensor});
    world.add({.shape = Compound{{Box{1, 1}, Point{{Real(0.5), 0}}}},
               .velocity = {Real(0.5), 0},
               .userData = 7});
    world.add(support::boxDef({0, 10}, 1, 1));
    world.add(support::boxDef({1, 10}, 1, 1));
    const BodyId left = world.add(support::ballDef({5, 0}, Real(0.5)));
    const BodyId right = world.add(support::ballDef({7, 0}, Real(0.5)));
    world.add(DistanceJoint{{left, right}, 2, 2});
    world.remove(world.add({.shape = Polygon{{{0, 0}, {1, 0}, {0, 1}}}, .position = {5, 5}}));
    world.setRegion(Aabb{{-16, -16}, {16, 16}});
    run(world, 6, Real(1) / 64);
    return world;
}

// The bytes are equal on every machine, and the test detects every change of the format. A change
// of the format must raise kFormat in world/snapshot.cpp.
TEST(Snapshot, TheBytesOfAFixedWorldMatchTheFormat) {
    const World world = fixedWorld();
    ASSERT_EQ(world.collisions().size(), 2u); // of the two parts with the sensor
    ASSERT_NE(world[world.bodies()[3]].flags() & kAsleep, 0u);
    const Bytes bytes = toBytes(world);
    const bool isFloat = sizeof(Real) == 4;
    EXPECT_EQ(bytes.size(), isFloat ? 2925u : 4981u);
    EXPECT_EQ(checksumOf(bytes), isFloat ? 0x3d689a136c16969au : 0x07c27aaf5e2e41a7u)
        << std::hex << checksumOf(bytes);
}

} // namespace
} // namespace kodo
