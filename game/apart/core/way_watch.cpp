// SPDX-License-Identifier: MIT
#include <apart/core/way_watch.hpp>

#include <variant>

namespace apart {

void WayWatch::update(const Game& game) {
    for (const Event& event : game.events()) {
        if (const auto* struck = std::get_if<Struck>(&event)) {
            follow(*struck);
        } else if (const auto* let = std::get_if<LetGo>(&event)) {
            const bool torn = let->why == LetGo::Why::Torn || let->why == LetGo::Why::Fatigue;
            now_ = torn ? Blow{.torn = true} : now_;
        } else if (std::holds_alternative<Served>(event)) {
            hasStruck_ = touched_ = false;
        }
    }
    const Collapse& collapse = game.collapse();
    if (blocks_ == 0 && collapse.blocks > 0) {
        start_ = now_;
        start_.torn = now_.torn || !game.counts().blow;
    }
    blocks_ = collapse.blocks;
    if (collapse.largest > most_ && !game.counts().isDown()) {
        most_ = collapse.largest;
        largest_ = start_;
    }
}

void WayWatch::follow(const Struck& struck) {
    switch (struck.what) {
    case Role::Paddle:
        hasStruck_ = touched_ = false;
        break;
    case Role::Block:
        now_ = {struck.letter, hasStruck_ ? now_.bank : touched_, false};
        hasStruck_ = true;
        break;
    case Role::Wall:
    case Role::Obstruction:
        touched_ = true;
        break;
    default:
        break;
    }
}

std::uint32_t WayWatch::ways(const Level& level) const {
    std::uint32_t ways = 0;
    for (std::size_t i = 0; i < level.ways.size(); ++i) {
        const WayDef& way = level.ways[i];
        const bool strikes =
            way.strikes.empty() ||
            (largest_.struck != 0 && way.strikes.find(largest_.struck) != std::string::npos);
        if (most_ > 0 && !largest_.torn && strikes &&
            way.bank.value_or(largest_.bank) == largest_.bank) {
            ways |= 1u << i;
        }
    }
    return ways;
}

} // namespace apart
