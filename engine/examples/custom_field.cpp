// SPDX-License-Identifier: MIT
// Custom force field: a magnet that pulls iron bodies and leaves wood alone.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>
#include <memory>

/// Pulls with a constant force (N) within a radius (m), and brakes: F = pull d / |d| - drag v.
class Magnet final : public kodo::ForceField {
public:
    Magnet(kodo::Vec2 center, float radius, float pull)
        : center_(center), radius_(radius), pull_(pull) {}

    // Called once per step for each body. It depends on its arguments alone and changes nothing.
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real dt) const override {
        const kodo::Vec2 d = center_ - kodo::midStep(body, dt).position;
        if (kodo::length(d) > radius_) {
            return {};
        }
        constexpr float kDrag = 2; // N s/m; given as `drag`, so that no step overshoots
        return {.force = pull_ * kodo::normalize(d) - kDrag * body.velocity(), .drag = kDrag};
    }

private:
    kodo::Vec2 center_;
    float radius_;
    float pull_;
};

int main(int argc, char** argv) {
    constexpr kodo::Flags kIron = 1;
    kodo::World world{{.gravity = {0, -10}}};
    world.add({.shape = kodo::Plane{}, .type = kodo::BodyType::Static});
    world.addField({std::make_shared<Magnet>(kodo::Vec2{0, 6}, 5.0f, 30.0f),
                    {kodo::kMatchAny, kIron}}); // acts on bodies with the category kIron

    const kodo::BodyId iron = world.add(
        {.shape = kodo::Circle{0.5f}, .position = {-1, 2}, .density = 1.5f, .flags = kIron});
    const kodo::BodyId wood =
        world.add({.shape = kodo::Circle{0.5f}, .position = {1, 2}, .density = 0.5f});

    for (int step = 0; step <= 240; ++step) {
        if (step % 60 == 0) {
            std::printf("%d s: iron at %.1f m, wood at %.1f m\n", step / 60,
                        world[iron].position().y, world[wood].position().y);
        }
        world.step(1.0f / 60);
        if (argc > 1 && step == 90) { // a picture
            std::ofstream(argv[1]) << kodo::svg(world, {.velocities = true}, {{{-4, -1}, {4, 7}}});
        }
    }
}
