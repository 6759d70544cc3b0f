// SPDX-License-Identifier: MIT
// Bullets: fast bodies do not tunnel through thin walls. Without continuous collision they do.
#include <kodo/kodo.hpp>

#include <cstdio>
#include <fstream>

namespace {

struct Range {
    kodo::World world;
    int stopped = 0; // bullets before the wall after a second
    float fastest = 0;
};

/// Ten bullets of 5 cm with up to 1000 m/s against a wall of 2 cm.
Range shoot(bool continuous) {
    Range range{kodo::World{{.lengthUnit = 0.1f}}};
    kodo::World& world = range.world;
    if (!continuous) {
        kodo::StepSettings settings;
        settings.leaveOut = kodo::Feature::ContinuousCollision;
        world.setSettings(settings);
    }
    world.add({.shape = kodo::Box{0.02f, 4}, .position = {5, 0}, .type = kodo::BodyType::Static});
    for (int i = 0; i < 10; ++i) {
        world.add({.shape = kodo::Circle{0.05f},
                   .position = {0, 0.3f * static_cast<float>(i) - 1.35f},
                   .velocity = {100 * static_cast<float>(i + 1), 0}});
    }
    for (int step = 0; step < 60; ++step) {
        world.step(1.0f / 60);
        for (const kodo::CollisionRecord& hit : world.hits(1)) {
            range.fastest = hit.approachSpeed > range.fastest ? hit.approachSpeed : range.fastest;
        }
    }
    for (const kodo::BodyId id : world.bodies()) {
        const bool isBullet = world[id].type() == kodo::BodyType::Dynamic;
        range.stopped += isBullet && world[id].position().x < 5 ? 1 : 0;
    }
    return range;
}

} // namespace

int main(int argc, char** argv) {
    const Range safe = shoot(true);
    const Range fast = shoot(false);
    std::printf("continuous collision: %d of 10 stopped, hits at up to %.0f m/s\n", safe.stopped,
                safe.fastest);
    std::printf("without: %d of 10 stopped\n", fast.stopped);
    if (argc > 1) { // a picture
        std::ofstream(argv[1]) << kodo::svg(safe.world, {}, kodo::Aabb{{2, -2.2f}, {6, 2.2f}});
    }
}
