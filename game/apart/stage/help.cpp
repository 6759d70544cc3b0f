// SPDX-License-Identifier: MIT
#include <apart/stage/help.hpp>
#include <apart/stage/palette.hpp>

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

namespace apart {

namespace {

struct Topic {
    std::string_view name;
    std::string text;
};

constexpr Real kRoom = Real(22); // m, right of the names

std::array<Topic, 12> topicsFor(const Bindings& keys) {
    const auto prompt = [&](Act act) { return keys.prompt(act); };
    return {{
        {"move", fmt::format("mouse; {}: left; {}: right; or the stick of a gamepad",
                             prompt(Act::Left), prompt(Act::Right))},
        {"serve", fmt::format("{}, enter, click, or {} of a gamepad; with a spring it leaps",
                              prompt(Act::Serve), keys.text(Act::Serve, Bindings::kPadColumn))},
        {"pull", fmt::format("left button, {}: balls, shards and rubble come to the paddle",
                             prompt(Act::Pull))},
        {"push", fmt::format("right button, {}: they fly away from it", prompt(Act::Push))},
        {"meter", "pull and push use it up; it refills, faster by shards that are caught"},
        {"buildings", "a block counts once it has fallen; a collapse counts up to eightfold"},
        {"combo", "blocks broken without a touch of the paddle count up to eightfold"},
        {"marks", "a part is released: disc good, square mixed, triangle bad"},
        {"glow", "nothing hit for long: now a pull tears the lowest block off"},
        {"honours", "cleared; no ball lost; eight in one combo or fall; medals by score"},
        {"pure", "rules that never bend a path, with scores of their own"},
        {"keys", fmt::format("{}: pause   {}: again   {}: sound   F11: full screen   F3: engine",
                             keys.firstKey(Act::Pause), keys.firstKey(Act::Restart),
                             keys.firstKey(Act::Mute))},
    }};
}

} // namespace

void paintHelp(Canvas& canvas, const Bindings& keys) {
    canvas.text("How to play", {0, Real(15.2)},
                {Real(1.4), palette::kText, Typeface::Display, Align::Middle});
    Real y = Real(13.6);
    for (const Topic& topic : topicsFor(keys)) {
        canvas.text(topic.name, {Real(-8.0), y},
                    {Real(0.52), palette::kAccent, Typeface::Bold, Align::Right});
        canvas.text(topic.text, {Real(-7.4), y},
                    {Real(0.5), palette::kText, Typeface::Plain, Align::Left, kRoom});
        y -= Real(0.92);
    }
    canvas.text("escape or enter: back", {0, Real(1.2)},
                {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle});
}

} // namespace apart
