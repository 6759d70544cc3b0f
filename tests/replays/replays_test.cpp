// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/replay.hpp>

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

TEST_P(ScriptedReplay, MeetsItsExpectations) {
    const Read<Replay> read = readReplayFile(GetParam());
    ASSERT_TRUE(std::holds_alternative<Replay>(read)) << std::get<FileProblem>(read).text();
    const Replay& replay = std::get<Replay>(read);
    EXPECT_FALSE(replay.expectations.empty());
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
    EXPECT_FALSE(playback.divergence());
}

INSTANTIATE_TEST_SUITE_P(All, ScriptedReplay, testing::ValuesIn(replayFiles()),
                         [](const auto& file) { return file.param.stem().string(); });

} // namespace
