// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/replay.hpp>
#include <apart/core/tuning.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;

std::shared_ptr<const Level> firstLight() {
    return std::make_shared<const Level>(std::get<Level>(loadLevel("first_light")));
}

/// A bot game of `ticks` ticks.
Replay recorded(std::uint32_t ticks) {
    Game game(firstLight(), 7);
    Recorder recorder(game);
    while (game.ticks() < ticks) {
        const Input input = bot(game);
        game.tick(input);
        recorder.record(input, game);
    }
    return recorder.finish(game);
}

std::string problemOf(const std::string& text) {
    const Read<Replay> replay = parseReplay(text, "test.replay");
    const auto* problem = std::get_if<FileProblem>(&replay);
    return problem != nullptr ? problem->text() : "none";
}

Playback played(const Replay& replay) {
    Playback playback(replay, firstLight());
    while (!playback.done()) {
        playback.tick();
    }
    return playback;
}

const std::string kByHand = R"(apart-replay 1
level first_light
seed 7
handwritten
# tick paddle target launch
0 0 - 0
30 0 - 1   # serve
40 -127 - 0
90 0 2500 0
hash 60 0123456789abcdef
expect 100 lives == 5
expect 120 result == playing
end 120
)";

TEST(ReplayFile, RoundTripsThroughText) {
    const Replay replay = recorded(500);
    EXPECT_EQ(replay.hashes.size(), 9u); // 60, 120 .. 480, 500
    const Read<Replay> back = parseReplay(toText(replay), "test.replay");
    ASSERT_TRUE(std::holds_alternative<Replay>(back)) << problemOf(toText(replay));
    EXPECT_EQ(std::get<Replay>(back), replay);
}

TEST(ReplayFile, CanBeWrittenByHand) {
    ASSERT_EQ(problemOf(kByHand), "none");
    const Replay replay = std::get<Replay>(parseReplay(kByHand, "test.replay"));
    ASSERT_EQ(replay.inputs.size(), 4u);
    EXPECT_TRUE(replay.inputs[1].input.launch);
    EXPECT_EQ(replay.inputs[2].input.paddle, -127);
    EXPECT_EQ(replay.inputs[3].input.target, 2500);
    ASSERT_EQ(replay.expectations.size(), 2u);
    EXPECT_EQ(replay.expectations[1].text(), "expect 120 result == playing");
    EXPECT_EQ(std::get<Replay>(parseReplay(toText(replay), "again")).inputs, replay.inputs);
}

TEST(ReplayFile, OfTheFirstRulesIsParsedAndRefusedInOneSentence) {
    std::string old = "apart-replay 1\nlevel first_light 0123456789abcdef\nrules 1\nseed 7\n"
                      "# tick paddle target launch\n0 0 - 0\nhash 60 0123456789abcdef\nend 60\n";
    old += "digest " + toHex(digestOf(std::string_view(old))) + "\n";
    ASSERT_EQ(problemOf(old), "none");
    const Replay replay = std::get<Replay>(parseReplay(old, "test.replay"));
    EXPECT_EQ(replay.mode, Mode::Standard);
    const auto reason = refusal(replay, *firstLight());
    ASSERT_TRUE(reason);
    EXPECT_EQ(*reason, "was recorded with version 1 of the rules, and this game has version " +
                           std::to_string(kRulesVersion));
}

// As the refusal suggests: without the digest, and with the line `handwritten` below the seed.
TEST(ReplayFile, IsAcceptedAfterManualEditing) {
    const std::string head = "apart-replay 2\nlevel first_light\nseed 7\n";
    const std::string rest = "0 0 - 0\n30 0 - 1\nend 60\n";
    EXPECT_NE(
        problemOf(head + rest + "digest 0123456789abcdef\n").find("handwritten below the seed"),
        std::string::npos);
    EXPECT_EQ(problemOf(head + "handwritten\n" + rest), "none");
}

