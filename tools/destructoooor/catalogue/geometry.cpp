// SPDX-License-Identifier: MIT
#include <array>

#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kContinuous = "Continuous collision";
constexpr std::string_view kCompounds = "Compounds";
constexpr std::string_view kGround = "Ground";

Ids buildBullets(kodo::World& world) {
    addGround(world);
    addBox(world, {4, 6}, 0.05_r, 12, {.type = kodo::BodyType::Static});
    Ids ids;
    for (int i = 0; i < 11; ++i) {
        ids.push_back(addBall(world, {-11, 1 + Real(i)}, 0.1_r,
                              {.velocity = {30 + 100 * Real(i), 0}, .density = 10}));
    }
    return ids;
}

bool stoppedByWall(const kodo::World& world, const Ids& ids) {
    return std::all_of(ids.begin(), ids.end(), [&](BodyId id) { return world[id].center().x < 4; });
}

Ids buildRods(kodo::World& world) {
    addGround(world);
    addBox(world, {4, 6}, 0.1_r, 12, {.type = kodo::BodyType::Static});
    Ids ids;
    for (int i = 0; i < 6; ++i) {
        ids.push_back(addBox(world, {-8, 1.5_r + 1.8_r * Real(i)}, 1.6_r, 0.08_r,
                             {.velocity = {60, 0}, .angularVelocity = 8 * Real(i)}));
    }
    return ids;
}

Ids buildMixer(kodo::World& world) {
    addRoom(world, 16, 12);
    for (int i = 0; i < 120; ++i) {
        addBall(world, {Real(i % 14) - 6.5_r, 8 + 0.4_r * Real(i / 14)}, 0.18_r);
    }
    return {addBox(world, {0, 6}, 9, 0.3_r,
                   {.angularVelocity = 12, .type = kodo::BodyType::Kinematic})};
}

Ids buildShot(kodo::World& world) {
    addGround(world);
    for (int i = 0; i < 30; ++i) {
        addBox(world, {2 + Real(i % 3), 0.5_r + Real(i / 3)}, 1, 1);
    }
    return {addBall(world, {-12, 4}, 0.4_r, {.velocity = {80, 0}, .density = 8})};
}

kodo::Compound crossOf(Real size) {
    return {{kodo::Box{size, size / 3}, kodo::Box{size / 3, size}}};
}

Ids buildCrosses(kodo::World& world) {
    addGround(world);
    addWall(world, {6, 0}, {6, 20});
    addWall(world, {-6, 20}, {-6, 0});
    for (int i = 0; i < 40; ++i) {
        const Vec2 at{Real(i % 5) * 2.2_r - 4.4_r, 1.5_r + Real(i / 5) * 2};
        const kodo::Shape shape =
            i % 2 == 0 ? kodo::Shape(crossOf(1.6_r))
                       : kodo::Shape(kodo::Compound{
                             {kodo::Box{0.4_r, 1.6_r}, kodo::Box{1.2_r, 0.4_r, {0.4_r, -0.6_r}}}});
        world.add({.shape = shape, .position = at});
    }
    return {};
}

Ids buildStars(kodo::World& world) {
    addGround(world);
    addWall(world, {5, 0}, {5, 10});
    addWall(world, {-5, 10}, {-5, 0});
    std::vector<Vec2> outline;
    for (int i = 0; i < 10; ++i) {
        const Real radius = i % 2 == 0 ? 0.9_r : 0.4_r;
        outline.push_back(radius * kodo::Rot::fromAngle(Real(i) * 3.14159265_r / 5).xAxis());
    }
    const auto star = kodo::decompose(outline);
    for (int i = 0; i < 28; ++i) {
        world.add({.shape = std::get<kodo::Compound>(star),
                   .position = {Real(i % 4) * 2.2_r - 3.3_r, 1.5_r + Real(i / 4) * 2}});
    }
    return {};
}

Ids buildWelding(kodo::World& world) {
    addGround(world);
    const BodyId whole = addBox(world, {0, 9}, 1, 1);
    for (int i = 1; i < 6; ++i) {
        world.weld(whole, addBox(world, {Real(i), 9}, 1, 1));
    }
    return {whole};
}

void breakUp(kodo::World& world, const Ids& ids, std::uint64_t tick) {
    if (tick >= 90 && tick % 15 == 0 && world[ids[0]].partCount() > 1) {
        world.unweld(ids[0], world[ids[0]].partCount() - 1);
    }
}

Ids buildHammer(kodo::World& world) {
    addGround(world);
    const BodyId post = addBox(world, {0, 6}, 0.3_r, 0.3_r, {.type = kodo::BodyType::Static});
    // Handle of 6 m, head of four times its mass: the centre of mass is where the pin is.
    kodo::Compound hammer{{kodo::Box{6, 0.4_r}, kodo::Box{1.6_r, 6, {3, 0}}}};
    const BodyId body = world.add({.shape = hammer, .position = {0, 6}});
    const Vec2 center = world[body].center();
    world[body].setPosition(Vec2{0, 12} - center);
    pin(world, post, body, {0, 6});
    world[body].setAngularVelocity(1);
    return {body};
}

Ids buildFlush(kodo::World& world) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 52; ++i) {
        points.push_back({Real(i) / 2 - 13, 4});
    }
    world.add({.shape = kodo::Chain{.points = points},
               .material = kodo::withFriction(0),
               .type = kodo::BodyType::Static});
    for (int i = 0; i < 26; ++i) {
        addBox(world, {Real(i) - 12.5_r, -0.5_r}, 1, 1,
               {.material = kodo::withFriction(0), .type = kodo::BodyType::Static});
    }
    const kodo::BodyDef sliding{.velocity = {3, 0}, .material = kodo::withFriction(0)};
    return {addBox(world, {-12, 4.5_r}, 1, 1, sliding), addBox(world, {-12, 0.5_r}, 1, 1, sliding)};
}

