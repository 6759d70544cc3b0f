// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/painters/level_preview.hpp>
#include <apart/stage/painters/map_scenery.hpp>
#include <apart/stage/screens/level_about.hpp>
#include <apart/stage/screens/level_map.hpp>
#include <apart/stage/screens/results.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Aabb kLands{{Real(-14.9), Real(1.5)}, {Real(4.2), Real(15.4)}};
constexpr std::size_t kMostBands = 7; // of the usual height
constexpr std::size_t kInSight = 12;  // levels of a band
constexpr Real kMargin = Real(1.3);   // m, from the first level of a band to the edge
constexpr Vec2 kNowhere{1000, 1000};
constexpr Real kFingerReach = 1; // m; a finger that misses a circle by less hits the nearest one

// Shares of the height of a band.
constexpr Real kWayUp = Real(0.58);
constexpr Real kZigzag = Real(0.07);
constexpr Real kRadius = Real(0.21);
constexpr Real kBossRadius = Real(0.35);

/// A curve through all points (Catmull-Rom), as a polyline.
std::vector<Vec2> curveThrough(const std::vector<Vec2>& points) {
    constexpr int kPieces = 8; // from one point to the next
    std::vector<Vec2> curve;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 a = points[i == 0 ? 0 : i - 1];
        const Vec2 b = points[i];
        const Vec2 c = points[i + 1];
        const Vec2 d = points[std::min(i + 2, points.size() - 1)];
        for (int k = 0; k < kPieces; ++k) {
            const Real t = static_cast<Real>(k) / kPieces;
            curve.push_back(Real(0.5) * (Real(2) * b + t * (c - a) +
                                         t * t * (Real(2) * a - Real(5) * b + Real(4) * c - d) +
                                         t * t * t * (Real(3) * b - a - Real(3) * c + d)));
        }
    }
    return curve;
}

} // namespace

LevelMap::LevelMap(LevelList levels, const Campaign& campaign) : campaign_(campaign) {
    setLevels(std::move(levels));
}

void LevelMap::setLevels(LevelList levels) {
    levels_ = std::move(levels);
    stops_.assign(levels_.size(), {});
    bands_.clear();
    const std::size_t own = campaign_.own;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool newTheme = i > 0 && i < own && levels_[i]->theme != levels_[i - 1]->theme;
        if (i == 0 || i == own || newTheme) {
            bands_.push_back({i, 0, i >= own, i});
        }
        ++bands_.back().count;
    }
    choose(chosen_);
}

void LevelMap::update(const Records& records) {
    Campaign campaign = campaign_;
    campaign.open = campaign.open || records.profile().settings.openLevels > 0;
    stops_ = stopsOf(levels_, campaign, records.profile(), records.marks());
}

std::size_t LevelMap::nextLevel(const Records& records) {
    update(records);
    return nextToPlay(levels_, stops_, records.profile(), records.marks());
}

bool LevelMap::isLastBoss(std::size_t level) const {
    const auto isBoss = [](const Stop& stop) { return stop.boss; };
    const auto after = stops_.begin() + static_cast<std::ptrdiff_t>(level) + 1;
    return stops_[level].boss && std::none_of(after, stops_.end(), isBoss);
}

std::size_t LevelMap::bandOf(std::size_t level) const {
    std::size_t band = 0;
    while (band + 1 < bands_.size() && bands_[band + 1].first <= level) {
        ++band;
    }
    return band;
}

Aabb LevelMap::boxOf(std::size_t band) const {
    const Real height = kLands.extent().y / static_cast<Real>(std::max(bands_.size(), kMostBands));
    const Real bottom = kLands.lower.y + height * static_cast<Real>(band);
    return {{kLands.lower.x, bottom}, {kLands.upper.x, bottom + height}};
}

bool LevelMap::isOpen(std::size_t band) const {
    const auto first = stops_.begin() + static_cast<std::ptrdiff_t>(bands_[band].first);
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(bands_[band].count),
                       [](const Stop& stop) { return stop.open(); });
}

std::size_t LevelMap::countShown(const Band& band) const {
    return std::min(band.count, kInSight);
}

Real LevelMap::radiusOf(std::size_t level) const {
    return boxOf(0).extent().y * (stops_[level].boss ? kBossRadius : kRadius);
}

