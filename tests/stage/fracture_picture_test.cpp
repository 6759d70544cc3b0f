// SPDX-License-Identifier: MIT
// What a fracture and a collapse show in their first frames.
#include <apart/core/assets.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/effects/block_bounds.hpp>
#include <apart/stage/effects/collapse_camera.hpp>
#include <apart/stage/effects/debris.hpp>
#include <apart/stage/effects/time_scale.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/painters/level_preview.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "stage_rig.hpp"

namespace apart {
namespace {

StageDef botIn(const char* name) {
    StageDef def = StageRig::played();
    def.levels = {std::make_shared<const Level>(std::get<Level>(loadLevel(name)))};
    return def;
}

Broke fractureOf(kodo::Real impulse) {
    Broke broke;
    broke.point = {1, 9};
    broke.impulse = impulse;
    broke.points = 50;
    return broke;
}

TEST(Fracture, FlashesThrowsChipsAndRaisesDustInItsFirstFrames) {
    const Game game(*glassLevel("x", {7}), 1);
    Juice juice(1, Settings{});
    juice.take(game, std::vector<Event>{fractureOf(12)});
    ASSERT_EQ(juice.flashes().glints().size(), 1u);
    EXPECT_GT(juice.flashes().punch(), 0);
    EXPECT_GT(juice.debris().chips(), 5u);
    EXPECT_GT(juice.debris().puffs(), 2u);
    Juice harder(1, Settings{});
    harder.take(game, std::vector<Event>{fractureOf(24)});
    EXPECT_GT(harder.debris().chips(), juice.debris().chips());
    EXPECT_GT(harder.flashes().glints()[0].weight, juice.flashes().glints()[0].weight);
    for (int tick = 0; tick < Glint::kTicks; ++tick) {
        juice.tick(game);
    }
    EXPECT_TRUE(juice.flashes().glints().empty()); // three frames
}

TEST(Fracture, ItsEffectsCanBeTurnedOff) {
    const Game game(*glassLevel("x", {7}), 1);
    Settings settings;
    settings.particles = settings.flash = 0;
    Juice juice(1, settings);
    juice.take(game, std::vector<Event>{fractureOf(24)});
    EXPECT_EQ(juice.debris().chips(), 0u);
    EXPECT_EQ(juice.debris().puffs(), 0u);
    EXPECT_EQ(juice.flashes().punch(), 0);
}

TEST(Fracture, DebrisFadesAndItsNumberIsLimited) {
    Debris debris(1);
    for (int i = 0; i < 200; ++i) {
        debris.add({{0, 9}, {}, {}, 30, 8});
    }
    EXPECT_LE(debris.chips(), 250u);
    EXPECT_LE(debris.puffs(), 100u);
    for (int tick = 0; tick < 2 * kTicksPerSecond; ++tick) {
        debris.tick(kTickSeconds);
    }
    EXPECT_EQ(debris.chips() + debris.puffs(), 0u);
}

// Points and words stand beside what breaks: at their start they touch nothing of it.
TEST(Labels, StartBesideAllThatBreaks) {
    int labels = 0;
    std::vector<std::string> covering;
    for (const char* name : {"first_light", "tower", "wrecking_yard"}) {
        const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel(name)));
        Game game(level, 1);
        Juice juice(1, Settings{});
        for (int tick = 0; tick < 2400; ++tick) {
            game.tick(bot(game));
            juice.tick(game);
            for (const Popup& popup : juice.popups()) {
                if (popup.age > 0) {
                    continue;
                }
                ++labels;
                const std::vector<Aabb> places = breakingPlaces(game);
                if (std::any_of(places.begin(), places.end(),
                                [&](const Aabb& place) { return overlap(place, popup.box()); })) {
                    covering.push_back(std::string(name) + ", tick " + std::to_string(tick) + ": " +
                                       popup.text);
                }
            }
        }
    }
    EXPECT_GT(labels, 20);
    EXPECT_EQ(covering, std::vector<std::string>{});
}

