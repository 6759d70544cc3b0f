// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <support/draws.hpp>

#include "game_access.hpp"

namespace {

using namespace apart;

TEST(Rewind, ACopiedGameContinuesWithTheSameBits) {
    const int between = support::kSanitized ? 97 : 397;
    const int ahead = support::kSanitized ? 50 : 200;
    for (const std::string& name : levelNames()) {
        SCOPED_TRACE(name);
        Game game(std::get<Level>(loadLevel(name)), 3);
        for (int part = 0; part < (support::kSanitized ? 1 : 4); ++part) {
            for (int tick = 0; tick < between; ++tick) {
                game.tick(bot(game));
            }
            Game copy = game;
            ASSERT_EQ(copy.stateHash(), game.stateHash());
            Game first = game;
            for (int tick = 0; tick < ahead; ++tick) {
                first.tick(bot(first));
            }
            for (int tick = 0; tick < ahead; ++tick) {
                copy.tick(bot(copy));
            }
            ASSERT_EQ(copy.stateHash(), first.stateHash());
        }
    }
}

TEST(Rewind, TheSameSeedAndInputsGiveTheSameGame) {
    const Level level = std::get<Level>(loadLevel("mitosis"));
    const auto played = [&](std::uint32_t seed) {
        Game game(level, seed);
        for (int tick = 0; tick < (support::kSanitized ? 500 : 2000); ++tick) {
            game.tick(bot(game));
        }
        return game.stateHash();
    };
    EXPECT_EQ(played(4), played(4));
    EXPECT_NE(played(4), played(5));
}

} // namespace
