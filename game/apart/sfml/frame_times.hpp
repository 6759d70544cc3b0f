// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace apart {

/// Durations of one frame (s).
struct FrameTime {
    double game = 0;       // ticks of the game
    double picture = 0;    // building of triangles
    double screen = 0;     // display
    double processors = 0; // processor time of all threads

    double total() const { return game + picture + screen; }
};

/// Statistics of frame times and of numbers of bodies.
class FrameTimes {
public:
    void add(const FrameTime& time, std::size_t bodies);
    /// The statistics in one line.
    std::string text() const;

private:
    std::vector<double> totals_;
    FrameTime sum_;
    std::size_t fewest_ = 0;
    std::size_t most_ = 0;
};

} // namespace apart
