// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/painters/level_preview.hpp>
#include <apart/stage/screens/level_about.hpp>
#include <apart/stage/screens/results.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Real kPreviewBelow = Real(6.45);           // m; what stands below needs so much
constexpr Vec2 kHonoursFrom{Real(0.3), Real(-1.95)}; // m, from the word BEST
constexpr Real kOtherRight = 5;                      // m, from the column of the standard rules

/// From one honour to the next (m): all of them stay in their column.
Real honourStep(std::size_t count) {
    constexpr Real kRoom = Real(4.7); // m
    return std::min(Real(0.8), kRoom / static_cast<Real>(count));
}

std::array<Vec2, 4> cornersOf(const Aabb& box) {
    return {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
}

/// Best score and honours of the chosen level. An unproved score is dim, with its reason.
void paintBest(Canvas& canvas, const AboutLook& look, Mode mode, Vec2 place) {
    const Records& records = look.records;
    const std::string& level = look.level.name;
    const Standing standing = records.standingOf(mode, level);
    const bool counts = mode == records.profile().mode;
    const bool proved = standing.proof == Proof::Proved;
    const Medal medal = records.medalOf(mode, level);
    const std::int32_t next = nextMark(proved ? standing.score : 0, level, records.marks());
    const bool shown = standing.proof != Proof::None && standing.proof != Proof::Missing &&
                       standing.score != kUnreadScore;
    const bool offersMedal = counts && next > 0;
    const bool noted = !standing.note.empty(); // in the place of the next medal
    constexpr std::array<std::string_view, kModeNames.size()> kTitles = {"BEST", "BEST, PURE",
                                                                         "BEST, ASSISTED"};
    canvas.text(kTitles[static_cast<std::size_t>(mode)], place,
                {Real(0.4), counts ? palette::kAccent : palette::kQuiet, Typeface::Plain,
                 Align::Left, offersMedal && noted ? Real(2.2) : Real(4.7)});
    // Larger letters need room above and below the score.
    const Real larger = canvas.textScale() - 1;
    const Vec2 below{0, Real(-1.4) - Real(0.15) * larger};
    canvas.text(shown ? grouped(standing.score) : "-", place - Vec2{0, Real(0.95)},
                {Real(0.8) - Real(0.25) * larger, proved ? palette::kText : palette::kQuiet,
                 Typeface::Bold, Align::Left, Real(3.1)});
    paintMedal(canvas, place + Vec2{Real(3.6), Real(-0.62)}, Real(0.36), medal);
    if (offersMedal) {
        canvas.text(
            fmt::format("{} {}", kMedalNames[static_cast<std::size_t>(medal) + 1], grouped(next)),
            place + (noted ? Vec2{Real(4.7), 0} : below),
            {Real(0.4), palette::kQuiet, Typeface::Plain, noted ? Align::Right : Align::Left,
             noted ? Real(2.3) : Real(4.7)});
    }
    const std::string note = standing.proof == Proof::Missing
                                 ? fmt::format("{}: {}", grouped(standing.score), standing.note)
                                 : standing.note;
    canvas.text(note, place + below,
                {Real(0.36), palette::kQuiet, Typeface::Plain, Align::Left, Real(4.7)});
    const MedalMarks* marks = marksFor(level, records.marks());
    const Real step = honourStep(honourNames(look.level, marks).size());
    paintHonours(canvas, place + kHonoursFrom, {step, 0}, std::min(Real(0.26), Real(0.38) * step),
                 {records.honoursOf(mode, level), look.level, marks});
}

/// The name of the honour under the pointer, else of those that this level offers beyond the usual
/// ones. `place`: of the column of the standard rules.
void paintHonourNames(Canvas& canvas, const AboutLook& look, Vec2 place) {
    const Level& level = look.level;
    const std::vector<std::string> names =
        honourNames(level, marksFor(level.name, look.records.marks()));
    std::string text;
    for (std::size_t i = usualHonours(level); i < names.size(); ++i) {
        text += (text.empty() ? "" : ", ") + names[i];
    }
    const Real step = honourStep(names.size());
    for (const Real right : {Real(0), kOtherRight}) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const Vec2 icon = place + kHonoursFrom + Vec2{right + step * static_cast<Real>(i), 0};
            if (lengthSquared(look.pointer - icon) < step * step / 4) {
                text = names[i];
            }
        }
    }
    const std::vector<std::string> lines =
        wrappedInto(canvas.textScale() > 1 ? 1 : 2, text, 44, 60);
    const Real height = evenHeight(canvas, lines, Real(0.4), kAboutRight - kAboutLeft);
    Real y = place.y - Real(2.75);
    for (const std::string& line : lines) {
        canvas.text(
            line, {place.x, y},
            {height, palette::kQuiet, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
        y -= Real(0.55);
    }
}

} // namespace

void paintAbout(Canvas& canvas, const AboutLook& look) {
    const Level& level = look.level;
    const ThemeLook& theme = lookOf(level.theme);
    canvas.text(
        fmt::format("{} {}   {}", look.stop.boss ? "BOSS" : "LEVEL", look.number, theme.title),
        {kAboutLeft, Real(14.9)},
        {Real(0.42), theme.glow, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
    Real y = Real(13.8);
    for (const std::string& line : wrappedInto(2, level.title, 14, 24)) {
        canvas.text(
            line, {kAboutLeft, y},
            {Real(0.9), palette::kText, Typeface::Display, Align::Left, kAboutRight - kAboutLeft});
        y -= Real(1.05);
    }
    const bool open = look.stop.open();
    const std::string idea = open ? level.idea : look.stop.asks();
    for (const std::string& line : wrappedInto(5, idea, fitting(canvas, 38), 42)) {
        canvas.text(line, {kAboutLeft, y},
                    {Real(0.46), open ? palette::kQuiet : palette::kAccent, Typeface::Plain,
                     Align::Left, kAboutRight - kAboutLeft});
        y -= Real(0.66) + Real(0.1) * (canvas.textScale() - 1);
    }
    const Aabb box{{kAboutLeft, std::max(y - Real(4.9), kPreviewBelow)},
                   {kAboutRight, y - Real(0.1)}};
    canvas.polygon(cornersOf(box), {10, 12, 24, 190});
    paintPreview(canvas, level, box.grown(Real(-0.25)));
    if (!open) {
        canvas.polygon(cornersOf(box), faded(palette::kNight, 0.8f));
    }
    y = box.lower.y - Real(0.65);
    Real x = kAboutLeft + Real(0.3);
    for (const Power power : powersOf(level)) {
        const double phase = 3 * look.seconds + static_cast<double>(x);
        const auto rise = static_cast<Real>(0.05 * std::sin(phase));
        paintMark(canvas, power, {{x, y + rise}, {}}, Real(0.26), canvas.palette().of(power));
        x += Real(0.8);
    }
    y -= Real(1.1);
    paintBest(canvas, look, Mode::Standard, {kAboutLeft, y});
    const Mode mode = look.records.profile().mode;
    paintBest(canvas, look, mode == Mode::Assisted ? mode : Mode::Pure,
              {kAboutLeft + kOtherRight, y});
    paintHonourNames(canvas, look, {kAboutLeft, y});
}

} // namespace apart
