// SPDX-License-Identifier: MIT
#include <apart/stage/hud.hpp>
#include <apart/stage/layout.hpp>
#include <apart/stage/marks.hpp>
#include <apart/stage/palette.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

using layout::kPanelLeft;
using layout::kPanelRight;

TextStyle quiet(Real height) {
    return {height, palette::kQuiet, Typeface::Plain, Align::Left};
}
TextStyle strong(Real height, Color color = palette::kText) {
    return {height, color, Typeface::Bold, Align::Left};
}

void paintLevel(Canvas& canvas, const Game& game, const HudLook& look) {
    canvas.text("aPart", {kPanelLeft, Real(17.05)}, strong(Real(1.1), palette::kAccent));
    const std::string place =
        "LEVEL " + std::to_string(look.levelNumber) + " OF " + std::to_string(look.levelCount);
    canvas.text(place, {kPanelLeft, Real(15.85)}, quiet(Real(0.42)));
    Real y = Real(15.15);
    for (const std::string& line : wrapped(game.level().title, 15)) {
        canvas.text(line, {kPanelLeft, y}, strong(Real(0.62)));
        y -= Real(0.72);
    }
}

void paintLives(Canvas& canvas, const Game& game) {
    canvas.text("BALLS", {kPanelLeft, Real(10.85)}, quiet(Real(0.42)));
    const int shown = std::min<int>(game.lives(), 8);
    for (int i = 0; i < shown; ++i) {
        const Vec2 center{kPanelLeft + Real(0.28) + Real(0.62) * static_cast<Real>(i), Real(10.3)};
        canvas.disc(center, Real(0.24), palette::kBall, darker(palette::kBall, 0.2f));
    }
}

void paintProgress(Canvas& canvas, const Game& game) {
    const int all = std::max<int>(game.blocksAtStart(), 1);
    const int left = game.blocksLeft();
    canvas.text("BLOCKS LEFT  " + std::to_string(left), {kPanelLeft, Real(9.15)},
                quiet(Real(0.42)));
    const auto bar = [&](Real share, Color color) {
        const Real right = kPanelLeft + share * (kPanelRight - kPanelLeft);
        canvas.rectangle({{kPanelLeft, Real(8.65)}, {right, Real(8.87)}}, color, color);
    };
    bar(1, {255, 255, 255, 26});
    bar(static_cast<Real>(left) / static_cast<Real>(all), palette::kPaddle);
}

void paintCombo(Canvas& canvas, const Game& game) {
    if (game.combo() < 2) {
        return;
    }
    const std::string text = "combo x" + std::to_string(game.combo());
    canvas.text(text, {kPanelLeft, Real(7.55)}, strong(Real(0.7), palette::kAccent));
}

void paintLegend(Canvas& canvas) {
    struct Line {
        Power power;
        const char* text;
    };
    constexpr std::array<Line, 3> kLines = {Line{Power::Weld, "welds to paddle"},
                                            Line{Power::Launch, "sticks, then fires"},
                                            Line{Power::Split, "becomes balls"}};
    Real y = Real(5.9);
    for (const Line& line : kLines) {
        const Vec2 center{kPanelLeft + Real(0.26), y + Real(0.13)};
        paintMark(canvas, line.power, {center, {}}, Real(0.22), palette::of(line.power));
        canvas.text(line.text, {kPanelLeft + Real(0.8), y}, quiet(Real(0.42)));
        y -= Real(0.72);
    }
}

void paintKeys(Canvas& canvas, const HudLook& look) {
    if (*look.mode != '\0') {
        canvas.text(look.mode, {kPanelLeft, Real(2.6)}, strong(Real(0.5), palette::kAccent));
    }
    constexpr std::array<const char*, 4> kKeys = {"mouse or left/right", "space: serve",
                                                  "P: pause   R: restart", "M: sound on/off"};
    Real y = Real(1.85);
    for (const char* line : kKeys) {
        canvas.text(line, {kPanelLeft, y}, {Real(0.36), faded(palette::kQuiet, 0.8f)});
        y -= Real(0.52);
    }
    if (look.muted) {
        canvas.text("sound off", {kPanelLeft, Real(3.3)}, quiet(Real(0.42)));
    }
}

} // namespace

std::string grouped(int number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3 + (number < 0 ? 1u : 0u);) {
        i -= 3;
        digits.insert(i, 1, ' ');
    }
    return digits;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t letters) {
    std::vector<std::string> lines;
    std::string line;
    while (!text.empty()) {
        const std::size_t space = text.find(' ');
        const std::string_view word = text.substr(0, space);
        text = space == std::string_view::npos ? std::string_view{} : text.substr(space + 1);
        if (!line.empty() && line.size() + 1 + word.size() > letters) {
            lines.push_back(line);
            line.clear();
        }
        line += (line.empty() ? "" : " ") + std::string(word);
    }
    if (!line.empty()) {
        lines.push_back(line);
    }
    return lines;
}

void paintServeHint(Canvas& canvas, const Game& game) {
    if (!game.serving() || game.result() != Result::Playing) {
        return;
    }
    const auto line = [&](std::string_view text, Real y, Real height, Color color) {
        canvas.text(text, {Real(0.04), y - Real(0.04)},
                    {height, palette::kInk, Typeface::Bold, Align::Middle});
        canvas.text(text, {0, y}, {height, color, Typeface::Bold, Align::Middle});
    };
    Real y = Real(6.2);
    if (game.score() == 0) {
        line(game.level().title, y, Real(1.1), palette::kAccent);
        for (const std::string& part : wrapped(game.level().idea, 48)) {
            y -= Real(0.85);
            line(part, y, Real(0.52), palette::kText);
        }
    }
    const float pulse = 0.75f + 0.25f * std::sin(0.07f * static_cast<float>(game.ticks() % 12000));
    line("space or click to serve", y - Real(1.1), Real(0.5), faded(palette::kQuiet, pulse));
}

void paintHud(Canvas& canvas, const Game& game, const HudLook& look) {
    paintLevel(canvas, game, look);
    canvas.text("SCORE", {kPanelLeft, Real(12.95)}, quiet(Real(0.42)));
    canvas.text(grouped(game.score()), {kPanelLeft, Real(11.95)}, strong(Real(1.05)));
    paintLives(canvas, game);
    paintProgress(canvas, game);
    paintCombo(canvas, game);
    paintLegend(canvas);
    paintKeys(canvas, look);
}

} // namespace apart
