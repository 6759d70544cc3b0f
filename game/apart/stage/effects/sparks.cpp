// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/effects/sparks.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::size_t kMostSparks = 700;
constexpr Real kFall = -9;            // m/s^2
constexpr Real kDrag = Real(2.2);     // 1/s
constexpr Real kStreak = Real(0.025); // s of flight shown as a streak
constexpr Real kSpread = Real(1.1);   // rad, to both sides of a heading

} // namespace

void Sparks::add(const Burst& burst) {
    const bool around = burst.heading == Vec2{};
    const Real middle = around ? 0 : std::atan2(burst.heading.y, burst.heading.x);
    const Real spread = around ? kTurn / 2 : kSpread;
    for (int i = 0; i < burst.count && sparks_.size() < kMostSparks; ++i) {
        const Real angle = middle + dice_.between(-spread, spread);
        const Real speed = burst.speed * dice_.between(Real(0.15), 1);
        sparks_.push_back({burst.point, speed * towards(angle), burst.color,
                           burst.size * dice_.between(Real(0.5), 1), 0,
                           burst.seconds * dice_.between(Real(0.4), 1)});
    }
}

void Sparks::tick(Real seconds) {
    for (Spark& spark : sparks_) {
        spark.age += seconds;
        spark.velocity += seconds * (Vec2{0, kFall} - kDrag * spark.velocity);
        spark.point += seconds * spark.velocity;
    }
    std::erase_if(sparks_, [](const Spark& spark) { return spark.age >= spark.life; });
}

void Sparks::draw(Canvas& canvas) const {
    canvas.setGlow(true);
    for (const Spark& spark : sparks_) {
        const Real left = 1 - spark.age / spark.life;
        const Vec2 streak = kStreak * spark.velocity + Vec2{0, Real(0.5) * spark.size};
        const Vec2 side =
            Real(0.6) * spark.size * (Real(0.4) + Real(0.6) * left) * perp(normalize(streak));
        // Bright at its centre and transparent along its outline: soft edges at any size.
        const Color head = faded(spark.color, left);
        const Color none = faded(head, 0);
        const Vec2 tail = spark.point - Real(1.8) * streak;
        const std::array<Color, 3> colors = {head, none, none};
        const Vec2 wide = Real(1.5) * side;
        canvas.facet(std::array{spark.point, spark.point + wide, tail}, colors);
        canvas.facet(std::array{spark.point, tail, spark.point - wide}, colors);
    }
    canvas.setGlow(false);
}

} // namespace apart
