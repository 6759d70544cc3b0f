// SPDX-License-Identifier: MIT
// Two players at one screen.
#include <apart/front/held_keys.hpp>
#include <apart/stage/screens/duel.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <set>

#include "text_room.hpp"

namespace apart {
namespace {

int codeOf(std::string_view name) {
    return keyNamed(name).value_or(kNoKey);
}

Real paddleOf(const Duel& duel, std::size_t player) {
    const Game& game = duel.game(player);
    return game.world()[game.paddle()].position().x;
}

/// What moves a paddle as the bot would. Without `clever` it only serves.
SeatSignals seatOf(const Game& game, bool clever) {
    SeatSignals seat;
    const Input wish = bot(game);
    const Real x = game.world()[game.paddle()].position().x;
    if (wish.target && clever) {
        seat.leftHeld = Real(*wish.target) / 1000 < x - Real(0.2);
        seat.rightHeld = Real(*wish.target) / 1000 > x + Real(0.2);
    }
    seat.serves = game.serving();
    return seat;
}

/// A duel with its players.
struct DuelRig {
    explicit DuelRig(const std::shared_ptr<const Level>& level = glassLevel("Three", {2, 7, 12}))
        : duel(level, 7, Mode::Standard, false) {}

    std::optional<Action> frame(const Signals& signals = {}) {
        const std::optional<Action> action = duel.take(signals, settings);
        duel.advance(1.0 / kTicksPerSecond, settings, {}, speaker);
        return action;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
        }
    }
    std::optional<Action> press(Command command) {
        Signals signals;
        signals.commands = {command};
        return frame(signals);
    }
    /// Frames with the keys that are held now.
    void hold(HeldKeys& keys, int frames) {
        for (int i = 0; i < frames; ++i) {
            Signals signals;
            keys.addHeld({}, signals);
            frame(signals);
        }
    }
    /// Plays to the result.
    void play(bool firstIsClever, bool secondIsClever) {
        for (int i = 0; i < 120 * 300 && duel.phase() != Duel::Phase::Over; ++i) {
            Signals signals;
            signals.seats = {seatOf(duel.game(0), firstIsClever),
                             seatOf(duel.game(1), secondIsClever)};
            frame(signals);
        }
        ASSERT_EQ(duel.phase(), Duel::Phase::Over);
    }
    const RecordingCanvas& picture() {
        canvas.begin(layout::kShownTitle, {});
        duel.draw(canvas, Bindings{});
        return canvas;
    }

