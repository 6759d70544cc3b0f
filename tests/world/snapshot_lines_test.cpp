// SPDX-License-Identifier: MIT
// Snapshots of Worlds with two-sided segments that meet: contacts with these keep their side.
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace kodo {
namespace {

/// Ground of fifteen segments in line, and rods that fall on it.
struct RodsOnSegments {
    World world{{.gravity = support::kEarth}};
    BodyId ground;

    explicit RodsOnSegments(std::uint64_t seed) {
        std::vector<Primitive> segments;
        for (int i = 0; i < 15; ++i) {
            segments.push_back(
                Segment{{static_cast<Real>(2 * i - 15), 0}, {static_cast<Real>(2 * i - 13), 0}});
        }
        ground = world.add({.shape = Compound{segments}, .type = BodyType::Static});
        support::RandomNumbers random(seed);
        for (std::uint64_t i = 0; i < 2 + seed % 5; ++i) {
            const Real half = random.between(0.2, 0.7);
            BodyDef rod{.shape = Segment{{-half, 0}, {half, 0}}};
            rod.position.x = random.between(-12, 12);
            rod.position.y = random.between(1, 4);
            rod.rotation = Rot::fromAngle(random.between(-3, 3));
            rod.density = random.between(0.5, 2);
            world.add(rod);
        }
    }
};

// The World continues with the bits of its snapshot, also once the ground falls and turns. The side
// of a contact once depended on a separation that only some contacts brought up to date.
TEST(SnapshotLines, ContinueWithTheSameBitsWhenTheGroundFalls) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(support::draws(40)); ++seed) {
        SCOPED_TRACE(seed);
        RodsOnSegments scene(seed);
        for (int step = 0; step < 120; ++step) {
            if (step == 40) {
                scene.world[scene.ground].setType(BodyType::Dynamic);
            }
            World loaded = fromBytes(toBytes(scene.world));
            loaded.step(support::kDt);
            scene.world.step(support::kDt);
            ASSERT_EQ(loaded.stateHash(), scene.world.stateHash()) << "step " << step;
        }
    }
}

} // namespace
} // namespace kodo
