// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/effects/juice.hpp>
#include <apart/stage/sound/speaker.hpp>

namespace apart {

/// Celebration of a cleared level: a tune in the key of the theme, with fireworks on its beats.
/// stop() ends it early.
class Fanfare {
public:
    static constexpr int kTicks = 360;

    void begin() { tick_ = 0; }
    void stop() { tick_ = kTicks; }
    bool done() const { return tick_ >= kTicks; }
    /// Call once per tick of the game; `volume` 0..1.
    void tick(Juice& juice, float volume, Theme theme, Speaker& speaker);

private:
    int tick_ = kTicks;
};

} // namespace apart
