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

/// Frees blocks of many sizes full of rubbish, for the next World to be built on.
void dirtyMemory() {
    std::vector<std::unique_ptr<unsigned char[]>> blocks;
    for (std::size_t size = 16; size <= std::size_t{1} << 18; size += size / 4) {
        blocks.push_back(std::make_unique<unsigned char[]>(size));
        std::memset(blocks.back().get(), 0xA5, size);
    }
}

/// Moves the centre of mass by the least possible. Its frame may lie nearer to x = 0, where one
/// unit is less than the centre can show, so this may take several.
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

// The heavy mode: every tick is played by the World and by a copy of it made just before.
TEST_P(Repeat, ACopyGoesOnAsTheOriginalDoes) {
    Player player(GetParam());
    while (player.ticks() < kTicks) {
        Player copy = player;
        player.tick();
        copy.tick();
        ASSERT_EQ(copy.hash(), player.hash()) << "after tick " << player.ticks();
    }
}

// The heaviest mode: before every tick the World is taken to bytes and back.
TEST_P(Repeat, AWorldThatGoesThroughBytesComesToTheSameEnd) {
    Player player(GetParam());
    Player moved = player;
    while (player.ticks() < kTicks) {
        moved.world() = kodo::fromBytes(kodo::toBytes(moved.world()));
        player.tick();
        moved.tick();
        ASSERT_EQ(moved.hash(), player.hash()) << "after tick " << player.ticks();
    }
}

TEST_P(Repeat, ARewoundWorldComesToTheSameEnd) {
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

// The hash has teeth: it sees one body moved by one unit in the last place, at once and after the
// next tick. Only a body that has just gone past a power of two may lose that unit by rounding.
TEST_P(Repeat, TheHashSeesANudgeOfOneUlp) {
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

/// Pose and motion of a body, to be compared bit by bit (== but for the two zeros).
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

/// Plays a scene with and without a ball that falls far away, and compares all others.
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

// What a body far away adds to the lists must not change the order in which others are solved. The
// pile of 29 has 32 bodies with its walls: one more, and another way to find pairs takes over.
TEST(FarAway, ABodyFarAwayChangesNoBitOfTheOthers) {
    for (const scenes::SceneDef& scene : {scenes::stack(10), scenes::pyramid(8), scenes::pile(29),
                                          scenes::elasticGas(), scenes::fastBalls()}) {
        expectUnmoved(scene, Where::First);
        expectUnmoved(scene, Where::Last);
    }
}

} // namespace
} // namespace determinism
