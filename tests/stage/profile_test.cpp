// SPDX-License-Identifier: MIT
#include <apart/stage/records/profile_file.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace apart {
namespace {

namespace fs = std::filesystem;

class ProfileFile : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        file_ = folder_ / "apart" / "profile.toml";
    }

    void write(const std::string& text) const {
        fs::create_directories(file_.parent_path());
        std::ofstream(file_) << text;
    }
    static std::string read(const fs::path& file) {
        std::ifstream stream(file);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    fs::path file_;
};

Profile someProfile() {
    Profile profile;
    profile.settings.shake = 0;
    profile.settings.mouse = 250;
    profile.mode = Mode::Pure;
    profile.enter(Mode::Standard, "first_light", {12300, true, false, true});
    profile.enter(Mode::Pure, "lift_off", {70, false, false, false, 0, true, true});
    profile.enter(Mode::Assisted, "lift_off", {60, true, false, false});
    profile.totals[2] = {3, 1, 500, 40, 12, 8, 5};
    return profile;
}

TEST_F(ProfileFile, ASavedProfileIsLoadedAgain) {
    ASSERT_FALSE(saveProfile(file_, someProfile())); // creates the folder
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_EQ(loaded.profile, someProfile());
    EXPECT_EQ(loaded.notice, "");
}

// The file may be written by another game or by hand while the game runs.
TEST_F(ProfileFile, SavingReplacesNeitherANewerFileNorADamagedOne) {
    ASSERT_FALSE(saveProfile(file_, someProfile()));
    const auto write = [&](const std::string& text) { std::ofstream(file_) << text; };
    const auto read = [&](const std::filesystem::path& file) {
        std::ifstream in(file);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    const std::string newer = "format = 3\n[best.quarry]\nscore = 7777\n";
    write(newer);
    ASSERT_TRUE(saveProfile(file_, someProfile()));
    EXPECT_EQ(read(file_), newer);
    const std::string damaged = "format = 1\nchain = ture\n";
    write(damaged);
    ASSERT_FALSE(saveProfile(file_, someProfile()));
    EXPECT_EQ(read(file_.string() + ".broken"), damaged);
    EXPECT_EQ(loadProfile(file_).profile, someProfile());
}

TEST_F(ProfileFile, WithoutAFileDefaultsApply) {
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_EQ(loaded.profile, Profile{});
    EXPECT_EQ(loaded.notice, "");
}

TEST_F(ProfileFile, EveryDialIsKept) {
    for (const Dial& dial : kDials) {
        Profile profile;
        profile.settings.*dial.value = std::min(dial.least + 10, dial.most);
        const auto read = profileFrom(toText(profile), "x");
        ASSERT_TRUE(std::holds_alternative<Profile>(read)) << dial.key;
        EXPECT_EQ(std::get<Profile>(read), profile) << dial.key;
    }
}

TEST_F(ProfileFile, ABrokenFileIsRenamedAndReported) {
    const std::string broken = "format = 2\n[settings]\nshake = \"much\"\n";
    write(broken);
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_EQ(loaded.profile, Profile{});
    EXPECT_NE(loaded.notice.find("profile.toml:3"), std::string::npos) << loaded.notice;
    EXPECT_NE(loaded.notice.find("profile.toml.broken"), std::string::npos) << loaded.notice;
    EXPECT_TRUE(loadProfile(file_).whole) << "a good one takes its place";
    EXPECT_EQ(read(file_.string() + ".broken"), broken);
}

// The usual text of a profile with one item wrong: all others stay, and the fault is named.
TEST_F(ProfileFile, ABadValueIsReplacedByItsDefaultAlone) {
    Profile profile = someProfile();
    EXPECT_EQ(profile.bindings.bind(Act::Mute, 0, *keyNamed("X")), "");
    struct Case {
        const char* good;
        const char* bad;
        const char* fault;
        void (*expect)(Profile&); // the change to the profile
    };
    const Case cases[] = {
        {"mouse = 250", "mouse = 400", "mouse must be a whole number from 20 to 300, and is 100",
         [](Profile& p) { p.settings.mouse = 100; }},
        {"mouse = 250", "mouse = fast", "", [](Profile& p) { p.settings.mouse = 100; }},
        {"pure = true", "pure = 1", "pure must be true or false, and is false now",
         [](Profile& p) { p.mode = Mode::Standard; }},
        {"score = 12300", "score = -1", "score must be a whole number",
         [](Profile& p) { p.best[0]["first_light"].score = kUnreadScore; }},
        {"score = 12300\ncleared = true", "score = 12300\ncleared = yes", "",
         [](Profile& p) { p.best[0]["first_light"].cleared = false; }},
        {"[best.first_light]", "[best.first_light", "", [](Profile& p) { p.best[0].clear(); }},
        {"games = 3\n", "", "games must be a whole number",
         [](Profile& p) { p.totals[2].games = 0; }},
        {"serve = [\"space\", \"-\", 1]", "serve = [\"space\", \"-\", 1", "", [](Profile&) {}},
        {"serve = [\"space\", \"-\", 1]", "serve = [\"X\", \"-\", 1]",
         "keys of serve: X is in use: mute, and they are the usual ones now", [](Profile&) {}},
        {"format = 2", "format = 2\nnew = 3", "unknown key new", [](Profile&) {}},
        {"format = 2\n", "", "format must be", [](Profile& p) { p.mapped = false; }},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.bad);
        std::string text = toText(profile);
        const std::size_t place = text.find(each.good);
        ASSERT_NE(place, std::string::npos) << text;
        write(text.replace(place, std::string(each.good).size(), each.bad));
        Profile expected = profile;
        each.expect(expected);
        const LoadedProfile loaded = loadProfile(file_);
        EXPECT_EQ(toText(loaded.profile), toText(expected));
        EXPECT_NE(loaded.notice.find("profile.toml:"), std::string::npos) << loaded.notice;
        EXPECT_NE(loaded.notice.find(each.fault), std::string::npos) << loaded.notice;
        EXPECT_NE(loaded.notice.find("kept as profile.toml.broken"), std::string::npos);
        EXPECT_EQ(read(file_.string() + ".broken"), text);
        EXPECT_EQ(loadProfile(file_).profile, expected) << "at the next start";
        fs::remove(file_.string() + ".broken");
    }
}

