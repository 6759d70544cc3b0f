// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/statistics_page.hpp>

#include <fmt/format.h>

namespace apart {

namespace {

constexpr Real kLeft = Real(-12.7);  // m, of the names
constexpr Real kFirst = Real(-5.0);  // m, right end of the first column
constexpr Real kColumn = Real(2.95); // m, between columns
constexpr Real kNameRoom = kFirst - kColumn + Real(0.2) - kLeft;
constexpr Real kTopRow = Real(12.9);
constexpr Real kRowStep = Real(0.92);

std::string cellText(const TotalField& field, const PlayTotals& totals) {
    const std::int32_t value = totals.*field.value;
    if (value == 0) {
        return "-";
    }
    return field.value == &PlayTotals::seconds ? durationText(value) : grouped(value);
}

void paintRow(Canvas& canvas, Real y, std::string_view name, const PlayTotals& totals,
              Color color) {
    const bool played = totals.games > 0;
    canvas.text(name, {kLeft, y}, {Real(0.52), color, Typeface::Bold, Align::Left, kNameRoom});
    for (std::size_t i = 0; i < kTotalFields.size(); ++i) {
        canvas.text(cellText(kTotalFields[i], totals), {kFirst + kColumn * static_cast<Real>(i), y},
                    {Real(0.52), played ? palette::kText : palette::kQuiet, Typeface::Plain,
                     Align::Right, kColumn - Real(0.3)});
    }
}

} // namespace

std::string durationText(std::int32_t seconds) {
    const std::int32_t minutes = seconds / 60;
    return minutes < 60 ? fmt::format("{}:{:02}", minutes, seconds % 60)
                        : fmt::format("{}:{:02}:{:02}", minutes / 60, minutes % 60, seconds % 60);
}

void paintStatistics(Canvas& canvas, const TotalsByTheme& totals) {
    canvas.text("Records", {0, Real(15.2)},
                {Real(1.4), palette::kText, Typeface::Display, Align::Middle});
    for (std::size_t i = 0; i < kTotalFields.size(); ++i) {
        Real y = kTopRow;
        const std::vector<std::string> words = wrapped(kTotalFields[i].label, 1);
        for (auto word = words.rbegin(); word != words.rend(); ++word) { // one in each line
            canvas.text(
                *word, {kFirst + kColumn * static_cast<Real>(i), y},
                {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Right, kColumn - Real(0.3)});
            y += Real(0.65);
        }
    }
    PlayTotals all;
    Real y = kTopRow;
    for (std::size_t i = 0; i < totals.size(); ++i) {
        y -= kRowStep;
        const ThemeLook& look = lookOf(static_cast<Theme>(i));
        paintRow(canvas, y, look.title, totals[i], look.glow);
        add(all, totals[i]);
    }
    y -= Real(0.35);
    canvas.line({kLeft, y}, {-kLeft, y}, Real(0.04), faded(palette::kQuiet, 0.6f));
    paintRow(canvas, y - Real(0.85), "All themes", all, palette::kAccent);
}

} // namespace apart
