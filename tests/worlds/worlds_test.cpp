// SPDX-License-Identifier: MIT
#include <support/draws.hpp>

#include "base/assert.hpp"

#include <gtest/gtest.h>
#include <worlds/recipe.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <variant>

namespace worlds {
namespace {

/// A failed assertion of the engine is a finding like any other.
class RandomWorlds : public testing::Test {
protected:
    void SetUp() override {
        previous_ = kodo::setAssertHandler([](const char* condition, const char* file, int line) {
            throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": " +
                                   condition);
        });
    }
    void TearDown() override { kodo::setAssertHandler(previous_); }

private:
    kodo::AssertHandler previous_ = nullptr;
};

/// A known limit of the engine: worlds of a kind in which a judge objects, per 500 worlds. The
/// rates are those of engine/docs/worlds.md, and twice as many are allowed, at least 2.
struct KnownLimit {
    const char* judge;
    const char* kind; // a word of kindOf()
    int most;
};
constexpr KnownLimit kKnownLimits[] = {
    {"energy", "joints", 30},  // joints on particles, and with anchors metres outside
    {"energy", "plain", 2},    // a heavy body that presses a light one into ground
    {"through", "plain", 2},   // a body that an impact turns by about a radian in a step
    {"energy", "thin", 2},     // records of the thesis's solver lack fast impacts
    {"momentum", "joints", 4}, // the same joints
    {"numbers", "joints", 4},  // the same joints
    {"through", "thin", 18},   // particles and segments on ground without thickness
    {"through", "thesis", 2},  // boxes at 50 m/s through walls of 0.2 m
    {"sleep", "thesis", 2},    // piles that creep
};

// Half of the seeds in float, the other half in double: 1,000 in all. tools/worlds judges more.
TEST_F(RandomWorlds, SatisfyEveryJudgeExceptAtKnownLimits) {
    const std::uint64_t first = sizeof(kodo::Real) == 4 ? 1 : 501;
    const auto count = static_cast<std::uint64_t>(support::draws(500));
    std::array<int, std::size(kKnownLimits)> found{};
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const Recipe recipe = randomRecipe(seed);
        const std::optional<Finding> finding = judge(recipe);
        if (!finding) {
            continue;
        }
        const auto covers = [&](const KnownLimit& limit) {
            return finding->judge == limit.judge &&
                   kindOf(recipe).find(limit.kind) != std::string::npos;
        };
        const auto* const limit =
            std::find_if(std::begin(kKnownLimits), std::end(kKnownLimits), covers);
        EXPECT_NE(limit, std::end(kKnownLimits))
            << "seed " << seed << " (" << kindOf(recipe) << "): " << finding->judge << ", step "
            << finding->step << ": " << finding->text
            << "\nsmallest: tools/worlds --count 1 --shrink --seed " << seed;
        if (limit != std::end(kKnownLimits)) {
            ++found[static_cast<std::size_t>(limit - std::begin(kKnownLimits))];
        }
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LE(found[i], kKnownLimits[i].most)
            << kKnownLimits[i].judge << " in worlds with " << kKnownLimits[i].kind;
    }
}

// A new kind of joint or shape must not be left out of them.
TEST_F(RandomWorlds, HaveEveryKindOfJointAndShape) {
    std::set<std::size_t> joints;
    std::set<std::size_t> shapes;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        const Recipe recipe = randomRecipe(seed);
        for (const kodo::JointDef& joint : recipe.joints) {
            joints.insert(joint.index());
        }
        for (const kodo::BodyDef& body : recipe.bodies) {
            shapes.insert(body.shape.index());
        }
    }
    EXPECT_EQ(joints.size(), std::variant_size_v<kodo::JointDef>);
    EXPECT_EQ(shapes.size(), std::variant_size_v<kodo::Shape>);
}

TEST_F(RandomWorlds, AreRestoredFromTheirText) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const std::string text = toText(randomRecipe(seed));
        const std::optional<Recipe> read = fromText(text);
        ASSERT_TRUE(read) << seed;
        EXPECT_EQ(toText(*read), text) << seed;
    }
    EXPECT_FALSE(fromText(""));
    EXPECT_FALSE(fromText("world 1 gravity x"));
}

/// The worlds of a folder that are meant for this precision, in the order of their names.
std::vector<std::filesystem::path> worldsIn(const char* folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        const char* const other = sizeof(kodo::Real) == 4 ? "_double" : "_float";
        if (entry.path().extension() == ".world" && name.find(other) == std::string::npos) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::optional<Recipe> recipeIn(const std::filesystem::path& path) {
    std::ifstream file(path);
    return fromText({std::istreambuf_iterator<char>(file), {}});
}

// Worlds in which a judge once objected, as tools/worlds --shrink saved them for a precision.
TEST_F(RandomWorlds, SavedOnesSatisfyEveryJudge) {
    for (const std::filesystem::path& path : worldsIn(KODO_SAVED_WORLDS)) {
        const std::optional<Recipe> recipe = recipeIn(path);
        ASSERT_TRUE(recipe) << path;
        const std::optional<Finding> finding = judge(*recipe);
        EXPECT_FALSE(finding) << path << ": " << finding->judge << ", step " << finding->step
                              << ": " << finding->text;
    }
}

// The smallest worlds of the known limits in engine/docs/worlds.md. One that satisfies all judges
// by now is named: it belongs to the saved ones then.
TEST_F(RandomWorlds, KnownLimitsAreReplayed) {
    for (const std::filesystem::path& path : worldsIn(KODO_KNOWN_WORLDS)) {
        const std::optional<Recipe> recipe = recipeIn(path);
        ASSERT_TRUE(recipe) << path;
        if (!judge(*recipe)) {
            std::printf("%s satisfies all judges now\n", path.c_str());
        }
    }
}

} // namespace
} // namespace worlds