TEST(ReplayFile, HasForceAndModeInItsSecondFormat) {
    const std::string text = "apart-replay 2\nlevel first_light\nseed 7\npure\nhandwritten\n"
                             "0 0 - 0\n30 0 - 1 pull\n40 0 - 0 push\n50 0 - 0 0\n"
                             "expect 60 forceChanged == 3\nexpect 60 patience == calm\nend 60\n";
    ASSERT_EQ(problemOf(text), "none");
    const Replay replay = std::get<Replay>(parseReplay(text, "test.replay"));
    EXPECT_EQ(replay.mode, Mode::Pure);
    EXPECT_EQ(replay.inputs[0].input.force, Force::None);
    EXPECT_EQ(replay.inputs[1].input.force, Force::Pull);
    EXPECT_EQ(replay.inputs[2].input.force, Force::Push);
    EXPECT_EQ(replay.expectations[1].text(), "expect 60 patience == calm");
    const Replay again = std::get<Replay>(parseReplay(toText(replay), "again"));
    EXPECT_EQ(again.inputs, replay.inputs);
    EXPECT_EQ(again.mode, Mode::Pure);
    const Playback playback = played(replay);
    EXPECT_TRUE(playback.failures().empty());
    EXPECT_EQ(playback.game().mode(), Mode::Pure);
    std::string assisted = text;
    assisted.replace(assisted.find("pure"), 4, "assisted");
    const Replay slow = std::get<Replay>(parseReplay(assisted, "assisted.replay"));
    EXPECT_EQ(slow.mode, Mode::Assisted);
    EXPECT_EQ(std::get<Replay>(parseReplay(toText(slow), "again")).mode, Mode::Assisted);
    std::string wrong = text;
    wrong.replace(wrong.find("pull"), 4, "suck");
    EXPECT_EQ(problemOf(wrong), "test.replay:7: force must be 0, pull or push");
}

TEST(ReplayFile, HasTheAimOfTheServeInItsThirdFormat) {
    const std::string head = "level first_light\nseed 7\nhandwritten\n";
    const std::string rest = "0 0 - 0\n10 0 - 0 0 -400\n20 0 - 0 0 -\n30 0 - 1 0\n"
                             "expect 15 serveX == -400\nexpect 25 serveX == -400\nend 60\n";
    const std::string text = "apart-replay 3\n" + head + rest;
    ASSERT_EQ(problemOf(text), "none");
    const Replay replay = std::get<Replay>(parseReplay(text, "test.replay"));
    EXPECT_FALSE(replay.inputs[0].input.aim);
    EXPECT_EQ(replay.inputs[1].input.aim, std::optional<std::int16_t>(-400));
    EXPECT_FALSE(replay.inputs[2].input.aim);
    EXPECT_TRUE(played(replay).failures().empty());
    EXPECT_EQ(std::get<Replay>(parseReplay(toText(replay), "again")).inputs, replay.inputs);
    EXPECT_EQ(problemOf("apart-replay 2\n" + head + rest),
              "test.replay:6: an input line has the columns tick paddle target launch force");
    std::string wrong = text;
    wrong.replace(wrong.find("0 -400"), 6, "0 1733");
    EXPECT_EQ(problemOf(wrong),
              "test.replay:6: aim must be - or a whole number from -1732 to 1732");
}

TEST(ReplayFile, IsRefusedAtEveryTruncation) {
    const std::string text = toText(recorded(130));
    for (std::size_t size = 0; size < text.size(); ++size) {
        ASSERT_NE(problemOf(text.substr(0, size)), "none") << "cut to " << size << " bytes";
    }
    EXPECT_EQ(problemOf(text.substr(0, text.size() / 2)).substr(0, 12), "test.replay:");
}

TEST(ReplayFile, IsRefusedWithAnyFlippedBit) {
    const std::string text = toText(recorded(70));
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string changed = text;
            changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
            ASSERT_NE(problemOf(changed), "none") << "byte " << i << ", bit " << bit;
        }
    }
}

