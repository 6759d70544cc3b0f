// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/dice.hpp>

#include <vector>

namespace apart {

/// What a fracture throws out beside its shards.
struct Rubble {
    Vec2 point;   // m
    Vec2 heading; // unit vector, centre of the spread; zero: all directions
    Color color{};
    int chips = 0;
    int puffs = 0;       // of dust
    Real speed = 6;      // m/s, of the fastest chip
    Real size = Real(1); // factor on the sizes
};

/// Solid chips and clouds of dust. A picture only: they touch nothing.
class Debris {
public:
    explicit Debris(std::uint32_t seed) : dice_(seed) {}

    /// Above a fixed number of each, new ones are dropped to keep the ball visible.
    /// `share` multiplies the numbers of chips and puffs.
    void add(const Rubble& rubble, float share = 1);
    void tick(Real seconds);
    void drawDust(Canvas& canvas) const;
    void drawChips(Canvas& canvas) const;
    std::size_t chips() const { return chips_.size(); }
    std::size_t puffs() const { return puffs_.size(); }

private:
    struct Chip {
        Vec2 point;
        Vec2 velocity;
        Color color;
        Real size;  // m
        Real angle; // rad
        Real spin;  // rad/s
        Real age = 0;
        Real life; // s
    };
    struct Puff {
        Vec2 point;
        Vec2 velocity;
        Color color;
        Real radius; // m, at its end
        Real age = 0;
        Real life; // s
    };
    void addChip(const Rubble& rubble);
    void addPuff(const Rubble& rubble);

    std::vector<Chip> chips_;
    std::vector<Puff> puffs_;
    Dice dice_;
};

} // namespace apart