// Praise of a fall does not cross what still stands, for as long as it is well seen.
TEST(Labels, PraiseStandsBesideWhatStands) {
    int praises = 0;
    std::vector<std::string> crossing;
    for (const std::string& name : levelNames()) {
        const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel(name)));
        if (!isBuilding(*level)) {
            continue;
        }
        Game game(level, 1);
        Juice juice(1, Settings{});
        for (int tick = 0; tick < 1500 && game.result() == Result::Playing; ++tick) {
            game.tick(bot(game));
            juice.tick(game);
            for (const Popup& popup : juice.popups()) {
                if (!popup.praise || popup.age > 45) {
                    continue;
                }
                praises += popup.age == 0 ? 1 : 0;
                const auto crosses = [&](const Block& block) {
                    const bool stands =
                        block.support == Support::Standing || block.support == Support::Mounted;
                    return stands && overlap(boundsOf(game, block), popup.box());
                };
                if (std::any_of(game.blocks().begin(), game.blocks().end(), crosses)) {
                    crossing.push_back(name + ", tick " + std::to_string(tick) + ": " + popup.text);
                }
            }
        }
    }
    EXPECT_GT(praises, 40);
    EXPECT_EQ(crossing, std::vector<std::string>{});
}

// "torn off" stands where the block does not fall through it.
TEST(Labels, ABlockThatIsTornOffPassesBesideItsLabel) {
    int labels = 0;
    int crossed = 0;
    for (const char* name : {"lift_off", "card_house"}) {
        Game game(std::make_shared<const Level>(std::get<Level>(loadLevel(name))), 1);
        Juice juice(1, Settings{});
        kodo::BodyId torn;
        for (int tick = 0; tick < 5000; ++tick) {
            game.tick(bot(game));
            juice.tick(game);
            for (const Event& event : game.events()) {
                const auto* let = std::get_if<LetGo>(&event);
                torn = let != nullptr && let->why == LetGo::Why::Torn ? let->block : torn;
            }
            for (const Popup& popup : juice.popups()) {
                if (popup.text == "torn off" && game.world().contains(torn)) {
                    labels += popup.age == 1 ? 1 : 0;
                    crossed += overlap(popup.box(), game.world()[torn].bounds()) ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(labels, 0);
    EXPECT_EQ(crossed, 0);
}

// A closeup of a collapse cuts no label off.
TEST(Labels, StayInTheEnlargedPicture) {
    StageRig rig(botIn("tower"));
    int seen = 0;
    for (int i = 0; i < 900; ++i) {
        rig.frame();
        if (rig.picture().mostZoom() < Real(1.02)) {
            continue;
        }
        for (const Stroke& stroke : rig.picture().strokes()) {
            if (stroke.text.starts_with("+") || stroke.text.ends_with("in one fall!")) {
                ++seen;
                const Real half = stroke.size * static_cast<Real>(stroke.text.size()) / 4;
                EXPECT_LE(std::abs(stroke.enlargedPlace.x) + half, layout::kRight + 1);
                EXPECT_LE(stroke.enlargedPlace.y + stroke.size, layout::kTop + 1);
            }
        }
    }
    EXPECT_GT(seen, 30);
}

// What comes down later passes in front of them.
TEST(Labels, ArePaintedBelowShards) {
    StageRig rig(botIn("first_light"));
    int seen = 0;
    for (int i = 0; i < 600; ++i) {
        rig.frame();
        const auto& strokes = rig.picture().strokes();
        const auto label = std::find_if(strokes.begin(), strokes.end(), [](const Stroke& stroke) {
            return stroke.text.starts_with("+");
        });
        const Game& game = rig.stage.session().game();
        if (label == strokes.end() || game.shards().empty()) {
            continue;
        }
        ++seen;
        // The outline of a shard is the only polygon with a rim of this width.
        const auto shard = std::find_if(strokes.begin(), strokes.end(), [](const Stroke& stroke) {
            return stroke.kind == Stroke::Kind::Polygon && stroke.size == Real(0.032);
        });
        EXPECT_LT(label, shard);
    }
    EXPECT_GT(seen, 30);
}

// A ball may be lost while the building still falls: the hint to serve the next one waits.
TEST(Labels, TheHintToServeIsNotOverWhatFalls) {
    const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel("first_light")));
    int waits = 0;
    int shown = 0;
    for (const int place : {-600, -300, 0}) { // from each the serve meets a glass foot
        Game game(level, 1, Mode::Pure);      // a hollow ball would fell nothing
        for (int tick = 0; tick < 1200; ++tick) {
            Input input;
            input.launch = tick == 90;
            input.target = static_cast<std::int16_t>(tick > 90 ? 9000 : place); // out of the way
            game.tick(input);
            if (!game.serving() || game.score() == 0) {
                continue;
            }
            const bool falls = std::any_of( // what lies on ground no longer does
                game.blocks().begin(), game.blocks().end(), [&](const Block& block) {
                    return block.support == Support::Fallen && !game.world()[block.body].isAsleep();
                });
            RecordingCanvas canvas;
            paintServeHint(canvas, game, Bindings{});
            EXPECT_NE(canvas.says("space or click to serve"), falls);
            ++(falls ? waits : shown);
        }
    }
    EXPECT_GT(waits, 20);
    EXPECT_GT(shown, 20);
}

TEST(Freeze, LastsLongerAfterAHarderImpact) {
    const auto framesOf = [](kodo::Real strength, int freeze) {
        StageDef def = StageRig::played();
        Level level = *def.levels[1]; // with three blocks
        level.kinds[0].strength = static_cast<std::int32_t>(1000 * strength);
        level.ballSpeed = static_cast<std::int32_t>(2500 + 500 * strength);
        def.levels = {std::make_shared<const Level>(level)};
        def.profile.settings.freeze = freeze;
        def.profile.settings.slow = 0;
        StageRig rig(std::move(def));
        int still = 0; // frames without a tick, at the first fracture
        while (rig.stage.session().game().blocksLeft() == 3) {
            rig.frame({}, 1.0 / kTicksPerSecond);
        }
        for (int i = 0; i < 12; ++i) {
            const std::uint32_t before = rig.stage.session().game().ticks();
            rig.frame({}, 1.0 / kTicksPerSecond);
            still += rig.stage.session().game().ticks() == before ? 1 : 0;
        }
        return still;
    };
    EXPECT_GT(framesOf(16, 100), framesOf(1, 100));
    EXPECT_LE(framesOf(16, 0), 2); // rounding of the frame's time
}

TEST(Closeup, KeepsPaddleAndBallsInThePictureAndShowsOnlyTheField) {
    for (const char* name : {"tower", "first_light"}) {
        const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel(name)));
        Game game(level, 1);
        CollapseCamera camera;
        Real most = 1;
        for (int tick = 0; tick < 2400; ++tick) {
            game.tick(bot(game));
            camera.advance(game, 1.0 / kTicksPerSecond, 1);
            const Closeup closeup = camera.closeup(game);
            most = std::max(most, closeup.scale);
            if (closeup.scale == 1) {
                continue;
            }
            const Aabb shown = shownBy(closeup);
            const Aabb slack = shown.grown(Real(1e-3));
            EXPECT_TRUE(slack.contains(game.world()[game.paddle()].bounds()));
            for (const Ball& ball : game.balls()) {
                const Vec2 place = game.world()[ball.body].center();
                EXPECT_TRUE(place.y < 0 || place.y > layout::kTop || slack.contains(place));
            }
            EXPECT_GE(shown.lower.x, layout::kShown.lower.x - Real(1e-3));
            EXPECT_GE(shown.lower.y, layout::kShown.lower.y - Real(1e-3));
            EXPECT_LE(shown.upper.y, layout::kShown.upper.y + Real(1e-3));
        }
        EXPECT_GT(most, Real(1.08)) << name;
    }
}

