// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/layout.hpp>

#include <span>
#include <string>
#include <vector>

namespace apart {

/// Popups from this height (m) on have the display face, which does not grow with the size of
/// texts.
inline constexpr Real kTitlePopup = Real(0.75);

/// Text that rises and fades.
struct Popup {
    std::string text;
    Vec2 place; // m; centre of the base line at age 0
    Color color{};
    Real height = 0;     // m, of the letters
    int points = 0;      // points shown, 0: a text without points
    bool praise = false; // one at a time
    int age = 0;         // ticks
    Vec2 origin{};       // m, set by Popups: the place wanted
    Real textScale = 1;  // set by Popups: the size of texts

    /// Current centre of the base line (m).
    Vec2 placeNow() const;
    /// The same, moved into a part of the field (m) if need be.
    Vec2 placeIn(const Aabb& shown) const;
    /// Current bounding box of the text (m).
    Aabb box() const;
    /// Remaining opacity, 0..1.
    float left() const;
};

/// All visible popups, placed without overlap.
class Popups {
public:
    /// `room`: the part of the field for all popups (m).
    explicit Popups(const Aabb& room = layout::kField) : room_(room) {}

    /// Points are added to a recent popup nearby, which keeps a chain of breaks legible. A recent
    /// nearby popup with the same text is kept instead of a new one. Of two praises the larger one
    /// is kept, of equal ones the latest. Other popups move up or down until they overlap no popup.
    /// All positions stay inside the room.
    /// A popup moves up, down or aside, as little as possible, off `busy` areas, where something
    /// breaks, and over as few `solid` ones as possible, where something stands (m). Praise and
    /// titles go farther for that than other words.
    void add(Popup popup, std::span<const Aabb> busy = {}, std::span<const Aabb> solid = {});
    void tick();
    /// Size of all texts of the picture; larger ones need more room.
    void setTextScale(Real scale);

    std::span<const Popup> all() const { return popups_; }

private:
    bool joins(const Popup& popup);
    Vec2 heldIn(const Popup& popup) const;
    Vec2 freePlace(Popup popup, std::span<const Aabb> busy, std::span<const Aabb> solid) const;

    std::vector<Popup> popups_;
    Aabb room_;
    Real textScale_ = 1;
};

} // namespace apart