TEST_F(ProfileFile, TheFirstFaultsAreNamedAndTheOthersCounted) {
    write("format = 2\n[settings]\nsound = 101\nmusic = loud\nmouse = 1\nshake = -1\nspin = 2\n"
          "zoom = 30\n");
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_EQ(loaded.profile.settings.zoom, 30);
    EXPECT_NE(loaded.notice.find("profile.toml:3: sound"), std::string::npos) << loaded.notice;
    EXPECT_NE(loaded.notice.find("line 4: "), std::string::npos) << loaded.notice;
    EXPECT_NE(loaded.notice.find("line 5: mouse"), std::string::npos) << loaded.notice;
    EXPECT_NE(loaded.notice.find("and 2 more"), std::string::npos) << loaded.notice;
}

// The scores of a file that another game has damaged meanwhile are merged as well.
TEST_F(ProfileFile, SavingKeepsWhatIsRightInADamagedFile) {
    Profile other;
    other.enter(Mode::Standard, "b", {70, false, false, true});
    write(toText(other) + "\nnonsense\n");
    Profile profile = someProfile();
    ASSERT_FALSE(saveProfile(file_, profile, profile));
    profile.enter(Mode::Standard, "b", {70, false, false, true});
    EXPECT_EQ(loadProfile(file_).profile, profile);
    EXPECT_TRUE(fs::exists(file_.string() + ".broken"));
}

