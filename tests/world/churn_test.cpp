// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <algorithm>

namespace kodo {
namespace {

// W1: a million random additions and removals among up to 10,000 bodies, against a model with the
// body of each slot. A call takes constant time if no bodies touch; otherwise this test would take
// minutes.
TEST(Churn, AMillionAddsAndRemovesAgreeWithAModel) {
    constexpr std::uint64_t kSeed = 171;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    World world;
    std::vector<BodyId> alive;
    std::vector<std::uint32_t> generations; // latest generation, by slot
    std::vector<std::uint64_t> owners;      // user data of the body in each slot
    BodyDef def = support::ballDef({}, Real(0.5));
    bool growing = true;
    for (std::uint64_t call = 0; call < (support::kSanitized ? 200000 : 1000000); ++call) {
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
    EXPECT_LE(generations.size(), 11000u); // slots are reused
    std::sort(alive.begin(), alive.end());
    EXPECT_EQ(world.bodies(), alive);
}

/// Expected bodies and revolute joints of a World.
struct PinnedModel {
    std::vector<BodyId> bodies;
    std::vector<std::pair<JointId, RevoluteJoint>> pins;

    BodyId any(support::RandomNumbers& random) const { return bodies[random.below(bodies.size())]; }
    void remove(BodyId id) {
        std::erase(bodies, id);
        std::erase_if(pins, [&](const auto& pin) {
            return pin.second.ends.a == id || pin.second.ends.b == id;
        });
    }
    bool lives(BodyId id) const {
        return std::find(bodies.begin(), bodies.end(), id) != bodies.end();
    }
};

/// Expects the World to hold exactly the bodies and joints of the model.
void expectToAgree(const World& world, const PinnedModel& model) {
    ASSERT_EQ(world.bodyCount(), model.bodies.size());
    std::vector<JointId> pins;
    for (const auto& [id, pin] : model.pins) {
        ASSERT_TRUE(world.contains(id));
        ASSERT_EQ(firstBody(world.joint(id)), pin.ends.a);
        ASSERT_EQ(secondBody(world.joint(id)), pin.ends.b);
        pins.push_back(id);
    }
    std::sort(pins.begin(), pins.end());
    ASSERT_EQ(world.joints(), pins);
}

// W1: the same in a heap with contacts, revolute joints and sleeping islands, with steps in
// between. After each call, bodies and joints match the model. StepStats never counts more than
// exist. Removed bodies appear in End records only.
TEST(Churn, AddsAndRemovesInAJointedHeapAgreeWithAModel) {
    constexpr std::uint64_t kSeed = 173;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    support::RandomNumbers random(kSeed);
    World world({.gravity = support::kEarth});
    PinnedModel model;
    model.bodies.push_back(support::addFloor(world));
    std::size_t contacts = 0;
    std::size_t pinned = 0;
    for (int call = 0; call < 6000; ++call) {
        SCOPED_TRACE(testing::Message() << "call " << call);
        const std::uint64_t choice = random.below(8);
        if (choice < 3 && model.bodies.size() < 80) {
            const Vec2 place{random.between(-4, 4), random.between(0, 6)};
            model.bodies.push_back(world.add(support::boxDef(place, Real(0.5), Real(0.5))));
        } else if (choice == 3 && model.bodies.size() > 20) {
            const BodyId id = model.bodies[1 + random.below(model.bodies.size() - 1)];
            world.remove(id);
            model.remove(id);
        } else if (choice == 4 && model.bodies.size() > 2) {
            const RevoluteJoint pin{.ends = {.a = model.any(random), .b = model.any(random)}};
            if (pin.ends.a != pin.ends.b) {
                model.pins.emplace_back(world.add(pin), pin);
            }
        } else if (choice == 5 && model.pins.size() > 10) {
            const std::size_t which = random.below(model.pins.size());
            world.remove(model.pins[which].first);
            model.pins.erase(model.pins.begin() + static_cast<std::ptrdiff_t>(which));
        } else {
            world.step(support::kDt);
            ASSERT_LE(stepStats(world).bodies, model.bodies.size());
            ASSERT_LE(stepStats(world).joints, model.pins.size());
            for (const CollisionRecord& record : world.collisions()) {
                const bool live = model.lives(record.a) && model.lives(record.b);
                ASSERT_TRUE(live || record.phase == TouchPhase::End);
            }
            contacts += world.collisions().size();
            pinned += stepStats(world).joints;
        }
        ASSERT_NO_FATAL_FAILURE(expectToAgree(world, model));
    }
    EXPECT_GT(contacts, 10000u); // otherwise the test covers nothing
    EXPECT_GT(pinned, 10000u);
    while (!model.bodies.empty()) {
        const BodyId id = model.bodies.back();
        world.remove(id);
        model.remove(id);
        ASSERT_NO_FATAL_FAILURE(expectToAgree(world, model));
    }
    world.step(support::kDt);
    for (const CollisionRecord& record : world.collisions()) {
        EXPECT_EQ(record.phase, TouchPhase::End);
    }
    world.step(support::kDt);
    EXPECT_TRUE(world.collisions().empty());
    EXPECT_EQ(stepStats(world).bodies + stepStats(world).joints + stepStats(world).contacts, 0u);
}

} // namespace
} // namespace kodo
