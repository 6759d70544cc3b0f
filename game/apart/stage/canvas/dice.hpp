// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace apart {

/// Random numbers for picture and sound. No game rule depends on them.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : state_(seed * 2654435761u + 0x9e3779b9u) {
        if (state_ == 0) {
            state_ = 1;
        }
    }

    std::uint32_t next() { // xorshift32
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_;
    }
    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(next() >> 8) * (1.0f / 16777216.0f);
    }

private:
    std::uint32_t state_;
};

} // namespace apart
