// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/daily.hpp>
#include <apart/stage/records/records.hpp>
#include <apart/stage/records/theatre.hpp>
#include <apart/stage/screens/menu.hpp>

#include <string>
#include <vector>

namespace apart {

/// What the title screen offers.
struct TitleOffer {
    std::string play{};   // number and title of the level to play
    bool endless = false; // endless and daily runs
    Day today = 0;        // 0: no daily run
    bool quits = true;
};
Menu titleMenu(const TitleOffer& offer, const Records& records);
/// Updates the labels that depend on mode and scores.
void refreshTitle(Menu& menu, const TitleOffer& offer, const Records& records);

Menu recordsMenu(bool replays);
Menu replaysMenu(const std::vector<ShowEntry>& replays);
/// `page`: index in kDialPages. The first one also leads to the bindings of keys.
Menu optionsMenu(const Settings& settings, int page);
/// `replays`: leads to the list of replays, too.
Menu pauseMenu(bool replays);
Menu endingMenu();
Menu helpMenu();

} // namespace apart
