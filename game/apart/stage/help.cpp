// SPDX-License-Identifier: MIT
#include <apart/stage/help.hpp>
#include <apart/stage/palette.hpp>

#include <array>
#include <string_view>

namespace apart {

namespace {

struct Topic {
    std::string_view name;
    std::string_view text;
};

constexpr Real kRoom = Real(22); // m, right of the names

constexpr std::array<Topic, 12> kTopics = {{
    {"move", "mouse, arrows, A and D, or the stick of a gamepad"},
    {"serve", "space, enter, click, or the first button; with a spring it leaps"},
    {"pull", "left button, down or S: balls, shards and rubble come to the paddle"},
    {"push", "right button, up or W: they fly away from it"},
    {"meter", "pull and push use it up; it refills, faster by shards that are caught"},
    {"buildings", "a block counts once it has fallen; a collapse counts up to eightfold"},
    {"combo", "blocks broken without a touch of the paddle count up to eightfold"},
    {"marks", "a part is released: disc good, square mixed, triangle bad"},
    {"glow", "nothing hit for long: now a pull tears the lowest block off"},
    {"honours", "cleared; no ball lost; eight blocks in one combo or one fall"},
    {"pure", "rules that never bend a path, with scores of their own"},
    {"keys", "P pause   R again   M sound   F11 full screen   F3 what the engine sees"},
}};

} // namespace

void paintHelp(Canvas& canvas) {
    canvas.text("How to play", {0, Real(15.2)},
                {Real(1.4), palette::kText, Typeface::Display, Align::Middle});
    Real y = Real(13.6);
    for (const Topic& topic : kTopics) {
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
