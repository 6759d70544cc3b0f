// SPDX-License-Identifier: MIT
// A7: a load goes, and what carried it stays where it is.
#include <kodo/world.hpp>
#include <support/scenes.hpp>

#include <algorithm>

namespace kodo {
namespace {

using support::kEarth;

/// How the load goes.
enum class Way { Remove, Teleport, Disable, MakeSensor, Lighten };
constexpr Way kWays[] = {Way::Remove, Way::Teleport, Way::Disable, Way::MakeSensor, Way::Lighten};

void takeAway(World& world, BodyId load, Way way) {
    switch (way) {
    case Way::Remove:
        world.remove(load);
        break;
    case Way::Teleport:
        world[load].setPosition({50, 10});
        break;
    case Way::Disable:
        world[load].setFlags(kDisabled);
        break;
    case Way::MakeSensor:
        world[load].setFlags(kSensor);
        break;
    case Way::Lighten: { // a body of 1 kg in its place
        const Vec2 place = world[load].position();
        world.remove(load);
        world.add(support::boxDef(place, 1, 1));
        break;
    }
    }
}

/// What carries the load: unit boxes of 1 kg.
enum class Below { Two, Stack, Tower, Pyramid };
constexpr Below kBelow[] = {Below::Two, Below::Stack, Below::Tower, Below::Pyramid};

struct Scene {
    World world;
    BodyId load;
    BodyId top; // the highest of the boxes that carry it
};

Scene sceneOf(Below below, Real mass) {
    Scene scene{World(support::withoutSleep()), {}, {}};
    World& world = scene.world;
    support::addFloor(world);
    const auto add = [&](Real x, int row) {
        scene.top = world.add(support::boxDef({x, Real(0.5) + static_cast<Real>(row)}, 1, 1));
    };
    int height = 1;
    Real middle = 0;
    Real width = 1;
    if (below == Below::Two) {
        add(Real(-0.75), 0);
        add(Real(0.75), 0);
        width = Real(2.5);
    } else if (below == Below::Pyramid) {
        height = 8;
        middle = Real(3.5) * Real(1.05);
        for (int row = 0; row < height; ++row) {
            for (int i = 0; i < height - row; ++i) {
                add((static_cast<Real>(i) + static_cast<Real>(row) / 2) * Real(1.05), row);
            }
        }
    } else {
        height = below == Below::Stack ? 2 : 8;
        for (int row = 0; row < height; ++row) {
            add(0, row);
        }
    }
    BodyDef load = support::boxDef({middle, Real(0.5) + static_cast<Real>(height)}, width, 1);
    load.density = mass / width;
    scene.load = world.add(load);
    return scene;
}

// The boxes decompress, which takes long, but none rises above where it comes to rest: the highest
// place is within 1 mm of the last one.
TEST(LoadRelease, WhatCarriedALoadStaysWhenTheLoadGoes) {
    for (const Real rate : {Real(30), Real(60), Real(240)}) {
        for (const Real mass : {Real(10), Real(100), Real(1000)}) {
            for (const Below below : kBelow) {
                Scene loaded = sceneOf(below, mass);
                support::run(loaded.world, static_cast<int>(2 * rate), 1 / rate);
                for (const Way way : kWays) {
                    Scene scene = loaded;
                    takeAway(scene.world, scene.load, way);
                    Real highest = 0;
                    for (int i = 0; i < static_cast<int>(2 * rate); ++i) {
                        scene.world.step(1 / rate);
                        highest = std::max(highest, scene.world[scene.top].position().y);
                    }
                    const auto what = testing::Message() << "rate " << rate << ", mass " << mass
                                                         << ", below " << static_cast<int>(below)
                                                         << ", way " << static_cast<int>(way);
                    EXPECT_LT(highest - scene.world[scene.top].position().y, Real(1e-3)) << what;
                }
            }
        }
    }
}

// A load that is thrown up does not take what carried it along. Until it comes down again, after
// two seconds, that is within 1 mm of where it comes to rest.
TEST(LoadRelease, WhatCarriedALoadStaysWhenTheLoadIsThrownOff) {
    for (const Real rate : {Real(30), Real(60), Real(240)}) {
        for (const Real mass : {Real(100), Real(1000)}) {
            for (const Below below : kBelow) {
                Scene scene = sceneOf(below, mass);
                support::run(scene.world, static_cast<int>(2 * rate), 1 / rate);
                scene.world[scene.load].applyImpulse({0, 10 * mass});
                Real highest = 0;
                for (int i = 0; i < static_cast<int>(Real(1.5) * rate); ++i) {
                    scene.world.step(1 / rate);
                    highest = std::max(highest, scene.world[scene.top].position().y);
                }
                EXPECT_LT(highest - scene.world[scene.top].position().y, Real(1e-3))
                    << "rate " << rate << ", mass " << mass << ", below "
                    << static_cast<int>(below);
            }
        }
    }
}

// Only what carried the load is concerned: not a bit changes in a tower beside it.
TEST(LoadRelease, OtherTowersKeepTheirImpulses) {
    Scene scene = sceneOf(Below::Tower, 1000);
    const std::vector<BodyId> other = support::addStack(scene.world, 8, 5);
    support::run(scene.world, 120);
    Scene kept = scene;
    scene.world.remove(scene.load);
    support::run(scene.world, 60);
    support::run(kept.world, 60);
    for (const BodyId box : other) {
        EXPECT_EQ(scene.world[box].position(), kept.world[box].position());
        EXPECT_EQ(scene.world[box].velocity(), kept.world[box].velocity());
    }
}

} // namespace
} // namespace kodo
