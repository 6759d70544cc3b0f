// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/level_preview.hpp>
#include <apart/stage/level_select.hpp>
#include <apart/stage/marks.hpp>
#include <apart/stage/palette.hpp>
#include <apart/stage/results.hpp>
#include <apart/stage/theme_look.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::size_t kInRow = 6;
constexpr std::size_t kRowsInSight = 4;
constexpr Real kTilesLeft = Real(-14.6);
constexpr Real kTilesTop = Real(15.5);
constexpr Vec2 kTileStep{Real(3.05), Real(3.3)}; // m, between tiles
constexpr Vec2 kTile{Real(2.8), Real(2.1)};
constexpr Real kNumber = Real(0.42); // m, height of the number of a level
constexpr Real kHeader = Real(0.75); // m, above the tiles of a row
constexpr Real kAboutLeft = Real(4.7);
constexpr Real kAboutRight = Real(14.6);
constexpr Real kPreviewBelow = Real(5.9); // m; what stands below needs so much
constexpr Vec2 kNowhere{1000, 1000};
constexpr Vec2 kHonoursFrom{Real(0.3), Real(-1.95)}; // m, from the word BEST
constexpr Real kHonourStep = Real(0.8);
constexpr Real kPureRight = 5; // m, from the column of the standard rules

std::array<Vec2, 4> cornersOf(const Aabb& box) {
    return {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
}

} // namespace

LevelSelect::LevelSelect(LevelList levels) : levels_(std::move(levels)) {
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool newTheme = i == 0 || levels_[i]->theme != levels_[i - 1]->theme;
        if (newTheme || rows_.back().count == kInRow) {
            rows_.push_back({i, 0, newTheme});
        }
        ++rows_.back().count;
    }
}

std::size_t LevelSelect::rowOf(std::size_t level) const {
    std::size_t row = 0;
    while (row + 1 < rows_.size() && rows_[row + 1].first <= level) {
        ++row;
    }
    return row;
}

Real LevelSelect::rowTop(std::size_t row) const {
    return kTilesTop - kTileStep.y * (static_cast<Real>(row) - static_cast<Real>(topRow_));
}

Aabb LevelSelect::tile(std::size_t level) const {
    const std::size_t row = rowOf(level);
    if (row < topRow_ || row >= topRow_ + kRowsInSight) {
        return {kNowhere, kNowhere};
    }
    const auto column = static_cast<Real>(level - rows_[row].first);
    const Vec2 lower{kTilesLeft + kTileStep.x * column, rowTop(row) - kHeader - kTile.y};
    return {lower, lower + kTile};
}

Aabb LevelSelect::backPlace() const {
    return {{kTilesLeft, Real(0.2)}, {kTilesLeft + Real(4), Real(1.2)}};
}

Aabb LevelSelect::editPlace() const {
    return {{kTilesLeft + Real(5.4), Real(0.2)}, {kTilesLeft + Real(7.4), Real(1.2)}};
}

Aabb LevelSelect::newPlace() const {
    return {{kTilesLeft + Real(7.5), Real(0.2)}, {kTilesLeft + Real(9.5), Real(1.2)}};
}

bool LevelSelect::wants(const Signals& signals, const Aabb& place, const char* key) {
    const Press press{false, keyNamed(key).value_or(kNoKey)};
    return (signals.clicked && place.contains(signals.pointerNow)) ||
           std::count(signals.presses.begin(), signals.presses.end(), press) > 0;
}

Aabb LevelSelect::upPlace() const {
    const Real middle = kTilesLeft + Real(0.5) * kInRow * kTileStep.x;
    return {{middle - Real(0.8), kTilesTop - Real(0.7)},
            {middle + Real(0.8), kTilesTop + Real(0.2)}};
}

Aabb LevelSelect::downPlace() const {
    const Vec2 shift{0, -kTileStep.y * static_cast<Real>(kRowsInSight)};
    return {upPlace().lower + shift, upPlace().upper + shift};
}

bool LevelSelect::scroll(Vec2 click) {
    if (topRow_ > 0 && upPlace().contains(click)) {
        choose(rows_[topRow_ - 1].first);
        return true;
    }
    if (topRow_ + kRowsInSight < rows_.size() && downPlace().contains(click)) {
        choose(rows_[topRow_ + kRowsInSight].first);
        return true;
    }
    return false;
}

void LevelSelect::choose(std::size_t level) {
    chosen_ = std::min(level, levels_.size() - 1);
    const std::size_t row = rowOf(chosen_);
    topRow_ = std::min(topRow_, row);
    if (row >= topRow_ + kRowsInSight) {
        topRow_ = row + 1 - kRowsInSight;
    }
}

