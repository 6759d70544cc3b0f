// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/run_statistics.hpp>

#include <array>

namespace apart {

/// What is won of the levels of the game, and what is left.
struct CampaignTally {
    std::array<int, kMedalNames.size()> levels{}; // with this medal as the best one
    int medals = 0;                               // silver counts as two, gold as three
    int mostMedals = 0;
    int honours = 0;
    int mostHonours = 0;
    int pure = 0; // levels won under pure rules
};
CampaignTally tallyOf(const LevelList& levels, const Campaign& campaign, const Profile& profile,
                      std::span<const MedalMarks> marks);

/// Paints the ending, after the last boss: the fall, all medals, and what is left to win.
void paintEnding(Canvas& canvas, const Game& game, const RunStatistics& run,
                 const CampaignTally& tally);

/// Paints the name of a boss before its first game. `seconds` since it appeared.
void paintBossCard(Canvas& canvas, const Level& boss, double seconds);

} // namespace apart
