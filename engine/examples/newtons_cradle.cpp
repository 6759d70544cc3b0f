// SPDX-License-Identifier: MIT
// Newton's cradle: five balls on rods. Two that fall on one side throw two off the other.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    const kodo::BodyId beam = world.add(
        {.shape = kodo::Box{6, 0.2f}, .position = {0, 4}, .type = kodo::BodyType::Static});
    std::array<kodo::BodyId, 5> balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const float x = static_cast<float>(i) - 2;
        const float angle = i < 2 ? -0.8f : 0.0f; // rad; two are held to the left
        const kodo::Vec2 arm = kodo::Rot::fromAngle(angle) * kodo::Vec2{0, -3};
        balls[i] = world.add({.shape = kodo::Circle{0.5f},
                              .position = kodo::Vec2{x, 4} + arm,
                              .material = kodo::withFriction(0, 1),
                              .flags = kodo::kLockRotate | kodo::kNeverSleep});
        world.add(kodo::DistanceJoint{.ends = {.a = beam, .b = balls[i], .anchorA = {x, 0}},
                                      .limits = kodo::Range{3, 3}});
    }

    // How far each ball is aside of where it hung, when one side is highest.
    const auto tell = [&](int step) {
        std::printf("%.2f s:", step / 240.0);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const float x = static_cast<float>(i) - 2;
            const float aside = world[balls[i]].position().x - x; // m
            std::printf(" %5.2f", std::abs(aside) < 0.005f ? 0.0f : aside);
        }
        std::printf(" m aside\n");
    };
    bool wasMoving = false;
    for (int step = 1; step <= 960; ++step) {
        world.step(1.0f / 240);
        float fastest = 0;
        for (const kodo::BodyId ball : balls) {
            fastest = std::max(fastest, length(world[ball].velocity()));
        }
        const bool moving = fastest > 0.1f;
        if (wasMoving && !moving) {
            tell(step);
        }
        wasMoving = moving;
        if (argc > 1 && step == 300) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true});
        }
    }
}
