// SPDX-License-Identifier: MIT
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/reload.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

namespace apart {

namespace {

/// True if two levels differ in more than title, idea and theme.
bool differInPlay(const Level& a, Level b) {
    b.title = a.title;
    b.idea = a.idea;
    b.theme = a.theme;
    return a != b;
}

} // namespace

std::vector<std::string> Reload::notes() const {
    if (faults.size() < 2) {
        return faults;
    }
    return {fmt::format("{} ({})", faults[0],
                        countText(static_cast<std::int64_t>(faults.size()) - 1, "more error"))};
}

/// Reads the level of a file again when the file has changed, or notes its errors. A game on it
/// that is not over starts again once it is on the screen.
void Stage::reloadLevel() {
    constexpr double kEvery = 0.5; // s
    std::shared_ptr<const Level>& known = def_.levels[def_.firstLevel];
    const bool own = !editor_ && session().kind() == Session::Kind::Own &&
                     games_.run().number == 0 && session().game().level().name == known->name;
    const bool over = session().game().result() != Result::Playing;
    const bool playing = screen_ == Screen::Playing;
    if (!def_.reload || (own && over && playing)) {
        return; // its score is entered first
    }
    if (seconds_ >= reload_.at) {
        reload_.at = seconds_ + kEvery;
        std::optional<LevelChange> change = def_.reload();
        if (change) {
            reload_.faults = std::move(change->errors);
        }
        if (change && change->level && *change->level != *known) {
            const bool ends = differInPlay(session().game().level(), *change->level);
            reload_.news =
                own && !over && !ends ? "The next game shows the new texts and theme." : "";
            reload_.newsAt = seconds_;
            if (digestOf(*change->level) != digestOf(*known)) {
                const Best best = records_.profile().bestOf(records_.profile().mode, known->name);
                reload_.news = best.score > 0
                                   ? fmt::format("The level has changed: a new table of scores "
                                                 "begins. {} of its earlier content are kept.",
                                                 countText(best.score, "point"))
                                   : "";
                records_.setLevel(change->level);
            }
            known = std::move(change->level);
            map_.setLevels(def_.levels);
            map_.update(records_);
        }
    }
    if (own && playing && differInPlay(session().game().level(), *known)) {
        reload_.newsAt = seconds_;
        begin(def_.firstLevel);
    }
}

} // namespace apart
