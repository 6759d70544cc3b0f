// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/player_settings.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// Flash at the point of a fracture, during its first three frames.
struct Glint {
    Vec2 point;
    Real weight = 0; // 0..1, of the impact
    int age = 0;     // ticks

    static constexpr int kTicks = 6; // three frames of a 60 Hz screen
    float left() const { return 1 - static_cast<float>(age) / kTicks; }
};

/// Flashes of the whole field, at most two in a second of real time, and of single fractures.
class Flashes {
public:
    void setSettings(const Settings& settings);
    /// Ratio of the time of the game to real time.
    void setPace(double pace) { pace_ = pace; }
    /// Call once per tick.
    void tick();
    /// Flashes the field, unless it did so a moment ago. `strength` 0..1.
    void light(Color color, float strength);
    void glint(Vec2 point, Real weight) { glints_.push_back({point, weight}); }

    /// Opacity of the flash over the field, 0..1.
    float field() const { return field_; }
    Color color() const { return color_; }
    /// Opacity of local flashes, 0..1: at the point of a fracture and on its new shards.
    float punch() const { return calm_ ? 0 : strength_; }
    /// Points of recent fractures.
    std::span<const Glint> glints() const { return glints_; }
    /// Share of the brightness of a block after an impact.
    Real heat() const;

private:
    float strength_ = 1; // setting
    bool calm_ = false;  // setting: reduced flashing
    double pace_ = 1;
    double pause_ = 0; // s of real time until the next flash of the field
    float field_ = 0;
    Color color_{};
    std::vector<Glint> glints_;
};

} // namespace apart
