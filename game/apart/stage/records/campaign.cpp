// SPDX-License-Identifier: MIT
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/records/campaign.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

constexpr int kOpenAtOnce = 2; // levels of a theme

bool isNamed(std::span<const std::string_view> names, const Level& level) {
    return std::find(names.begin(), names.end(), level.name) != names.end();
}

/// End of the levels of the same theme as levels[first], before `end`.
std::size_t endOfTheme(const LevelList& levels, std::size_t first, std::size_t end) {
    std::size_t last = first;
    while (last < end && levels[last]->theme == levels[first]->theme) {
        ++last;
    }
    return last;
}

} // namespace

void putBossesLast(LevelList& levels) {
    for (std::size_t first = 0; first < levels.size();) {
        const std::size_t last = endOfTheme(levels, first, levels.size());
        const auto begin = levels.begin() + static_cast<std::ptrdiff_t>(first);
        std::stable_partition(begin, levels.begin() + static_cast<std::ptrdiff_t>(last),
                              [](const auto& level) { return !isNamed(kBosses, *level); });
        first = last;
    }
}

std::string Stop::asks() const {
    if (after) {
        return fmt::format("Opens once {} is won.", after->title);
    }
    return medals > 0 ? fmt::format("Opens with {}.", countText(medals, "more medal")) : "";
}

int mostMedalsOf(const Level& level, std::span<const MedalMarks> marks) {
    return marksFor(level.name, marks) != nullptr ? 3 : 1;
}

bool isWon(const Level& level, const Profile& profile) {
    return std::any_of(profile.best.begin(), profile.best.end(), [&](const auto& bests) {
        const auto best = bests.find(level.name);
        return best != bests.end() && best->second.cleared;
    });
}

bool isPlayed(const Level& level, const Profile& profile) {
    return std::any_of(profile.best.begin(), profile.best.end(),
                       [&](const auto& bests) { return bests.count(level.name) > 0; });
}

int medalsOf(const Level& level, const Profile& profile, std::span<const MedalMarks> marks) {
    if (marksFor(level.name, marks) == nullptr) {
        return isWon(level, profile) ? 1 : 0;
    }
    Medal medal = Medal::None;
    for (std::size_t mode = 0; mode < kModeNames.size(); ++mode) {
        const Best best = profile.bestOf(static_cast<Mode>(mode), level.name);
        medal = std::max(medal, medalWon(best.score, best.cleared, level.name, marks));
    }
    return static_cast<int>(medal);
}

std::vector<Stop> stopsOf(const LevelList& levels, const Campaign& campaign, const Profile& profile,
                          std::span<const MedalMarks> marks) {
    std::vector<Stop> stops(levels.size());
    const std::size_t end = std::min(campaign.own, levels.size());
    std::shared_ptr<const Level> gate; // the boss of the theme before, unless it is won
    for (std::size_t first = 0, last = 0; first < end; first = last) {
        last = endOfTheme(levels, first, end);
        int won = 0;
        int most = 0;
        int others = 0;
        std::shared_ptr<const Level> boss;
        for (std::size_t i = first; i < last; ++i) {
            if (isNamed(campaign.bosses, *levels[i])) {
                boss = levels[i];
                continue;
            }
            won += medalsOf(*levels[i], profile, marks);
            most += mostMedalsOf(*levels[i], marks);
            ++others;
        }
        const int asked = std::min(kMedalsForTwo * others / 2, most);
        int place = 0; // among the others
        for (std::size_t i = first; i < last && boss; ++i) {
            stops[i].boss = levels[i] == boss;
            const int asks = stops[i].boss ? asked : std::max(++place - kOpenAtOnce, 0);
            stops[i].medals = std::max(asks - won, 0);
            stops[i].after = gate;
        }
        gate = boss && !isWon(*boss, profile) ? boss : nullptr;
    }
    const auto reached = std::find_if(levels.begin(), levels.end(), [&](const auto& level) {
        return level->name == profile.reached;
    });
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool before =
            reached != levels.end() && levels.begin() + std::ptrdiff_t(i) <= reached;
        if (campaign.open || before || isPlayed(*levels[i], profile)) {
            stops[i] = {stops[i].boss};
        }
    }
    return stops;
}

std::string reachedBy(const LevelList& levels, const Profile& profile) {
    for (std::size_t i = levels.size(); i-- > 0;) {
        if (isPlayed(*levels[i], profile)) {
            return levels[std::min(i + 1, levels.size() - 1)]->name;
        }
    }
    return "";
}

std::size_t nextToPlay(const LevelList& levels, const std::vector<Stop>& stops,
                       const Profile& profile, std::span<const MedalMarks> marks) {
    std::size_t poorest = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (!stops[i].open()) {
            continue;
        }
        if (!profile.bestOf(profile.mode, levels[i]->name).cleared) {
            return i;
        }
        const bool poorer =
            medalsOf(*levels[i], profile, marks) < medalsOf(*levels[poorest], profile, marks);
        poorest = poorer ? i : poorest;
    }
    return poorest;
}

} // namespace apart
