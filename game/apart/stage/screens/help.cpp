// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/inset_canvas.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/help.hpp>
#include <apart/stage/screens/help_powers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace apart {

namespace {

constexpr double kLongestFrame = 0.1; // s
constexpr std::size_t kAcross = 3;    // of scenes
constexpr Real kGap = Real(0.8);      // m, between columns
constexpr Real kWide = Real(9.2);     // m, of a scene
constexpr Real kText = Real(0.42);    // m, height of the texts
constexpr Real kName = Real(0.52);    // m, height of the names

struct Topic {
    std::string_view name;
    std::string text;
};

/// What is explained by words alone, in two columns.
std::array<Topic, 6> topicsFor(const Bindings& keys) {
    const auto prompt = [&](Act act) { return keys.prompt(act); };
    const std::string pad = keys.text(Act::Serve, Bindings::kPadColumn);
    return {{
        {"move", keys.fingers ? "a finger that moves"
                              : fmt::format("mouse; {}: left; {}: right; or a stick",
                                            prompt(Act::Left), prompt(Act::Right))},
        {"serve", keys.fingers ? "a tap; a finger that rests aims"
                               : fmt::format("{}, enter, click{}; a spring leaps",
                                             prompt(Act::Serve), pad == "-" ? "" : ", or " + pad)},
        {"buildings", "what has fallen counts; a collapse up to eightfold"},
        {"glow", "no hit for long: a pull tears the lowest block off"},
        {"modes", "pure never bends a path, assisted slows the ball"},
        {keys.fingers ? "pause" : "keys",
         keys.fingers ? "a button in the corner"
                      : fmt::format("{}: pause  {}: again  {}: sound  F11: full screen",
                                    keys.firstKey(Act::Pause), keys.firstKey(Act::Restart),
                                    keys.firstKey(Act::Mute))},
    }};
}

/// A line of its own, below both columns.
constexpr std::string_view kHollow = "at buildings or joints the serve clears nothing until the "
                                     "paddle moves 0.6 m and returns it";

/// Where the page leads to, of the powers or of the scenes.
std::string_view footOf(bool powers, bool fingers) {
    if (fingers) {
        return powers ? "tap: back" : "tap: the powers";
    }
    return powers ? "left, right, click: how to play      escape or enter: back"
                  : "left, right, click: the powers      escape or enter: back";
}

/// Name of a scene, what to press for it, and what it shows.
struct Caption {
    std::string_view name;
    std::string press;
    std::string_view text;
};

bool isHollow(const Game& game) {
    return std::any_of(game.balls().begin(), game.balls().end(),
                       [](const Ball& ball) { return ball.hollow; });
}

Caption captionOf(HelpTopic topic, const Game& game, const Bindings& keys) {
    switch (topic) {
    case HelpTopic::Pull:
        return {"pull", keys.anyPrompt(Act::Pull), "balls, shards and rubble come to the paddle"};
    case HelpTopic::Push:
        return {"push", keys.anyPrompt(Act::Push),
                isHollow(game) ? "the ball is hollow: it clears nothing yet"
                               : "balls, shards and rubble fly from the paddle"};
    case HelpTopic::Meter:
        return {"meter", "", "both empty it; time and caught shards fill it"};
    case HelpTopic::Moods:
        return {"marks", "", "parts: disc good, square mixed, triangle bad"};
    case HelpTopic::Combo:
        return {"combo", game.counts().combo > 1 ? fmt::format("x{}", game.counts().combo) : "",
                "breaks without a touch count up to eightfold"};
    case HelpTopic::Honours:
        return {"honours", isHollow(game) ? "the serve is hollow" : "medals by score", ""};
    }
    return {};
}

/// An honour, and whether the game has it.
struct Honour {
    std::string_view name;
    bool done = false;
};

std::array<Honour, 3> honoursOf(const Game& game) {
    const bool won = game.result() == Result::Won;
    return {
        {{"cleared", won},
         {"no ball lost", won && game.lives() == game.level().lives},
         {"8 in one combo or fall", std::max(game.counts().combo, game.collapse().largest) >= 8}}};
}

/// Lines of a text at the current size, within `room` (m).
std::vector<std::string> linesOf(const Canvas& canvas, std::string_view text, Real room) {
    constexpr Real kLetter = Real(0.48); // mean width relative to the height
    const Real letters = room / (kLetter * kText * canvas.textScale());
    return wrapped(text, static_cast<std::size_t>(letters));
}

/// Heights of the page, which depend on the size of texts (m).
struct Layout {
    explicit Layout(const Canvas& canvas) : pitch(Real(0.6) * canvas.textScale()) {
        lines = canvas.textScale() > Real(1.05) ? 2 : 1;
        caption = Real(0.45) + Real(0.3) * canvas.textScale() + static_cast<Real>(lines) * pitch;
        words = Real(0.85) + pitch * static_cast<Real>(3 * lines + 1);
        scene = (kTop - words) / 2 - caption - Real(0.25);
    }
    /// Base line of the name of a scene.
    static Real nameLine(const Canvas& canvas, const Aabb& box) {
        return box.lower.y - Real(0.25) - Real(0.4) * canvas.textScale();
    }
    /// Box of a scene.
    Aabb box(std::size_t number) const {
        const auto column = static_cast<Real>(number % kAcross) - 1;
        const auto row = static_cast<Real>(number / kAcross);
        const Vec2 upper{column * (kWide + kGap) + kWide / 2,
                         kTop - row * (scene + caption + Real(0.25))};
        return {{upper.x - kWide, upper.y - scene}, upper};
    }

