// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <worlds/invariance.hpp>

#include <map>

namespace worlds {
namespace {

// Of 200 worlds, half of them with a body that moves by itself. The rates over more are in
// engine/docs/worlds.md.
TEST(Invariances, HoldInBitsAndElsewhereUpToTheRatesThatAreReachedToday) {
    std::map<std::string, int> found;
    std::string list;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        for (const Finding& finding : judgeInvariances(invarianceRecipe(seed))) {
            ++found[finding.judge];
            list += "\nseed " + std::to_string(seed) + ", " + finding.judge + ", step " +
                    std::to_string(finding.step) + ": " + finding.text;
        }
    }
    // 14 of 10,000: the bias of an angle is bounded by a speed, see JointSet::boundBias().
    EXPECT_LE(found["length"], 1) << list;
    EXPECT_EQ(found["mass"], 0) << list;
    EXPECT_EQ(found["at rest"], 0) << list;
    EXPECT_LE(found["mirror"], 2) << list;
    EXPECT_LE(found["order"], 5) << list;
    EXPECT_LE(found["boost"], 60) << list;
    EXPECT_LE(found["heavy"], 54) << list;
}

/// A box that turns, and hits a floor on a corner.
Recipe falling() {
    Recipe recipe;
    recipe.world.gravity = {0, -10};
    recipe.steps = 30;
    recipe.bodies = {
        {.shape = kodo::Box{20, 1}, .type = kodo::BodyType::Static},
        {.shape = kodo::Polygon{{{0, 0}, {1, 0}, {0, 1}}}, .position = {1, 2}},
    };
    recipe.bodies[1].velocity = {1, -2};
    recipe.bodies[1].angularVelocity = 3;
    return recipe;
}

TEST(Invariances, HoldForABoxThatFalls) {
    for (const Invariance invariance : kInvariances) {
        const std::optional<Finding> finding = judgeInvariance(falling(), invariance);
        EXPECT_FALSE(finding) << finding->judge << ", step " << finding->step << ": "
                              << finding->text;
    }
}

// Each change reaches each number of a body: without that, the outcome differs.
TEST(Invariances, AreNotHeldByAWorldThatIsChangedOtherwise) {
    using Spoil = void (*)(Recipe&);
    const Spoil spoils[] = {
        [](Recipe& recipe) { recipe.bodies[0].position.y += kodo::Real(0.5); },
        [](Recipe& recipe) { recipe.world.gravity.y *= kodo::Real(1.2); },
        [](Recipe& recipe) {
            for (kodo::BodyDef& def : recipe.bodies) {
                def.velocity.y += def.type == kodo::BodyType::Dynamic ? 1 : 0;
            }
        },
        [](Recipe& recipe) {
            for (kodo::BodyDef& def : recipe.bodies) {
                def.angularVelocity = -def.angularVelocity;
            }
        },
    };
    for (const Invariance invariance : kInvariances) {
        for (const Spoil spoil : spoils) {
            std::optional<Changed> other = changed(falling(), invariance);
            if (other) { // "heavy" needs a kinematic body
                spoil(other->recipe);
                EXPECT_TRUE(compare(falling(), *other)) << nameOf(invariance);
            }
        }
    }
}

TEST(Invariances, NameWhatDiffersFirst) {
    std::optional<Changed> other = changed(falling(), Invariance::Mass);
    ASSERT_TRUE(other);
    other->recipe.bodies[1].angularVelocity = 4;
    const std::optional<Finding> finding = compare(falling(), *other);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->judge, "mass");
    EXPECT_EQ(finding->step, 0);
    EXPECT_EQ(finding->text, "spin of body 1 differs by 1");
}

TEST(Invariances, AreNotJudgedWhereTheyCannotHold) {
    Recipe recipe = falling();
    EXPECT_FALSE(changed(recipe, Invariance::Heavy)); // nothing is kinematic
    recipe.joints = {kodo::MouseJoint{.body = {1, 1, 0}, .force = 1}};
    EXPECT_FALSE(changed(recipe, Invariance::Boost)); // its target stands still
    recipe.bodies[1].shape = kodo::Compound{{kodo::Circle{1}, kodo::Segment{{0, 0}, {2, 0}}}};
    EXPECT_FALSE(changed(recipe, Invariance::Length)); // area and length
    recipe.bodies.erase(recipe.bodies.begin());
    EXPECT_FALSE(changed(recipe, Invariance::AtRest)); // nothing is static
}

} // namespace
} // namespace worlds
