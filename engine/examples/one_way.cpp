// SPDX-License-Identifier: MIT
// One-way platforms: a one-sided segment lets a body through from below and carries it from above.
// To drop through, the body leaves out the category of platforms for a moment.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    constexpr kodo::Flags kGround = 1;
    constexpr kodo::Flags kPlatform = 2;
    kodo::World world{{.gravity = {0, -20}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static, .flags = kGround});
    for (int i = 1; i <= 2; ++i) {
        // The front is on the left of from -> to: above.
        const float y = 2 * static_cast<float>(i);
        world.add({.shape = kodo::Segment{.from = {-2, y}, .to = {2, y}, .oneSided = true},
                   .type = kodo::BodyType::Static,
                   .flags = kPlatform});
    }
    const kodo::BodyId player =
        world.add({.shape = kodo::Capsule{{0, -0.3f}, {0, 0.3f}, 0.3f},
                   .position = {0, 0.6f},
                   .flags = kodo::kLockRotate | kodo::kMatchAny | kodo::kNeverSleep,
                   .required = kGround | kPlatform});
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(1.0f / 60);
        }
    };
    const auto tell = [&](const char* what) {
        std::printf("%s: at a height of %.2f m\n", what, world[player].position().y);
    };

    run(10);
    tell("on the ground");
    for (int jump = 1; jump <= 2; ++jump) {
        world[player].setVelocity({0, 10});
        run(90);
        tell(jump == 1 ? "first platform" : "second platform");
    }
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {.contacts = true},
                                            kodo::Aabb{{-3, -0.5f}, {3, 5.5f}});
    }
    world[player].setRequired(kGround); // falls through platforms
    run(15);
    world[player].setRequired(kGround | kPlatform);
    run(60);
    tell("dropped by one");
}
