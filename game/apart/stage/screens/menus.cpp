// SPDX-License-Identifier: MIT
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/menus.hpp>

#include <fmt/format.h>

#include <array>

namespace apart {

namespace {

std::string modeLabel(Mode mode) {
    constexpr std::array<std::string_view, kModeNames.size()> kLabels = {
        "Standard rules", "Pure: no path is ever bent", "Assisted: a slower ball"};
    return fmt::format("\u2039  {}  \u203a", kLabels[static_cast<std::size_t>(mode)]);
}

/// An item with the best score of its runs, if one is proved.
std::string runLabel(std::string_view name, std::int32_t best) {
    return best > 0 ? fmt::format("{}   best {}", name, grouped(best)) : std::string(name);
}

std::string endlessLabel(const Records& records) {
    return runLabel("Endless", records.provedScore(records.profile().mode, kEndlessKey));
}

std::string dailyLabel(Day today, const Records& records) {
    return runLabel(dailyName(today), records.provedScore(records.profile().mode, dailyKey(today)));
}

} // namespace

Menu titleMenu(const TitleOffer& offer, const Records& records) {
    std::vector<MenuItem> items = {{Action::Play, offer.play}, {Action::Levels, "Map"}};
    if (offer.endless) {
        items.push_back({Action::Endless, endlessLabel(records)});
    }
    if (offer.endless && offer.today > 0) {
        items.push_back({Action::Daily, dailyLabel(offer.today, records)});
    }
    items.push_back({Action::Duel, "Duel for two"});
    items.push_back({Action::Mode, modeLabel(records.profile().mode)});
    items.push_back({Action::Records, "Records"});
    items.push_back({Action::Help, "How to play"});
    items.push_back({Action::Options, "Options"});
    if (offer.quits) {
        items.push_back({Action::Quit, "Quit"});
    }
    Menu menu(std::move(items), Real(11.48));
    if (records.profile().bindings.fingers) {
        menu.fitFingers();
    }
    return menu;
}

void refreshTitle(Menu& menu, const TitleOffer& offer, const Records& records) {
    menu.setLabel(Action::Play, offer.play);
    menu.setLabel(Action::Endless, endlessLabel(records));
    menu.setLabel(Action::Daily, dailyLabel(offer.today, records));
    menu.setLabel(Action::Mode, modeLabel(records.profile().mode));
}

Menu recordsMenu(bool replays) {
    std::vector<MenuItem> items;
    if (replays) {
        items.push_back({Action::Replays, "Replays"});
    }
    items.push_back({Action::Back, "Back"});
    return {std::move(items), Real(3.2)};
}

Menu replaysMenu(const std::vector<ShowEntry>& replays) {
    std::vector<MenuItem> items;
    for (std::size_t i = 0; i < replays.size(); ++i) {
        const ShowEntry& replay = replays[i];
        items.push_back({Action::Replay,
                         shortened(replay.title, 40),
                         std::nullopt,
                         i,
                         {replay.date, replay.result,
                          replay.score ? grouped(static_cast<int>(*replay.score)) : ""}});
    }
    items.push_back({Action::Back, "Back"});
    return {std::move(items), Real(13.2), Real(13)};
}

Menu optionsMenu(const Settings& settings, int page) {
    std::vector<MenuItem> items;
    for (std::size_t i = 0; i < kDials.size(); ++i) {
        const Dial& dial = kDials[i];
        if (dial.page == page) {
            items.push_back({Action::Dial, std::string(dial.label),
                             Gauge{settings.*dial.value, dial.least, dial.most, dial.words}, i});
        }
    }
    const std::string_view name = kDialPages[static_cast<std::size_t>(page)];
    items.push_back({Action::Page, fmt::format("\u2039  {}  \u203a", name)});
    if (page == 0) {
        items.push_back({Action::Keys, "Keys and buttons"});
    }
    items.push_back({Action::Reset, "As they were at first"});
    items.push_back({Action::Back, "Back"});
    return {std::move(items), Real(13.2), Real(7.4)};
}

Menu pauseMenu(bool replays) {
    std::vector<MenuItem> items = {{Action::Resume, "Go on"},
                                   {Action::Restart, "Restart"},
                                   {Action::Help, "How to play"},
                                   {Action::Options, "Options"}};
    if (replays) {
        items.push_back({Action::Replays, "All replays"});
    }
    items.push_back({Action::Levels, "Map"});
    items.push_back({Action::ToTitle, "Title"});
    return {std::move(items), replays ? Real(12.4) : Real(11.6)};
}

Menu endingMenu() {
    return {{{Action::Levels, "Map"}, {Action::ToTitle, "Title"}}, Real(5.1)};
}

Menu helpMenu() {
    return {{{Action::Back, "Back"}}, Real(-2)}; // below the picture
}

} // namespace apart