TEST_F(ProfileFile, OfAFileWithNothingRightDefaultsApplyAndTheFileIsKept) {
    for (const char* text :
         {"", "format = 0\n", "format = 2\nnew = 3\n", "format = 2\n[settings]\nspin = 3\n",
          "format = 2\n[settings]\nsound = 101\n", "format = 2\n[settings]\nsound = -1\n",
          "format = 2\n[settings]\nmouse = 19\n", "format = 2\n[settings]\npure = 1\n",
          "format = 2\nsettings = 3\n", "format = 2\nbest = 3\n", "format = 2\n[best]\na = 3\n",
          "format = 2\nstatistics = 1\n", "format = 2\n[statistics.nowhere]\n", "[[[",
          "format = 2\nformat = 2\n"}) {
        SCOPED_TRACE(text);
        write(text);
        const LoadedProfile loaded = loadProfile(file_);
        Profile expected;
        expected.mapped = loaded.profile.mapped; // false without a valid format
        EXPECT_EQ(loaded.profile, expected);
        EXPECT_NE(loaded.notice, "");
        EXPECT_FALSE(loaded.keepFile);
        EXPECT_EQ(read(file_.string() + ".broken"), text);
        fs::remove(file_.string() + ".broken");
    }
}

// D4: what is kept from an earlier fault is not lost by the next one.
TEST_F(ProfileFile, AnEarlierBrokenFileIsNotOverwritten) {
    for (const char* text : {"one", "two", "three"}) {
        write(text);
        EXPECT_NE(loadProfile(file_).notice, "");
    }
    EXPECT_EQ(read(file_.string() + ".broken"), "one");
    EXPECT_EQ(read(file_.string() + ".broken-2"), "two");
    EXPECT_EQ(read(file_.string() + ".broken-3"), "three");
}

// D4: a newer format is neither damage nor replaced.
TEST_F(ProfileFile, OneOfANewerGameStays) {
    const std::string newer = "format = 3\nfuture = 1\n";
    write(newer);
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_EQ(loaded.profile, Profile{});
    EXPECT_NE(loaded.notice.find("newer game"), std::string::npos) << loaded.notice;
    EXPECT_TRUE(loaded.keepFile);
    EXPECT_EQ(read(file_), newer);
}

// D4, D6: what cannot be read is not damaged, and nothing is renamed.
TEST_F(ProfileFile, OneThatCannotBeReadStays) {
    fs::create_directories(file_ / "inside");
    const LoadedProfile loaded = loadProfile(file_);
    EXPECT_TRUE(loaded.keepFile);
    EXPECT_NE(loaded.notice, "");
    EXPECT_TRUE(fs::is_directory(file_));
}

// D4: of two games that run at once, neither loses the scores of the other.
TEST_F(ProfileFile, SavingKeepsTheBetterScores) {
    Profile one;
    one.enter(Mode::Standard, "a", {100, true, false, false});
    one.enter(Mode::Standard, "b", {50, false, false, false});
    Profile other;
    other.enter(Mode::Standard, "b", {70, false, false, true});
    ASSERT_FALSE(saveProfile(file_, one));
    ASSERT_FALSE(saveProfile(file_, other));
    const Profile both = loadProfile(file_).profile;
    EXPECT_EQ(both.bestOf(Mode::Standard, "a"), (Best{100, true, false, false}));
    EXPECT_EQ(both.bestOf(Mode::Standard, "b"), (Best{70, false, false, true}));
}

// Of two games that run at once, neither loses the counts of the other.
TEST_F(ProfileFile, SavingAddsWhatWasCountedSinceTheLastSave) {
    Profile start;
    start.totals[2] = {10, 4, 500, 40, 12, 8, 5};
    ASSERT_FALSE(saveProfile(file_, start));
    const auto saveOne = profileSaver(file_, start);
    const auto saveOther = profileSaver(file_, start);
    Profile one = start;
    Profile other = start;
    add(one.totals[2], {1, 1, 60, 7, 0, 9, 2});
    EXPECT_EQ(saveOne(one), "");
    EXPECT_EQ(saveOne(one), "") << "nothing is counted twice";
    add(other.totals[2], {2, 0, 90, 5, 1, 3, 6});
    EXPECT_EQ(saveOther(other), "");
    EXPECT_EQ(loadProfile(file_).profile.totals[2], (PlayTotals{13, 5, 650, 52, 13, 9, 6}));
}

