// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace apart {

/// A stereo sample, -1..1.
struct Frame {
    float left = 0;
    float right = 0;
};

/// Reverberation of a room: four comb filters in parallel, then two allpass filters, for each ear
/// [Schroeder62]. The lengths of the two ears differ, which makes the room wide.
class Room {
public:
    explicit Room(Theme theme);
    Frame next(float dry);

private:
    struct Delay {
        std::vector<float> line;
        std::size_t at = 0;
        float dull = 0; // state of the low-pass filter of a comb
    };
    struct Ear {
        std::array<Delay, 4> combs;
        std::array<Delay, 2> allpasses;
    };
    float throughEar(Ear& ear, float dry) const;

    float feedback_; // 0..1, of the combs
    float damping_;  // 0..1, of high frequencies
    float wet_;      // gain
    std::array<Ear, 2> ears_;
};

} // namespace apart
