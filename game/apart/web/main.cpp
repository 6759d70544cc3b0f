// SPDX-License-Identifier: MIT
// The game in a page. The page prepares typefaces and storage, then calls startGame().
#include <apart/core/replay_link.hpp>
#include <apart/front/setup.hpp>
#include <apart/web/pixel_share.hpp>
#include <apart/web/web_canvas.hpp>
#include <apart/web/web_controls.hpp>
#include <apart/web/web_speaker.hpp>

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace apart {
namespace {

constexpr const char* kElement = "#canvas";
constexpr double kAspect = 1.6;       // of the picture, at least: layout::kShown
constexpr double kFewestPixels = 360; // of its height, so that letters stay legible

// Shows a sentence instead of the game.
EM_JS(void, complain, (const char* sentence), { Module.complain(UTF8ToString(sentence)); });
// Copies the files of the player to the browser's storage, if it has any.
EM_JS(void, keepFiles, (), { Module.keepFiles(); });
// True if the page shows the picture turned clockwise by a quarter.
EM_JS(int, isTurned, (), { return Module.turned() ? 1 : 0; });
// True if the screen is one for fingers.
EM_JS(int, hasFingers, (), { return matchMedia("(pointer: coarse)").matches ? 1 : 0; });
// Copies a text to the clipboard; the page's address goes before its link.
EM_JS(void, copyText, (const char* text), { Module.copyText(UTF8ToString(text)); });

/// Everything that lives as long as the page.
struct Page {
    explicit Page(StageDef def) : stage(std::move(def)), canvas({1, 1}), controls(canvas) {}

    Stage stage;
    WebCanvas canvas;
    WebControls controls;
    WebSpeaker speaker;
    PixelShare pixelShare;
    double density = 1; // pixels of the picture for one of the page
    double last = 0;    // ms
    bool lost = false;  // the context of the canvas
};

std::unique_ptr<Page> thePage;

/// Fits the canvas to the page; the result is its size in pixels.
kodo_draw::Size fitCanvas(Page& page) {
    double width = 0;
    double height = 0;
    emscripten_get_element_css_size(kElement, &width, &height); // as it is on the page
    const bool turned = isTurned() != 0;
    page.controls.setTurned(turned ? width : 0);
    if (turned) {
        std::swap(width, height);
    }
    const double all = emscripten_get_device_pixel_ratio();
    const double fewest =
        std::min(all, kFewestPixels / std::max(1.0, std::min(width / kAspect, height)));
    const double density = std::max(all * page.pixelShare.share(), fewest);
    const kodo_draw::Size wanted{static_cast<unsigned>(width * density),
                                 static_cast<unsigned>(height * density)};
    int nowX = 0;
    int nowY = 0;
    emscripten_get_canvas_element_size(kElement, &nowX, &nowY);
    if (kodo_draw::Size{static_cast<unsigned>(nowX), static_cast<unsigned>(nowY)} != wanted) {
        emscripten_set_canvas_element_size(kElement, static_cast<int>(wanted.x),
                                           static_cast<int>(wanted.y));
    }
    page.density = density;
    page.controls.setDensity(density);
    return wanted;
}

void frame() {
    Page& page = *thePage;
    const double now = emscripten_get_now();
    const double seconds = (now - page.last) / 1000;
    page.last = now;
    page.pixelShare.next(seconds);
    page.controls.setBindings(page.stage.records().profile().bindings);
    const Signals signals = page.controls.poll();
    if (page.controls.takePress()) {
        page.speaker.start();
    }
    page.stage.advance(seconds, signals, page.speaker);
    page.controls.capture(!page.stage.wantsPointer());
    if (page.lost) {
        return;
    }
    const kodo_draw::Size size = fitCanvas(page);
    page.canvas.setSize(size);
    page.stage.draw(page.canvas);
    page.canvas.show(size);
}

bool openContext(WebCanvas& canvas) {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = EM_FALSE;
    wanted.preserveDrawingBuffer = EM_TRUE; // a frame paints over what changes: see still_part.hpp
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context =
        emscripten_webgl_create_context(kElement, &wanted);
    if (context <= 0) {
        return false;
    }
    emscripten_webgl_make_context_current(context);
    canvas.makeResources();
    return true;
}

/// A context is lost when the machine sleeps, for instance; it comes back later. A page may be
/// hidden.
void watchPage(Page& page) {
    emscripten_set_webglcontextlost_callback(kElement, &page, EM_FALSE,
                                             [](int, const void*, void* self) -> EM_BOOL {
                                                 static_cast<Page*>(self)->lost = true;
                                                 return EM_TRUE; // it may be restored
                                             });
    emscripten_set_webglcontextrestored_callback(kElement, &page, EM_FALSE,
                                                 [](int, const void*, void* self) -> EM_BOOL {
                                                     auto& restored = *static_cast<Page*>(self);
                                                     restored.canvas.makeResources();
                                                     restored.lost = false;
                                                     return EM_TRUE;
                                                 });
    emscripten_set_visibilitychange_callback(
        &page, EM_FALSE,
        [](int, const EmscriptenVisibilityChangeEvent* event, void* self) -> EM_BOOL {
            auto& seen = *static_cast<Page*>(self);
            seen.speaker.pause(event->hidden != 0);
            if (event->hidden) {
                seen.controls.loseFocus();
            }
            return EM_FALSE;
        });
}

/// The files of the player are copied to the browser's storage whenever one was written.
void keepInBrowser(StageDef& def) {
    if (def.keeping.save) {
        def.keeping.save = [save = std::move(def.keeping.save)](const Profile& profile) {
            std::string problem = save(profile);
            keepFiles();
            return problem;
        };
    }
    if (def.edit) {
        def.edit = [edit = std::move(def.edit)](const Level* level) {
            EditorStart start = edit(level);
            start.save = [save = std::move(start.save)](const std::string& text) {
                std::string problem = save(text);
                keepFiles();
                return problem;
            };
            return start;
        };
    }
    if (def.keeping.keepReplay) {
        def.keeping.keepReplay = [keep = std::move(def.keeping.keepReplay)](
                                     const ReplayRun& run, const std::string& best) {
            std::string problem = keep(run, best);
            keepFiles();
            return problem;
        };
    }
}

/// Where one sees a name (m): on the map "back" or the number of a level, else an item of a menu
/// that begins so.
std::optional<Vec2> placeOf(const Stage& stage, std::string_view name) {
    if (stage.screen() == Screen::Levels) {
        const LevelMap& map = stage.levelMap();
        const int level = std::atoi(std::string(name).c_str());
        return (level > 0 ? map.tile(static_cast<std::size_t>(level) - 1) : map.backPlace())
            .center();
    }
    const std::vector<MenuItem>& items = stage.menu().items();
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].label.starts_with(name)) {
            return stage.menu().place(i).center();
        }
    }
    return std::nullopt;
}

} // namespace
} // namespace apart

