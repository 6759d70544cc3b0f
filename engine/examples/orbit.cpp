// SPDX-License-Identifier: MIT
// Orbits: planets around a sun. Kepler's third law gives their years.
#include <kodo/kodo.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

int main(int argc, char** argv) {
    constexpr float kStrength = 40; // m^3/s^2
    kodo::World world;
    world.addField({std::make_shared<kodo::Attractor>(kodo::Attractor::Law::InverseSquare,
                                                      kodo::Vec2{0, 0}, kStrength),
                    {}});
    world.add({.shape = kodo::Circle{0.6f}, .type = kodo::BodyType::Static});
    struct Planet {
        float radius; // m, where it begins
        float speed;  // 1: a circle; more: an ellipse, begun at its closest point
        double year;  // s; 0: not over yet
        kodo::BodyId id{};
    };
    std::array<Planet, 3> planets{{{2, 1, 0}, {4, 1, 0}, {3, 1.2f, 0}}};
    for (Planet& planet : planets) {
        const float speed = planet.speed * std::sqrt(kStrength / planet.radius);
        planet.id = world.add(
            {.shape = kodo::Circle{0.2f}, .position = {planet.radius, 0}, .velocity = {0, speed}});
    }
    kodo::SvgDraw picture({{-11, -7}, {5, 7}});
    for (int step = 1; step <= 4000; ++step) {
        const kodo::World before = world;
        world.step(1.0f / 240);
        for (Planet& planet : planets) {
            const kodo::Vec2 place = world[planet.id].position();
            if (planet.year == 0 && before[planet.id].position().y < 0 && place.y >= 0) {
                planet.year = step / 240.0; // upwards through the x axis
            } else if (planet.year == 0 && step % 40 == 0) {
                picture.circle(place, 0.03f, {{120, 130, 150}});
            }
        }
    }
    for (const Planet& planet : planets) { // 2 pi sqrt(a^3 / strength), half axis a
        const double axis = planet.radius / (2 - planet.speed * planet.speed);
        std::printf("half axis %.2f m: year %.2f s, by Kepler %.2f s\n", axis, planet.year,
                    6.2831853 * std::sqrt(axis * axis * axis / kStrength));
    }
    if (argc > 1) { // a picture, with the paths
        kodo::draw(world, picture);
        std::ofstream(argv[1]) << picture.document();
    }
}
