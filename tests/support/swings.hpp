// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

/// Samples an oscillation about zero once per step.
namespace support {

class Swings {
public:
    explicit Swings(double dt) : dt_(dt) {}

    void see(double value) {
        if (steps_ > 0 && last_ < 0 && value >= 0) {
            crossings_.push_back(dt_ * (steps_ - 1 + last_ / (last_ - value)));
        }
        peak_ = std::max(peak_, std::abs(value));
        last_ = value;
        ++steps_;
    }
    /// Number of full periods between the first and the last upward crossing.
    int count() const { return crossings_.empty() ? 0 : static_cast<int>(crossings_.size()) - 1; }
    /// Mean period (s). Crossings are interpolated linearly between two steps.
    double period() const { return (crossings_.back() - crossings_.front()) / count(); }
    /// Largest magnitude since the start or since the last forgetPeak().
    double peak() const { return peak_; }
    void forgetPeak() { peak_ = 0; }

private:
    double dt_;
    double last_ = 0;
    double peak_ = 0;
    int steps_ = 0;
    std::vector<double> crossings_; // s
};

} // namespace support
