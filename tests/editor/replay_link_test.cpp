// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bit_coder.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/replay_link.hpp>
#include <apart/core/tuning.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace apart {
namespace {

/// A game of a bot on a level, of at most so many ticks.
Replay played(const std::string& name, std::uint32_t ticks, BotKind kind) {
    Game game(std::make_shared<const Level>(std::get<Level>(loadLevel(name))), 7);
    Recorder recorder(game);
    while (game.ticks() < ticks && game.result() == Result::Playing) {
        const Input input = bot(game, kind);
        game.tick(input);
        recorder.record(input, game);
    }
    Replay replay = recorder.finish(game);
    replay.expectations.push_back(
        {game.ticks(), Field::Score, Comparison::Equal, game.score(), 0, When::At, 0});
    return replay;
}

TEST(BitCoder, ReadsWhatItWrote) {
    const std::vector<std::uint32_t> numbers = {0, 1, 2, 3, 255, 256, 65535, 2147483647, 0, 0, 7};
    BitCoder writer;
    BitCoder::NumberOdds odds;
    for (const std::uint32_t number : numbers) {
        writer.number(number, odds);
    }
    writer.signedNumber(-1000000, odds);
    const std::string coded = writer.finish();
    BitCoder reader(coded);
    odds = {};
    for (const std::uint32_t number : numbers) {
        EXPECT_EQ(reader.number(0, odds), number);
    }
    EXPECT_EQ(reader.signedNumber(0, odds), -1000000);
}

// A long row of ones makes a carry run through many bytes.
TEST(BitCoder, ReadsAnyRowOfBits) {
    std::uint32_t state = 1;
    for (int round = 0; round < 50; ++round) {
        std::vector<bool> bits;
        for (int i = 0; i < 400; ++i) {
            state = state * 1664525 + 1013904223;
            bits.push_back((state >> 24) >= static_cast<std::uint32_t>(5 * round));
        }
        BitCoder writer;
        BitCoder::Odds odds;
        for (const bool bit : bits) {
            writer.bit(bit, odds);
        }
        const std::string coded = writer.finish();
        BitCoder reader(coded);
        odds = {};
        for (const bool bit : bits) {
            ASSERT_EQ(reader.bit(false, odds), bit) << round;
        }
    }
}

TEST(ReplayLink, HoldsTheInputsAndTheExpectationsAndFewHashes) {
    for (const BotKind kind : {BotKind::Good, BotKind::Clumsy, BotKind::Erratic}) {
        const Replay replay = played("arch", 3000, kind);
        const std::string link = linkOf({replay});
        ASSERT_TRUE(isLink(link));
        const Read<ReplayRun> read = readRunFile("page.html" + link);
        ASSERT_TRUE(std::holds_alternative<ReplayRun>(read)) << std::get<FileProblem>(read).text();
        const Replay& back = std::get<ReplayRun>(read)[0];
        EXPECT_EQ(back.inputs, replay.inputs);
        EXPECT_EQ(back.end, replay.end);
        EXPECT_EQ(back.seed, replay.seed);
        EXPECT_EQ(back.levelDigest, replay.levelDigest);
        ASSERT_EQ(back.expectations.size(), 1u);
        EXPECT_EQ(back.expectations[0].value, replay.expectations[0].value);
        ASSERT_FALSE(back.hashes.empty());
        EXPECT_LE(back.hashes.size(), replay.end / kLinkHash + 1);
        EXPECT_EQ(back.hashes.back(), replay.hashes.back());
        EXPECT_EQ(linkOf({back}), link);
    }
}

// The good bot moves in each of 120 ticks a second, as no hand does.
TEST(ReplayLink, AMinuteHasAtMost4kB) {
    constexpr std::uint32_t kMinute = 60 * kTicksPerSecond;
    for (const char* name : {"apart", "sentinel", "first_light"}) {
        for (const BotKind kind : {BotKind::Good, BotKind::Clumsy}) {
            const Replay replay = played(name, kMinute, kind);
            const std::size_t size = linkOf({replay}).size();
            EXPECT_LE(size, 512 + 3584 * std::size_t{replay.end} / kMinute)
                << name << " " << kBotNames[static_cast<std::size_t>(kind)] << " " << replay.end;
            RecordProperty(std::string(name) + kBotNames[static_cast<std::size_t>(kind)].data(),
                           static_cast<int>(size));
        }
    }
}

TEST(ReplayLink, ARunOfSeveralLevelsIsOneLink) {
    ReplayRun run = {played("endless:5:1", 600, BotKind::Good),
                     played("endless:5:2", 600, BotKind::Good)};
    const Read<ReplayRun> read = runOfLink(linkOf(run));
    ASSERT_TRUE(std::holds_alternative<ReplayRun>(read)) << std::get<FileProblem>(read).text();
    EXPECT_EQ(std::get<ReplayRun>(read).size(), 2u);
    EXPECT_EQ(std::get<ReplayRun>(read)[1].inputs, run[1].inputs);
}

// The last letters hold bits that belong to nothing: with others the game is the same.
TEST(ReplayLink, ADamagedLinkIsRefusedOrPlaysTheSameGame) {
    const std::string link = linkOf({played("arch", 600, BotKind::Clumsy)});
    const auto refused = [](const std::string& text) {
        return std::holds_alternative<FileProblem>(runOfLink(text));
    };
    EXPECT_FALSE(refused(link));
    EXPECT_TRUE(refused("#replay="));
    EXPECT_TRUE(refused("#replay=*"));
    EXPECT_TRUE(refused(link.substr(0, link.size() / 2)));
    for (std::size_t i = 9; i < link.size(); ++i) {
        std::string changed = link;
        changed[i] = changed[i] == 'A' ? 'B' : 'A';
        const Read<ReplayRun> read = runOfLink(changed);
        if (i + 4 < link.size()) {
            EXPECT_TRUE(std::holds_alternative<FileProblem>(read)) << i;
        } else if (const ReplayRun* run = std::get_if<ReplayRun>(&read)) {
            EXPECT_EQ(linkOf(*run), link) << i;
        }
    }
}

TEST(ReplayLink, WhatFollowsItsEndIsRefused) {
    const ReplayRun run = {played("arch", 600, BotKind::Clumsy)};
    const std::string link = linkOf(run);
    for (const char* junk : {"A", "AA", "AAAA", "B", "zz", "junk"}) {
        EXPECT_TRUE(std::holds_alternative<FileProblem>(runOfLink(link + junk))) << junk;
    }
    const std::string bytes = packed(run);
    EXPECT_TRUE(std::holds_alternative<ReplayRun>(unpacked(bytes, "x")));
    for (const std::string& junk : {std::string(1, '\0'), std::string("\n"), bytes}) {
        EXPECT_TRUE(std::holds_alternative<FileProblem>(unpacked(bytes + junk, "x")));
    }
}

// Regression: such a link took seconds and the memory of all its inputs before it was refused.
TEST(ReplayLink, OneThatUnpacksToMoreThanAReplayMayHaveIsRefusedAtOnce) {
    Replay replay;
    replay.level = "arch";
    replay.handwritten = true;
    replay.end = kLongestReplay;
    replay.inputs.resize(kLargestReplay / 10 + 1);
    for (std::size_t i = 0; i < replay.inputs.size(); ++i) {
        replay.inputs[i].tick = static_cast<std::uint32_t>(i);
    }
    std::string bytes = packed({replay});
    EXPECT_LT(bytes.size(), 100000u);
    bytes.resize(bytes.size() / 2); // what it says about its size comes first
    for (const Read<ReplayRun>& read :
         {unpacked(bytes, "the link"), runOfLink("#replay=" + std::string(kLargestReplay, 'A'))}) {
        ASSERT_TRUE(std::holds_alternative<FileProblem>(read));
        EXPECT_EQ(std::get<FileProblem>(read).text(), longerThanLargest("the link").text());
    }
}

} // namespace
} // namespace apart
