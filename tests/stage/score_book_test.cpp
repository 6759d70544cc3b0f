// SPDX-License-Identifier: MIT
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/records/score_book.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

/// A level that the bot wins within seconds, and its recorded game.
struct Recorded {
    std::shared_ptr<const Level> level = glassLevel("One block", {7});
    Replay replay = recordedGame(level, 3);
    std::int32_t score = 0;

    Recorded() {
        Playback playback(replay, level);
        while (!playback.done()) {
            playback.tick();
        }
        score = playback.game().score();
    }
    ScoreBook::Key key() const { return {Mode::Standard, level->name}; }
    ScoreStore store(std::variant<ReplayRun, std::string> best) const {
        ScoreStore store;
        store.load = [best = std::move(best)](Mode, const std::string&) { return best; };
        store.levelOf = [level = level](const Replay& wanted) -> LevelOrReason {
            if (wanted.level != level->name) {
                return "no such level";
            }
            return level;
        };
        return store;
    }
};

/// Checks one score to its end.
Standing checked(ScoreBook& book, const ScoreBook::Key& key, std::int32_t claim) {
    book.checkFirst(key, claim);
    std::optional<ScoreBook::Finding> finding;
    for (int i = 0; i < 100000 && book.busy(); ++i) {
        finding = book.advance(100);
    }
    EXPECT_TRUE(finding && finding->key == key);
    return finding ? finding->standing : Standing{};
}

TEST(ScoreBook, AScoreIsProvedByItsReplay) {
    const Recorded game;
    ASSERT_GT(game.score, 0);
    ScoreBook book(game.store(ReplayRun{game.replay}));
    EXPECT_EQ(book.standingOf(game.key(), game.score).proof, Proof::Waiting);
    const Standing standing = checked(book, game.key(), game.score);
    EXPECT_EQ(standing.proof, Proof::Proved);
    EXPECT_EQ(book.standingOf(game.key(), game.score).score, game.score);
    EXPECT_EQ(book.standingOf({Mode::Pure, game.level->name}, game.score).proof, Proof::Waiting);
    EXPECT_EQ(book.standingOf(game.key(), 0).proof, Proof::None);
}

// D12: a score that was typed into the profile.
TEST(ScoreBook, ATypedInScoreIsNotProved) {
    const Recorded game;
    ScoreBook book(game.store(ReplayRun{game.replay}));
    const Standing standing = checked(book, game.key(), 99999999);
    EXPECT_EQ(standing.score, game.score) << "that of the replay";
    EXPECT_NE(book.standingOf(game.key(), 99999999).proof, Proof::Proved);

    ScoreBook without(game.store("no replay"));
    EXPECT_EQ(checked(without, game.key(), 99999999).proof, Proof::Missing);
    EXPECT_EQ(without.standingOf(game.key(), 99999999).note, "no replay");
}

TEST(ScoreBook, AReplayOfAnotherLevelOrModeIsNoProof) {
    const Recorded game;
    ScoreBook book(game.store(ReplayRun{game.replay}));
    EXPECT_EQ(checked(book, {Mode::Pure, game.level->name}, game.score).proof, Proof::Missing);
    EXPECT_EQ(checked(book, {Mode::Standard, "another"}, game.score).proof, Proof::Missing);
    EXPECT_EQ(checked(book, {Mode::Standard, kEndlessKey}, game.score).proof, Proof::Missing);
}

TEST(ScoreBook, ScoresOfOtherRulesAreShownAsSuch) {
    const Recorded game;
    Replay old = game.replay;
    old.rules = kRulesVersion - 1;
    ScoreBook book(game.store(ReplayRun{old}));
    const Standing standing = checked(book, game.key(), game.score);
    EXPECT_EQ(standing.proof, Proof::Older);
    EXPECT_EQ(standing.note, "rules " + std::to_string(kRulesVersion - 1));

    Replay changed = game.replay;
    changed.levelDigest = *changed.levelDigest + 1;
    ScoreBook other(game.store(ReplayRun{changed}));
    EXPECT_EQ(checked(other, game.key(), game.score).note, "older level");
}

TEST(ScoreBook, AReplayThatDivergesIsNoProof) {
    const Recorded game;
    Replay forged = game.replay;
    forged.hashes.back().hash ^= 1;
    ScoreBook book(game.store(ReplayRun{forged}));
    EXPECT_EQ(checked(book, game.key(), game.score).proof, Proof::Missing);
}

