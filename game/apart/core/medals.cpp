// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/medals.hpp>
#include <apart/core/toml_keys.hpp>
#include <apart/core/tuning.hpp>
#include <apart/core/way_watch.hpp>

#include <toml++/toml.h>

#include <algorithm>
#include <limits>

namespace apart {

namespace {

constexpr std::size_t kLargestTable = std::size_t{1} << 20; // bytes

/// The value at a quantile, 0..1. At least one value.
std::int32_t quantile(std::vector<std::int32_t> values, double share) {
    std::sort(values.begin(), values.end()); // total order: equal numbers do not differ
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// The marks in a table of one level; nullopt if it is invalid.
std::optional<MedalMarks> marksIn(std::string_view level, const toml::node& node) {
    const toml::table* table = node.as_table();
    const auto* digest = table != nullptr ? table->get_as<std::string>("digest") : nullptr;
    const toml::array* scores = table != nullptr ? table->get_as<toml::array>("scores") : nullptr;
    if (digest == nullptr || !fromHex(digest->get()) || scores == nullptr || scores->size() != 3) {
        return std::nullopt;
    }
    MedalMarks marks{std::string(level), *fromHex(digest->get())};
    for (const auto& [key, value] : {std::pair("few-hits", &MedalMarks::fewHits),
                                     std::pair("one-fall", &MedalMarks::oneFall)}) {
        const std::int64_t count = (*table)[key].value_or(std::int64_t{0});
        marks.*value = static_cast<std::int32_t>(std::clamp<std::int64_t>(count, 0, 1000000));
    }
    for (std::size_t i = 0; i < marks.scores.size(); ++i) {
        const auto score = scores->get(i)->value<std::int64_t>();
        const std::int32_t least = i == 0 ? 1 : marks.scores[i - 1];
        if (!score || *score < least || *score > std::numeric_limits<std::int32_t>::max()) {
            return std::nullopt;
        }
        marks.scores[i] = static_cast<std::int32_t>(*score);
    }
    return marks;
}

} // namespace

std::array<std::int32_t, 3> scoresForMedals(const std::vector<std::int32_t>& lazy,
                                            const std::vector<std::int32_t>& good,
                                            const std::vector<std::int32_t>& absent) {
    const auto rounded = [](std::int32_t score) { // up, to one of the marks
        return std::max(1, (score + kMedalStep - 1) / kMedalStep) * kMedalStep;
    };
    const auto above = [&](double share) { // what so many games of each bot do not exceed
        return std::max(quantile(lazy, 1 - share), quantile(good, 1 - share));
    };
    const std::int32_t bronze = rounded(quantile(lazy, 1 - kBronzeShare));
    const std::int32_t idle = absent.empty() ? 0 : *std::max_element(absent.begin(), absent.end());
    const std::int32_t silver = rounded(std::max(above(kSilverShare), idle + 1));
    const auto gold =
        std::max(static_cast<std::int32_t>((1 + kGoldOver) * silver), above(kGoldShare) + 1);
    return {bronze, silver, rounded(gold)};
}

MedalGames playForMedals(const Level& level, std::uint32_t seeds, std::uint32_t mostTicks) {
    const auto play = [&](BotKind kind, std::uint32_t count) {
        PlayedGames games;
        for (std::uint32_t seed = 1; seed <= count; ++seed) {
            const BotRun run = runBot(level, seed, mostTicks, kind);
            games.scores.push_back(run.score);
            games.falls.push_back(run.largestFall);
            if (run.result == Result::Won) {
                games.hits.push_back(run.paddleHits);
                for (std::size_t way = 0; way < kMostWays; ++way) {
                    games.ways[way] += isWayIn(run.ways, way) ? 1 : 0;
                }
            }
        }
        return games;
    };
    return {.lazy = play(BotKind::Lazy, seeds),
            .good = play(BotKind::Good, seeds),
            .absent = play(BotKind::Absent, kAbsentGames * seeds),
            .planner = play(BotKind::Planner,
                            isBuilding(level) ? std::max(1u, seeds / kPlannerShare) : 0)};
}

MedalMarks marksOf(const Level& level, const MedalGames& games) {
    std::vector<std::int32_t> falls;
    std::vector<std::int32_t> hits;
    for (const PlayedGames* played : {&games.lazy, &games.good, &games.planner}) {
        falls.insert(falls.end(), played->falls.begin(), played->falls.end());
        hits.insert(hits.end(), played->hits.begin(), played->hits.end());
    }
    MedalMarks marks{level.name, digestOf(level),
                     scoresForMedals(games.lazy.scores, games.good.scores, games.absent.scores)};
    const std::int32_t fall = quantile(std::move(falls), kOneFallShare);
    marks.oneFall = fall >= kLeastOneFall ? fall : 0;
    marks.fewHits = hits.empty() ? 0 : std::max(1, quantile(std::move(hits), kFewHitsShare));
    return marks;
}

Medal medalOf(std::int32_t score, const std::string& level, std::span<const MedalMarks> marks) {
    const MedalMarks* own = marksFor(level, marks);
    if (own == nullptr) {
        return Medal::None;
    }
    const auto reached = std::count_if(own->scores.begin(), own->scores.end(),
                                       [&](std::int32_t mark) { return score >= mark; });
    return static_cast<Medal>(reached);
}

Medal medalWon(std::int32_t score, bool won, const std::string& level,
               std::span<const MedalMarks> marks) {
    return std::min(medalOf(score, level, marks), won ? Medal::Gold : Medal::Bronze);
}

std::int32_t nextMark(std::int32_t score, const std::string& level,
                      std::span<const MedalMarks> marks) {
    const MedalMarks* own = marksFor(level, marks);
    const Medal medal = medalOf(score, level, marks);
    return own == nullptr || medal == Medal::Gold ? 0
                                                  : own->scores[static_cast<std::size_t>(medal)];
}

const MedalMarks* marksFor(const std::string& level, std::span<const MedalMarks> marks) {
    const auto found = std::find_if(marks.begin(), marks.end(),
                                    [&](const MedalMarks& m) { return m.level == level; });
    return found != marks.end() ? &*found : nullptr;
}

bool measuredOn(const MedalMarks& marks, const Level& level) {
    return marks.level == level.name && marks.digest == digestOf(level);
}

std::string toText(std::span<const MedalMarks> marks) {
    std::string text = "# What medals and honours need, measured by bots. Remade by "
                       "tools/medals.\nformat = 1\nrules = " +
                       std::to_string(kRulesVersion) + "\n";
    for (const MedalMarks& level : marks) {
        text += "\n[" + level.level + "]\ndigest = \"" + toHex(level.digest) + "\"\nscores = [" +
                std::to_string(level.scores[0]) + ", " + std::to_string(level.scores[1]) + ", " +
                std::to_string(level.scores[2]) + "]\nfew-hits = " + std::to_string(level.fewHits) +
                "\none-fall = " + std::to_string(level.oneFall) + "\n";
    }
    return text;
}

Read<std::vector<MedalMarks>> parseMedals(std::string_view text, const std::string& file) {
    const Read<toml::table> read = parseToml(text, file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return *problem;
    }
    const auto& root = std::get<toml::table>(read);
    if (root["format"].value_or(std::int64_t{0}) != 1) {
        return FileProblem{file, 1, "format must be 1"};
    }
    if (root["rules"].value_or(std::int64_t{0}) != std::int64_t{kRulesVersion}) {
        return FileProblem{file, 0,
                           "was measured with other rules than version " +
                               std::to_string(kRulesVersion) + "; tools/medals remakes it"};
    }
    std::vector<MedalMarks> marks;
    for (const auto& [key, node] : root) {
        if (key == "format" || key == "rules") {
            continue;
        }
        const std::optional<MedalMarks> level = marksIn(key.str(), node);
        if (!level) {
            return FileProblem{file, static_cast<int>(node.source().begin.line),
                               "a level needs a digest and three rising scores"};
        }
        marks.push_back(*level);
    }
    return marks;
}

Read<std::vector<MedalMarks>> readMedals(const std::filesystem::path& path) {
    const Read<std::string> text = readTextFile(path, kLargestTable);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        return *problem;
    }
    return parseMedals(std::get<std::string>(text), path.string());
}

} // namespace apart