// Of two games that run at once, neither loses the settings of the other.
TEST_F(ProfileFile, SavingReplacesTheSettingsThatThisGameHasChanged) {
    const Profile start;
    ASSERT_FALSE(saveProfile(file_, start));
    const auto saveOne = profileSaver(file_, start);
    const auto saveOther = profileSaver(file_, start);
    Profile one = start;
    Profile other = start;
    other.settings.sound = 100;
    other.muted = true;
    other.bindings.bind(Act::Pull, 1, kNoKey);
    EXPECT_EQ(saveOther(other), "");
    one.settings.music = 10;
    one.mode = Mode::Pure;
    EXPECT_EQ(saveOne(one), "");
    Profile both = other;
    both.settings.music = 10;
    both.mode = Mode::Pure;
    EXPECT_EQ(loadProfile(file_).profile, both);
    other.settings.music = 30; // the latest change counts
    EXPECT_EQ(saveOther(other), "");
    EXPECT_EQ(saveOne(one), "");
    EXPECT_EQ(loadProfile(file_).profile.settings.music, 30);
}

// D12: a score that its replay did not give does not come back from the file.
TEST_F(ProfileFile, SavingDoesNotBringBackACorrectedScore) {
    Profile claimed;
    claimed.enter(Mode::Standard, "a", {99999999, false, false, false});
    ASSERT_FALSE(saveProfile(file_, claimed));
    Profile profile = loadProfile(file_).profile;
    profile.correct(Mode::Standard, "a", 0);
    profile.enter(Mode::Standard, "a", {120, true, false, false});
    ASSERT_FALSE(saveProfile(file_, profile));
    EXPECT_EQ(loadProfile(file_).profile.bestOf(Mode::Standard, "a"),
              (Best{120, true, false, false, 99999999}));
}

TEST_F(ProfileFile, KeepsEachMode) {
    for (const Mode mode : {Mode::Standard, Mode::Pure, Mode::Assisted}) {
        Profile profile;
        profile.mode = mode;
        const auto read = profileFrom(toText(profile), "x");
        ASSERT_TRUE(std::holds_alternative<Profile>(read));
        EXPECT_EQ(std::get<Profile>(read).mode, mode);
    }
}

// D7: level names that are no bare keys of TOML.
TEST_F(ProfileFile, KeepsScoresOfAnyLevelName) {
    for (const char* name : {"a b", "a.b", "\"", "\\", "x\ty", "\x7f", "", "grün", "]"}) {
        Profile profile;
        profile.enter(Mode::Standard, name, {100, true, false, false});
        const auto read = profileFrom(toText(profile), "x");
        ASSERT_TRUE(std::holds_alternative<Profile>(read)) << name;
        EXPECT_EQ(std::get<Profile>(read), profile) << name;
    }
}

// D3: a key of 40,000 names would overflow the stack of the parser.
TEST_F(ProfileFile, AVeryLongKeyIsRefused) {
    std::string key = "a";
    for (int i = 0; i < 40000; ++i) {
        key += ".a";
    }
    for (const std::string& text : {"format = 1\n" + key + " = 1\n", "format = 1\n[" + key + "]\n",
                                    "format = 1\nbest = {" + key + " = 1}\n"}) {
        write(text);
        const LoadedProfile loaded = loadProfile(file_);
        EXPECT_NE(loaded.notice.find("profile.toml:2: a key has more than 16 names"),
                  std::string::npos)
            << loaded.notice;
        EXPECT_FALSE(loaded.keepFile);
    }
}

