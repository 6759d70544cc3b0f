// SPDX-License-Identifier: MIT
// B3: an inactive body that comes to overlap a sleeping one, in each way in which a pair can begin.
#include "support/solver.hpp"
#include <support/sleeping.hpp>

#include <algorithm>
#include <functional>
#include <string>

namespace kodo {
namespace {

using support::boxDef;
using support::isAsleep;
using support::run;

constexpr Flags kBox = 1; // category of the sleeping box
constexpr Vec2 kAside{Real(0.9), Real(0.5)};

struct Way {
    const char* name;
    BodyDef (*before)(BodyDef wall); // how the wall is added before the box sleeps
    void (*change)(World& world, BodyId wall);
};

const Way kWays[] = {
    {"setPosition",
     [](BodyDef wall) {
         wall.position = {5, Real(0.5)};
         return wall;
     },
     [](World& world, BodyId wall) { world[wall].setPosition(kAside); }},
    {"setRotation",
     [](BodyDef wall) {
         wall.shape = Box{1, 1, {Real(-1.5), 0}, {}};
         wall.rotation = Rot::fromAngle(Real(3.14159265));
         wall.position = kAside + Vec2{Real(1.5), 0};
         return wall;
     },
     [](World& world, BodyId wall) {
         world[wall].setRotation({1, 0});
     }},
    {"enable",
     [](BodyDef wall) {
         wall.flags |= kDisabled;
         return wall;
     },
     [](World& world, BodyId wall) { world[wall].setFlags(world[wall].flags() & ~kDisabled); }},
    {"setFlags",
     [](BodyDef wall) {
         wall.flags |= kMatchAny;
         wall.required = 0x8000; // a category of no body
         return wall;
     },
     [](World& world, BodyId wall) { world[wall].setFlags(world[wall].flags() & ~kMatchAny); }},
    {"setRequired",
     [](BodyDef wall) {
         wall.flags |= kMatchAny;
         wall.required = 0x8000;
         return wall;
     },
     [](World& world, BodyId wall) { world[wall].setRequired(kBox); }},
};

struct Case {
    support::Solver solver;
    BodyType type;
    bool sensor;
};

struct Scene {
    World world;
    BodyId box;

    explicit Scene(const Case& row)
        : world({.gravity = support::kEarth, .settings = support::settingsOf(row.solver)}) {
        support::addFloor(world);
        BodyDef def = boxDef({0, Real(0.5)}, 1, 1);
        def.flags = kBox;
        box = world.add(def);
    }
};

BodyDef wallOf(const Case& row) {
    BodyDef wall = boxDef(kAside, 1, 1);
    wall.type = row.type;
    wall.flags = row.sensor ? kSensor : 0;
    return wall;
}

/// The first record of the two within two steps is a Begin, and the box is pushed out, or not if
/// the wall is a sensor.
void expectNoticed(Scene& scene, BodyId wall, const Case& row) {
    std::vector<TouchPhase> phases;
    for (int step = 0; step < 2; ++step) {
        run(scene.world, 1);
        for (const CollisionRecord& record : scene.world.collisions()) {
            if (record.involves(wall) && record.involves(scene.box)) {
                phases.push_back(record.phase);
            }
        }
    }
    ASSERT_FALSE(phases.empty()) << "no record";
    EXPECT_EQ(phases.front(), TouchPhase::Begin);
    if (row.sensor) {
        return;
    }
    EXPECT_FALSE(isAsleep(scene.world, scene.box));
    run(scene.world, 60);
    EXPECT_LT(scene.world[scene.box].position().x, -Real(0.09)) << "still 0.1 m deep";
    EXPECT_GT(scene.world[scene.box].position().x, -Real(0.5));
}

TEST(WakeByOverlap, EachWayIsNoticed) {
    for (const support::Solver solver : support::kSolvers) {
        for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
            for (const bool sensor : {false, true}) {
                const Case row{solver, type, sensor};
                for (const Way& way : kWays) {
                    SCOPED_TRACE(testing::Message()
                                 << way.name << ", solver " << static_cast<int>(solver) << ", type "
                                 << static_cast<int>(type) << ", sensor " << sensor);
                    Scene scene(row);
                    const BodyId wall = scene.world.add(way.before(wallOf(row)));
                    run(scene.world, 300);
                    ASSERT_TRUE(isAsleep(scene.world, scene.box));
                    way.change(scene.world, wall);
                    expectNoticed(scene, wall, row);
                }
                SCOPED_TRACE("add");
                Scene scene(row);
                run(scene.world, 300);
                ASSERT_TRUE(isAsleep(scene.world, scene.box));
                expectNoticed(scene, scene.world.add(wallOf(row)), row);
            }
        }
    }
}

// What comes near without touching wakes nothing.
TEST(WakeByOverlap, AWallBesideASleepingBoxLetsItSleep) {
    for (const support::Solver solver : support::kSolvers) {
        const Case row{solver, BodyType::Static, false};
        Scene scene(row);
        run(scene.world, 300);
        BodyDef wall = wallOf(row);
        wall.position.x = Real(1.01); // 1 cm away
        scene.world.add(wall);
        run(scene.world, 60);
        EXPECT_TRUE(isAsleep(scene.world, scene.box));
    }
}

} // namespace
} // namespace kodo
