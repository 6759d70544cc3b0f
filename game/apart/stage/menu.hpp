// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <apart/stage/controls.hpp>

#include <optional>
#include <string>
#include <vector>

namespace apart {

enum class Action : std::uint8_t {
    Resume,
    Restart,
    NextLevel,
    ToTitle,
    Particles, // the settings, in percent
    Trail,
    Shake,
    Flash,
    Sound,
};

struct MenuItem {
    Action action;
    std::string label;
    std::optional<int> percent{}; // a setting; left and right change it
};

/// What the player did to a menu: chose an item, or moved a setting by so many percent.
struct MenuOutcome {
    Action action;
    int change = 0; // 0: chosen
};

/// A column of items, by keys and by mouse alike.
class Menu {
public:
    Menu() = default;
    Menu(std::vector<MenuItem> items, Real top) : items_(std::move(items)), top_(top) {}

    std::optional<MenuOutcome> take(const Signals& signals);
    void setPercent(Action action, int percent);
    void draw(Canvas& canvas) const;

    const std::vector<MenuItem>& items() const { return items_; }
    std::size_t chosen() const { return chosen_; }
    /// Where an item can be clicked.
    Aabb place(std::size_t item) const;

private:
    std::optional<MenuOutcome> take(Command command);
    std::optional<MenuOutcome> click(Vec2 place) const;
    std::optional<std::size_t> itemAt(Vec2 place) const;

    std::vector<MenuItem> items_;
    Real top_ = 0; // m, of the first item
    std::size_t chosen_ = 0;
};

} // namespace apart
