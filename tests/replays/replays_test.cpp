// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/replay.hpp>
#include <apart/core/tuning.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace apart;

std::vector<std::filesystem::path> replayFiles() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(APART_REPLAYS)) {
        if (entry.path().extension() == ".replay") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

class ScriptedReplay : public testing::TestWithParam<std::filesystem::path> {};

// A3: the game runs headless from a script.
TEST_P(ScriptedReplay, MeetsItsExpectations) {
    const Read<Replay> read = readReplayFile(GetParam());
    ASSERT_TRUE(std::holds_alternative<Replay>(read)) << std::get<FileProblem>(read).text();
    const Replay& replay = std::get<Replay>(read);
    EXPECT_FALSE(replay.expectations.empty());
    EXPECT_FALSE(replay.hashes.empty()) << "made by: apart-headless hash FILE...";
    const Read<Level> level = loadLevelOf(GetParam(), replay.level);
    ASSERT_TRUE(std::holds_alternative<Level>(level)) << std::get<FileProblem>(level).text();
    ASSERT_EQ(refusal(replay, std::get<Level>(level)), std::nullopt);

    Playback playback(replay, std::make_shared<const Level>(std::get<Level>(level)));
    while (!playback.done()) {
        playback.tick();
    }

    for (const Playback::Failure& failure : playback.failures()) {
        ADD_FAILURE() << GetParam().string() << ":" << failure.expectation.line << ": "
                      << failure.text();
    }
    EXPECT_FALSE(playback.divergence())
        << "the hashes change with the game; made by: apart-headless hash FILE...";
}

/// Most blocks of one collapse, with all targets of the paddle moved by `shift`
/// (1/1000 m).
std::int32_t largestFall(Replay replay, std::shared_ptr<const Level> level, std::int16_t shift) {
    for (InputChange& change : replay.inputs) {
        if (change.input.target) {
            change.input.target = static_cast<std::int16_t>(*change.input.target + shift);
        }
    }
    replay.end += 3 * kTicksPerSecond; // a hit beside it may take longer
    Playback playback(std::move(replay), std::move(level));
    while (!playback.done()) {
        playback.tick();
    }
    return playback.game().collapse().largest;
}

class Building : public testing::TestWithParam<std::filesystem::path> {};

/// The paddle half a ball further left or right: near hits bring near falls.
TEST_P(Building, FallsAlikeUnderAHitBesideTheIntendedOne) {
    const Replay replay = std::get<Replay>(readReplayFile(GetParam()));
    const auto level =
        std::make_shared<const Level>(std::get<Level>(loadLevelOf(GetParam(), replay.level)));
    const std::int32_t fall = largestFall(replay, level, 0);
    EXPECT_GE(fall, 6);
    for (const std::int16_t shift : {std::int16_t{-300}, std::int16_t{300}}) {
        EXPECT_GE(2 * largestFall(replay, level, shift), fall) << shift;
    }
}

std::vector<std::filesystem::path> buildings() {
    std::vector<std::filesystem::path> files = replayFiles();
    std::erase_if(files, [](const std::filesystem::path& file) {
        return !file.stem().string().starts_with("building_");
    });
    return files;
}

INSTANTIATE_TEST_SUITE_P(All, Building, testing::ValuesIn(buildings()),
                         [](const auto& file) { return file.param.stem().string(); });

INSTANTIATE_TEST_SUITE_P(All, ScriptedReplay, testing::ValuesIn(replayFiles()),
                         [](const auto& file) { return file.param.stem().string(); });

} // namespace
