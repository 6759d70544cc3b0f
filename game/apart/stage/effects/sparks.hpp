// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/dice.hpp>

#include <vector>

namespace apart {

/// A burst of short-lived glowing particles.
struct Burst {
    Vec2 point;   // m
    Vec2 heading; // unit vector, centre of the spread; zero: all directions
    Color color{};
    int count = 0;
    Real speed = 6;           // m/s, maximum
    Real seconds = Real(0.5); // maximum lifetime
    Real size = Real(0.07);   // m
};

/// Particle effects, outside the simulation.
class Sparks {
public:
    explicit Sparks(std::uint32_t seed) : dice_(seed) {}

    /// Above a fixed number of sparks, new ones are dropped to keep the ball visible.
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
