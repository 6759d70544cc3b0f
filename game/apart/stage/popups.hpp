// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>

#include <span>
#include <string>
#include <vector>

namespace apart {

/// A number or a word that rises and fades.
struct Popup {
    std::string text;
    Vec2 place; // m; the middle of its base line, where it began
    Color color{};
    Real height = 0; // m, of the letters
    int points = 0;  // that it tells of, if any
    int age = 0;     // ticks

    /// m; where the middle of its base line is now.
    Vec2 placeNow() const;
    /// m; room for its letters, as it is now.
    Aabb box() const;
    /// 0..1, how much of it is still to be seen.
    float left() const;
};

/// All that are to be seen, each where it can be read.
class Popups {
public:
    /// Points join those that have just come up nearby, so that a chain of breaks stays readable. A
    /// word that has just come up there is not said twice; any other one stands above or below what
    /// would cover it. All of them stay in the field.
    void add(Popup popup);
    void tick();

    std::span<const Popup> all() const { return popups_; }

private:
    bool joins(const Popup& popup);

    std::vector<Popup> popups_;
};

} // namespace apart
