// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <apart/stage/dice.hpp>

#include <vector>

namespace apart {

/// A burst of short-lived glowing bits.
struct Burst {
    Vec2 point;   // m
    Vec2 heading; // unit, the middle of the spread; zero: all around
    Color color{};
    int count = 0;
    Real speed = 6;           // m/s, of the fastest
    Real seconds = Real(0.5); // of the longest life
    Real size = Real(0.07);   // m
};

/// Particles: only looked at, never in the simulation.
class Sparks {
public:
    explicit Sparks(std::uint32_t seed) : dice_(seed) {}

    /// Past a fixed number of sparks, new ones are dropped: the ball must stay visible.
    void add(const Burst& burst);
    void tick(Real seconds);
    void draw(Canvas& canvas) const;
    std::size_t count() const { return sparks_.size(); }

private:
    struct Spark {
        Vec2 point;
        Vec2 velocity;
        Color color;
        Real size;
        Real age;  // s
        Real life; // s
    };
    std::vector<Spark> sparks_;
    Dice dice_;
};

} // namespace apart
