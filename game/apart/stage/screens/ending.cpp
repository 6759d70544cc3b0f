// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/backdrop.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/ending.hpp>
#include <apart/stage/screens/results.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

constexpr Real kRoom = 22; // m, of a line

void addHonours(CampaignTally& tally, const HonoursLook& look) {
    const std::vector<bool> won = honoursWon(look);
    tally.mostHonours += static_cast<int>(won.size());
    tally.honours += static_cast<int>(std::count(won.begin(), won.end(), true));
}

std::string fallText(const Game& game, const RunStatistics& run) {
    const std::uint32_t seconds = run.ticks / kTicksPerSecond;
    return fmt::format("{}: {} in one fall, {}, {}:{:02}", game.level().title,
                       countText(run.largestFall, "block"), countText(game.counts().hits, "hit"),
                       seconds / 60, seconds % 60);
}

} // namespace

CampaignTally tallyOf(const LevelList& levels, const Campaign& campaign, const Profile& profile,
                      std::span<const MedalMarks> marks) {
    CampaignTally tally;
    for (std::size_t i = 0; i < std::min(campaign.own, levels.size()); ++i) {
        const Level& level = *levels[i];
        const int medals = medalsOf(level, profile, marks);
        ++tally.levels[static_cast<std::size_t>(medals)];
        tally.medals += medals;
        tally.mostMedals += mostMedalsOf(level, marks);
        tally.pure += profile.bestOf(Mode::Pure, level.name).cleared ? 1 : 0;
        addHonours(tally,
                   {profile.bestOf(profile.mode, level.name), level, marksFor(level.name, marks)});
    }
    return tally;
}

void paintEnding(Canvas& canvas, const Game& game, const RunStatistics& run,
                 const CampaignTally& tally) {
    const ThemeLook& theme = lookOf(game.level().theme);
    const auto line = [&](std::string_view text, Real y, Real height, Color color) {
        canvas.text(text, {0, y}, {height, color, Typeface::Plain, Align::Middle, kRoom});
    };
    paintVeil(canvas, faded(palette::kNight, 0.7f));
    line("THE LAST BOSS IS DOWN", Real(16), Real(0.5), theme.glow);
    canvas.text("All of it came apart", {0, Real(14)},
                {Real(1.7), palette::kAccent, Typeface::Display, Align::Middle, kRoom});
    line("The fall was yours.", Real(12.7), Real(0.7), palette::kText);
    line(fallText(game, run), Real(11.7), Real(0.5), palette::kQuiet);
    for (std::size_t i = 1; i < tally.levels.size(); ++i) {
        const Real x = Real(-4.4) + Real(4) * static_cast<Real>(i - 1);
        paintMedal(canvas, {x, Real(9.8)}, Real(0.75), static_cast<Medal>(i));
        canvas.text(std::to_string(tally.levels[i]), {x + Real(1.05), Real(9.5)},
                    {Real(0.9), palette::kText, Typeface::Bold, Align::Left, Real(1.8)});
    }
    line(fmt::format("{} of {} medals", tally.medals, tally.mostMedals), Real(8), Real(0.55),
         palette::kText);
    const auto levels = static_cast<int>(tally.levels[0] + tally.levels[1] + tally.levels[2]);
    const int all = levels + tally.levels[3];
    const bool left = levels > 0 || tally.honours < tally.mostHonours || tally.pure < all;
    line(left ? fmt::format("left to win: gold in {}, {}, {} under pure rules",
                            countText(levels, "level"),
                            countText(tally.mostHonours - tally.honours, "honour"),
                            countText(all - tally.pure, "level"))
              : "nothing is left to win",
         Real(7.1), Real(0.5), palette::kQuiet);
}

void paintBossCard(Canvas& canvas, const Level& boss, double seconds) {
    const ThemeLook& theme = lookOf(boss.theme);
    const auto in = static_cast<float>(std::clamp(2.5 * seconds, 0.0, 1.0));
    const Real slide = Real(3) * (1 - in) * (1 - in); // m, from the right
    const Aabb all = canvas.visible().grown(1);
    constexpr Real kTop = Real(12.6);
    constexpr Real kBottom = Real(6.6);
    paintVeil(canvas, faded(palette::kNight, 0.45f * in));
    canvas.rectangle({{all.lower.x, kBottom}, {all.upper.x, kTop}}, faded(theme.night, in),
                     faded(theme.dusk, in));
    for (const Real y : {kBottom, kTop}) {
        canvas.line({all.lower.x, y}, {all.upper.x, y}, Real(0.09), faded(theme.glow, in));
    }
    canvas.text(fmt::format("THE BOSS   {}", theme.title), {-slide, Real(11.4)},
                {Real(0.55), faded(theme.glow, in), Typeface::Bold, Align::Middle, kRoom});
    canvas.text(shortened(boss.title, 40), {slide, Real(9.3)},
                {Real(2.2), faded(palette::kText, in), Typeface::Display, Align::Middle, kRoom});
    Real y = Real(8.3);
    for (const std::string& text : wrappedInto(2, boss.idea, fitting(canvas, 72), 90)) {
        canvas.text(text, {0, y},
                    {Real(0.5), faded(palette::kText, in), Typeface::Plain, Align::Middle, kRoom});
        y -= Real(0.75);
    }
}

} // namespace apart
