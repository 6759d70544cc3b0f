// SPDX-License-Identifier: MIT
// The picture of the map: the lands, the way, the levels, and what stands around them.
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
    const bool told = level == shown(); // by the card
    const Color rim = chosen || told ? palette::kAccent
                      : stop.open()  ? look.glow
                                     : Color{64, 68, 92};
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
    canvas.ring(place, radius, Real(told ? 0.09 : 0.055), rim);
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
               {*levels_[shown()], shown() + 1, stops_[shown()], records, pointer_, seconds});
    drawFoot(canvas, records);
}

} // namespace apart