void LevelSelect::move(Command command) {
    const std::size_t row = rowOf(chosen_);
    const std::size_t column = chosen_ - rows_[row].first;
    const auto inRow = [&](std::size_t other) {
        return rows_[other].first + std::min(column, rows_[other].count - 1);
    };
    if (command == Command::Left && chosen_ > 0) {
        choose(chosen_ - 1);
    } else if (command == Command::Right && chosen_ + 1 < levels_.size()) {
        choose(chosen_ + 1);
    } else if (command == Command::Up && row > 0) {
        choose(inRow(row - 1));
    } else if (command == Command::Down && row + 1 < rows_.size()) {
        choose(inRow(row + 1));
    }
}

std::optional<std::size_t> LevelSelect::take(const Signals& signals) {
    const auto under = [&](Vec2 place) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            if (tile(i).contains(place)) {
                return i;
            }
        }
        return std::nullopt;
    };
    if (signals.pointer) {
        pointer_ = *signals.pointer;
        chosen_ = under(*signals.pointer).value_or(chosen_);
    }
    for (const Command command : signals.commands) {
        if (command == Command::Launch || command == Command::Confirm) {
            return chosen_;
        }
        move(command);
    }
    if (!signals.clicked || scroll(signals.pointerNow)) {
        return std::nullopt;
    }
    return under(signals.pointerNow);
}

void LevelSelect::drawTile(Canvas& canvas, std::size_t level, const Records& records) const {
    const std::string& name = levels_[level]->name;
    const Mode mode = records.profile().mode;
    const Aabb box = tile(level);
    const bool chosen = level == chosen_;
    const Color rim = chosen ? palette::kAccent : faded(palette::kQuiet, 0.45f);
    canvas.polygon(cornersOf(box), {10, 12, 24, 190});
    paintPreview(canvas, *levels_[level], box.grown(Real(-0.18)));
    canvas.outline(cornersOf(box), chosen ? Real(0.09) : Real(0.04), rim);
    canvas.text(std::to_string(level + 1), {box.lower.x + Real(0.18), box.lower.y + Real(0.17)},
                {kNumber, chosen ? palette::kAccent : palette::kQuiet, Typeface::Bold});
    // From the right edge on; closer together where the number leaves less room.
    const MedalMarks* marks = marksFor(name, records.marks());
    const auto gaps = static_cast<Real>(honourNames(*levels_[level], marks).size() - 1);
    const Real room = kTile.x - Real(0.7) - Real(1.4) * kNumber * canvas.textScale();
    const Real step = std::min(Real(0.37), room / std::max(gaps, Real(1)));
    paintHonours(canvas, {box.upper.x - Real(0.3) - step * gaps, box.lower.y + Real(0.33)},
                 {step, 0}, Real(0.405) * step,
                 {records.honoursOf(mode, name), *levels_[level], marks});
    paintMedal(canvas, box.upper - Vec2{Real(0.36), Real(0.36)}, Real(0.24),
               records.medalOf(mode, name));
}