/// `level` and `replay` may be empty: what a link names. The level may be a daily run: daily, or
/// daily-2026-11-26. The replay is a file. What cannot be played is told, and the game starts with
/// its title. The sentence is valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* startGame(const char* level, const char* replay) {
    using namespace apart;
    static std::string told;
    StartOptions options;
    options.level = level;
    options.replay = replay;
    auto def = setUp(options);
    if (const auto* problem = std::get_if<std::string>(&def)) {
        told = *problem;
        def = setUp({});
    }
    if (const auto* problem = std::get_if<std::string>(&def)) {
        complain(problem->c_str());
        return "";
    }
    auto& stage = std::get<StageDef>(def);
    keepInBrowser(stage);
    stage.sharing.copy = [](const std::string& text) { copyText(text.c_str()); };
    stage.quits = false;
    stage.profile.bindings.fingers = hasFingers() != 0;
    thePage = std::make_unique<Page>(std::move(stage));
    if (!openContext(thePage->canvas)) {
        complain("This browser has no WebGL 2, which the game is drawn with.");
        return "";
    }
    watchPage(*thePage);
    thePage->last = emscripten_get_now();
    emscripten_set_main_loop(frame, 0, EM_FALSE);
    return told.c_str();
}

/// Why a file is no level; "" if it is one. Valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* problemOfLevel(const char* file) {
    static std::string problem;
    apart::StartOptions options;
    options.level = file;
    const auto def = apart::setUp(options);
    const auto* told = std::get_if<std::string>(&def);
    problem = told != nullptr ? *told : "";
    return problem.c_str();
}

/// The fragment of a link to the game in a file; "" if there is none. Valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* linkOfLastGame(const char* file) {
    static std::string link;
    const apart::Read<apart::ReplayRun> read = apart::readRunFile(file);
    const auto* run = std::get_if<apart::ReplayRun>(&read);
    link = run != nullptr ? apart::linkOf(*run) : "";
    return link.c_str();
}

/// What the buttons of the page do: 0 pause.
extern "C" EMSCRIPTEN_KEEPALIVE void pressButton(int button) {
    if (apart::thePage && button == 0) {
        apart::thePage->controls.give(apart::Command::Pause);
    }
}

/// State of the game, for tests: 0 the screen, 1 the tick, 2 the score, 3 the seed of the serves,
/// 4 the mode, 5 the place of the paddle (mm), 6 whether a ball waits for its serve, 7 the level
/// chosen on the map, from 0, 8 the place of a ball (mm), 9 the result. In a duel, that of a
/// player, 0 or 1.
extern "C" EMSCRIPTEN_KEEPALIVE int gameState(int what, int player) {
    if (!apart::thePage) {
        return -1;
    }
    const apart::Stage& stage = apart::thePage->stage;
    const bool dueling = stage.screen() == apart::Screen::Duel;
    const apart::Game& game =
        dueling ? stage.duel()->game(static_cast<std::size_t>(player)) : stage.session().game();
    switch (what) {
    case 0:
        return static_cast<int>(stage.screen());
    case 1:
        return static_cast<int>(game.ticks());
    case 2:
        return game.score();
    case 3:
        return static_cast<int>(game.seed());
    case 4:
        return static_cast<int>(game.mode());
    case 5:
        return static_cast<int>(1000 * game.world()[game.paddle()].position().x);
    case 6:
        return game.serving() ? 1 : 0;
    case 7:
        return static_cast<int>(stage.levelMap().chosen());
    case 8:
        return game.balls().empty()
                   ? 0
                   : static_cast<int>(1000 * game.world()[game.balls()[0].body].position().x);
    default:
        return static_cast<int>(game.result());
    }
}

/// Where one sees a name, for tests, as placeOf(): "x y" in pixels of the page, of a picture that
/// is not turned; "" if nowhere. Valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* gamePlace(const char* name) {
    static std::string place;
    const apart::Page& page = *apart::thePage;
    const std::optional<apart::Vec2> found = apart::placeOf(page.stage, name);
    const kodo_draw::Pixel pixel = page.canvas.camera().toPixels(found.value_or(apart::Vec2{}));
    const auto onPage = [&](float pixels) {
        return std::to_string(static_cast<double>(pixels) / page.density);
    };
    place = found ? onPage(pixel.x) + " " + onPage(pixel.y) : "";
    return place.c_str();
}

int main() {
    setenv("APART_ASSETS", "/assets", 1);
    setenv("XDG_CONFIG_HOME", "/player", 1);
    return 0;
}