    static constexpr Real kTop = Real(16.7); // of the first row
    int lines = 1;                           // of a text
    Real pitch;                              // from line to line
    Real caption;                            // below a scene
    Real words;                              // below all scenes, from the bottom
    Real scene;                              // height of a scene
};

void paintCaption(Canvas& canvas, const Aabb& box, const Caption& caption, bool acts) {
    const Layout layout(canvas);
    Real y = Layout::nameLine(canvas, box);
    const Color color = acts ? palette::kPaddle : palette::kAccent;
    canvas.text(caption.name, {box.lower.x, y}, {kName, color, Typeface::Bold, Align::Left, 3});
    canvas.text(
        caption.press, {box.upper.x, y},
        {kText, acts ? palette::kPaddle : palette::kQuiet, Typeface::Plain, Align::Right, 6});
    for (const std::string& line : linesOf(canvas, caption.text, kWide)) {
        y -= layout.pitch;
        canvas.text(line, {box.lower.x, y},
                    {kText, palette::kText, Typeface::Plain, Align::Left, kWide});
    }
}

void paintHonours(Canvas& canvas, const Aabb& box, const Game& game) {
    const Layout layout(canvas);
    Real y = Layout::nameLine(canvas, box) - layout.pitch;
    Real x = box.lower.x;
    const auto honours = honoursOf(game);
    const std::array<Real, 3> shares = layout.lines > 1
                                           ? std::array{Real(0.4), Real(0.6), Real(1)}
                                           : std::array{Real(0.2), Real(0.3), Real(0.5)};
    for (std::size_t i = 0; i < honours.size(); ++i) {
        const Honour& honour = honours[i];
        const Real room = kWide * shares[i];
        if (x + room > box.upper.x + Real(0.1)) { // the last one has a line of its own
            x = box.lower.x;
            y -= layout.pitch;
        }
        const Color color = honour.done ? palette::kAccent : palette::kQuiet;
        const Vec2 dot{x + Real(0.16), y + Real(0.14)};
        if (honour.done) {
            canvas.disc(dot, Real(0.15), color, color);
        } else {
            canvas.ring(dot, Real(0.15), Real(0.04), color);
        }
        canvas.text(honour.name, {x + Real(0.45), y},
                    {kText, color, Typeface::Plain, Align::Left, room - Real(0.6)});
        x += room;
    }
}

/// The bar of pull and push, to the right of the name of its scene.
void paintMeterBar(Canvas& canvas, const Aabb& box, const Game& game) {
    const Real y = Layout::nameLine(canvas, box);
    const Aabb bar{{box.upper.x - Real(5.6), y + Real(0.02)}, {box.upper.x, y + Real(0.3)}};
    const Real right = bar.lower.x + game.meter() * bar.extent().x;
    const Color color = game.meter() > Real(0.15) ? palette::kPaddle : palette::kDanger;
    canvas.rectangle(bar, {255, 255, 255, 26}, {255, 255, 255, 26});
    canvas.rectangle({bar.lower, {right, bar.upper.y}}, darker(color, 0.15f), color);
}

/// Covers a margin around the scenes of one row. The picture begins black: to paint all of it costs
/// several milliseconds without a graphics card.
void paintMargin(Canvas& canvas, const Layout& layout, std::size_t row) {
    constexpr Real kMargin = 1; // m; most that a primitive reaches beyond its scene
    constexpr Color kBlack{0, 0, 0};
    const Aabb first = layout.box(row * kAcross);
    const Aabb last = layout.box(row * kAcross + kAcross - 1);
    const Real left = first.lower.x - kMargin;
    const Real right = last.upper.x + kMargin;
    const auto cover = [&](const Aabb& box) { canvas.rectangle(box, kBlack, kBlack); };
    cover({{left, first.upper.y}, {right, first.upper.y + kMargin}});
    cover({{left, first.lower.y - kMargin}, {right, first.lower.y}});
    Real from = left;
    for (std::size_t column = 0; column < kAcross; ++column) {
        const Aabb box = layout.box(row * kAcross + column);
        cover({{from, box.lower.y}, {box.lower.x, box.upper.y}});
        from = box.upper.x;
    }
    cover({{from, first.lower.y}, {right, first.upper.y}});
}

void paintWords(Canvas& canvas, const Bindings& keys, Real top) {
    constexpr Real kTopicRoom = Real(12.1);
    constexpr Real kFirst = Real(-11.9);
    constexpr Real kSecond = Real(3.1);
    const Layout layout(canvas);
    const auto name = [&](std::string_view topic, Vec2 place) {
        canvas.text(topic, place - Vec2{Real(0.4), 0},
                    {kText, palette::kAccent, Typeface::Bold, Align::Right, Real(2.9)});
    };
    const std::array<Topic, 6> topics = topicsFor(keys);
    for (std::size_t column = 0; column < 2; ++column) {
        const Real left = column == 0 ? kFirst : kSecond;
        Real y = top;
        for (std::size_t i = 0; i < 3; ++i) {
            const Topic& topic = topics[3 * column + i];
            name(topic.name, {left, y});
            Real line = y;
            for (const std::string& text : linesOf(canvas, topic.text, kTopicRoom)) {
                canvas.text(text, {left, line},
                            {kText, palette::kText, Typeface::Plain, Align::Left, kTopicRoom});
                line -= layout.pitch;
            }
            y -= static_cast<Real>(layout.lines) * layout.pitch;
        }
    }
    const Vec2 last{kFirst, top - static_cast<Real>(3 * layout.lines) * layout.pitch};
    name("hollow", last);
    canvas.text(
        kHollow, last,
        {kText, palette::kText, Typeface::Plain, Align::Left, kSecond + kTopicRoom - kFirst});
}

} // namespace

