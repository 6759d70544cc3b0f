// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/canvas/letterforms.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/logo.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::string_view kName = "aPart";
constexpr std::array<Stuff, kName.size()> kStuffs = {Stuff::Glass, Stuff::Wood, Stuff::Brick,
                                                     Stuff::Stone, Stuff::Glass};
constexpr double kRound = 7;       // s, until the first letter breaks again
constexpr double kStep = 0.45;     // s, from letter to letter
constexpr double kOpens = 0.16;    // s
constexpr double kCloses = 1.3;    // s
constexpr Real kWay = Real(2.4);   // units of the face, of a stone that comes apart
constexpr Real kTilt = Real(0.16); // rad
constexpr Real kJoint = Real(0.9); // units
constexpr Real kCrack = Real(0.5); // units, width

/// How far a letter is open, 0..1.
Real openOf(std::size_t letter, double seconds) {
    const double time =
        std::fmod(seconds + kRound - 2 - kStep * static_cast<double>(letter), kRound);
    if (time < 0 || time > kOpens + kCloses) {
        return 0;
    }
    const double t = time < kOpens ? time / kOpens : 1 - (time - kOpens) / kCloses;
    return static_cast<Real>(t * t * (3 - 2 * t));
}

Vec2 meanOf(std::span<const Vec2> points) {
    Vec2 sum;
    for (const Vec2 point : points) {
        sum += point;
    }
    return sum / static_cast<Real>(points.size());
}

/// Mean of the stones of each letter.
std::array<Vec2, kName.size()> middlesOf(const LaidText& laid) {
    std::array<Vec2, kName.size()> sums{};
    std::array<Real, kName.size()> counts{};
    for (const LaidStone& stone : laid.stones) {
        sums[stone.letter] += meanOf(stone.corners);
        counts[stone.letter] += 1;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = sums[i] / std::max(counts[i], Real(1));
    }
    return sums;
}

/// A zigzag across the stone, from the middle of one edge to that of the opposite one.
void paintCrack(Canvas& canvas, std::span<const Vec2> corners, Real width, std::uint32_t seed) {
    Dice dice(seed);
    const std::size_t half = corners.size() / 2;
    const Vec2 from = Real(0.5) * (corners[0] + corners[1]);
    const Vec2 to = Real(0.5) * (corners[half] + corners[(half + 1) % corners.size()]);
    const Vec2 side = Real(0.14) * perp(to - from);
    std::array<Vec2, 6> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Real t = static_cast<Real>(i) / static_cast<Real>(points.size() - 1);
        const bool end = i == 0 || i + 1 == points.size();
        const Real sway = end ? 0 : dice.between(-1, 1);
        points[i] = from + t * (to - from) + sway * side;
    }
    canvas.ribbon(points, width, palette::kInk);
}

} // namespace

void paintLogo(Canvas& canvas, Vec2 middle, Real height, double seconds) {
    const std::optional<LaidText> laid = layStones(kName, kJoint);
    const std::array<Vec2, kName.size()> middles = middlesOf(*laid);
    const Real unit = height / kCapital;
    for (const bool shadow : {true, false}) {
        std::uint32_t number = 0;
        for (const LaidStone& stone : laid->stones) {
            ++number;
            Dice dice(number);
            const Real open = openOf(stone.letter, seconds);
            const Vec2 center = meanOf(stone.corners);
            const Vec2 arm = center - middles[stone.letter];
            const Vec2 way = (open * kWay) * normalize(arm + Vec2{0, Real(0.1)});
            const auto turn = kodo::Rot::fromAngle(open * dice.between(-kTilt, kTilt));
            std::vector<Vec2> corners;
            for (const Vec2 corner : stone.corners) {
                const Vec2 place = center + way + turn * (corner - center);
                corners.push_back(middle + unit * (place - Vec2{laid->width / 2, 0}));
            }
            if (shadow) {
                for (Vec2& corner : corners) {
                    corner += Vec2{Real(0.07), Real(-0.09)};
                }
                canvas.polygon(corners, faded(palette::kInk, 0.9f));
                continue;
            }
            Color color = lighter(canvas.palette().of(kStuffs[stone.letter]), 0.12f);
            color.a = 255;
            paintLit(canvas, corners, color, {Real(0.06), faded(lighter(color, 0.6f), 0.7f)});
            if (open > 0) {
                paintCrack(canvas, corners, unit * kCrack * std::sqrt(open), number);
            }
        }
    }
}

} // namespace apart
