// SPDX-License-Identifier: MIT
// The stage while two players play at once.
#include <apart/stage/stage.hpp>

namespace apart {

/// The session behind it is a demo, so that nothing is recorded.
void Stage::beginDuel(std::size_t level) {
    games_.demo(level, false);
    map_.update(records_);
    const bool more = level + 1 < def_.levels.size() && map_.stops()[level + 1].open();
    duel_ = std::make_unique<Duel>(def_.levels[level], games_.takeSeed(), records_.profile().mode,
                                   more);
    screen_ = Screen::Duel;
}

/// True if the input has chosen something.
bool Stage::takeDuel(const Signals& signals) {
    const std::size_t before = duel_->menu().chosen();
    const std::optional<Action> action = duel_->take(signals, records_.profile().settings);
    if (!action) {
        return duel_->menu().chosen() != before;
    }
    switch (*action) {
    case Action::Options:
        toOptions();
        break;
    case Action::Levels:
        toLevels(true);
        break;
    case Action::ToTitle:
        toTitle();
        break;
    default:
        beginDuel(*action == Action::NextLevel ? games_.level() + 1 : games_.level());
    }
    return true;
}

} // namespace apart
