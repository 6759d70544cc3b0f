// SPDX-License-Identifier: MIT
// Hello: a ball falls on the ground and bounces.
#include <kodo/kodo.hpp>

#include <cstdio>

int main() {
    kodo::World world{{.gravity = {0, -10}}};

    // A contact takes the smaller restitution of the two materials.
    const kodo::Material rubber = kodo::withFriction(0.6f, 0.8f);
    const kodo::BodyId ground = world.add({.shape = kodo::Box{20, 1},
                                           .position = {0, -0.5f},
                                           .material = rubber,
                                           .type = kodo::BodyType::Static});
    const kodo::BodyId ball =
        world.add({.shape = kodo::Circle{0.5f}, .position = {0, 4}, .material = rubber});

    for (int step = 1; step <= 180; ++step) {
        world.step(1.0f / 60);
        for (const kodo::CollisionRecord& hit : world.begunCollisions()) {
            if (hit.involves(ground)) {
                std::printf("%.2f s: hits the ground at %.1f m/s\n", step / 60.0,
                            hit.approachSpeed);
            }
        }
        if (step % 30 == 0) {
            std::printf("%.2f s: height %.2f m\n", step / 60.0, world[ball].position().y);
        }
    }
}
