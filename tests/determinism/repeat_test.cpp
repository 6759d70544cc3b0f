// SPDX-License-Identifier: MIT
#include <determinism/player.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

namespace determinism {
namespace {

using kodo::BodyId;
using kodo::Real;

std::string nameOfRecipe(const testing::TestParamInfo<Recipe>& info) {
    return info.param.name;
}

/// Frees blocks of many sizes filled with a pattern, for the allocations of the next World.
void dirtyMemory() {
    std::vector<std::unique_ptr<unsigned char[]>> blocks;
    for (std::size_t size = 16; size <= std::size_t{1} << 18; size += size / 4) {
        blocks.push_back(std::make_unique<unsigned char[]>(size));
        std::memset(blocks.back().get(), 0xA5, size);
    }
}

/// Moves the centre of mass by the smallest possible distance. The origin of the body may be closer
/// to x = 0, where one unit in the last place is too small to move the centre, so this may take
/// several.
void nudge(kodo::BodyRef body) {
    const Real before = body.center().x;
    kodo::Vec2 place = body.position();
    while (body.center().x == before) {
        place.x = std::nextafter(place.x, std::numeric_limits<Real>::max());
        body.setPosition(place);
    }
}

class Repeat : public testing::TestWithParam<Recipe> {};

TEST_P(Repeat, ASecondRunInOneProcessGivesTheSameBits) {
    const std::vector<std::uint64_t> first = hashesOf(GetParam());
    dirtyMemory();
    EXPECT_EQ(hashesOf(GetParam()), first);
}

// The World and a copy made just before play every tick.
TEST_P(Repeat, ACopyContinuesWithTheSameBits) {
    Player player(GetParam());
    while (player.ticks() < kTicks) {
        Player copy = player;
        player.tick();
        copy.tick();
        ASSERT_EQ(copy.hash(), player.hash()) << "after tick " << player.ticks();
    }
}

// Before every tick, the World is written to bytes and restored.
TEST_P(Repeat, AWorldRestoredFromBytesContinuesWithTheSameBits) {
    Player player(GetParam());
    Player moved = player;
    while (player.ticks() < kTicks) {
        moved.world() = kodo::fromBytes(kodo::toBytes(moved.world()));
        player.tick();
        moved.tick();
        ASSERT_EQ(moved.hash(), player.hash()) << "after tick " << player.ticks();
    }
}

TEST_P(Repeat, ARewoundWorldEndsWithTheSameBits) {
    Player player(GetParam());
    while (player.ticks() < kTicks / 2) {
        player.tick();
    }
    Player saved = player;
    while (player.ticks() < kTicks) {
        player.tick();
    }
    while (saved.ticks() < kTicks) {
        saved.tick();
    }
    EXPECT_EQ(saved.hash(), player.hash());
}

// The hash detects a displacement of one body by one unit in the last place, at once and after the
// next tick. Only a body that has just passed a power of two may lose that unit by rounding.
TEST_P(Repeat, TheHashDetectsADisplacementOfOneUlp) {
    Player before(GetParam());
    while (before.ticks() < 100) {
        before.tick();
    }
    Player undisturbed = before;
    undisturbed.tick();
    std::size_t lost = 0;
    for (const BodyId id : before.world().bodies()) {
        Player nudged = before;
        nudge(nudged.world()[id]);
        EXPECT_NE(nudged.hash(), before.hash()) << "body " << id.index;
        nudged.tick();
        lost += nudged.hash() == undisturbed.hash() ? 1 : 0;
    }
    EXPECT_LE(10 * lost, before.world().bodyCount());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Repeat, testing::ValuesIn(recipes().begin(), recipes().end()),
                         nameOfRecipe);

/// Pose and velocity of a body, compared bit by bit (== except for the two zeros).
struct Bits {
    kodo::Vec2 center;
    kodo::Rot rotation;
    kodo::Vec2 velocity;
    Real spin;
    friend bool operator==(const Bits&, const Bits&) = default;
};
Bits bitsOf(const kodo::World& world, BodyId id) {
    const kodo::BodyView view = world[id];
    return {view.center(), view.rotation(), view.velocity(), view.angularVelocity()};
}

enum class Where { First, Last };

/// Plays a scene with and without a ball that falls far away, and compares all other bodies.
void expectUnmoved(const scenes::SceneDef& scene, Where where) {
    scenes::SceneDef crowded = scene;
    const scenes::BodyDef far = scenes::ball(0.5, {3000, 9000});
    crowded.bodies.insert(where == Where::First ? crowded.bodies.begin() : crowded.bodies.end(),
                          far);
    const std::size_t shift = where == Where::First ? 1 : 0;
    scenes::KodoScene alone = scenes::inKodo(scene);
    scenes::KodoScene together = scenes::inKodo(crowded);
    for (int tick = 1; tick <= 300; ++tick) {
        alone.world.step(kDt);
        together.world.step(kDt);
        for (std::size_t i = 0; i < alone.ids.size(); ++i) {
            ASSERT_EQ(bitsOf(alone.world, alone.ids[i]),
                      bitsOf(together.world, together.ids[i + shift]))
                << scene.name << ", body " << i << ", tick " << tick;
        }
    }
}

// List entries of a distant body must not change the order in which others are solved. The pile of
// 29 has 32 bodies with its walls: with one more, another algorithm searches pairs.
TEST(DistantBody, ChangesNoBitOfTheOthers) {
    for (const scenes::SceneDef& scene : {scenes::stack(10), scenes::pyramid(8), scenes::pile(29),
                                          scenes::elasticGas(), scenes::fastBalls()}) {
        expectUnmoved(scene, Where::First);
        expectUnmoved(scene, Where::Last);
    }
}

} // namespace
} // namespace determinism
