// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

namespace apart {

/// What a scene of the help page is about.
enum class HelpTopic : std::uint8_t { Pull, Push, Meter, Moods, Combo, Honours };
inline constexpr std::size_t kHelpTopics = 6;

/// A short game on a tiny level, in a room of ledges at the bottom of the field. Its input is a
/// function of the state, so each showing is the same.
struct HelpScene {
    HelpTopic topic;
    std::string_view blocks; // TOML, beside the walls of the room
    std::uint32_t seed;
    std::uint32_t ticks; // then it starts again
    Input (*script)(const Game&);
};

/// In the order of HelpTopic.
const std::array<HelpScene, kHelpTopics>& helpScenes();
std::shared_ptr<const Level> levelOf(const HelpScene& scene);

/// The visible part of the field of a scene (m).
inline constexpr kodo::Aabb kHelpRoom{{kodo::Real(-6.75), kodo::Real(0.5)},
                                      {kodo::Real(6.75), kodo::Real(7.8)}};

} // namespace apart
