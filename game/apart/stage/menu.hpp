// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <apart/stage/controls.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace apart {

enum class Action : std::uint8_t {
    Play, // the next level that is not cleared yet
    Levels,
    Endless,
    Mode, // standard or pure
    Options,
    Quit,
    Resume,
    Restart,
    NextLevel,
    ToTitle,
    Back,
    Reset, // all dials
    Dial,  // left and right turn it
};

/// A number between two ends, shown as a bar.
struct Gauge {
    int percent = 0;
    int least = 0;
    int most = 100;
};

struct MenuItem {
    Action action;
    std::string label;
    std::optional<Gauge> gauge{};
    std::size_t dial = 0; // index into kDials, with a gauge
};

/// What the player did to a menu: chose an item, or turned a dial to a new value.
struct MenuOutcome {
    Action action;
    std::size_t dial = 0;
    int percent = 0;
};

/// A column of items, by keys and by mouse alike.
class Menu {
public:
    Menu() = default;
    Menu(std::vector<MenuItem> items, Real top) : items_(std::move(items)), top_(top) {}

    std::optional<MenuOutcome> take(const Signals& signals);
    void setPercent(std::size_t dial, int percent);
    void setLabel(Action action, std::string label);
    void choose(Action action);
    void draw(Canvas& canvas) const;

    const std::vector<MenuItem>& items() const { return items_; }
    std::size_t chosen() const { return chosen_; }
    /// Where an item can be clicked.
    Aabb place(std::size_t item) const;
    /// Where the bar of its dial is.
    Aabb bar(std::size_t item) const;

private:
    std::optional<MenuOutcome> take(Command command);
    std::optional<MenuOutcome> click(Vec2 place) const;
    std::optional<MenuOutcome> turned(const MenuItem& item, int percent) const;
    std::optional<std::size_t> itemAt(Vec2 place) const;
    void drawDial(Canvas& canvas, std::size_t item, Color color) const;

    std::vector<MenuItem> items_;
    Real top_ = 0; // m, of the first item
    std::size_t chosen_ = 0;
};

} // namespace apart