std::optional<Vec2> LevelMap::placeOf(std::size_t level) const {
    const std::size_t index = bandOf(level);
    const Band& band = bands_[index];
    const std::size_t count = countShown(band);
    if (level < band.shown || level >= band.shown + count) {
        return std::nullopt;
    }
    const Aabb box = boxOf(index);
    const std::size_t i = level - band.shown;
    const Real room = box.extent().x - 2 * kMargin;
    const Real along = count == 1 ? Real(0.5) : static_cast<Real>(i) / static_cast<Real>(count - 1);
    const Real x = index % 2 == 0 ? along : 1 - along;
    const Real zigzag = stops_[level].boss ? 0 : i % 2 == 0 ? -kZigzag : kZigzag;
    return box.lower + Vec2{kMargin + room * x, (kWayUp + zigzag) * box.extent().y};
}

Aabb LevelMap::tile(std::size_t level) const {
    const Vec2 place = placeOf(level).value_or(kNowhere);
    return Aabb{place, place}.grown(radiusOf(level));
}

Aabb LevelMap::backPlace() const {
    return {{Real(-14.6), 0}, {Real(-10.6), Real(1.4)}};
}

Aabb LevelMap::editPlace() const {
    return {{Real(-9.2), 0}, {Real(-7.2), Real(1.4)}};
}

Aabb LevelMap::newPlace() const {
    return {{Real(-7.1), 0}, {Real(-5.1), Real(1.4)}};
}

bool LevelMap::wants(const Signals& signals, const Aabb& place, const char* key) {
    const Press press{false, keyNamed(key).value_or(kNoKey)};
    return (signals.clicked && place.contains(signals.pointerNow)) ||
           std::count(signals.presses.begin(), signals.presses.end(), press) > 0;
}

void LevelMap::choose(std::size_t level) {
    chosen_ = std::min(level, levels_.size() - 1);
    Band& band = bands_[bandOf(chosen_)];
    const std::size_t count = countShown(band);
    band.shown = std::min(band.shown, chosen_);
    band.shown = std::max(band.shown + count, chosen_ + 1) - count;
}

/// To the nearest level of the band above or below.
void LevelMap::moveAcross(bool up) {
    const std::size_t band = bandOf(chosen_);
    if (up ? band + 1 == bands_.size() : band == 0) {
        return;
    }
    const Band& other = bands_[up ? band + 1 : band - 1];
    const Real x = placeOf(chosen_).value_or(Vec2{}).x;
    const auto distance = [&](std::size_t level) {
        return std::abs(placeOf(level).value_or(kNowhere).x - x);
    };
    std::size_t nearest = other.shown;
    for (std::size_t i = other.shown; i < other.shown + countShown(other); ++i) {
        nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    choose(nearest);
}

/// Left and right follow the way, also where it turns into the next band.
void LevelMap::move(Command command) {
    const bool forth = (command == Command::Right) == (bandOf(chosen_) % 2 == 0);
    if (command == Command::Up || command == Command::Down) {
        moveAcross(command == Command::Up);
    } else if (command == Command::Left || command == Command::Right) {
        choose(forth ? chosen_ + 1 : chosen_ - std::min<std::size_t>(chosen_, 1));
    }
}

std::optional<std::size_t> LevelMap::take(const Signals& signals) {
    const auto under = [&](Vec2 place) -> std::optional<std::size_t> {
        const auto distance = [&](std::size_t level) {
            return length(placeOf(level).value_or(kNowhere) - place);
        };
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < levels_.size(); ++i) {
            nearest = distance(i) < distance(nearest) ? i : nearest;
        }
        return distance(nearest) < kFingerReach ? std::optional(nearest) : std::nullopt;
    };
    const auto ifOpen = [&](std::optional<std::size_t> level) {
        return level && stops_[*level].open() ? level : std::nullopt;
    };
    if (signals.pointer) {
        pointer_ = *signals.pointer;
        chosen_ = under(*signals.pointer).value_or(chosen_);
    }
    for (const Command command : signals.commands) {
        if (command == Command::Launch || command == Command::Confirm) {
            return ifOpen(chosen_);
        }
        move(command);
    }
    return signals.clicked ? ifOpen(under(signals.pointerNow)) : std::nullopt;
}

/// The way through all levels of the game: lit as far as it is open.
void LevelMap::drawWay(Canvas& canvas) const {
    std::vector<Vec2> places;
    std::size_t lit = 0; // places that are open without a gap
    for (std::size_t i = 0; i < levels_.size() && !bands_[bandOf(i)].own; ++i) {
        if (const std::optional<Vec2> place = placeOf(i)) {
            lit += lit == places.size() && stops_[i].open() ? 1 : 0;
            places.push_back(*place);
        }
    }
    const Real width = Real(0.11) * boxOf(0).extent().y;
    if (places.size() > 1) {
        const std::vector<Vec2> whole = curveThrough(places);
        canvas.ribbon(whole, Real(1.5) * width, faded(palette::kInk, 0.8f));
        canvas.ribbon(whole, width, {58, 60, 80});
    }
    if (lit > 1) {
        places.resize(lit);
        canvas.ribbon(curveThrough(places), width, mix(palette::kAccent, {120, 84, 50}, 0.25f));
    }
}

