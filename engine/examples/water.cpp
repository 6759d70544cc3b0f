// SPDX-License-Identifier: MIT
// Water: bodies float where they displace their own mass (Archimedes), and heavy ones sink.
#include <kodo/kodo.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

int main(int argc, char** argv) {
    constexpr kodo::Vec2 kGravity{0, -10}; // m/s^2
    kodo::World world{{.gravity = kGravity}};
    const kodo::Buoyancy::Fluid water{.density = 1, .drag = 2};
    world.addField({std::make_shared<kodo::Buoyancy>(water, kodo::Vec2{0, 0}, kGravity), {}});
    world.add({.shape = kodo::Chain{.points = {{-6, 1}, {-5, -3}, {5, -3}, {6, 1}}},
               .type = kodo::BodyType::Static});

    const auto addBox = [&](float x, float density) {
        return world.add({.shape = kodo::Box{1.5f, 1}, .position = {x, 1}, .density = density});
    };
    const kodo::BodyId cork = addBox(-4, 0.25f);
    const kodo::BodyId wood = addBox(-1.5f, 0.6f);
    const kodo::BodyId stone = addBox(1, 2.5f);
    const kodo::BodyId boat = // a hull with two walls: lighter than the water below its deck
        world.add(
            {.shape =
                 kodo::Compound{{kodo::Polygon{{{-1, 0}, {-0.6f, -0.6f}, {0.6f, -0.6f}, {1, 0}}},
                                 kodo::Box{0.1f, 0.5f, {-0.9f, 0.25f}},
                                 kodo::Box{0.1f, 0.5f, {0.9f, 0.25f}}}},
             .position = {3.5f, 0.5f},
             .density = 0.5f});
    for (int step = 0; step < 600; ++step) {
        world.step(1.0f / 60);
    }
    // A box of density rho floats with the share rho of its height under water.
    const auto tell = [&](const char* name, kodo::BodyId id) {
        std::printf("%s: %.2f m under water\n", name, 0.5f - world[id].position().y);
    };
    tell("cork, 0.25 of its height", cork);
    tell("wood, 0.6", wood);
    std::printf("stone: lies at %.2f m\n", world[stone].position().y);
    std::printf("boat: deck at %.2f m, leans by %.2f rad\n", world[boat].position().y,
                std::abs(world[boat].rotation().angle()));
    if (argc > 1) { // a picture, with the surface of the water
        kodo::SvgDraw picture({{-6.5f, -3.5f}, {6.5f, 1.5f}});
        kodo::draw(world, picture);
        picture.line({-6, 0}, {6, 0}, {{60, 140, 255}});
        std::ofstream(argv[1]) << picture.document();
    }
}
