// SPDX-License-Identifier: MIT
// Car: wheel joints with suspension and motor, over bumps. The load on each axle is read, and the
// motor is changed on the way.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <vector>

int main() {
    kodo::World world{{.gravity = {0, -10}}};
    std::vector<kodo::Vec2> ground{{-10, 0}};
    for (int i = 0; i < 12; ++i) { // bumps of 0.15 m, 2 m apart
        const float x = 6 + 2 * static_cast<float>(i);
        ground.insert(ground.end(), {{x - 0.5f, 0}, {x, 0.15f}, {x + 0.5f, 0}});
    }
    ground.push_back({60, 0});
    world.add({.shape = kodo::Chain{.points = ground},
               .material = kodo::withFriction(1),
               .type = kodo::BodyType::Static});

    const kodo::BodyId chassis =
        world.add({.shape = kodo::Box{3, 0.6f}, .position = {0, 1.3f}, .density = 100}); // 180 kg
    std::vector<kodo::JointId> axles;
    for (const float x : {-1.0f, 1.0f}) {
        const kodo::BodyId wheel = world.add({.shape = kodo::Circle{0.4f},
                                              .position = {x, 0.4f},
                                              .material = kodo::withFriction(1),
                                              .density = 50}); // 25 kg
        axles.push_back(
            world.add(kodo::WheelJoint{.ends = {.a = chassis, .b = wheel, .anchorA = {x, -0.9f}},
                                       .limits = kodo::Range{-0.15f, 0.25f}, // m
                                       .hertz = 5,
                                       .damping = 0.7f}));
    }
    const auto setMotors = [&](float speed) { // rad/s; clockwise is forwards
        for (const kodo::JointId axle : axles) {
            world.changeJoint<kodo::WheelJoint>(axle, [&](kodo::WheelJoint& joint) {
                joint.motorSpeed = -speed;
                joint.motorTorque = 100;
            });
        }
    };
    for (int step = 0; step < 600; ++step) {
        if (step == 0 || step == 420) {
            setMotors(step == 0 ? 12.5f : 0); // 5 m/s; brake
        }
        world.step(1.0f / 60);
        if (step % 60 == 59) {
            const kodo::JointState front = world.jointState(axles[1]);
            std::printf("%2d s: %4.1f m, %3.1f m/s, front axle %+.0f mm, tilt %+.2f rad\n",
                        (step + 1) / 60, world[chassis].position().x, world[chassis].velocity().x,
                        1000 * front.translation, world[chassis].rotation().angle());
        }
    }
}
