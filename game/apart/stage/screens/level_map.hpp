// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/controls.hpp>
#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/records.hpp>

#include <optional>
#include <vector>

namespace apart {

/// A picture of the way through all levels, with a description of the chosen one. Each theme is a
/// band of land, the first at the bottom; the way turns at the end of each. The levels of the
/// player have a band of their own.
class LevelMap {
public:
    explicit LevelMap(LevelList levels, const Campaign& campaign = {});
    void setLevels(LevelList levels);

    /// Reads results and medals from the records, and derives which levels are open.
    void update(const Records& records);
    const std::vector<Stop>& stops() const { return stops_; } // of all levels
    /// As nextToPlay(), after an update.
    std::size_t nextLevel(const Records& records);
    bool isLastBoss(std::size_t level) const;

    /// The pointer shows the card of a level while it passes, and chooses one on which it rests.
    /// `now`: s.
    void point(const Signals& signals, double now);
    /// The level to play, after the player has confirmed a choice. None if it is closed.
    std::optional<std::size_t> take(const Signals& signals);
    void choose(std::size_t level);
    /// The level is chosen for a duel.
    void setDuel(bool on) { duel_ = on; }
    bool forDuel() const { return duel_; }
    std::size_t chosen() const { return chosen_; }
    /// The level of the card, which keys act on: that under the pointer, else the chosen one.
    std::size_t shown() const { return hover_.level.value_or(chosen_); }

    /// `seconds`: of animations.
    void draw(Canvas& canvas, const Records& records, double seconds) const;
    /// Area of the circle of a level; a click near it counts too. Far outside the picture if its
    /// part of the band is not in sight.
    Aabb tile(std::size_t level) const;
    /// Clickable area that returns to the title.
    Aabb backPlace() const;
    // The level of the card is to be edited, or a new one: by a click or the keys E and N.
    bool wantsEdit(const Signals& signals) const { return wants(signals, editPlace(), "E"); }
    bool wantsNew(const Signals& signals) const { return wants(signals, newPlace(), "N"); }
    Aabb editPlace() const;
    Aabb newPlace() const;

private:
    struct Band {
        std::size_t first = 0;
        std::size_t count = 0;
        bool own = false;
        std::size_t shown = 0; // index of the first level in sight
    };
    struct Hover {
        std::optional<std::size_t> level{}; // under the pointer, unless it is the chosen one
        double since = 0;                   // s; the pointer has not moved from then on
    };
    static constexpr Aabb kLands{{Real(-14.9), Real(1.5)}, {Real(4.2), Real(15.4)}}; // m
    static constexpr Real kMargin = Real(1.3); // m, from the first level of a band to the edge

    static bool wants(const Signals& signals, const Aabb& place, const char* key);
    std::size_t bandOf(std::size_t level) const;
    Aabb boxOf(std::size_t band) const;
    bool isOpen(std::size_t band) const;
    std::size_t countShown(const Band& band) const;
    std::optional<Vec2> placeOf(std::size_t level) const;
    std::optional<std::size_t> under(Vec2 place) const; // the level to which a finger there belongs
    Real radiusOf(std::size_t level) const;
    void move(Command command);
    void moveAcross(bool up);

    // Pictures (level_map_painter.cpp).
    void drawWay(Canvas& canvas) const;
    void drawStop(Canvas& canvas, std::size_t level, const Records& records, double seconds) const;
    void drawNames(Canvas& canvas, std::size_t band, const Records& records) const;
    void drawHead(Canvas& canvas, const Records& records) const;
    void drawFoot(Canvas& canvas, const Records& records) const;

    LevelList levels_;
    Campaign campaign_;
    std::vector<Stop> stops_;
    std::vector<Band> bands_;
    std::size_t chosen_ = 0;
    Hover hover_;
    bool duel_ = false;
    Vec2 pointer_{-1000, -1000}; // where it was last
};

} // namespace apart
