// SPDX-License-Identifier: MIT
#include <determinism/player.hpp>
#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace determinism {
namespace {

/// The lines of golden.txt for this recipe and precision: hash as text by tick.
std::map<int, std::string> goldenOf(const Recipe& recipe) {
    std::map<int, std::string> golden;
    std::ifstream file(KODO_GOLDEN_FILE);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string scene;
        std::string precision;
        int tick = 0;
        std::string hash;
        words >> scene >> precision >> tick >> hash;
        if (scene == recipe.name && precision == kPrecision) {
            golden[tick] = hash;
        }
    }
    return golden;
}

std::string asText(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, hash);
    return text;
}

std::string nameOf(const testing::TestParamInfo<Recipe>& info) {
    return info.param.name;
}

class Golden : public testing::TestWithParam<Recipe> {};

// The same bits with every compiler, optimisation and machine. tools/determinism_engine compares
// many builds with golden.txt.
TEST_P(Golden, EveryBuildGivesTheSameBits) {
    const Recipe& recipe = GetParam();
    const std::map<int, std::string> golden = goldenOf(recipe);
    const std::vector<std::uint64_t> hashes = hashesOf(recipe);
    std::string fresh;
    int differs = 0;
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        const int tick = static_cast<int>(i + 1) * kHashEvery;
        const std::string hash = asText(hashes[i]);
        fresh += std::string(recipe.name) + " " + kPrecision + " " + std::to_string(tick) + " " +
                 hash + "\n";
        const auto found = golden.find(tick);
        if (differs == 0 && (found == golden.end() || found->second != hash)) {
            differs = tick;
        }
    }
    EXPECT_EQ(golden.size(), hashes.size());
    EXPECT_EQ(differs, 0)
        << "The first tick whose hash differs from that in\n"
        << KODO_GOLDEN_FILE << " is " << differs
        << ".\nAfter an intended change of the engine, write the file again with\n"
        << "    tools/determinism_engine --golden\nor paste these lines:\n"
        << fresh;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(recipes().begin(), recipes().end()),
                         nameOf);

} // namespace
} // namespace determinism
