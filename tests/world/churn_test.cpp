// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <algorithm>

namespace kodo {
namespace {

// W1: a million random adds and removes in a world of up to 10,000 bodies against a model that
// keeps, for every slot, who lives in it. Each call takes the same time however many there are, or
// this test would take minutes.
TEST(Churn, AMillionAddsAndRemovesAgreeWithAModel) {
    constexpr std::uint64_t kSeed = 171;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    World world;
    std::vector<BodyId> alive;
    std::vector<std::uint32_t> generations; // the last that each slot has seen
    std::vector<std::uint64_t> owners;      // the user data of who lives there
    BodyDef def = support::ballDef({}, Real(0.5));
    bool growing = true;
    for (std::uint64_t call = 0; call < 1000000; ++call) {
        growing = alive.empty() || (growing && alive.size() < 10000);
        if (random.below(8) < (growing ? 5u : 3u) || alive.empty()) {
            def.position = random.point(1000);
            def.userData = call;
            const BodyId id = world.add(def);
            generations.resize(std::max<std::size_t>(generations.size(), id.index + 1));
            owners.resize(generations.size());
            ASSERT_GT(id.generation, generations[id.index]) << "given out twice, call " << call;
            generations[id.index] = id.generation;
            owners[id.index] = call;
            alive.push_back(id);
        } else {
            std::swap(alive[random.below(alive.size())], alive.back());
            const BodyId id = alive.back();
            ASSERT_EQ(world[id].userData(), owners[id.index]) << "call " << call;
            world.remove(id);
            ASSERT_FALSE(world.contains(id));
            alive.pop_back();
        }
        growing = growing || alive.size() < 100;
        ASSERT_EQ(world.bodyCount(), alive.size());
    }
    EXPECT_LE(generations.size(), 11000u); // slots are used again
    std::sort(alive.begin(), alive.end());
    EXPECT_EQ(world.bodies(), alive);
}

} // namespace
} // namespace kodo