void LevelMap::drawStop(Canvas& canvas, std::size_t level, const Records& records,
                        double seconds) const {
    const std::optional<Vec2> found = placeOf(level);
    if (!found) {
        return;
    }
    const Vec2 place = *found;
    const Stop& stop = stops_[level];
    const Real radius = radiusOf(level);
    const ThemeLook& look = lookOf(levels_[level]->theme);
    const bool won = isWon(*levels_[level], records.profile());
    const bool chosen = level == chosen_;
    const Color rim = chosen ? palette::kAccent : stop.open() ? look.glow : Color{64, 68, 92};
    if (stop.open() && !won) { // it waits
        const auto pulse = static_cast<float>(0.5 + 0.5 * std::sin(3 * seconds));
        canvas.setGlow(true);
        canvas.disc(place, Real(1.9) * radius, faded(look.glow, 0.25f + 0.3f * pulse),
                    faded(look.glow, 0));
        canvas.setGlow(false);
    }
    const Color inside = !stop.open() ? Color{26, 28, 44}
                         : won        ? mix(look.dusk, look.frame, 0.7f)
                                      : darker(look.glow, 0.55f);
    canvas.disc(place, radius, lighter(inside, 0.12f), inside);
    canvas.ring(place, radius, Real(chosen ? 0.09 : 0.055), rim);
    if (stop.boss) {
        paintCrown(canvas, place + Vec2{0, Real(1.02) * radius}, Real(0.42) * radius, rim);
    }
    if (stop.boss && stop.open()) {
        paintPreview(canvas, *levels_[level], Aabb{place, place}.grown(Real(0.66) * radius));
    } else if (stop.open()) {
        const Real height = Real(0.95) * radius / std::max(canvas.textScale() * Real(0.9), Real(1));
        canvas.text(std::to_string(level + 1), place - Vec2{0, Real(0.32) * height},
                    {height, palette::kText, Typeface::Bold, Align::Middle, Real(1.5) * radius});
    } else {
        paintLock(canvas, place, Real(0.45) * radius, {110, 116, 146});
    }
    paintMedal(canvas, place + radius * Vec2{Real(0.8), Real(0.75)},
               Real(0.12) * boxOf(0).extent().y,
               static_cast<Medal>(medalsOf(*levels_[level], records.profile(), records.marks())));
    if (chosen) {
        canvas.ring(place, radius + Real(0.14), Real(0.05), faded(palette::kAccent, 0.7f));
    }
}

/// Name and medals of a theme, and what its boss asks for, below the way.
void LevelMap::drawNames(Canvas& canvas, std::size_t index, const Records& records) const {
    const Band& band = bands_[index];
    const Aabb box = boxOf(index);
    int won = 0;
    int most = 0;
    const Stop* boss = nullptr;
    for (std::size_t i = band.first; i < band.first + band.count; ++i) {
        won += medalsOf(*levels_[i], records.profile(), records.marks());
        most += mostMedalsOf(*levels_[i], records.marks());
        boss = stops_[i].boss ? &stops_[i] : boss;
    }
    const ThemeLook& look = lookOf(levels_[band.first]->theme);
    const bool open = isOpen(index);
    const std::string name = band.own ? "Your levels" : std::string(look.title);
    const std::string after = stops_[band.first].after ? stops_[band.first].after->title : "";
    const bool right = index % 2 == 0; // direction of the way
    const Real y = box.lower.y + Real(0.07) * box.extent().y;
    const Real edge = Real(0.35);
    const Real inside = kMargin + Real(0.6); // beside the way from the band below
    canvas.text(open ? fmt::format("{}   {} of {}", name, won, most)
                     : fmt::format("{}   after {}", name, shortened(after, 24)),
                {right ? box.lower.x + inside : box.upper.x - inside, y},
                {Real(0.4), open ? look.glow : Color{120, 126, 156}, Typeface::Bold,
                 right ? Align::Left : Align::Right, Real(9)});
    if (boss != nullptr && open && !boss->open()) {
        canvas.text("boss: " + countText(boss->medals, "more medal"),
                    {right ? box.upper.x - edge : box.lower.x + edge, y},
                    {Real(0.36), palette::kText, Typeface::Plain,
                     right ? Align::Right : Align::Left, Real(5)});
    }
}