// D6: ten hours of play in one small file do not stop the game.
TEST(ScoreBook, AVeryLongReplayIsCheckedInSlices) {
    const Recorded game;
    Replay endless = game.replay;
    endless.inputs.clear();
    endless.hashes.clear();
    endless.end = kLongestReplay;
    ScoreBook book(game.store(ReplayRun{endless}));
    book.checkFirst(game.key(), game.score);
    for (int i = 0; i < 20; ++i) {
        EXPECT_FALSE(book.advance(100));
    }
    EXPECT_EQ(book.standingOf(game.key(), game.score).note, "checked: 0 %");
    // A more urgent check comes first and does not end this one.
    book.checkFirst({Mode::Pure, game.level->name}, game.score);
    EXPECT_TRUE(book.advance(100));
    EXPECT_TRUE(book.busy());
    EXPECT_EQ(book.standingOf(game.key(), game.score).note, "checked: 0 %");
}

/// A stage whose profile claims this score.
StageDef claiming(const Recorded& game, std::int32_t score,
                  std::variant<ReplayRun, std::string> best) {
    StageDef def = StageRig::twoLevels();
    def.levels[0] = game.level;
    def.profile.enter(Mode::Standard, game.level->name, {score, true, false, false});
    def.scores = game.store(std::move(best));
    return def;
}

// D12, on the screen: it says what a score is worth.
TEST(ScoreBook, TheMapShowsNoTypedInScoreAsTheBestOne) {
    const Recorded game;
    StageRig rig(claiming(game, 99999999, "no replay"));
    rig.clickItem(Action::Levels);
    rig.press(Command::Left);
    rig.frames(60);
    EXPECT_TRUE(rig.picture().says("99 999 999: no replay"));
    EXPECT_FALSE(rig.picture().says("99 999 999 points"));
    rig.press(Command::Confirm);
    rig.frames(10);
    EXPECT_FALSE(rig.picture().says("best")) << "no score to beat";

    StageRig proved(claiming(game, 99999999, ReplayRun{game.replay}));
    proved.clickItem(Action::Levels);
    proved.press(Command::Left);
    proved.frames(60 * 20);
    EXPECT_FALSE(proved.picture().says("99 999 999"));
    EXPECT_EQ(proved.stage.records().profile().bestOf(Mode::Standard, game.level->name).score,
              game.score);
    EXPECT_EQ(proved.stage.records().profile().bestOf(Mode::Standard, game.level->name).unproved,
              99999999);
}

TEST(ScoreBook, AScoreThatCannotBeReadIsTakenFromItsReplay) {
    const Recorded game;
    StageRig rig(claiming(game, kUnreadScore, ReplayRun{game.replay}));
    rig.clickItem(Action::Levels);
    rig.press(Command::Left);
    EXPECT_TRUE(rig.picture().says("so far, more are checked"));
    rig.frames(60 * 20);
    const Best best = rig.stage.records().profile().bestOf(Mode::Standard, game.level->name);
    EXPECT_EQ(best.score, game.score);
    EXPECT_EQ(best.unproved, 0);
    EXPECT_TRUE(rig.picture().says(countText(game.score, "point") + " in all"));

    StageRig without(claiming(game, kUnreadScore, "no replay"));
    without.clickItem(Action::Levels);
    without.frames(60);
    EXPECT_EQ(without.stage.records().profile().bestOf(Mode::Standard, game.level->name).score, 0);
}

// After a line like "cleared = maybe", or without a profile.
TEST(ScoreBook, ThatALevelIsClearedIsTakenFromItsReplay) {
    const Recorded game;
    std::vector<Profile> saved;
    StageDef def = claiming(game, game.score, ReplayRun{game.replay});
    def.profile.best[0][game.level->name].cleared = false;
    def.keeping.save = StageRig::keeping(saved);
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("Play   1  One block"));
    rig.frames(60 * 10);
    EXPECT_TRUE(rig.stage.records().profile().bestOf(Mode::Standard, game.level->name).cleared);
    EXPECT_TRUE(rig.picture().says("Play   2  Three blocks"));
    ASSERT_EQ(saved.size(), 1u) << "at once, and once";
    EXPECT_TRUE(saved[0].bestOf(Mode::Standard, game.level->name).cleared);
    rig.clickItem(Action::Levels);
    EXPECT_TRUE(rig.picture().says("1 of 2 cleared"));

    Replay lost = game.replay; // left before its end
    lost.end /= 2;
    std::erase_if(lost.inputs, [&](const auto& change) { return change.tick > lost.end; });
    std::erase_if(lost.hashes, [&](const auto& mark) { return mark.tick > lost.end; });
    StageDef other = claiming(game, game.score, ReplayRun{lost});
    other.profile.best[0][game.level->name].cleared = false;
    StageRig without(std::move(other));
    without.frames(60 * 20);
    EXPECT_FALSE(
        without.stage.records().profile().bestOf(Mode::Standard, game.level->name).cleared);
}

