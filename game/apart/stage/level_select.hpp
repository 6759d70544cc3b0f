// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/controls.hpp>
#include <apart/stage/records.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace apart {

using LevelList = std::vector<std::shared_ptr<const Level>>;

/// One tile per level, in rows by theme, with a description of the chosen level.
class LevelSelect {
public:
    explicit LevelSelect(LevelList levels);

    /// The level to play, after the player has confirmed a choice.
    std::optional<std::size_t> take(const Signals& signals);
    void choose(std::size_t level);
    std::size_t chosen() const { return chosen_; }

    /// `seconds`: of animations.
    void draw(Canvas& canvas, const Records& records, double seconds) const;
    /// Clickable area of a level's tile. Far outside the picture if its row is scrolled away.
    Aabb tile(std::size_t level) const;
    /// Clickable area that returns to the title.
    Aabb backPlace() const;
    // The chosen level is to be edited, or a new one: by a click or the keys E and N.
    bool wantsEdit(const Signals& signals) const { return wants(signals, editPlace(), "E"); }
    bool wantsNew(const Signals& signals) const { return wants(signals, newPlace(), "N"); }
    Aabb editPlace() const;
    Aabb newPlace() const;
    // Clickable areas that scroll by one row, if possible.
    Aabb upPlace() const;
    Aabb downPlace() const;

private:
    struct Row {
        std::size_t first = 0;
        std::size_t count = 0;
        bool newTheme = false;
    };

    static bool wants(const Signals& signals, const Aabb& place, const char* key);
    std::size_t rowOf(std::size_t level) const;
    Real rowTop(std::size_t row) const;
    void move(Command command);
    bool scroll(Vec2 click);
    void drawArrows(Canvas& canvas) const;
    void drawTile(Canvas& canvas, std::size_t level, const Records& records) const;
    void drawHonourNames(Canvas& canvas, const Records& records, Vec2 place) const;
    void drawChosen(Canvas& canvas, const Records& records, double seconds) const;
    void drawBest(Canvas& canvas, const Records& records, Mode mode, Vec2 place) const;
    void drawFoot(Canvas& canvas, const Records& records) const;

    LevelList levels_;
    std::vector<Row> rows_;
    std::size_t chosen_ = 0;
    std::size_t topRow_ = 0;     // first visible row
    Vec2 pointer_{-1000, -1000}; // where it was last
};

} // namespace apart