HelpPage::HelpPage(const Settings& settings) : settings_(settings) {
    for (const HelpScene& scene : helpScenes()) {
        starts_.emplace_back(levelOf(scene), scene.seed, Mode::Standard, settings,
                             kHelpRoom.grown(-Real(0.15)));
    }
    plays_ = starts_;
}

void HelpPage::tick() {
    SilentSpeaker silence;
    for (std::size_t i = 0; i < plays_.size(); ++i) {
        const HelpScene& scene = helpScenes()[i];
        if (plays_[i].game().ticks() >= scene.ticks) {
            plays_[i] = starts_[i];
        }
        plays_[i].tick(scene.script(plays_[i].game()), silence);
    }
}

void HelpPage::advance(double seconds) {
    owed_ += static_cast<double>(apart::share(settings_.speed)) * std::min(seconds, kLongestFrame);
    for (; owed_ >= 1.0 / kTicksPerSecond; owed_ -= 1.0 / kTicksPerSecond) {
        tick();
    }
}

Real HelpPage::share() const {
    return static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
}

void HelpPage::drawScene(Canvas& canvas, HelpTopic topic, const Aabb& box) const {
    const auto vision = static_cast<Vision>(std::clamp(settings_.colors, 0, 3));
    InsetCanvas inset(canvas, kHelpRoom, box, vision);
    play(topic).draw(inset, share());
}

void HelpPage::draw(Canvas& canvas, const Bindings& keys) const {
    canvas.text(footOf(powers_, keys.fingers), {0, Real(-0.2)},
                {kText, palette::kQuiet, Typeface::Plain, Align::Middle});
    if (powers_) {
        return paintPowersPage(canvas);
    }
    const Layout layout(canvas);
    for (std::size_t row = 0; row < 2; ++row) {
        for (std::size_t i = row * kAcross; i < (row + 1) * kAcross; ++i) {
            drawScene(canvas, static_cast<HelpTopic>(i), layout.box(i));
        }
        paintMargin(canvas, layout, row);
    }
    for (std::size_t i = 0; i < kHelpTopics; ++i) {
        const auto topic = static_cast<HelpTopic>(i);
        const Aabb box = layout.box(i);
        canvas.outline(std::array{box.lower, Vec2{box.upper.x, box.lower.y}, box.upper,
                                  Vec2{box.lower.x, box.upper.y}},
                       Real(0.06), faded(palette::kMachine, 0.6f));
        paintCaption(canvas, box, captionOf(topic, game(topic), keys),
                     topic == HelpTopic::Combo || game(topic).force() != Force::None);
    }
    paintMeterBar(canvas, layout.box(static_cast<std::size_t>(HelpTopic::Meter)),
                  game(HelpTopic::Meter));
    paintHonours(canvas, layout.box(static_cast<std::size_t>(HelpTopic::Honours)),
                 game(HelpTopic::Honours));
    canvas.text("How to play", {0, Real(17.3)},
                {Real(1.2), palette::kText, Typeface::Display, Align::Middle});
    paintWords(canvas, keys, layout.words - Real(0.55));
}

} // namespace apart