Ids buildBowl(kodo::World& world) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 60; ++i) {
        const Real angle = 3.14159265_r * (1 + Real(i) / 60);
        points.push_back(Vec2{0, 11} + 10 * Vec2{std::cos(angle), std::sin(angle)});
    }
    world.add({.shape = kodo::Chain{.points = points},
               .material = kodo::withFriction(0),
               .type = kodo::BodyType::Static});
    return {addBall(world, {-9.4_r, 11}, 0.5_r, {.material = kodo::withFriction(0)})};
}

Ids buildHills(kodo::World& world) {
    kodo::Heightmap hills{.origin = {-15, 1}, .spacing = 0.5_r};
    for (int i = 0; i <= 60; ++i) {
        const Real x = Real(i) / 2 - 15;
        hills.heights.push_back(std::sin(0.7_r * x) + 0.4_r * std::sin(2.1_r * x) +
                                std::max(0_r, std::abs(x) - 11));
    }
    world.add({.shape = hills, .type = kodo::BodyType::Static});
    for (int i = 0; i < 40; ++i) {
        const Vec2 at{Real(i % 10) * 2 - 9, 6 + Real(i / 10) * 1.5_r};
        if (i % 2 == 0) {
            addBall(world, at, 0.4_r);
        } else {
            world.add({.shape = kodo::Capsule{{-0.4_r, 0}, {0.4_r, 0}, 0.25_r}, .position = at});
        }
    }
    return {};
}

Ids buildCoaster(kodo::World& world) {
    // Hills of 10, 7 and 12 m. The ball starts from the first one.
    std::vector<Vec2> points;
    for (int i = 0; i <= 192; ++i) {
        const Real x = Real(i) / 8 - 12;
        const Real height = x < -6 ? 10_r : x < 6 ? 7_r : 12_r;
        points.push_back({x, height * (1 + std::cos(3.14159265_r * x / 6)) / 2});
    }
    world.add({.shape = kodo::Chain{.points = points},
               .material = kodo::withFriction(0),
               .type = kodo::BodyType::Static});
    return {addBall(world, {-11.4_r, 10.2_r}, 0.25_r, {.material = kodo::withFriction(0)})};
}

const Scene kGeometryScenes[] = {
    {kContinuous, "Bullets", "Do balls at 30 to 1,030 m/s pass a wall of 5 cm?",
     "None does, though the fastest moves 17 m in a step.", buildBullets, 3, stoppedByWall},
    {kContinuous, "Spinning rods", "Do rods at 60 m/s that spin pass a wall of 10 cm?",
     "None does.", buildRods, 3, stoppedByWall},
    {kContinuous, "Mixer", "Does a bar that turns twice a second throw balls out?",
     "None of 120 leaves the room.", buildMixer, 8,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-8, 0}, {8, 12}});
     }},
    {kContinuous, "Shot", "What does a shot of 80 m/s do to a tower?", "It falls.", buildShot, 5,
     [](const kodo::World& world, const Ids&) {
         return !allWithin(world, {{-13, 0}, {6, 14}});
     }},
    {kCompounds, "Crosses and corners", "Do concave bodies interlock?",
     "They form a heap; overlap stays below a centimetre.", buildCrosses, 12,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-6, 0}, {6, 20}}) && deepestOverlap(world) < 0.01_r;
     }},
    {kCompounds, "Stars", "Can an outline that is not convex be a body?",
     "decompose() makes convex parts of it.", buildStars, 12,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-5, 0}, {5, 20}}) && deepestOverlap(world) < 0.01_r;
     }},
    {kCompounds,
     "Breaking up",
     "Can parts become bodies while the world runs?",
     "Six welded boxes land as one and come apart, one by one.",
     buildWelding,
     5,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].partCount() == 1 && world.bodyCount() == 7;
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     kodo::balanced(),
     breakUp},
    {kCompounds, "Hammer", "Where is the centre of mass of a hammer?",
     "Pinned there, it turns on and does not swing.", buildHammer, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].angularVelocity(), 1, 0.02_r);
     }},
    {kGround, "Flush ground", "Do boxes slide over seams as over one surface?",
     "On a chain and on tiles they keep 3 m/s.", buildFlush, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].velocity().x, 3, 0.01_r) &&
                isNear(world[ids[1]].velocity().x, 3, 0.01_r);
     }},
    {kGround, "Bowl", "Does a ball in a bowl of sixty lines gain or lose height?",
     "It gains nothing.", buildBowl, 20,
     [](const kodo::World& world, const Ids& ids) {
         const Real start = world[ids[0]].mass() * 10 * 11;
         return energyOf(world, 10) < 1.01_r * start && energyOf(world, 10) > 0.5_r * start;
     }},
    {kGround, "Hills", "Does anything fall through a heightmap?",
     "Nothing does; balls and capsules roll into the valleys.", buildHills, 10,
     [](const kodo::World& world, const Ids&) {
         return allWithin(world, {{-15, -1}, {15, 14}});
     }},
    {kGround, "Roller coaster", "Does a ball from 10 m get over a hill of 7 m?",
     "It does, and turns around below the hill of 12 m.", buildCoaster, 4,
     [](const kodo::World& world, const Ids& ids) {
         const Real start = world[ids[0]].mass() * 10 * 10.2_r;
         return world[ids[0]].center().x > 0 && energyOf(world, 10) < 1.01_r * start;
     }},
};

} // namespace

std::span<const Scene> geometryScenes() {
    return kGeometryScenes;
}

} // namespace destructoooor