    Settings settings;
    Duel duel;
    RecordingSpeaker speaker;
    RecordingCanvas canvas;
};

TEST(Duel, KeysOfEachPlayerMoveTheirPaddleAlone) {
    for (const auto& [name, player, way] :
         {std::tuple{"A", 0u, -1}, {"D", 0u, 1}, {"left", 1u, -1}, {"right", 1u, 1}}) {
        SCOPED_TRACE(name);
        DuelRig rig;
        HeldKeys keys;
        Signals signals;
        keys.press(codeOf(name), signals);
        rig.hold(keys, 30);
        EXPECT_GT(static_cast<Real>(way) * paddleOf(rig.duel, player), 1);
        EXPECT_EQ(paddleOf(rig.duel, 1 - player), 0);
    }
}

TEST(Duel, EachPlayerHasAKeyForTheServe) {
    for (const auto& [name, player] : {std::pair{"space", 0u}, {"enter", 1u}}) {
        DuelRig rig;
        HeldKeys keys;
        keys.setInGame(true);
        Signals signals;
        keys.press(codeOf(name), signals);
        keys.release(codeOf(name)); // within the frame
        rig.frame(signals);
        rig.frame();
        EXPECT_FALSE(rig.duel.game(player).serving());
        EXPECT_TRUE(rig.duel.game(1 - player).serving());
    }
}

TEST(Duel, TheMouseMovesAndServesTheFirstPlayer) {
    DuelRig rig;
    Signals signals;
    signals.moved = 1;
    signals.clicked = true;
    rig.frame(signals);
    rig.frames(60);
    EXPECT_NEAR(paddleOf(rig.duel, 0), 1 / Duel::scale(), 0.05);
    EXPECT_EQ(paddleOf(rig.duel, 1), 0);
    EXPECT_FALSE(rig.duel.game(0).serving());
    EXPECT_TRUE(rig.duel.game(1).serving());
}

TEST(Duel, EachPlayerHasAGamepad) {
    const Pad used{.stickX = 1, .held = 1};
    for (std::size_t player = 0; player < kSeats; ++player) {
        DuelRig rig;
        HeldKeys keys;
        std::array<Pad, kSeats> pads{};
        pads[player] = used;
        for (int i = 0; i < 30; ++i) {
            Signals signals;
            keys.take(pads, signals);
            EXPECT_EQ(signals.seats[player].serves, i == 0);
            EXPECT_FALSE(signals.seats[1 - player].serves);
            pads[player].held = 0;
            rig.frame(signals);
        }
        EXPECT_GT(paddleOf(rig.duel, player), 1);
        EXPECT_EQ(paddleOf(rig.duel, 1 - player), 0);
        EXPECT_FALSE(rig.duel.game(player).serving());
        EXPECT_TRUE(rig.duel.game(1 - player).serving());
    }
}

TEST(Duel, BothHaveTheSameServes) {
    DuelRig rig;
    EXPECT_EQ(rig.duel.game(0).serveHeading(), rig.duel.game(1).serveHeading());
    for (int i = 0; i < 600; ++i) {
        Signals signals;
        signals.seats[0] = signals.seats[1] = seatOf(rig.duel.game(0), true);
        rig.frame(signals);
        ASSERT_EQ(rig.duel.game(0).stateHash(), rig.duel.game(1).stateHash()) << i;
    }
}

TEST(Duel, NamesTheWinnerOrATie) {
    for (const auto& [first, second, words] : {std::tuple{true, false, "Player 1 wins"},
                                               {false, true, "Player 2 wins"},
                                               {true, true, "A tie"}}) {
        DuelRig rig(glassLevel("Three blocks", {1, 7, 12}));
        rig.play(first, second);
        EXPECT_TRUE(rig.picture().says(words)) << words;
        EXPECT_EQ(rig.duel.winner().has_value(), first != second);
        EXPECT_TRUE(rig.picture().says("Rematch"));
        EXPECT_EQ(rig.press(Command::Confirm), std::nullopt) << "a late serve";
        rig.frames(120);
        EXPECT_EQ(rig.press(Command::Confirm), Action::Restart);
    }
}

TEST(Duel, TheFirstToEndWaitsForTheOther) {
    DuelRig rig(glassLevel("One block", {7}));
    for (int i = 0; i < 120 * 60 && rig.duel.game(0).result() == Result::Playing; ++i) {
        Signals signals;
        signals.seats[0] = seatOf(rig.duel.game(0), true);
        rig.frame(signals);
    }
    rig.frames(120 * 5);
    EXPECT_EQ(rig.duel.phase(), Duel::Phase::Playing);
    EXPECT_TRUE(rig.picture().says("waits for the other player"));
}

TEST(Duel, APauseStopsBoth) {
    for (const bool focus : {false, true}) {
        DuelRig rig;
        Signals signals;
        signals.seats[0].serves = true;
        rig.frame(signals);
        signals = {};
        signals.focusLost = focus;
        signals.commands = focus ? std::vector<Command>{} : std::vector{Command::Back};
        rig.frame(signals);
        const auto ticks = rig.duel.game(0).ticks();
        EXPECT_EQ(rig.duel.phase(), Duel::Phase::Paused);
        rig.frames(100);
        EXPECT_EQ(rig.duel.game(0).ticks(), ticks);
        EXPECT_EQ(rig.duel.game(1).ticks(), ticks);
        EXPECT_TRUE(rig.picture().says("Paused"));
        rig.press(Command::Confirm); // go on
        EXPECT_EQ(rig.duel.game(0).ticks(), ticks + 1);
        EXPECT_EQ(rig.duel.game(1).ticks(), ticks + 1);
    }
}

TEST(Duel, RestartsAtOnceOnlyWithoutPoints) {
    DuelRig rig(glassLevel("Rows", {1, 3, 5, 7, 9, 11}));
    EXPECT_EQ(rig.press(Command::Restart), Action::Restart);
    for (int i = 0; i < 120 * 60 && rig.duel.game(1).score() == 0; ++i) {
        Signals signals;
        signals.seats[1] = seatOf(rig.duel.game(1), true);
        rig.frame(signals);
    }
    ASSERT_GT(rig.duel.game(1).score(), 0);
    EXPECT_EQ(rig.press(Command::Restart), std::nullopt);
    EXPECT_TRUE(rig.picture().says("once more to start again"));
    EXPECT_EQ(rig.press(Command::Restart), Action::Restart);
}

TEST(Duel, SoundsComeFromTheSideOfTheirGame) {
    for (const std::size_t player : {0u, 1u}) {
        DuelRig rig;
        Signals signals;
        signals.seats[player].serves = true;
        rig.frame(signals);
        rig.frame();
        ASSERT_FALSE(rig.speaker.notes.empty());
        for (const Note& note : rig.speaker.notes) {
            EXPECT_TRUE(player == 0 ? note.pan <= 0 : note.pan >= 0) << note.pan;
        }
    }
}

TEST(Duel, BothFieldsTogetherFlashTwiceASecondAtMost) {
    std::size_t all = 0;
    for (const char* name : {"castle", "dam", "tower", "arch"}) {
        DuelRig rig(std::make_shared<const Level>(std::get<Level>(loadLevel(name))));
        std::vector<int> flashes; // their ticks
        std::array<float, kSeats> before{};
        for (int tick = 0; tick < 120 * 20; ++tick) {
            Signals signals;
            signals.seats = {seatOf(rig.duel.game(0), true), seatOf(rig.duel.game(1), false)};
            rig.frame(signals);
            for (std::size_t i = 0; i < kSeats; ++i) {
                const float now = rig.duel.play(i).juice().flashes().field();
                if (now > std::exchange(before[i], now)) {
                    flashes.push_back(tick);
                }
            }
        }
        for (std::size_t i = 2; i < flashes.size(); ++i) {
            EXPECT_GE(flashes[i] - flashes[i - 2], 118) << name << ": three within a second";
        }
        all += flashes.size();
    }
    EXPECT_GT(all, 8u);
}

/// A canvas that knows its rectangles.
class PageCanvas : public RecordingCanvas {
public:
    void rectangle(const Aabb& box, Color below, Color above) override {
        if (below.a == 255 && above.a == 255) {
            boxes.emplace_back(strokes().size(), box);
        }
        RecordingCanvas::rectangle(box, below, above);
    }
    std::vector<std::pair<std::size_t, Aabb>> boxes; // with the number of strokes before
};

TEST(Duel, NothingOfAGameIsSeenOutsideItsHalf) {
    for (const char* name : {"castle", "dam", "tower"}) {
        SCOPED_TRACE(name);
        DuelRig rig(std::make_shared<const Level>(std::get<Level>(loadLevel(name))));
        std::size_t crossing = 0;
        for (int i = 0; i < 900; ++i) {
            Signals signals;
            signals.seats = {seatOf(rig.duel.game(0), true), seatOf(rig.duel.game(1), false)};
            rig.frame(signals);
            if (i % 60 != 0) {
                continue;
            }
            PageCanvas canvas;
            canvas.begin(layout::kShownTitle, {});
            rig.duel.draw(canvas, Bindings{});
            const auto& strokes = canvas.strokes();
            const std::size_t panels = static_cast<std::size_t>(
                std::find_if(strokes.begin(), strokes.end(),
                             [](const Stroke& stroke) { return stroke.text == "Player 1"; }) -
                strokes.begin());
            ASSERT_LT(panels, strokes.size());
            for (std::size_t s = 0; s < panels; ++s) {
                const Vec2 place = strokes[s].place;
                const bool inside = strokes[s].kind == Stroke::Kind::Text ||
                                    strokes[s].kind == Stroke::Kind::Rectangle || // cut
                                    Duel::boxOf(0).grown(Real(0.01)).contains(place) ||
                                    Duel::boxOf(1).grown(Real(0.01)).contains(place);
                crossing += inside ? 0 : 1;
                EXPECT_TRUE(inside || std::any_of(canvas.boxes.begin(), canvas.boxes.end(),
                                                  [&](const auto& cover) {
                                                      return cover.first > s &&
                                                             cover.first < panels &&
                                                             cover.second.contains(place);
                                                  }))
                    << place.x << ", " << place.y;
            }
        }
        EXPECT_GT(crossing, 0u) << "the test has seen something to cover";
    }
}

TEST(Duel, HalvesAreOfEqualSizeAndApart) {
    EXPECT_FALSE(overlap(Duel::boxOf(0), Duel::boxOf(1)));
    EXPECT_EQ(Duel::boxOf(0).extent().x, Duel::boxOf(1).extent().x);
    EXPECT_TRUE(layout::kShownTitle.contains(Duel::boxOf(0)));
    EXPECT_TRUE(layout::kShownTitle.contains(Duel::boxOf(1)));
}

TEST(Duel, ShowsAllBallsOfBothPlayersBesideTheirHits) {
    for (const int lives : {1, 3, 9, 12}) {
        SCOPED_TRACE(lives);
        Level level = *glassLevel("Three", {2, 7, 12});
        level.lives = lives;
        const DuelRig rig(std::make_shared<const Level>(level));
        RecordingCanvas canvas;
        canvas.begin(layout::kShownTitle, {});
        rig.duel.draw(canvas, Bindings{});
        std::vector<Real> words; // left edges of the numbers of hits
        for (const Stroke& s : canvas.strokes()) {
            if (s.text == "0 hits") {
                words.push_back(s.place.x - Real(1.7)); // its room, see paintHits
            }
        }
        ASSERT_EQ(words.size(), 2u);
        std::array<int, 2> balls{};
        std::array<Real, 2> last = {-100, -100};
        for (const Stroke& s : canvas.strokes()) {
            if (s.kind == Stroke::Kind::Disc && s.place.y == Real(4.55)) {
                const std::size_t player = s.place.x < words[0] ? 0 : 1;
                ++balls[player];
                EXPECT_LE(s.place.x + s.size, words[player]);
                EXPECT_GE(s.place.x - last[player], Real(0.2)) << "one covers the other";
                last[player] = s.place.x;
            }
        }
        EXPECT_EQ(balls[0], lives);
        EXPECT_EQ(balls[1], lives);
    }
}

TEST(Duel, LeadsFromTheTitleOverTheMapAndBackAndWritesNothing) {
    std::vector<Profile> kept;
    int replays = 0;
    StageDef def = StageRig::twoLevels();
    def.keeping.save = StageRig::keeping(kept);
    def.keeping.keepReplay = [&](const ReplayRun&, const std::string&) {
        ++replays;
        return std::string();
    };
    StageRig rig(def);
    rig.clickItem(Action::Duel);
    ASSERT_EQ(rig.stage.screen(), Screen::Levels);
    EXPECT_TRUE(rig.picture().says("Duel"));
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Duel);
    EXPECT_FALSE(rig.stage.wantsPointer());
    const Profile before = rig.stage.records().profile();
    const Duel* duel = rig.stage.duel();
    for (int i = 0; i < 120 * 300 && duel->phase() != Duel::Phase::Over; ++i) {
        Signals signals;
        signals.seats = {seatOf(duel->game(0), true), seatOf(duel->game(1), true)};
        rig.frame(signals, 1.0 / kTicksPerSecond);
    }
    ASSERT_EQ(duel->phase(), Duel::Phase::Over);
    EXPECT_TRUE(rig.stage.wantsPointer());
    EXPECT_EQ(duel->game(0).result(), Result::Won);
    const auto seed = duel->game(0).seed();
    rig.frames(60);
    rig.press(Command::Next);
    ASSERT_EQ(rig.stage.screen(), Screen::Duel);
    EXPECT_EQ(rig.stage.duel()->game(0).level().name, "test_3");
    EXPECT_NE(rig.stage.duel()->game(1).seed(), seed) << "other serves";
    rig.press(Command::Pause);
    rig.press(Command::Down);
    rig.press(Command::Down);
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Options);
    rig.press(Command::Back);
    ASSERT_EQ(rig.stage.screen(), Screen::Duel);
    EXPECT_EQ(rig.stage.duel()->phase(), Duel::Phase::Paused);
    rig.press(Command::Up); // from the first item to the last one
    rig.press(Command::Up);
    rig.press(Command::Up);
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    EXPECT_EQ(rig.stage.records().profile(), before);
    EXPECT_EQ(replays, 0);
    for (const Profile& profile : kept) {
        EXPECT_EQ(profile, before);
    }
}