TEST(ReplayFile, NamesTheLineOfAnError) {
    const auto with = [](const std::string& before, const std::string& after) {
        std::string changed = kByHand;
        return changed.replace(changed.find(before), before.size(), after);
    };
    const std::vector<std::pair<std::string, std::string>> cases = {
        {with("apart-replay 1", "apart-film 1"), ":1: not a replay"},
        {with("apart-replay 1", "apart-replay 4"), ":1: was written by a newer game"},
        {with("30 0 - 1", "30 0 - 1 pull"), ":7: an input line has four columns"},
        {with("seed 7", "seed 7\nrules 1\nrules 1"), ":5: a second version of the rules"},
        {with("seed 7", "seed 7\npure\nassisted"), ":5: a second mode"},
        {with("seed 7", "seed -7"), ":3: seed needs one whole number"},
        {with("seed 7\n", ""), ":12: there is no line seed N"},
        {with("level first_light\n", ""), ":12: there is no line level NAME"},
        {with("30 0 - 1", "30 0 1"), ":7: an input line has four columns"},
        {with("30 0 - 1", "30 0 - 2"), ":7: launch must be 0 or 1"},
        {with("40 -127", "40 -128"), ":8: paddle must be"},
        {with("40 -127", "30 -127"), ":8: the ticks of input lines must rise"},
        {with("2500", "99999"), ":9: target must be"},
        {with("0123456789abcdef", "0123"), ":10: a hash has 16"},
        {with("lives", "life"), ":11: there is no field 'life'"},
        {with("==", "="), ":11: there is no operator '='"},
        {with("== playing", "== 3"),
         ":12: '3' is no value of result, which is playing, won or lost"},
        {with("== playing", "< playing"), ":12: result has names, which have no order"},
        {with("lives == 5", "lives == 3.5"),
         ":11: '3.5' is no value of lives, which is a whole number"},
        {with("expect 100", "expect by 100-60"),
         ":11: '100-60' is no span FROM-TO: FROM must not be above TO"},
        {with("expect 100", "expect 121"), ":11: the expectation comes after the end, tick 120"},
        {with("expect 120", "expect 121"), ":12: the expectation comes after the end, tick 120"},
        {with("hash 60", "hash 121"), ":10: a hash comes after the end, tick 120"},
        {with("end 120", "end 50"), ":10: a hash comes after the end, tick 50"},
        {with("end 120", "end"), ":13: end needs one tick"},
        {kByHand + "200 0 - 0\n", ":14: nothing may follow"},
        {with("30 0", "launch 0"), ":7: 'launch' is neither a tick nor a word"},
    };
    for (const auto& [text, start] : cases) {
        const std::string problem = problemOf(text);
        EXPECT_EQ(problem.substr(0, 11 + start.size()), "test.replay" + start) << problem;
    }
}

TEST(ReplayFile, IsRefusedWhenTheLevelOrTheRulesHaveChanged) {
    Replay replay = recorded(60);
    const Level level = *firstLight();
    EXPECT_FALSE(refusal(replay, level));
    Level changed = level;
    changed.ballSpeed += 1;
    ASSERT_TRUE(refusal(replay, changed));
    EXPECT_NE(refusal(replay, changed)->find("which has changed since"), std::string::npos);
    replay.rules = kRulesVersion + 1;
    EXPECT_NE(refusal(replay, level)->find("of the rules"), std::string::npos);
}

TEST(Playback, ReproducesTheRecordedGameBitForBit) {
    const Replay replay = recorded(2000);
    const Playback playback = played(replay);
    EXPECT_FALSE(playback.divergence());
    EXPECT_EQ(playback.game().stateHash(), replay.hashes.back().hash);
}

TEST(Playback, NamesTheFirstTickThatDiffers) {
    Replay replay = recorded(600);
    // With other input from tick 200 on, the first different hash is that of tick 240.
    for (InputChange& change : replay.inputs) {
        if (change.tick >= 200) {
            change.input.target = 11000;
        }
    }
    const Playback playback = played(replay);
    ASSERT_TRUE(playback.divergence());
    EXPECT_EQ(playback.divergence()->tick, 240u);
    EXPECT_EQ(playback.divergence()->agreed, 180u);
}

TEST(Playback, ReportsFailedExpectations) {
    Replay replay = std::get<Replay>(parseReplay(kByHand, "test.replay"));
    replay.hashes.clear();
    EXPECT_TRUE(played(replay).failures().empty());
    replay.expectations[0].value = 2;
    const Playback playback = played(replay);
    ASSERT_EQ(playback.failures().size(), 1u);
    EXPECT_EQ(playback.failures()[0].text(), "expect 100 lives == 2, but lives is 5");
}

/// The replay by hand with these expectations alone, which end at tick 200.
Replay expecting(const std::string& lines) {
    const std::string text = "apart-replay 2\nlevel first_light\nseed 7\nhandwritten\n"
                             "0 0 0 0\n90 0 0 1\n" +
                             lines + "end 200\n";
    const Read<Replay> read = parseReplay(text, "test.replay");
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        ADD_FAILURE() << problem->text();
        return {};
    }
    return std::get<Replay>(read);
}