TEST(Closeup, IsASetting) {
    const auto mostOf = [](int zoom) {
        StageDef def = botIn("tower");
        def.profile.settings.zoom = zoom;
        StageRig rig(std::move(def));
        Real most = 1;
        for (int i = 0; i < 1500 && rig.stage.screen() == Screen::Playing; ++i) {
            rig.frame();
            most = std::max(most, rig.picture().mostZoom());
        }
        return most;
    };
    EXPECT_EQ(mostOf(0), 1);
    EXPECT_GT(mostOf(100), Real(1.05));
}

// What is drawn over the picture, as by F3, needs its closeup and its game.
TEST(Closeup, OfTheStageIsThatOfThePicture) {
    StageDef def = botIn("tower"); // ends with a collapse
    def.profile.settings.zoom = 100;
    StageRig rig(std::move(def));
    Real most = 1;
    for (int i = 0; i < 60 * 300 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame();
        most = std::max(most, shownBy(rig.stage).closeup.scale);
        ASSERT_EQ(rig.picture().mostZoom(), shownBy(rig.stage).closeup.scale);
        ASSERT_TRUE(&shownBy(rig.stage).game == &rig.stage.session().game() ||
                    rig.stage.screen() == Screen::Over);
    }
    EXPECT_GT(most, Real(1.05));
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_EQ(rig.picture().mostZoom(), shownBy(rig.stage).closeup.scale);
    EXPECT_NE(&shownBy(rig.stage).game, &rig.stage.session().game()) << "the rerun of the collapse";
}

