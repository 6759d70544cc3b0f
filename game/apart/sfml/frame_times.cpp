// SPDX-License-Identifier: MIT
#include <apart/sfml/frame_times.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace apart {

void FrameTimes::add(double seconds, std::size_t bodies) {
    fewest_ = seconds_.empty() ? bodies : std::min(fewest_, bodies);
    most_ = std::max(most_, bodies);
    seconds_.push_back(seconds);
}

std::string FrameTimes::text() const {
    if (seconds_.empty()) {
        return "no frames";
    }
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) {
        return 1000 * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    const double mean = 1000 * std::accumulate(sorted.begin(), sorted.end(), 0.0) /
                        static_cast<double>(sorted.size());
    return fmt::format("{} frames, {} to {} bodies: mean {:.2f} ms, median {:.2f} ms, 99 % within "
                       "{:.2f} ms, longest {:.2f} ms, {:.0f} frames a second",
                       sorted.size(), fewest_, most_, mean, at(0.5), at(0.99), at(1), 1000 / mean);
}

} // namespace apart
