// SPDX-License-Identifier: MIT
#include <apart/core/absent_bot.hpp>
#include <apart/core/tuning.hpp>

#include <array>

namespace apart {

Input absentBot(const Game& game) {
    constexpr std::array<std::int16_t, 7> kHeld = {-1200, -600, -400, 0, 400, 600, 1200};
    constexpr auto kForces = static_cast<std::uint32_t>(kForceNames.size());
    Input input{.launch = game.ticks() % (kTicksPerSecond / 2) < 2,
                .force = static_cast<Force>(game.seed() % kForces)};
    const std::size_t aim = game.seed() / kForces % (kHeld.size() + 1);
    if (aim < kHeld.size()) {
        input.aim = kHeld[aim]; // else the direction that the game draws
    }
    return input;
}

} // namespace apart