TEST(Playback, JudgesSpansByNeverAndAlways) {
    EXPECT_TRUE(played(expecting("expect by 200 served == 1\n"
                                 "expect never 0-89 served > 0\n"
                                 "expect always 95-200 served == 1\n"
                                 "expect always 0-200 lives > 0\n"))
                    .failures()
                    .empty());
    const Playback late = played(expecting("expect by 80 served == 1\n"));
    ASSERT_EQ(late.failures().size(), 1u);
    EXPECT_EQ(late.failures()[0].text(), "expect by 80 served == 1, but served is 0 at tick 80");
    const Playback once = played(expecting("expect never 50-200 served == 1\n"));
    ASSERT_EQ(once.failures().size(), 1u); // once, not at each tick
    EXPECT_GT(once.failures()[0].tick, 89u);
    const Playback broken = played(expecting("expect always 0-200 served == 0\n"));
    ASSERT_EQ(broken.failures().size(), 1u);
    EXPECT_EQ(broken.failures()[0].tick, once.failures()[0].tick);
}

TEST(ReplayFile, KeepsSpansWhenWritten) {
    const Replay replay = expecting("expect by 200 served == 1\n"
                                    "expect by 50-120 served == 1\n"
                                    "expect never 0-89 power == well\n"
                                    "expect always 95-200 lives == 3\n"
                                    "expect 200 hitImpulse >= 0\n");
    const Read<Replay> again = parseReplay(toText(replay), "again.replay");
    ASSERT_TRUE(std::holds_alternative<Replay>(again));
    const auto& expectations = std::get<Replay>(again).expectations;
    ASSERT_EQ(expectations.size(), replay.expectations.size());
    for (std::size_t i = 0; i < expectations.size(); ++i) {
        EXPECT_EQ(expectations[i].text(), replay.expectations[i].text());
    }
    EXPECT_EQ(replay.expectations[1].text(), "expect by 50-120 served == 1");
}

TEST(ReplayFile, RefusesBadSpans) {
    const auto reasonOf = [](const std::string& line) {
        const Read<Replay> read = parseReplay(
            "apart-replay 2\nlevel first_light\nseed 7\nhandwritten\n" + line + "\nend 200\n",
            "test.replay");
        return std::holds_alternative<FileProblem>(read) ? std::get<FileProblem>(read).reason
                                                         : std::string("none");
    };
    EXPECT_NE(reasonOf("expect by 90-80 served == 1").find("FROM must not"), std::string::npos);
    EXPECT_NE(reasonOf("expect until 90 served == 1").find("reads: expect"), std::string::npos);
    EXPECT_NE(reasonOf("expect never 0-201 served == 1").find("after the end"), std::string::npos);
    EXPECT_NE(reasonOf("expect never 0-x served == 1").find("is no span"), std::string::npos);
    EXPECT_NE(reasonOf("expect 100 power == dragon").find("no value of power"), std::string::npos);
}

TEST(Playback, MomentumOfPiecesAndMountIsTheImpulseOfTheBreak) {
    const Read<Replay> read = readReplayFile(std::string(APART_REPLAYS) + "/pattern_halves.replay");
    ASSERT_TRUE(std::holds_alternative<Replay>(read));
    Replay replay = std::get<Replay>(read);
    const Read<Level> level = loadLevelOf(std::string(APART_REPLAYS) + "/x", replay.level);
    ASSERT_TRUE(std::holds_alternative<Level>(level));
    Playback playback(replay, std::make_shared<const Level>(std::get<Level>(level)));
    while (playback.valueOf(Field::BreakPieces) == 0 && !playback.done()) {
        playback.tick();
    }
    EXPECT_GT(playback.valueOf(Field::BreakImpulse), 0);
    EXPECT_NEAR(static_cast<double>(playback.valueOf(Field::PieceMomentumY) +
                                    playback.valueOf(Field::MountImpulseY)),
                static_cast<double>(playback.valueOf(Field::BreakImpulse)), 3);
    EXPECT_EQ(playback.valueOf(Field::BreakPieces), playback.valueOf(Field::Shards));
}

} // namespace
