// SPDX-License-Identifier: MIT
// Pick by mouse: the body under the pointer is pulled by a mouse joint until the button is let go.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <optional>

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    const kodo::BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = {0, 0.5f}});
    std::optional<kodo::JointId> joint;

    // What a game calls for the events of a mouse. Points are in the world (m).
    const auto press = [&](kodo::Vec2 point) {
        const auto found = kodo::closestPoint(world, point, 0.1f); // a little beside counts too
        if (found && world[found->body].type() == kodo::BodyType::Dynamic) {
            const kodo::BodyRef body = world[found->body];
            joint = world.add(kodo::MouseJoint{.body = body.id(),
                                               .anchor = toLocal(body.transform(), found->point),
                                               .target = point,
                                               .force = 100 * body.mass()}); // ten times its weight
        }
        return joint.has_value();
    };
    const auto move = [&](kodo::Vec2 point) {
        auto pulled = std::get<kodo::MouseJoint>(world.joint(*joint));
        pulled.target = point;
        world.setJoint(*joint, pulled);
    };
    const auto release = [&] {
        if (joint && world.contains(*joint)) { // removed with its body otherwise
            world.remove(*joint);
        }
        joint.reset();
    };

    std::printf("beside: %d, on the ground: %d\n", press({2, 2}), press({5, 0}));
    std::printf("at a corner: %d\n", press({0.45f, 0.95f}));
    for (int step = 0; step < 120; ++step) { // up and to the right
        const float share = step < 60 ? static_cast<float>(step) / 60 : 1;
        move({0.45f + 2 * share, 0.95f + 2 * share});
        world.step(1.0f / 60);
    }
    std::printf("hangs at (%.2f, %.2f)\n", world[box].center().x, world[box].center().y);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(world, {}, kodo::Aabb{{-2, -0.5f}, {4, 4}});
    }
    release();
    for (int step = 0; step < 120; ++step) {
        world.step(1.0f / 60);
    }
    std::printf("dropped: height %.2f m\n", world[box].center().y);
}
