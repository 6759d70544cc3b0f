// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace apart {

/// How long frames took, and with how many bodies.
class FrameTimes {
public:
    void add(double seconds, std::size_t bodies);
    /// One line of figures.
    std::string text() const;

private:
    std::vector<double> seconds_;
    std::size_t fewest_ = 0;
    std::size_t most_ = 0;
};

} // namespace apart
