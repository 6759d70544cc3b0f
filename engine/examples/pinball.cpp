// SPDX-License-Identifier: MIT
// Pinball: two flippers, hinges with limits and a motor that a button reverses.
#include <kodo/kodo.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -1}, .lengthUnit = 0.1f}}; // the table leans back
    const kodo::Chain outline{
        .points = {{-0.25f, -0.1f}, {-0.3f, 0.9f}, {0.3f, 0.9f}, {0.25f, -0.1f}}};
    const kodo::BodyId table = world.add({.shape = outline,
                                          .material = kodo::withFriction(0.1f, 0.4f),
                                          .type = kodo::BodyType::Static});
    world.add({.shape = kodo::Circle{0.04f},
               .position = {0.05f, 0.6f},
               .material = kodo::withFriction(0.1f, 0.9f),
               .type = kodo::BodyType::Static}); // a bumper

    // Side -1 is the left flipper, 1 the right one.
    const auto addFlipper = [&](float side) {
        const kodo::BodyId flipper =
            world.add({.shape = kodo::Capsule{{}, {-0.13f * side, 0}, 0.015f},
                       .position = {0.17f * side, 0.1f},
                       .density = 20});
        return world.add(kodo::RevoluteJoint{
            .ends = {.a = table, .b = flipper, .anchorA = {0.17f * side, 0.1f}},
            .limits = side < 0 ? kodo::Range{-0.4f, 0.5f} : kodo::Range{-0.5f, 0.4f},
            .motorSpeed = 10 * side, // rests down: the left one turns clockwise
            .motorTorque = 0.5f});
    };
    const kodo::JointId left = addFlipper(-1);
    addFlipper(1);
    const auto press = [&](kodo::JointId joint, float speed) {
        auto flipper = std::get<kodo::RevoluteJoint>(world.joint(joint));
        flipper.motorSpeed = speed; // rad/s
        world.setJoint(joint, flipper);
    };
    const kodo::BodyId ball = world.add({.shape = kodo::Circle{0.02f},
                                         .position = {-0.1f, 0.5f},
                                         .material = kodo::withFriction(0.1f, 0.4f),
                                         .density = 20,
                                         .flags = kodo::kNeverSleep});
    float highest = 0; // m
    for (int step = 1; step <= 300; ++step) {
        if (step == 110 || step == 130) {
            press(left, step == 110 ? 20.0f : -10.0f);
            std::printf("step %d: button %s, ball at a height of %.2f m\n", step,
                        step == 110 ? "down" : "up", world[ball].position().y);
        }
        world.step(1.0f / 120);
        if (argc > 1 && step == 118) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true});
        }
        highest = std::max(highest, world[ball].position().y);
    }
    std::printf("the flipper lifts the ball to %.2f m\n", highest);
}
