// SPDX-License-Identifier: MIT
// Drops a ball and prints the state hash and the version. It uses what a package may lose: inline
// and compiled functions, instances of templates, threads, an exception and a virtual class.
#include <kodo/kodo.hpp>

#include <cinttypes>
#include <cstdio>
#include <memory>

namespace {

class Lift final : public kodo::ForceField {
public:
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real) const override {
        return {.force = {0, body.mass()}};
    }
};

bool refuses(kodo::World& world) {
    try {
        world.add({.shape = kodo::Circle{-1}});
    } catch (const kodo::BadDefinition&) {
        return true;
    }
    return false;
}

} // namespace

int main() {
    kodo::ThreadPool threads(1);
    kodo::World world{{.gravity = {0, -10}}};
    world.addField({.field = std::make_shared<Lift>()});
    world.add({.shape = kodo::Box{20, 1}, .type = kodo::BodyType::Static});
    const kodo::BodyId ball = world.add({
        .shape = kodo::Circle{kodo::Real(0.5)},
        .position = {0, 10},
        .rotation = kodo::Rot::fromAngle(1),
        .material = kodo::withFriction(kodo::Real(0.5), 1),
    });
    for (int i = 0; i < 240; ++i) {
        world.step(kodo::Real(1) / 60, {.executor = &threads});
    }
    if (!refuses(world) || world[ball].rotation().angle() <= 0) {
        return 1;
    }
    std::printf("%016" PRIx64 " %d.%d.%d\n", world.stateHash(), KODO_VERSION_MAJOR,
                KODO_VERSION_MINOR, KODO_VERSION_PATCH);
    return 0;
}
