// SPDX-License-Identifier: MIT
// Rope: links and revolute joints carry a load. A second load breaks the weakest one.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <vector>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    const kodo::BodyId hook =
        world.add({.shape = kodo::Circle{0.1f}, .type = kodo::BodyType::Static});

    // Ten links of 0.5 m, 0.05 kg each, hang straight down. The joint in the middle is the weakest.
    std::vector<kodo::JointId> joints;
    kodo::BodyId last = hook;
    float end = 0; // m, of the lower end of `last`, in its frame
    for (int i = 0; i < 10; ++i) {
        const kodo::BodyId link =
            world.add({.shape = kodo::Box{0.1f, 0.5f},
                       .position = {0, -0.25f - 0.5f * static_cast<float>(i)}});
        joints.push_back(
            world.add(kodo::RevoluteJoint{.ends = {.a = last,
                                                   .b = link,
                                                   .anchorA = {0, end},
                                                   .anchorB = {0, 0.25f},
                                                   .breakForce = i == 5 ? 70.0f : 200.0f}}));
        last = link;
        end = -0.25f;
    }
    const auto addLoad = [&] { // 4 kg at the lower end
        const kodo::Vec2 place = world[last].transform() * kodo::Vec2{0, end} - kodo::Vec2{0, 0.5f};
        const kodo::BodyId load =
            world.add({.shape = kodo::Box{1, 1}, .position = place, .density = 4});
        world.add(kodo::RevoluteJoint{
            .ends = {.a = last, .b = load, .anchorA = {0, end}, .anchorB = {0, 0.5f}}});
        last = load;
        end = -0.5f;
    };
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(1.0f / 60);
            for (const kodo::BrokenJoint& broken : world.brokenJoints()) {
                std::printf("joint %u broke at %.1f N\n", broken.id.index, broken.force);
            }
        }
    };
    run(60);
    std::printf("rope alone: %.1f N\n", world.jointForce(joints[0]).y);
    addLoad();
    run(120);
    std::printf("with 4 kg: %.1f N\n", world.jointForce(joints[0]).y);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world);
    }
    addLoad(); // 8 kg in all
    run(60);
    std::printf("%zu of 12 joints left\n", world.joints().size());
}