void LevelMap::drawHead(Canvas& canvas, const Records& records) const {
    const Mode mode = records.profile().mode;
    const std::string_view name = kModeNames[static_cast<std::size_t>(mode)];
    const std::string by = mode == Mode::Standard ? "" : fmt::format(" ({})", name);
    canvas.text((duel_ ? "Duel" : "Map") + by, {Real(-14.6), Real(16.6)},
                {Real(1.2), palette::kText, Typeface::Display});
    std::array<int, kMedalNames.size()> counts{};
    for (std::size_t i = 0; i < levels_.size() && !bands_[bandOf(i)].own; ++i) {
        const int medals = medalsOf(*levels_[i], records.profile(), records.marks());
        ++counts[static_cast<std::size_t>(medals)];
    }
    for (std::size_t i = 1; i < counts.size(); ++i) {
        const Real x = Real(-1.6) + Real(1.9) * static_cast<Real>(i - 1);
        paintMedal(canvas, {x, Real(16.95)}, Real(0.28), static_cast<Medal>(i));
        canvas.text(std::to_string(counts[i]), {x + Real(0.45), Real(16.78)},
                    {Real(0.5), palette::kText, Typeface::Bold, Align::Left, Real(1)});
    }
}

void LevelMap::drawFoot(Canvas& canvas, const Records& records) const {
    int cleared = 0;
    std::int64_t points = 0;
    bool checks = false; // some scores are not checked yet
    const Mode mode = records.profile().mode;
    for (const auto& level : levels_) {
        const Standing standing = records.standingOf(mode, level->name);
        cleared += records.isCleared(level->name) ? 1 : 0; // as for medals: in any mode
        points += standing.proof == Proof::Proved ? standing.score : 0;
        checks = checks || standing.proof == Proof::Waiting;
    }
    const Aabb back = backPlace();
    const bool fingers = records.profile().bindings.fingers;
    canvas.text(fingers ? "\u2039 back" : "\u2039 back (escape)",
                {back.lower.x, back.lower.y + Real(0.55)},
                {Real(0.46), palette::kText, Typeface::Plain, Align::Left, Real(5.2)});
    const auto offer = [&](const Aabb& place, const char* text) {
        canvas.text(text, {place.lower.x, place.lower.y + Real(0.55)},
                    {Real(0.46), palette::kText, Typeface::Plain, Align::Left,
                     place.extent().x - Real(0.1)});
    };
    offer(editPlace(), fingers ? "edit" : "edit (E)");
    offer(newPlace(), fingers ? "new" : "new (N)");
    const std::string rules =
        mode == Mode::Standard
            ? "in all"
            : fmt::format("by {} rules", kModeNames[static_cast<std::size_t>(mode)]);
    canvas.text(
        fmt::format("{} of {} cleared, {} {}", cleared, levels_.size(),
                    countText(std::min<std::int64_t>(points, 999999999), "point"),
                    checks ? "so far, more are checked" : rules),
        {kAboutLeft, back.lower.y + Real(0.55)},
        {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Left, kAboutRight - kAboutLeft});
}

void LevelMap::draw(Canvas& canvas, const Records& records, double seconds) const {
    const Aabb all = canvas.visible().grown(1);
    const ThemeLook& look = lookOf(levels_[chosen_]->theme);
    canvas.rectangle(all, mix(look.night, look.dusk, 0.3f), darker(look.night, 0.3f));
    for (std::size_t band = bands_.size(); band-- > 0;) {
        const Theme theme = levels_[bands_[band].first]->theme;
        const Aabb box = boxOf(band);
        paintLand(canvas, theme, {{all.lower.x, box.lower.y}, box.upper}, isOpen(band), seconds);
    }
    canvas.rectangle({all.lower, {all.upper.x, kLands.lower.y}}, palette::kNight, palette::kNight);
    canvas.rectangle({{kLands.upper.x, kLands.lower.y}, all.upper}, darker(look.night, 0.2f),
                     mix(look.night, look.dusk, 0.3f));
    drawWay(canvas);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        drawStop(canvas, i, records, seconds);
    }
    for (std::size_t band = 0; band < bands_.size(); ++band) {
        drawNames(canvas, band, records);
    }
    drawHead(canvas, records);
    paintAbout(canvas,
               {*levels_[chosen_], chosen_ + 1, stops_[chosen_], records, pointer_, seconds});
    drawFoot(canvas, records);
}

} // namespace apart
