// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/bindings.hpp>
#include <apart/stage/controls/controls.hpp>

#include <string>

namespace apart {

/// The table of keys and buttons. A chosen cell waits for the key or the button to bind.
class KeyScreen {
public:
    /// Changes the bindings. True if the player leaves the screen.
    bool take(const Signals& signals, Bindings& bindings);
    bool waiting() const { return waiting_; }
    const std::string& notice() const { return notice_; }

    void draw(Canvas& canvas, const Bindings& bindings) const;
    /// Clickable area of a cell; of the whole row below the acts.
    Aabb cell(std::size_t row, std::size_t column) const;

    static constexpr std::size_t kResetRow = kActs;
    static constexpr std::size_t kBackRow = kActs + 1;
    static constexpr std::size_t kRows = kActs + 2;

private:
    void takePress(Press press, Bindings& bindings);
    void point(Vec2 place);
    void move(Command command);
    bool confirm(Bindings& bindings);

    std::size_t row_ = 0;
    std::size_t column_ = 0;
    bool waiting_ = false;
    std::string notice_; // why the last key was refused
};

} // namespace apart