TEST(ScoreBook, AScoreThatItsReplayGivesIsSavedAtOnce) {
    const Recorded game;
    std::vector<Profile> saved;
    StageDef def = claiming(game, kUnreadScore, ReplayRun{game.replay});
    def.keeping.save = StageRig::keeping(saved);
    StageRig rig(std::move(def));
    for (int i = 0; i < 60 * 20 && saved.empty(); ++i) {
        rig.frame();
    }
    ASSERT_EQ(saved.size(), 1u);
    EXPECT_EQ(saved[0].bestOf(Mode::Standard, game.level->name).score, game.score);
}

// Honours that were typed into the profile without a game, or with a score that no replay gives.
TEST(ScoreBook, TheMapShowsNoHonoursOfAScoreWithoutProof) {
    const Recorded game;
    const auto footAfterChecks = [&](std::int32_t score,
                                     std::variant<ReplayRun, std::string> best) {
        StageRig rig(claiming(game, score, std::move(best)));
        rig.clickItem(Action::Levels);
        rig.frames(60 * 20);
        return rig.picture().says("1 of 2 cleared")   ? 1
               : rig.picture().says("0 of 2 cleared") ? 0
                                                      : -1;
    };
    EXPECT_EQ(footAfterChecks(0, "no replay"), 0);
    EXPECT_EQ(footAfterChecks(500, "no replay"), 0);
    EXPECT_EQ(footAfterChecks(game.score, ReplayRun{game.replay}), 1);
    Replay old = game.replay;
    old.rules = kRulesVersion - 1;
    EXPECT_EQ(footAfterChecks(game.score, ReplayRun{old}), 1) << "of older rules";
}

/// Lists the names under which games are kept as the best ones; "" for others.
void listKept(StageDef& def, std::vector<std::string>& kept) {
    def.keeping.keepReplay = [&kept](const ReplayRun&, const std::string& best) {
        kept.push_back(best);
        return std::string();
    };
}

TEST(ScoreBook, AGameReplacesAScoreWithoutProofAndKeepsIt) {
    const Recorded game;
    std::vector<std::string> kept;
    StageDef def = claiming(game, 99999999, "no replay");
    def.startAtOnce = true;
    listKept(def, kept);
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    const Best best = rig.stage.records().profile().bestOf(Mode::Standard, game.level->name);
    EXPECT_EQ(best.score, rig.stage.session().game().score());
    EXPECT_EQ(best.unproved, 99999999);
    EXPECT_EQ(kept, (std::vector<std::string>{"", game.level->name}));
    EXPECT_EQ(rig.stage.records().standingOf(Mode::Standard, game.level->name).proof,
              Proof::Proved);
}

// The check of the old score takes longer than the game: until it ends, both scores are kept.
TEST(ScoreBook, AGameWaitsForTheCheckOfTheScoreThatItMayReplace) {
    const Recorded game;
    Replay slow = game.replay;
    slow.hashes.clear();
    slow.end = 400000;
    std::vector<std::string> kept;
    StageDef def = claiming(game, 99999999, ReplayRun{slow});
    def.startAtOnce = true;
    listKept(def, kept);
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    EXPECT_EQ(rig.stage.records().profile().bestOf(Mode::Standard, game.level->name).score,
              99999999);
    EXPECT_EQ(kept, (std::vector<std::string>{""}));
    for (int i = 0; i < 10000 && kept.size() < 2; ++i) {
        rig.frame();
        if (rig.stage.records().standingOf(Mode::Standard, game.level->name).proof ==
            Proof::Proved) {
            break;
        }
    }
    EXPECT_EQ(rig.stage.records().profile().bestOf(Mode::Standard, game.level->name).score,
              std::max(game.score, rig.stage.session().game().score()));
}

} // namespace
} // namespace apart
