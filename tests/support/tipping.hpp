// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace support {

inline constexpr double kFallen = 0.5; // rad from the balance: where the time of a fall is taken

/// Time (s) in which a body on a corner that does not slip turns from `off` to kFallen (rad): a
/// pendulum upside down, angle'' = rate sin(angle), `rate` = m g r / (I + m r^2) in 1/s^2.
inline double fallTime(double off, double rate) {
    constexpr double h = 1e-4; // s; leapfrog
    double angle = off;
    double speed = 0;
    double time = 0;
    for (; angle < kFallen; time += h) {
        angle += h / 2 * speed;
        speed += h * rate * std::sin(angle);
        angle += h / 2 * speed;
    }
    return time;
}

} // namespace support
