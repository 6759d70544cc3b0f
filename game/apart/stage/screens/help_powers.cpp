// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/help_powers.hpp>

#include <array>
#include <string>
#include <string_view>

namespace apart {

namespace {

constexpr std::size_t kAcross = 3;
constexpr Vec2 kStep{Real(10.1), Real(3.5)}; // m, between powers
constexpr Vec2 kFirst{Real(-14.2), Real(13.7)};
constexpr Real kWordsLeft = Real(1.9); // m, from the left edge of a power
constexpr Real kTextRoom = Real(7.9);  // m
constexpr std::size_t kLetters = 34;   // of a line

/// Effect of a power, for the player. Those of balls and paddle last 15 s (kEffectTicks).
std::string_view effectOf(Power power) {
    constexpr std::array<std::string_view, kPowerNames.size()> kEffects = {
        "",
        "the part is welded to the paddle where it is caught",
        "the part sticks to the paddle, then flies straight up",
        "nothing to catch: the block breaks into balls",
        "balls have three times the mass and hit harder",
        "the mass of balls is off their middle: impacts spin them",
        "balls are eggs and bounce askew",
        "balls have friction: they spin, and bounce by their spin",
        "the paddle draws balls and parts in",
        "the paddle recoils; serve makes it leap",
        "two plates make the paddle wider",
        "the place of the block attracts balls and shards",
        "wind blows across the field, to either side",
    };
    return kEffects[static_cast<std::size_t>(power)];
}

void paintPower(Canvas& canvas, Power power, Vec2 corner) {
    const Color color = canvas.palette().of(power);
    const Vec2 middle = corner + Vec2{Real(0.9), Real(-0.1)};
    paintMood(canvas, moodOf(power), middle, {Real(0.62), {12, 14, 26, 235}, color, Real(0.08)});
    paintMark(canvas, power, {middle, {}}, Real(0.4), color);
    Vec2 place = corner + Vec2{kWordsLeft, 0};
    canvas.text(kPowerNames[static_cast<std::size_t>(power)], place,
                {Real(0.56), color, Typeface::Bold, Align::Left, kTextRoom});
    const Real pitch = Real(0.62) * canvas.textScale();
    place.y -= Real(0.1);
    for (const std::string& line : wrappedInto(3, effectOf(power), fitting(canvas, kLetters))) {
        place.y -= pitch;
        canvas.text(line, place,
                    {Real(0.42), palette::kText, Typeface::Plain, Align::Left, kTextRoom});
    }
}

} // namespace

void paintPowersPage(Canvas& canvas) {
    canvas.text("The powers", {0, Real(17.3)},
                {Real(1.2), palette::kText, Typeface::Display, Align::Middle});
    canvas.text("A block with a mark drops a part. Disc: good; square: mixed; triangle: bad.",
                {0, Real(15.9)},
                {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Middle, Real(29)});
    for (std::size_t i = 1; i < kPowerNames.size(); ++i) {
        const Vec2 place{static_cast<Real>((i - 1) % kAcross),
                         static_cast<Real>((i - 1) / kAcross)};
        paintPower(canvas, static_cast<Power>(i),
                   kFirst + Vec2{kStep.x * place.x, -kStep.y * place.y});
    }
}

} // namespace apart
