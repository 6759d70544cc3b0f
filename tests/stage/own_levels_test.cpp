// SPDX-License-Identifier: MIT
#include <apart/stage/own_levels.hpp>
#include <apart/stage/records/replay_store.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "stage_rig.hpp"

namespace apart {
namespace {

namespace fs = std::filesystem;

class OwnLevels : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        fs::create_directories(folder_);
    }

    fs::path write(const std::string& name) const {
        std::ofstream(folder_ / name) << "format = 1\ntitle = \"Mine\"\nidea = \"One block.\"\n"
                                         "grid = '''\n...............\n.......b.......\n'''\n"
                                         "[legend.b]\nstuff = \"glass\"\n";
        return folder_ / name;
    }
    /// The stage after --level FILE, with the best game of the first level and lists of what is
    /// kept.
    StageDef withFile(const fs::path& file) {
        StageDef def = StageRig::twoLevels();
        def.profile.enter(Mode::Standard, name_, {25, false, false, false});
        EXPECT_EQ(takeLevelFile(def, file, folders_), "");
        def.keeping.save = StageRig::keeping(saved_);
        def.keeping.keepReplay = [this](const ReplayRun&, const std::string& best) {
            replays_.push_back(best);
            return std::string();
        };
        return def;
    }

    const std::string name_ = "test_1"; // of the first level of the stage
    std::vector<fs::path> folders_;
    std::vector<Profile> saved_;
    std::vector<std::string> replays_;
};

TEST_F(OwnLevels, AFileWithTheNameOfAnotherLevelIsPlayedWithoutRecords) {
    StageRig rig(withFile(write(name_ + ".toml")));
    ASSERT_EQ(rig.stage.records().notices().size(), 1u);
    EXPECT_NE(rig.stage.records().notices()[0].find(
                  "test_1 is the name of another level. It is played without scores"),
              std::string::npos);
    EXPECT_EQ(rig.stage.session().game().level().title, "Mine");
    playToTheEnd(rig);
    ASSERT_GT(rig.stage.session().game().score(), 25);
    EXPECT_TRUE(rig.picture().says("test_1.toml is played without scores, honours and replays."));
    rig.clickItem(Action::Levels);
    EXPECT_TRUE(replays_.empty());
    const Profile& profile = rig.stage.records().profile();
    EXPECT_EQ(profile.bestOf(Mode::Standard, name_), (Best{25, false, false, false}));
    EXPECT_EQ(profile.best[0].size(), 1u);
    EXPECT_EQ(profile.totals, TotalsByTheme{});
}

TEST_F(OwnLevels, AFileThatIsTheListedLevelIsRecorded) {
    folders_ = {folder_};
    const StageDef def = withFile(write(name_ + ".toml"));
    EXPECT_TRUE(def.notices.empty());
    EXPECT_EQ(def.levels.size(), 2u);
    EXPECT_EQ(def.levels[def.firstLevel]->name, name_);
    EXPECT_TRUE(isRecorded(*def.levels[def.firstLevel]));
}

TEST_F(OwnLevels, AChangedFileStaysWithoutRecords) {
    const fs::path file = write(name_ + ".toml");
    const StageDef def = withFile(file);
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
    const std::optional<LevelChange> change = def.reload();
    ASSERT_TRUE(change && change->level);
    EXPECT_EQ(change->level->name, name_ + ".toml");
    EXPECT_FALSE(isRecorded(*change->level));
}

// A replay cannot hold these names, or they are keys of other scores.
TEST_F(OwnLevels, AFileWhoseNameNoReplayCanHoldIsPlayedWithoutRecords) {
    for (const char* name : {"my tower", "größe", "endless", "endless:7:3", "daily-2026-11-26"}) {
        StageDef def = withFile(write(std::string(name) + ".toml"));
        ASSERT_EQ(def.notices.size(), 1u) << name;
        EXPECT_NE(def.notices[0].find(": " + std::string(name) + " is "), std::string::npos);
        EXPECT_FALSE(isRecorded(*def.levels[def.firstLevel])) << name;
        EXPECT_TRUE(def.startAtOnce);
    }
    EXPECT_TRUE(withFile(write("my_tower-2.toml")).notices.empty());
}

TEST_F(OwnLevels, TheFolderOmitsFilesWhoseNameNoReplayCanHold) {
    for (const char* name : {"my tower", "größe", "endless", "daily-2026-11-26", "my_tower-2"}) {
        write(std::string(name) + ".toml");
    }
    StageDef def = StageRig::twoLevels();
    addOwnLevels(def, folder_);
    ASSERT_EQ(def.levels.size(), 3u);
    EXPECT_EQ(def.levels[2]->name, "my_tower-2");
    EXPECT_EQ(def.leftOut.size(), 4u);
}

// Regression: the last two were shown, without the number of the others.
TEST_F(OwnLevels, TheTitleShowsTheFirstErrorAndTheNumberOfTheOtherLevels) {
    for (const char* name : {"a", "b", "c", "d"}) {
        std::ofstream(folder_ / (std::string(name) + ".toml")) << "format = 1\nwidth = 0\n";
    }
    StageDef def = StageRig::twoLevels();
    addOwnLevels(def, folder_);
    def.notices = {"Another notice."};
    StageRig rig(std::move(def));
    const std::vector<std::string>& notices = rig.stage.records().notices();
    ASSERT_EQ(notices.size(), 2u);
    EXPECT_NE(notices[0].find("a.toml:"), std::string::npos) << notices[0];
    EXPECT_TRUE(notices[0].ends_with("The level is left out, and 3 more.")) << notices[0];
    EXPECT_TRUE(rig.picture().says("and 3 more."));
    EXPECT_TRUE(rig.picture().says("Another notice."));

    fs::remove(folder_ / "b.toml");
    fs::remove(folder_ / "c.toml");
    fs::remove(folder_ / "d.toml");
    StageDef one = StageRig::twoLevels();
    addOwnLevels(one, folder_);
    EXPECT_TRUE(StageRig(std::move(one)).picture().says("left out."));
}

} // namespace
} // namespace apart
