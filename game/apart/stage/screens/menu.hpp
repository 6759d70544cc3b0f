// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/controls.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

enum class Action : std::uint8_t {
    Play,   // the first open level not cleared yet
    Levels, // the map
    Duel,   // the map, for two players
    Endless,
    Daily,
    Mode, // the next of the modes
    Records,
    Replays,
    Replay, // MenuItem::dial is its index
    Help,
    Options,
    Quit,
    Resume,
    Restart,
    NextLevel,
    ToTitle,
    Back,
    Page,  // shows the next page of options
    Reset, // resets all dials
    Keys,  // opens the table of keys and buttons
    Dial,  // adjusted by left and right
};

/// An integer within a range, shown as a bar.
struct Gauge {
    int percent = 0;
    int least = 0;
    int most = 100;
    std::span<const std::string_view> words = {}; // of the values from 0 on, instead of percent
};

struct MenuItem {
    Action action;
    std::string label;
    std::optional<Gauge> gauge{};
    std::size_t dial = 0; // index into kDials, if there is a gauge
    /// Further columns; then the label is the first one, at the left.
    std::vector<std::string> columns{};
};

/// Result of an input: an item was chosen, or a dial got a new value.
struct MenuOutcome {
    Action action;
    std::size_t dial = 0;
    int percent = 0;
};

/// A column of items, operated by keys and mouse.
class Menu {
public:
    Menu() = default;
    Menu(std::vector<MenuItem> items, Real top, Real halfWidth = Real(5.7))
        : items_(std::move(items)), top_(top), halfWidth_(halfWidth) {}

    /// Two columns of items without gauges, each high enough for a finger on a phone.
    void fitFingers() {
        columns_ = 2;
        row_ = Real(2.24);
    }

    std::optional<MenuOutcome> take(const Signals& signals);
    void setPercent(std::size_t dial, int percent);
    void setLabel(Action action, std::string label);
    void choose(Action action);
    void chooseAt(std::size_t item) { chosen_ = std::min(item, items_.size() - 1); }
    void draw(Canvas& canvas) const;

    const std::vector<MenuItem>& items() const { return items_; }
    std::size_t chosen() const { return chosen_; }
    /// Clickable area of an item.
    Aabb place(std::size_t item) const;
    /// Clickable area of the bar of an item's dial.
    Aabb bar(std::size_t item) const;

private:
    static constexpr Real kRow = Real(0.98); // m, between items

    std::optional<MenuOutcome> take(Command command);
    std::optional<MenuOutcome> click(Vec2 place) const;
    std::optional<MenuOutcome> turned(const MenuItem& item, int percent) const;
    std::optional<std::size_t> itemAt(Vec2 place) const;
    void drawRow(Canvas& canvas, std::size_t item, Color color) const;
    void drawDial(Canvas& canvas, std::size_t item, Color color) const;

    std::vector<MenuItem> items_;
    Real top_ = 0;               // m, top of the first item
    Real halfWidth_ = Real(5.7); // m, of an item
    Real row_ = kRow;            // m
    std::size_t columns_ = 1;    // filled from the left
    std::size_t chosen_ = 0;
};

} // namespace apart
