// SPDX-License-Identifier: MIT
#include <memory>

#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kFilters = "Sensors and filters";
constexpr std::string_view kFields = "Fields";
constexpr std::string_view kWater = "Water";

constexpr kodo::Flags kRed = 1;
constexpr kodo::Flags kBlue = 2;

Ids buildSensor(kodo::World& world) {
    addGround(world);
    const BodyId sensor =
        addBox(world, {0, 4}, 8, 3, {.type = kodo::BodyType::Static, .flags = kodo::kSensor});
    for (int i = 0; i < 6; ++i) {
        addBall(world, {Real(i) * 1.2_r - 3, 9}, 0.3_r);
    }
    return {sensor};
}

bool sensedAll(const kodo::World& world, const Ids& ids) {
    return world.collisions(ids[0]).size() == 6;
}

Ids buildFilters(kodo::World& world) {
    addGround(world);
    world.add({.shape = kodo::Box{20, 0.5_r},
               .position = {0, 5},
               .type = kodo::BodyType::Static,
               .flags = kRed | kodo::kMatchAny,
               .required = kRed});
    Ids ids;
    for (int i = 0; i < 10; ++i) {
        ids.push_back(
            addBall(world, {2 * Real(i) - 9, 10}, 0.6_r, {.flags = i % 2 == 0 ? kRed : kBlue}));
    }
    return ids;
}

bool sieved(const kodo::World& world, const Ids& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!isNear(world[ids[i]].center().y, i % 2 == 0 ? 5.85_r : 0.6_r, 0.05_r)) {
            return false;
        }
    }
    return true;
}

Ids buildOrbit(kodo::World& world) {
    // Circular orbits: v^2 = strength / r.
    world.addField(
        {std::make_shared<kodo::Attractor>(kodo::Attractor::Law::InverseSquare, Vec2{0, 6}, 200_r),
         {}});
    Ids ids;
    for (int i = 0; i < 4; ++i) {
        const Real radius = 2.5_r + Real(i);
        ids.push_back(
            addBall(world, {radius, 6}, 0.2_r, {.velocity = {0, std::sqrt(200 / radius)}}));
    }
    addBall(world, {0, 6}, 0.8_r, {.type = kodo::BodyType::Static});
    return ids;
}

bool orbitsStay(const kodo::World& world, const Ids& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Real radius = kodo::length(world[ids[i]].center() - Vec2{0, 6});
        if (!isNear(radius, 2.5_r + Real(i), 0.1_r)) {
            return false;
        }
    }
    return true;
}

Ids buildWind(kodo::World& world) {
    addGround(world);
    world.addField({std::make_shared<kodo::Wind>(kodo::DragLaw{.linear = 2}, Vec2{8, 0},
                                                 kodo::Aabb{{-20, 4}, {20, 12}}),
                    {}});
    Ids ids;
    for (int i = 0; i < 8; ++i) {
        ids.push_back(addBall(world, {-11, 5 + Real(i)}, 0.3_r, {.density = 0.5_r * Real(i + 1)}));
    }
    return ids;
}

Ids buildTerminal(kodo::World& world) {
    world.addField({std::make_shared<kodo::Drag>(kodo::DragLaw{.linear = 5}), {}});
    return {addBall(world, {0, 13}, 0.5_r, {.density = 4})};
}

bool fallsSteadily(const kodo::World& world, const Ids& ids) {
    // Weight equals drag: m g = linear d v with d = 1 m.
    const Real speed = world[ids[0]].mass() * 10 / 5;
    return isNear(world[ids[0]].velocity().y, -speed, 0.05_r * speed);
}

void addWater(kodo::World& world, Real surface, Real drag = 3) {
    addRoom(world, 24, 16);
    world.addField(
        {std::make_shared<kodo::Buoyancy>(kodo::Buoyancy::Fluid{.density = 1, .drag = drag},
                                          Vec2{0, surface}, Vec2{0, -10}),
         {}});
}

Ids buildFloating(kodo::World& world) {
    addWater(world, 6);
    Ids ids;
    for (int i = 0; i < 5; ++i) {
        ids.push_back(
            addBox(world, {4 * Real(i) - 8, 7}, 2, 2, {.density = 0.2_r * Real(i + 1) + 0.05_r}));
    }
    return ids;
}

bool floatByDensity(const kodo::World& world, const Ids& ids) {
    for (std::size_t i = 0; i < 3; ++i) { // these lie flat, with this share below the surface
        const Real density = 0.2_r * Real(i + 1) + 0.05_r;
        const kodo::Aabb bounds = world[ids[i]].bounds();
        const Real below = (6 - bounds.lower.y) / (bounds.upper.y - bounds.lower.y);
        if (!isNear(below, density, 0.1_r)) {
            return false;
        }
    }
    return world[ids[4]].center().y < 2;
}

Ids buildBoat(kodo::World& world) {
    addWater(world, 6);
    kodo::Compound hull{{kodo::Box{6, 0.5_r}, kodo::Box{0.4_r, 1.5_r, {-2.8_r, 0.9_r}},
                         kodo::Box{0.4_r, 1.5_r, {2.8_r, 0.9_r}}}};
    const BodyId boat = world.add({.shape = hull, .position = {0, 6}, .density = 0.35_r});
    for (int i = 0; i < 3; ++i) {
        addBox(world, {1.2_r * Real(i) - 1.2_r, 8}, 0.8_r, 0.8_r, {.density = 0.2_r});
    }
    return {boat};
}

Ids buildBubbles(kodo::World& world) {
    addWater(world, 10);
    Ids ids;
    for (int i = 0; i < 40; ++i) {
        ids.push_back(
            addBall(world, {Real(i % 10) * 2 - 9, 1 + Real(i / 10)}, 0.3_r, {.density = 0.3_r}));
    }
    return ids;
}

const Scene kFieldScenes[] = {
    {kFilters, "Sensor", "What does a sensor see?",
     "Each of six balls begins and ends in it; nothing is stopped.", buildSensor, 1, sensedAll},
    {kFilters, "Sieve", "Can a platform hold red balls and let blue ones pass?",
     "With flags: red lies above, blue below.", buildFilters, 6, sieved},
    {kFields,
     "Orbits",
     "Do four planets stay on their circles?",
     "They do: the field is read at the middle of each step.",
     buildOrbit,
     20,
     orbitsStay,
     {}},
    {kFields, "Wind", "Which ball does the wind take farthest?", "The lightest one.", buildWind, 2,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].center().x > world[ids[7]].center().x + 1;
     }},
    {kFields, "Terminal speed", "When does a falling ball stop getting faster?",
     "When drag equals its weight.", buildTerminal, 4, fallsSteadily},
    {kWater, "Floating", "How deep do boxes of density 0.25 to 1.05 lie in water?",
     "By their density; the last one sinks.", buildFloating, 20, floatByDensity},
    {kWater, "Boat", "Does an open boat carry three boxes?", "It floats upright.", buildBoat, 15,
     [](const kodo::World& world, const Ids& ids) {
         return world[ids[0]].rotation().c > 0.9_r && world[ids[0]].center().y > 5;
     }},
    {kWater, "Bubbles", "Do forty light balls reach the surface?", "All of them.", buildBubbles, 10,
     [](const kodo::World& world, const Ids& ids) {
         return std::all_of(ids.begin(), ids.end(),
                            [&](BodyId id) { return world[id].center().y > 9; });
     }},
};

} // namespace

std::span<const Scene> fieldScenes() {
    return kFieldScenes;
}

} // namespace destructoooor
