// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace apart {

/// How long one frame took (s): the game's ticks, making triangles of it, showing them; and the
/// time of all processors together.
struct FrameTime {
    double game = 0;
    double picture = 0;
    double screen = 0;
    double processors = 0;

    double total() const { return game + picture + screen; }
};

/// How long frames took, and with how many bodies.
class FrameTimes {
public:
    void add(const FrameTime& time, std::size_t bodies);
    /// One line of figures.
    std::string text() const;

private:
    std::vector<double> totals_;
    FrameTime sum_;
    std::size_t fewest_ = 0;
    std::size_t most_ = 0;
};

} // namespace apart
