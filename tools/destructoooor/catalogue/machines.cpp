// SPDX-License-Identifier: MIT
#include "parts.hpp"

namespace destructoooor {

namespace {

constexpr std::string_view kMachines = "Machines";
constexpr std::string_view kVehicles = "Vehicles";
constexpr std::string_view kCharacters = "Characters";

void drive(kodo::World& world, BodyId a, BodyId b, Vec2 at, Real speed, Real torque) {
    kodo::RevoluteJoint motor{.ends = endsAt(world, a, b, at)};
    motor.motorSpeed = speed;
    motor.motorTorque = torque;
    world.add(motor);
}

Ids buildPiston(kodo::World& world) {
    // Crank of 2 m, rod of 5 m: the piston moves between 3 m and 7 m from the axle.
    const Vec2 axle{-7, 5};
    const BodyId post = addAnchor(world, axle);
    const BodyId crank = addBox(world, axle + Vec2{1, 0}, 2, 0.4_r);
    const BodyId rod = addBox(world, axle + Vec2{4.5_r, 0}, 5, 0.3_r);
    const BodyId piston = addBox(world, axle + Vec2{7, 0}, 1.5_r, 2, {.density = 2});
    drive(world, post, crank, axle, 4, 400);
    meetNothing(world, crank);
    meetNothing(world, rod);
    pin(world, crank, rod, axle + Vec2{2, 0});
    pin(world, rod, piston, axle + Vec2{7, 0});
    world.add(kodo::PrismaticJoint{.ends = endsAt(world, post, piston, axle + Vec2{7, 0})});
    addWall(world, {-3, 3.9_r}, {8, 3.9_r}, 0.5_r);
    addBox(world, {3, 4.5_r}, 1, 1);
    return {piston, crank};
}

Ids buildTrebuchet(kodo::World& world) {
    addGround(world);
    const BodyId post = addAnchor(world, {-4, 5});
    const BodyId beam = addBox(world, {-6, 5}, 8, 0.4_r, {.rotation = kodo::Rot::fromAngle(0)});
    const BodyId weight = addBox(world, {-2.4_r, 4.4_r}, 1, 1, {.density = 60});
    pin(world, post, beam, {-4, 5});
    pin(world, beam, weight, {-2.4_r, 5});
    const BodyId stone = addBall(world, {-9.6_r, 5.6_r}, 0.35_r);
    for (int i = 0; i < 5; ++i) {
        addBox(world, {9, 0.5_r + Real(i)}, 1, 1);
    }
    return {stone};
}

Ids buildDominoes(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int i = 0; i < 22; ++i) {
        ids.push_back(addBox(world, {Real(i) - 10.5_r, 1}, 0.25_r, 2));
    }
    addBall(world, {-12.3_r, 1.9_r}, 0.4_r, {.velocity = {3, 0}, .density = 4});
    return ids;
}

Ids buildSeeSaw(kodo::World& world) {
    addGround(world);
    const BodyId post = addAnchor(world, {0, 0.8_r});
    const BodyId plank = addBox(world, {0, 1.1_r}, 10, 0.2_r);
    pin(world, post, plank, {0, 1});
    const BodyId light = addBox(world, {-4.5_r, 1.6_r}, 0.8_r, 0.8_r);
    addBox(world, {4.2_r, 9}, 1.5_r, 1.5_r, {.density = 6});
    return {light};
}

Ids buildBigWheel(kodo::World& world) {
    addGround(world);
    const Vec2 hub{0, 7};
    const BodyId post = addAnchor(world, hub);
    kodo::Compound rim;
    for (int i = 0; i < 4; ++i) {
        rim.parts.push_back(
            kodo::Box{11, 0.25_r, {}, kodo::Rot::fromAngle(Real(i) * 3.14159265_r / 4)});
    }
    const BodyId wheel = world.add({.shape = rim, .position = hub});
    meetNothing(world, wheel);
    drive(world, post, wheel, hub, 0.4_r, 3000);
    Ids ids{wheel};
    for (int i = 0; i < 8; ++i) {
        const Vec2 at = hub + 5.5_r * kodo::Rot::fromAngle(Real(i) * 3.14159265_r / 4).xAxis();
        ids.push_back(addBox(world, at - Vec2{0, 0.6_r}, 1, 1, {.density = 2}));
        kodo::RevoluteJoint hanger{.ends = endsAt(world, wheel, ids.back(), at)};
        hanger.motorTorque = 1; // with speed 0: friction of the pivot
        world.add(hanger);
    }
    return ids;
}

Ids buildCar(kodo::World& world) {
    std::vector<Vec2> road;
    for (int i = 0; i <= 120; ++i) {
        const Real x = Real(i) / 2 - 12;
        road.push_back({x, x < -4 ? 0 : 0.3_r * std::sin(1.3_r * x) * std::sin(0.4_r * x)});
    }
    world.add(
        {.shape = kodo::Chain{.points = road, .oneSided = false}, .type = kodo::BodyType::Static});
    const BodyId chassis = addBox(world, {-9, 1.2_r}, 3, 0.8_r, {.density = 2});
    for (const Real x : {-10.1_r, -7.9_r}) {
        const BodyId wheel = addBall(world, {x, 0.6_r}, 0.5_r, {.material = kodo::withFriction(1)});
        drive(world, chassis, wheel, {x, 0.6_r}, -12, 60);
    }
    return {chassis};
}

Ids buildTrain(kodo::World& world) {
    addGround(world);
    Ids ids;
    for (int i = 0; i < 4; ++i) {
        const Real x = -3.5_r * Real(i) - 1;
        ids.push_back(addBox(world, {x, 0.8_r}, 2.6_r, 0.8_r, {.density = i == 0 ? 4_r : 1_r}));
        for (const Real way : {-0.8_r, 0.8_r}) {
            const BodyId wheel =
                addBall(world, {x + way, 0.4_r}, 0.4_r, {.material = kodo::withFriction(1)});
            drive(world, ids.back(), wheel, {x + way, 0.4_r}, i == 0 ? -8_r : 0_r,
                  i == 0 ? 80_r : 0_r);
        }
        if (i > 0) {
            tie(world, ids[ids.size() - 2], {x + 2.2_r, 0.8_r}, ids.back(), {x + 1.3_r, 0.8_r},
                {.length = 0.9_r, .limits = kodo::Range{0.7_r, 1.1_r}});
        }
    }
    return ids;
}

/// A figure of eight bodies with its feet at a point; returns them, the trunk first.
Ids addFigure(kodo::World& world, Vec2 feet) {
    const auto limb = [&](Vec2 from, Vec2 to, Real radius) {
        return world.add({.shape = kodo::Capsule{feet + from, feet + to, radius}});
    };
    const auto joint = [&](BodyId a, BodyId b, Vec2 at, Real lower, Real upper) {
        kodo::RevoluteJoint hinge{.ends = endsAt(world, a, b, feet + at)};
        hinge.limits = kodo::Range{lower, upper};
        world.add(hinge);
    };
    const BodyId trunk = limb({0, 1.3_r}, {0, 2.1_r}, 0.25_r);
    const BodyId head = world.add({.shape = kodo::Circle{0.25_r, feet + Vec2{0, 2.7_r}}});
    Ids ids{trunk, head};
    joint(trunk, head, {0, 2.45_r}, -0.5_r, 0.5_r);
    for (const Real side : {-1_r, 1_r}) {
        const BodyId thigh = limb({side * 0.15_r, 1.1_r}, {side * 0.25_r, 0.7_r}, 0.13_r);
        const BodyId shin = limb({side * 0.25_r, 0.5_r}, {side * 0.25_r, 0.13_r}, 0.11_r);
        const BodyId arm = limb({side * 0.35_r, 2.1_r}, {side * 1.1_r, 2.1_r}, 0.1_r);
        joint(trunk, thigh, {side * 0.15_r, 1.15_r}, -1, 1);
        joint(thigh, shin, {side * 0.25_r, 0.6_r}, -1, 1);
        joint(trunk, arm, {side * 0.3_r, 2.1_r}, -1.5_r, 1.5_r);
        ids.insert(ids.end(), {thigh, shin, arm});
    }
    return ids;
}

Ids buildRagdolls(kodo::World& world) {
    for (int i = 0; i < 8; ++i) {
        const Real top = 6 - 0.8_r * Real(i);
        addBox(world, {Real(i) * 2 - 9, top / 2}, 2, std::max(top, 0.2_r),
               {.type = kodo::BodyType::Static});
    }
    addGround(world);
    Ids ids = addFigure(world, {-8, 8});
    const Ids second = addFigure(world, {-4, 9});
    for (const Ids& figure : {ids, second}) {
        world[figure[0]].setVelocity({4, 0});
    }
    ids.insert(ids.end(), second.begin(), second.end());
    return ids;
}

bool figuresRest(const kodo::World& world, const Ids& ids) {
    return std::all_of(ids.begin(), ids.end(), [&](BodyId id) {
        return kodo::length(world[id].velocity()) < 0.5_r && world[id].center().y > 0;
    });
}

Ids buildWalker(kodo::World& world) {
    addGround(world);
    addBox(world, {3, 0.15_r}, 4, 0.3_r, {.type = kodo::BodyType::Static});
    addBox(world, {-5, 0.5_r}, 1, 1);
    return {world.add({.shape = kodo::Capsule{{0, 0.4_r}, {0, 1.4_r}, 0.4_r},
                       .position = {-10, 0.1_r},
                       .material = kodo::withFriction(0),
                       .density = 3,
                       .flags = kodo::kLockRotate})};
}

void walk(kodo::World& world, const Ids& ids, std::uint64_t) {
    kodo::BodyRef figure = world[ids[0]];
    const Real wanted = 3; // m/s
    figure.applyImpulse(
        {figure.mass() * std::clamp(wanted - figure.velocity().x, -0.5_r, 0.5_r), 0});
}

Ids buildOneWay(kodo::World& world) {
    addGround(world);
    world.add({.shape = kodo::Chain{.points = {{-4, 4}, {4, 4}}, .oneSided = true},
               .type = kodo::BodyType::Static});
    return {world.add({.shape = kodo::Capsule{{0, 0.4_r}, {0, 1.4_r}, 0.4_r},
                       .position = {0, 0.1_r},
                       .velocity = {0, 13},
                       .flags = kodo::kLockRotate})};
}

Ids buildLift(kodo::World& world) {
    addGround(world);
    const BodyId lift = addBox(world, {0, 1}, 5, 0.5_r, {.type = kodo::BodyType::Kinematic});
    const BodyId crate = addBox(world, {0, 1.75_r}, 1, 1);
    addBox(world, {0, 2.75_r}, 1, 1);
    return {lift, crate};
}

void ride(kodo::World& world, const Ids& ids, std::uint64_t tick) {
    const Real time = Real(tick + 1) * kStepSeconds;
    world[ids[0]].moveTo({0, 5 - 4 * std::cos(time)}, kStepSeconds);
}

const Scene kMachineScenes[] = {
    {kMachines, "Piston", "Does a crank with a motor move a piston to and fro?",
     "It turns at 4 rad/s; the piston stays on its line.", buildPiston, 6,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].center().y, 5, 0.02_r) &&
                isNear(world[ids[1]].angularVelocity(), 4, 0.3_r);
     }},
    {kMachines, "Trebuchet", "How far does a falling weight throw a stone?",
     "Over the wall of boxes, or into it.", buildTrebuchet, 3,
     [](const kodo::World& world, const Ids& ids) { return world[ids[0]].center().x > 0; }},
    {kMachines, "Dominoes", "Does the first of twenty-two reach the last?", "It does.",
     buildDominoes, 8,
     [](const kodo::World& world, const Ids& ids) {
         return std::abs(world[ids.back()].rotation().s) > 0.5_r;
     }},
    {kMachines, "See-saw", "A heavy box lands on one end: where does the other box go?",
     "Up, higher than the heavy one fell from.", buildSeeSaw, 2,
     [](const kodo::World& world, const Ids& ids) { return world[ids[0]].center().y > 5; }},
    {kMachines, "Big wheel", "Do eight gondolas hang upright while the wheel turns?",
     "They swing a little and stay upright.", buildBigWheel, 12,
     [](const kodo::World& world, const Ids& ids) {
         return std::all_of(ids.begin() + 1, ids.end(),
                            [&](BodyId id) { return world[id].rotation().c > 0.5_r; }) &&
                isNear(world[ids[0]].angularVelocity(), 0.4_r, 0.1_r);
     }},
    {kVehicles,
     "Car",
     "Does a car with two driven wheels get over a rough road?",
     "It is 15 m farther after eight seconds.",
     buildCar,
     8,
     [](const kodo::World& world, const Ids& ids) { return world[ids[0]].center().x > 6; },
     {0, -10},
     {{-12, -4}, {40, 10}}},
    {kVehicles, "Train", "Does an engine pull three wagons by loose couplings?",
     "All four move together.", buildTrain, 4,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].velocity().x, world[ids[3]].velocity().x, 0.5_r) &&
                world[ids[3]].velocity().x > 1;
     }},
    {kCharacters, "Ragdolls on stairs", "Do two figures fall down the stairs in one piece?",
     "Their joints hold, and they come to rest.", buildRagdolls, 10, figuresRest},
    {kCharacters,
     "Walker",
     "Does a capsule walk over a step and push a box?",
     "It walks to the right at 3 m/s.",
     buildWalker,
     5,
     [](const kodo::World& world, const Ids& ids) { return world[ids[0]].position().x > -2; },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     kodo::balanced(),
     walk},
    {kCharacters, "One-way platform", "Can one jump through a platform and land on it?",
     "From below it lets pass; from above it carries.", buildOneWay, 4,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[0]].position().y, 4, 0.05_r);
     }},
    {kCharacters,
     "Lift",
     "Do two boxes stay on a platform that goes up and down?",
     "They do.",
     buildLift,
     12.5664_r,
     [](const kodo::World& world, const Ids& ids) {
         return isNear(world[ids[1]].center() - world[ids[0]].center(), {0, 0.75_r}, 0.2_r);
     },
     {0, -10},
     {{-13, -1.5_r}, {13, 14.5_r}},
     kodo::balanced(),
     ride},
};

} // namespace

std::span<const Scene> machineScenes() {
    return kMachineScenes;
}

} // namespace destructoooor