TEST_F(ProfileFile, AFailedSaveLeavesTheOldFileUnchanged) {
    fs::create_directories(file_ / "inside"); // cannot be replaced
    const auto problem = saveProfile(file_, someProfile());
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->text().find("profile.toml"), std::string::npos);
    EXPECT_TRUE(fs::exists(file_ / "inside"));
    const auto files = fs::directory_iterator(file_.parent_path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "no temporary file is left";
}

TEST_F(ProfileFile, SavingLeavesNoTemporaryFile) {
    ASSERT_FALSE(saveProfile(file_, someProfile()));
    ASSERT_FALSE(saveProfile(file_, Profile{}));
    const auto files = fs::directory_iterator(file_.parent_path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
    EXPECT_EQ(loadProfile(file_).profile.settings, Profile{}.settings);
}

// A profile may be kept in a folder under version control, and linked from there.
TEST_F(ProfileFile, OneThatIsALinkStaysALink) {
    const fs::path target = folder_ / "kept" / "aPart.toml";
    fs::create_directories(target.parent_path());
    fs::create_directories(file_.parent_path());
    fs::create_symlink("../kept/aPart.toml", file_);
    ASSERT_FALSE(saveProfile(file_, someProfile())) << "there is no target yet";
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_EQ(loadProfile(target).profile, someProfile());
    std::ofstream(target) << "format = 1\nchain = ture\n";
    EXPECT_NE(loadProfile(file_).notice, "");
    EXPECT_TRUE(fs::is_symlink(file_));
    EXPECT_EQ(read(file_.string() + ".broken"), "format = 1\nchain = ture\n");
    EXPECT_TRUE(loadProfile(target).whole);
}

TEST_F(ProfileFile, IsInTheConfigurationFolderOfTheUser) {
    const auto with = [](const char* config, const char* home) {
        setenv("XDG_CONFIG_HOME", config, 1);
        setenv("HOME", home, 1);
        return profileFile();
    };
    const std::string config = std::getenv("XDG_CONFIG_HOME") ? std::getenv("XDG_CONFIG_HOME") : "";
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    EXPECT_EQ(with("/somewhere", "/home/me"), fs::path("/somewhere/apart/profile.toml"));
    EXPECT_EQ(with("", "/home/me"), fs::path("/home/me/.config/apart/profile.toml"));
    EXPECT_EQ(with("not/a/full/path", "/home/me"), fs::path("/home/me/.config/apart/profile.toml"));
    EXPECT_EQ(with("", ""), std::nullopt);
    with(config.c_str(), home.c_str());
}

TEST(Profile, ABestScoreIsReplacedByAHigherOneOnly) {
    Profile profile;
    EXPECT_FALSE(profile.enter(Mode::Standard, "a", {100, false, false, false})); // no previous
                                                                                  // score
    EXPECT_FALSE(profile.enter(Mode::Standard, "a", {100, false, false, false}));
    EXPECT_TRUE(profile.enter(Mode::Standard, "a", {101, false, false, false}));
    EXPECT_EQ(profile.bestOf(Mode::Standard, "a").score, 101);
}

TEST(Profile, AchievementsOfALevelPersist) {
    Profile profile;
    profile.enter(Mode::Standard, "a", {100, true, true, false});
    profile.enter(Mode::Standard, "a", {50, false, false, true});
    EXPECT_EQ(profile.bestOf(Mode::Standard, "a"), (Best{100, true, true, true}));
}

TEST(Profile, TheTablesOfBothModesAreSeparate) {
    Profile profile;
    profile.enter(Mode::Pure, "a", {100, true, false, false});
    EXPECT_EQ(profile.bestOf(Mode::Standard, "a"), Best{});
    EXPECT_EQ(profile.bestOf(Mode::Pure, "a").score, 100);
}

} // namespace
} // namespace apart