std::string strokesOf(const Level& level) {
    RecordingCanvas canvas;
    paintPreview(canvas, level, {{-5, -4}, {5, 4}});
    std::string text;
    for (const Stroke& stroke : canvas.strokes()) {
        text += std::to_string(static_cast<int>(stroke.kind)) + " " +
                std::to_string(stroke.place.x) + " " + std::to_string(stroke.place.y) + " " +
                std::to_string(stroke.size) + " " + std::to_string(stroke.color.r) + "\n";
    }
    return text;
}

// Whatever is taken from a level, or changed to the usual, its preview changes.
TEST(Preview, ShowsAllThatIsInALevel) {
    for (const std::string& name : levelNames()) {
        const Level level = std::get<Level>(loadLevel(name));
        const std::string whole = strokesOf(level);
        const auto expectOther = [&](const char* what, std::size_t index, auto change) {
            Level other = level;
            change(other);
            EXPECT_NE(strokesOf(other), whole) << name << ": " << what << " " << index;
        };
        for (std::size_t i = 0; i < level.links.size(); ++i) {
            expectOther("link", i,
                        [&](Level& l) { l.links.erase(l.links.begin() + std::ptrdiff_t(i)); });
        }
        for (std::size_t i = 0; i < level.obstructions.size(); ++i) {
            expectOther("obstruction", i, [&](Level& l) {
                l.obstructions.erase(l.obstructions.begin() + std::ptrdiff_t(i));
            });
        }
        for (std::size_t i = 0; i < level.wells.size(); ++i) {
            expectOther("well", i,
                        [&](Level& l) { l.wells.erase(l.wells.begin() + std::ptrdiff_t(i)); });
        }
        for (std::size_t i = 0; i < level.kinds.size(); ++i) {
            if (level.kinds[i].power != Power::None) {
                expectOther("power", i, [&](Level& l) { l.kinds[i].power = Power::None; });
            }
            if (level.kinds[i].support == Support::Hanging) {
                expectOther("hanging", i, [&](Level& l) { l.kinds[i].support = Support::Mounted; });
            }
            if (level.kinds[i].core) {
                expectOther("core", i, [&](Level& l) { l.kinds[i].core = false; });
            }
        }
        for (std::size_t i = 0; i < level.waters.size(); ++i) {
            expectOther("water", i,
                        [&](Level& l) { l.waters.erase(l.waters.begin() + std::ptrdiff_t(i)); });
        }
        if (level.keep >= 0) {
            expectOther("keep", 0, [](Level& l) { l.keep = -1; });
        }
        if (level.wind != 0) {
            expectOther("wind", 0, [](Level& l) { l.wind = 0; });
        }
        if (level.paddle != PaddleKind::Steady) {
            expectOther("paddle", 0, [](Level& l) { l.paddle = PaddleKind::Steady; });
        }
        if (level.ball != BallKind::Round) {
            expectOther("ball", 0, [](Level& l) { l.ball = BallKind::Round; });
        }
    }
}

TEST(Preview, StaysInItsRectangle) {
    const Aabb box{{-5, -4}, {5, 4}};
    for (const std::string& name : levelNames()) {
        RecordingCanvas canvas;
        paintPreview(canvas, std::get<Level>(loadLevel(name)), box);
        for (const Stroke& stroke : canvas.strokes()) {
            EXPECT_TRUE(box.grown(Real(0.1)).contains(stroke.place)) << name;
        }
    }
}

} // namespace
} // namespace apart