/// Best score and honours of the chosen level. An unproved score is dim, with its reason.
void LevelSelect::drawBest(Canvas& canvas, const Records& records, Mode mode, Vec2 place) const {
    const std::string& level = levels_[chosen_]->name;
    const Standing standing = records.standingOf(mode, level);
    const bool counts = mode == records.profile().mode;
    const bool proved = standing.proof == Proof::Proved;
    const Medal medal = records.medalOf(mode, level);
    const std::int32_t next = nextMark(proved ? standing.score : 0, level, records.marks());
    const bool shown = standing.proof != Proof::None && standing.proof != Proof::Missing &&
                       standing.score != kUnreadScore;
    const bool offersMedal = counts && next > 0;
    const bool noted = !standing.note.empty(); // in the place of the next medal
    canvas.text(mode == Mode::Pure ? "BEST, PURE" : "BEST", place,
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
    paintHonours(canvas, place + kHonoursFrom, {kHonourStep, 0}, Real(0.26),
                 {records.honoursOf(mode, level), *levels_[chosen_], marks});
}

/// The name of the honour under the pointer, else of those that this level offers beyond the usual
/// ones. `place`: of the column of the standard rules.
void LevelSelect::drawHonourNames(Canvas& canvas, const Records& records, Vec2 place) const {
    const Level& level = *levels_[chosen_];
    const std::vector<std::string> names =
        honourNames(level, marksFor(level.name, records.marks()));
    std::string text;
    for (std::size_t i = kUsualHonours; i < names.size(); ++i) {
        text += (text.empty() ? "" : ", ") + names[i];
    }
    for (const Real right : {Real(0), kPureRight}) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const Vec2 icon =
                place + kHonoursFrom + Vec2{right + kHonourStep * static_cast<Real>(i), 0};
            if (lengthSquared(pointer_ - icon) < kHonourStep * kHonourStep / 4) {
                text = names[i];
            }
        }
    }
    canvas.text(
        shortened(text, 60), place + Vec2{0, Real(-2.75)},
        {Real(0.4), palette::kQuiet, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
}

void LevelSelect::drawChosen(Canvas& canvas, const Records& records, double seconds) const {
    const Level& level = *levels_[chosen_];
    const ThemeLook& look = lookOf(level.theme);
    canvas.text(fmt::format("LEVEL {}   {}", chosen_ + 1, look.title), {kAboutLeft, Real(14.9)},
                {Real(0.42), look.glow, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
    Real y = Real(13.8);
    for (const std::string& line : wrappedInto(2, level.title, 14, 24)) {
        canvas.text(
            line, {kAboutLeft, y},
            {Real(0.9), palette::kText, Typeface::Display, Align::Left, kAboutRight - kAboutLeft});
        y -= Real(1.05);
    }
    for (const std::string& line : wrappedInto(5, level.idea, fitting(canvas, 38), 42)) {
        canvas.text(
            line, {kAboutLeft, y},
            {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
        y -= Real(0.66) + Real(0.1) * (canvas.textScale() - 1);
    }
    const Aabb box{{kAboutLeft, std::max(y - Real(4.9), kPreviewBelow)},
                   {kAboutRight, y - Real(0.1)}};
    canvas.polygon(cornersOf(box), {10, 12, 24, 190});
    paintPreview(canvas, level, box.grown(Real(-0.25)));
    y = box.lower.y - Real(0.65);
    Real x = kAboutLeft + Real(0.3);
    for (const Power power : powersOf(level)) {
        const double phase = 3 * seconds + static_cast<double>(x);
        const auto rise = static_cast<Real>(0.05 * std::sin(phase));
        paintMark(canvas, power, {{x, y + rise}, {}}, Real(0.26), canvas.palette().of(power));
        x += Real(0.8);
    }
    y -= Real(1.1);
    drawBest(canvas, records, Mode::Standard, {kAboutLeft, y});
    drawBest(canvas, records, Mode::Pure, {kAboutLeft + kPureRight, y});
    drawHonourNames(canvas, records, {kAboutLeft, y});
}

void LevelSelect::drawFoot(Canvas& canvas, const Records& records) const {
    int cleared = 0;
    std::int64_t points = 0;
    bool checks = false; // some scores are not checked yet
    for (const auto& level : levels_) {
        const Mode mode = records.profile().mode;
        const Standing standing = records.standingOf(mode, level->name);
        cleared += records.honoursOf(mode, level->name).cleared ? 1 : 0;
        points += standing.proof == Proof::Proved ? standing.score : 0;
        checks = checks || standing.proof == Proof::Waiting;
    }
    const Aabb back = backPlace();
    canvas.text("\u2039 back (escape)", {back.lower.x, back.lower.y + Real(0.35)},
                {Real(0.46), palette::kText, Typeface::Plain, Align::Left, Real(5.2)});
    const auto offer = [&](const Aabb& place, const char* text) {
        canvas.text(text, {place.lower.x, place.lower.y + Real(0.35)},
                    {Real(0.46), palette::kText, Typeface::Plain, Align::Left,
                     place.extent().x - Real(0.1)});
    };
    offer(editPlace(), "edit (E)");
    offer(newPlace(), "new (N)");
    canvas.text(
        fmt::format("{} of {} cleared, {} {}", cleared, levels_.size(),
                    countText(std::min<std::int64_t>(points, 999999999), "point"),
                    checks ? "so far, more are checked" : "in all"),
        {kAboutLeft, back.lower.y + Real(0.35)},
        {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
}

void LevelSelect::drawArrows(Canvas& canvas) const {
    const TextStyle style{Real(0.6), palette::kText, Typeface::Plain, Align::Middle};
    const auto foot = [](const Aabb& box) {
        return Vec2{box.center().x, box.lower.y + Real(0.25)};
    };
    if (topRow_ > 0) {
        canvas.text("\u25b2", foot(upPlace()), style);
    }
    if (topRow_ + kRowsInSight < rows_.size()) {
        canvas.text("\u25bc", foot(downPlace()), style);
    }
}

void LevelSelect::draw(Canvas& canvas, const Records& records, double seconds) const {
    const Profile& profile = records.profile();
    const bool pure = profile.mode == Mode::Pure;
    canvas.text(pure ? "Choose a level (pure)" : "Choose a level", {kTilesLeft, Real(16.6)},
                {Real(1.2), palette::kText, Typeface::Display});
    const std::size_t end = std::min(topRow_ + kRowsInSight, rows_.size());
    for (std::size_t row = topRow_; row < end; ++row) {
        const Row& levels = rows_[row];
        if (levels.newTheme) {
            const ThemeLook& theme = lookOf(levels_[levels.first]->theme);
            canvas.text(theme.title, {kTilesLeft, rowTop(row) - Real(0.5)},
                        {Real(0.46), theme.glow, Typeface::Bold, Align::Left, Real(8)});
        }
        for (std::size_t i = levels.first; i < levels.first + levels.count; ++i) {
            drawTile(canvas, i, records);
        }
    }
    drawArrows(canvas);
    drawChosen(canvas, records, seconds);
    drawFoot(canvas, records);
}

} // namespace apart
