// SPDX-License-Identifier: MIT
// Picture of buildings: previews, falls and results.
#include <apart/core/assets.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/field_painter.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/painters/level_preview.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "stage_rig.hpp"
#include "text_bounds.hpp"

namespace apart {
namespace {

std::shared_ptr<const Level> shipped(const std::string& name) {
    return std::make_shared<const Level>(std::get<Level>(loadLevel(name)));
}

StageDef played(const std::string& name) {
    StageDef def = StageRig::played();
    def.levels = {shipped(name), def.levels[0]};
    return def;
}

bool tells(const RecordingCanvas& canvas, std::string_view words) {
    return std::any_of(canvas.strokes().begin(), canvas.strokes().end(), [&](const Stroke& stroke) {
        return stroke.text.find(words) != std::string::npos;
    });
}

TEST(Preview, ShowsEveryBlockLedgeAndJointInsideItsBox) {
    const Aabb box{{-5, -4}, {5, 4}};
    for (const std::string& name : levelNames()) {
        SCOPED_TRACE(name);
        const Level level = *shipped(name);
        RecordingCanvas canvas;
        paintPreview(canvas, level, box);
        EXPECT_GE(canvas.strokes().size(),
                  level.cells.size() + level.freeBlocks.size() + level.links.size());
        for (const Stroke& stroke : canvas.strokes()) {
            EXPECT_TRUE(box.grown(Real(0.1)).contains(stroke.place))
                << stroke.place.x << " " << stroke.place.y;
        }
    }
}

TEST(Preview, AJointAndALedgeAddToIt) {
    Level level = *shipped("rope_bridge");
    RecordingCanvas whole;
    paintPreview(whole, level, {{-5, -4}, {5, 4}});
    level.links.clear();
    level.obstructions.clear();
    RecordingCanvas bare;
    paintPreview(bare, level, {{-5, -4}, {5, 4}});
    EXPECT_GT(whole.strokes().size(), bare.strokes().size() + 15);
}

/// Gap (m) between the lower left corner of a block of 2 by 1 m and its picture.
Real gapOf(std::uint32_t key, const kodo::Shape& shape) {
    kodo::World world;
    const kodo::BodyView body = world[world.add({.shape = shape})];
    RecordingCanvas canvas;
    paintBlock(canvas, body.part(0).convex, body.massFrame(), {.kind = {}, .key = key});
    return length(canvas.strokes().at(0).place - Vec2{-1, Real(-0.5)});
}

// A roof would hover over its columns.
TEST(Building, FreeBlocksAreDrawnToTheirEdges) {
    const kodo::Shape box = kodo::Box{2, 1};
    EXPECT_LT(gapOf(keyOfFree(0), box), Real(1e-4));
    EXPECT_GT(gapOf(keyOfFree(0) - 1, box), Real(0.02)) << "those of the grid keep a gap";
    const kodo::Shape wedge = kodo::Polygon{{{-1, Real(-0.5)}, {1, Real(-0.5)}, {1, Real(0.5)}}};
    EXPECT_LT(gapOf(keyOfFree(0), wedge), Real(1e-4));
}

/// The filled shape of a mast of 0.3 by 6 m.
Stroke mastAt(Real heat) {
    kodo::World world;
    const kodo::BodyView body = world[world.add({.shape = kodo::Box{Real(0.3), 6}})];
    RecordingCanvas canvas;
    paintBlock(canvas, body.part(0).convex, body.massFrame(),
               {.kind = {.stuff = Stuff::Wood}, .heat = heat, .key = keyOfFree(0)});
    return canvas.strokes().at(0);
}

// Regression: a struck mast turned white from end to end.
TEST(Building, AHitLightsTheRimAlone) {
    const Stroke calm = mastAt(0);
    const Stroke struck = mastAt(1);
    EXPECT_EQ(struck.color, calm.color);
    EXPECT_GT(struck.size, calm.size);
    EXPECT_LT(struck.size, Real(0.3) / 2 * Real(0.8)) << "of the half width, a fifth stays";
}

/// Places of the bolts of all straps, two of each.
std::vector<Vec2> boltsIn(const Play& play) {
    RecordingCanvas canvas;
    paintMounts(canvas, {play.game(), play.juice(), PoseBlend{}});
    std::vector<Vec2> bolts;
    for (const Stroke& stroke : canvas.strokes()) {
        if (stroke.kind == Stroke::Kind::Disc) {
            bolts.push_back(stroke.place);
        }
    }
    return bolts;
}

TEST(Building, StrapsHoldWhatIsMountedAndNothingElse) {
    const auto level = shipped("castle");
    Play play(level, 1, Mode::Standard, Settings{});
    SilentSpeaker silence;
    for (int i = 0; i < 250; ++i) { // all has appeared
        play.tick({}, silence);
    }
    std::size_t bolts = 0;
    for (const Block& block : play.game().blocks()) {
        const kodo::BodyView body = play.game().world()[block.body];
        const Real width = body.bounds().extent().x;
        bolts += block.support != Support::Mounted ? 0u : width > Real(0.9) ? 4u : 2u;
    }
    EXPECT_EQ(bolts, 4u * 4 + 2u * 2 + 4u) << "foundations, hooks and the block with a power";
    EXPECT_EQ(boltsIn(play).size(), bolts);
    const Play ledges(shipped("arch"), 1, Mode::Standard, Settings{});
    EXPECT_EQ(boltsIn(ledges).size(), 6u * 2) << "ledges: the blocks have not appeared yet";
}

/// Places of all texts in the field.
std::vector<Vec2> textsInField(const RecordingCanvas& canvas) {
    std::vector<Vec2> places;
    for (const Stroke& stroke : canvas.strokes()) {
        if (!stroke.text.empty() && stroke.place.x < layout::kRight) {
            places.push_back(stroke.place);
        }
    }
    return places;
}

TEST(ServeHint, StaysWhereItIsWhileTheServeTurnsAndMachinesRun) {
    for (const char* name : {"tower", "escapement", "mobile", "valves"}) {
        Game game(shipped(name), 1);
        RecordingCanvas canvas;
        canvas.begin(layout::kShown, {});
        paintServeHint(canvas, game, Bindings{});
        const std::vector<Vec2> before = textsInField(canvas);
        EXPECT_FALSE(before.empty()) << name;
        for (int tick = 0; tick < 240; ++tick) {
            Input input;
            input.aim = static_cast<std::int16_t>(10 * tick - 1200);
            game.tick(input);
        }
        canvas.begin(layout::kShown, {});
        paintServeHint(canvas, game, Bindings{});
        EXPECT_EQ(textsInField(canvas), before) << name;
    }
}

TEST(ServeHint, IsNotShownWhileTheServeIsHeld) {
    StageRig rig(StageRig::playing());
    rig.frames(30);
    EXPECT_TRUE(rig.picture().says("to serve"));
    Signals held;
    held.serveHeld = held.clicked = true;
    rig.frame(held);
    EXPECT_FALSE(rig.picture().says("to serve"));
}

// Blocks appear row by row: no rope hangs in the air before its blocks are there.
TEST(Building, RopesAppearWithTheirBlocks) {
    StageRig rig(played("scales")); // four ropes
    const auto thinLines = [&] {
        const auto& strokes = rig.picture().strokes();
        return std::count_if(strokes.begin(), strokes.end(), [](const Stroke& stroke) {
            return stroke.kind == Stroke::Kind::Ribbon && stroke.color.r == 222;
        });
    };
    rig.frame();
    EXPECT_EQ(thinLines(), 0);
    for (int i = 0; i < 60; ++i) {
        rig.frame();
    }
    EXPECT_GE(thinLines(), 4);
}

TEST(Collapse, IsToldInWordsAndInTheResults) {
    StageRig rig(played("tower"));
    bool told = false;
    for (int i = 0; i < 60 * 120 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame();
        told = told || tells(rig.picture(), " in one fall");
    }
    EXPECT_TRUE(told);
    rig.frames(240);
    EXPECT_TRUE(tells(rig.picture(), "points") && tells(rig.picture(), " in one fall"));
}

// Regression: "fallen 9 blocks, 10 in one fall"; a fall holds blocks that broke in it too.
TEST(Results, NameTheLargestFallBesideAllThatWasClearedWhichIsMore) {
    StageRig rig(played("tower"));
    for (int i = 0; i < 60 * 120 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame();
    }
    rig.frames(240);
    int lines = 0;
    for (const Stroke& stroke : rig.picture().strokes()) {
        const std::size_t comma = stroke.text.rfind(", ");
        if (stroke.text.ends_with(" in one fall") && comma != std::string::npos) {
            EXPECT_NE(stroke.text.find(" blocks in "), std::string::npos) << stroke.text;
            EXPECT_GE(std::stoi(stroke.text), std::stoi(stroke.text.substr(comma + 2)));
            ++lines;
        }
    }
    EXPECT_EQ(lines, 1);
}

struct WordsOfTheEnd {
    std::vector<Aabb> won; // in the picture (m)
    std::vector<Aabb> praise;
};

WordsOfTheEnd wordsOfTheEnd(StageRig& rig) {
    constexpr Real kPixels = 40; // per metre
    WordsOfTheEnd words;
    for (const Stroke& stroke : rig.picture().strokes()) {
        const bool wins = stroke.text == "Cleared!" || stroke.text.ends_with("go on");
        const bool praises = stroke.text.find(" in one fall!") != std::string::npos;
        if (wins || praises) {
            Stroke inPicture = stroke;
            inPicture.place = stroke.enlargedPlace;
            (wins ? words.won : words.praise).push_back(boundsOf(inPicture, rig.canvas, kPixels));
        }
    }
    return words;
}

// Regression: the words of a won game stood on the praise of its last fall.
TEST(Collapse, ThePraiseOfTheLastFallStandsBelowTheWordsOfAWonGame) {
    for (const char* name : {"stilts", "ship", "rope_bridge"}) {
        int seen = 0;
        // Not each game ends with its largest fall.
        for (std::uint32_t seed = 1; seed <= 8 && seen == 0; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            StageDef def = played(name);
            def.seed = seed;
            StageRig rig(std::move(def));
            for (int i = 0; i < 60 * 60 && rig.stage.screen() == Screen::Playing; ++i) {
                rig.frame();
                const WordsOfTheEnd words = wordsOfTheEnd(rig);
                for (const Aabb& a : words.won) {
                    for (const Aabb& b : words.praise) {
                        ASSERT_FALSE(overlap(a, b)) << "after " << i << " frames";
                        ++seen;
                    }
                }
            }
        }
        EXPECT_GT(seen, 0) << name;
    }
}

TEST(Collapse, IsSlowedByTheSettingOfSlowMotion) {
    const auto framesOf = [](int slow) {
        StageDef def = played("stilts");
        def.profile.settings.slow = slow;
        StageRig rig(def);
        int frames = 0;
        while (frames < 6000 && rig.stage.session().game().collapse().largest < 15) {
            rig.frame();
            ++frames;
        }
        return frames;
    };
    EXPECT_GT(framesOf(100), framesOf(0) + 10);
}

} // namespace
} // namespace apart
