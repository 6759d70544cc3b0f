// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/stage/play/show_file.hpp>
#include <apart/stage/records/replay_store.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <filesystem>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

class ShowFile : public support::FolderTest {};

// Regression: the message had the names of all levels, and a path that never existed.
TEST_F(ShowFile, AMissingLevelIsNamedInOneLineWithThePlaceOfOwnLevels) {
    Replay replay = recordedGame(glassLevel("One block", {7}), 3);
    replay.level = "my_tower";
    EXPECT_EQ(keepReplay(folder_, {replay}, ""), "");
    const fs::path file = folder_ / "last.replay";
    EXPECT_EQ(std::get<std::string>(showOf(file, "a/levels")),
              "The level my_tower is not among the levels. Levels of your own belong in a/levels.");
    EXPECT_EQ(std::get<std::string>(showOf(file, {})),
              "The level my_tower is not among the levels.");
    fs::create_directories(folder_ / "levels");
    ASSERT_FALSE(writeTextFile(folder_ / "levels" / "my_tower.toml", "format = 1\nwidth = 0\n"));
    EXPECT_NE(std::get<std::string>(showOf(file, {})).find("my_tower.toml:"), std::string::npos)
        << "a file with errors";
}

TEST_F(ShowFile, AReplayOfALevelOfTheGameIsPlayed) {
    const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel("first_light")));
    const Replay replay = recordedGame(level, 3, 300);
    EXPECT_EQ(keepReplay(folder_, {replay}, ""), "");
    StageDef def = StageRig::twoLevels();
    def.show = std::get<Show>(showOf(folder_ / "last.replay", {}));
    EXPECT_EQ(def.show->end, 300u);
    StageRig rig(std::move(def));
    rig.untilOver();
    EXPECT_EQ(rig.stage.session().game().stateHash(), replay.hashes.back().hash);
}

// Regression: it was "not among the levels", although --level played it.
TEST_F(ShowFile, AReplayOfALevelOfThePlayerIsPlayedWhereverItIs) {
    const fs::path own = folder_ / "own" / "levels";
    fs::create_directories(own);
    ASSERT_FALSE(writeTextFile(own / "alpha.toml",
                               "format = 1\ntitle = \"Mine\"\nidea = \"One block.\"\n"
                               "grid = '''\n.......b.......\n'''\n"
                               "[legend.b]\nstuff = \"glass\"\n"));
    const auto level =
        std::make_shared<const Level>(std::get<Level>(readLevelFile(own / "alpha.toml")));
    const Replay replay = recordedGame(level, 3, 60);
    ASSERT_FALSE(writeTextFile(folder_ / "a.replay", toText(replay)));
    const std::variant<Show, std::string> show = showOf(folder_ / "a.replay", own);
    ASSERT_TRUE(std::holds_alternative<Show>(show)) << std::get<std::string>(show);
    EXPECT_EQ(std::get<Show>(show).level->title, "Mine");
    EXPECT_TRUE(std::holds_alternative<std::string>(showOf(folder_ / "a.replay", {})));
}

TEST_F(ShowFile, ADailyRunHasItsDay) {
    constexpr Day kDay = 20261126;
    const auto level = std::make_shared<const Level>(endlessLevel({kDay, 1}));
    for (const std::uint32_t seed : {dailySeed(kDay, 1), dailySeed(kDay, 1) + 1}) {
        EXPECT_EQ(keepReplay(folder_, {recordedGame(level, seed, 10)}, ""), "");
        const auto show = showOf(folder_ / "last.replay", {});
        EXPECT_EQ(std::get<Show>(show).day, seed == dailySeed(kDay, 1) ? kDay : 0);
    }
}

} // namespace
} // namespace apart
