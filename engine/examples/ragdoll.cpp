// SPDX-License-Identifier: MIT
// Ragdoll: ten capsules on hinges with limits, thrown down a flight of stairs.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

/// A figure with its hips at a point (m). Returns the chest.
kodo::BodyId addRagdoll(kodo::World& world, kodo::Vec2 hips, kodo::Flags ground) {
    // A limb between two points, on a hinge at the first one.
    const auto limb = [&](kodo::BodyId parent, kodo::Vec2 from, kodo::Vec2 to, kodo::Range limits) {
        const kodo::BodyId id = world.add({.shape = kodo::Capsule{{}, to - from, 0.07f},
                                           .position = hips + from,
                                           .velocity = {3, 1},
                                           .flags = kodo::kMatchAny, // limbs pass each other
                                           .required = static_cast<std::uint16_t>(ground)});
        if (world.contains(parent)) {
            const kodo::Vec2 anchor = toLocal(world[parent].transform(), hips + from);
            world.add(kodo::RevoluteJoint{.ends = {.a = parent, .b = id, .anchorA = anchor},
                                          .limits = limits});
        }
        return id;
    };
    const kodo::BodyId chest = limb({}, {0, 0.1f}, {0, 0.5f}, {});
    limb(chest, {0, 0.65f}, {0, 0.75f}, {-0.5f, 0.5f}); // head
    for (const float x : {-0.05f, 0.05f}) {
        const kodo::BodyId arm = limb(chest, {x, 0.5f}, {x, 0.22f}, {-2.5f, 2.5f});
        limb(arm, {x, 0.22f}, {x, 0}, {0, 2.4f}); // the elbow bends to the front
        const kodo::BodyId thigh = limb(chest, {x, 0}, {x, -0.4f}, {-0.5f, 1.8f});
        limb(thigh, {x, -0.4f}, {x, -0.8f}, {-2.4f, 0}); // the knee to the back
    }
    return chest;
}

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}, .lengthUnit = 0.2f}};
    kodo::Chain stairs{.points = {{-6, 0}, {0, 0}}};
    for (int i = 0; i < 6; ++i) {
        const kodo::Vec2 edge = stairs.points.back();
        stairs.points.push_back(edge - kodo::Vec2{0, 0.3f});
        stairs.points.push_back(edge + kodo::Vec2{0.5f, -0.3f});
    }
    stairs.points.back().x = 9;
    world.add({.shape = stairs, .type = kodo::BodyType::Static, .flags = 1});
    const kodo::BodyId chest = addRagdoll(world, {-1, 1}, 1);
    int step = 0;
    for (; step < 1200 && !world[chest].isAsleep(); ++step) {
        world.step(1.0f / 60);
        if (argc > 1 && step == 40) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{-2, -2.2f}, {5, 1.8f}});
        }
    }
    const kodo::Vec2 place = world[chest].position();
    std::printf("%.1f s: it lies at (%.1f, %.1f) and sleeps\n", step / 60.0, place.x, place.y);
}