TEST(Duel, MuteAndTextSizeHoldInIt) {
    StageDef def = StageRig::twoLevels();
    def.duel = true;
    def.profile.settings.text = 140;
    StageRig rig(def);
    ASSERT_EQ(rig.stage.screen(), Screen::Duel);
    EXPECT_EQ(rig.picture().textScale(), Real(1.4));
    rig.press(Command::Mute);
    rig.speaker.notes.clear();
    Signals signals;
    signals.seats[0].serves = signals.seats[1].serves = true;
    rig.frame(signals);
    rig.frames(120);
    EXPECT_TRUE(rig.speaker.notes.empty());
    EXPECT_EQ(rig.speaker.scene.volume, 0);
    EXPECT_EQ(rig.speaker.scene.music, 0);
}

TEST(TextRoom, OfADuel) {
    const std::size_t step = support::kSanitized ? 23 : 4;
    for (const Mode mode : {Mode::Standard, Mode::Assisted}) {
        inEachSize([&](int percent, Vec2 window) {
            for (std::size_t i = 0; i < allLevels().size(); i += step) {
                StageDef def = crowded(percent, mode);
                def.duel = true;
                def.firstLevel = i;
                TextScreen room(def, window);
                room.expectFree("before the serve");
                room.press(Command::Pause);
                room.expectFree("pause");
            }
            StageDef def = crowded(percent, mode);
            TextScreen map(def, window);
            map.clickItem(Action::Duel);
            map.expectFree("map of a duel");

            def.levels = {glassLevel("A level whose title is rather long", {1, 3, 7, 12}),
                          glassLevel("Next", {7})};
            def.duel = true;
            TextScreen room(def, window);
            const Duel& duel = *room.stage.duel();
            bool asked = false;
            for (int t = 0; t < 120 * 300 && duel.phase() != Duel::Phase::Over; ++t) {
                Signals signals;
                signals.seats = {seatOf(duel.game(0), true), seatOf(duel.game(1), false)};
                room.frame(signals, 1.0 / kTicksPerSecond);
                if (!asked && duel.game(0).score() > 0) {
                    room.press(Command::Restart);
                    EXPECT_TRUE(room.picture().says("once more")) << "asks";
                    asked = true;
                }
            }
            ASSERT_EQ(duel.phase(), Duel::Phase::Over);
            room.expectFree("result");
        });
    }
}

} // namespace
} // namespace apart
