// SPDX-License-Identifier: MIT
// Preview: a copy of the World shows where a throw will land, to the last bit, before it is made.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <vector>

constexpr float kDt = 1.0f / 60; // s

/// Where a ball will be after each step of a throw. The World stays as it is.
std::vector<kodo::Vec2> preview(const kodo::World& world, kodo::BodyId ball, kodo::Vec2 velocity) {
    kodo::World copy = world;
    copy[ball].setVelocity(velocity);
    std::vector<kodo::Vec2> path(120);
    for (kodo::Vec2& place : path) {
        copy.step(kDt);
        place = copy[ball].position();
    }
    return path;
}

int main(int argc, char** argv) {
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    for (int i = 0; i < 4; ++i) { // a tower
        world.add(
            {.shape = kodo::Box{0.8f, 0.8f}, .position = {6, 0.4f + 0.8f * static_cast<float>(i)}});
    }
    const kodo::BodyId ball = world.add({.shape = kodo::Circle{0.3f},
                                         .position = {0, 0.3f},
                                         .material = kodo::withFriction(0.5f, 0.5f),
                                         .density = 2});
    for (int i = 1; i <= 4; ++i) { // aim
        const kodo::Vec2 velocity =
            8.0f * kodo::Rot::fromAngle(0.3f * static_cast<float>(i)).xAxis();
        const std::vector<kodo::Vec2> path = preview(world, ball, velocity);
        std::printf("%.1f rad: ends at x = %.2f m\n", 0.3 * i, path.back().x);
    }
    const kodo::Vec2 best = 8.0f * kodo::Rot::fromAngle(0.9f).xAxis();
    const std::vector<kodo::Vec2> path = preview(world, ball, best);
    if (argc > 1) { // a picture, with the path
        kodo::SvgDraw picture({{-1, -0.5f}, {9, 5}});
        kodo::draw(world, picture);
        for (const kodo::Vec2 place : path) {
            picture.point(place, {{255, 210, 70}});
        }
        std::ofstream(argv[1]) << picture.document();
    }
    world[ball].setVelocity(best);
    bool equal = true;
    for (const kodo::Vec2 place : path) {
        world.step(kDt);
        equal = equal && world[ball].position() == place;
    }
    std::printf("the throw goes as shown: %s\n", equal ? "yes, to the last bit" : "no");
}
