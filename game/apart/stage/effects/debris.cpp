// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/effects/debris.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr std::size_t kMostChips = 80;
constexpr std::size_t kMostPuffs = 12;
constexpr Real kFall = -16;           // m/s^2, of chips
constexpr Real kChipDrag = Real(1.1); // 1/s
constexpr Real kDustDrag = Real(3.2); // 1/s
constexpr Real kRise = Real(0.5);     // m/s^2, of dust
constexpr Real kSpread = Real(1.2);   // rad, to both sides of a heading
constexpr float kDustOpacity = 0.3f;

} // namespace

void Debris::addChip(const Rubble& rubble) {
    const bool around = rubble.heading == Vec2{};
    const Real middle = around ? 0 : std::atan2(rubble.heading.y, rubble.heading.x);
    const Real spread = around ? kTurn / 2 : kSpread;
    const Real angle = middle + dice_.between(-spread, spread);
    const Real speed = rubble.speed * dice_.between(Real(0.3), 1);
    const Real size = rubble.size * dice_.between(Real(0.05), Real(0.13));
    const float shade = dice_.between(-0.25f, 0.35f);
    const Color color = shade < 0 ? darker(rubble.color, -shade) : lighter(rubble.color, shade);
    const Real turned = dice_.between(0, kTurn);
    const Real spin = dice_.between(-14, 14);
    const Real life = dice_.between(Real(0.45), Real(1));
    chips_.push_back({rubble.point, speed * towards(angle), color, size, turned, spin, 0, life});
}

void Debris::addPuff(const Rubble& rubble) {
    const Real angle = dice_.between(0, kTurn);
    const Real speed = Real(0.35) * rubble.speed * dice_.between(Real(0.2), 1);
    const Real radius = rubble.size * dice_.between(Real(0.5), Real(0.9));
    const Real life = dice_.between(Real(0.5), Real(1.1));
    puffs_.push_back({rubble.point, speed * towards(angle),
                      mix(rubble.color, {214, 208, 200, 255}, 0.6f), radius, 0, life});
}

void Debris::add(const Rubble& rubble, float share) {
    const auto count = [&](int all) {
        return static_cast<int>(share * static_cast<float>(all) + 0.5f);
    };
    for (int i = 0; i < count(rubble.chips) && chips_.size() < kMostChips; ++i) {
        addChip(rubble);
    }
    for (int i = 0; i < count(rubble.puffs) && puffs_.size() < kMostPuffs; ++i) {
        addPuff(rubble);
    }
}

void Debris::tick(Real seconds) {
    for (Chip& chip : chips_) {
        chip.age += seconds;
        chip.velocity += seconds * (Vec2{0, kFall} - kChipDrag * chip.velocity);
        chip.point += seconds * chip.velocity;
        chip.angle += seconds * chip.spin;
    }
    for (Puff& puff : puffs_) {
        puff.age += seconds;
        puff.velocity += seconds * (Vec2{0, kRise} - kDustDrag * puff.velocity);
        puff.point += seconds * puff.velocity;
    }
    std::erase_if(chips_, [](const Chip& chip) { return chip.age >= chip.life; });
    std::erase_if(puffs_, [](const Puff& puff) { return puff.age >= puff.life; });
}

void Debris::drawDust(Canvas& canvas) const {
    for (const Puff& puff : puffs_) {
        const Real t = puff.age / puff.life;
        const Real grown = 1 - (1 - t) * (1 - t); // fast at first
        const Color color = faded(puff.color, kDustOpacity * (1 - t) * (1 - t));
        canvas.disc(puff.point, puff.radius * (Real(0.3) + Real(0.7) * grown), color,
                    faded(color, 0));
    }
}

void Debris::drawChips(Canvas& canvas) const {
    constexpr std::array<Real, 4> kReach = {1, Real(0.7), Real(1.1), Real(0.6)};
    for (const Chip& chip : chips_) {
        const float left = std::min(1.0f, 3 * (1 - chip.age / chip.life));
        std::array<Vec2, 4> corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Real angle = chip.angle + kTurn * static_cast<Real>(i) / 4;
            corners[i] = chip.point + chip.size * kReach[i] * towards(angle);
        }
        canvas.polygon(corners, faded(chip.color, left));
    }
}

} // namespace apart
