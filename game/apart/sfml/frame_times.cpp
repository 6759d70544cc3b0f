// SPDX-License-Identifier: MIT
#include <apart/sfml/frame_times.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

void FrameTimes::add(const FrameTime& time, std::size_t bodies) {
    fewest_ = totals_.empty() ? bodies : std::min(fewest_, bodies);
    most_ = std::max(most_, bodies);
    sum_.game += time.game;
    sum_.picture += time.picture;
    sum_.screen += time.screen;
    sum_.processors += time.processors;
    totals_.push_back(time.total());
}

std::string FrameTimes::text() const {
    if (totals_.empty()) {
        return "no frames";
    }
    std::vector<double> sorted = totals_;
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    const auto at = [&](double share) {
        return 1000 * sorted[static_cast<std::size_t>(share * (count - 1))];
    };
    const double mean = 1000 * sum_.total() / count;
    return fmt::format(
        "{} frames, {} to {} bodies: mean {:.2f} ms (game {:.2f}, picture {:.2f}, "
        "screen {:.2f}), median {:.2f} ms, 99 % within {:.2f} ms, longest {:.2f} ms; "
        "{:.2f} ms of processor time",
        sorted.size(), fewest_, most_, mean, 1000 * sum_.game / count, 1000 * sum_.picture / count,
        1000 * sum_.screen / count, at(0.5), at(0.99), at(1), 1000 * sum_.processors / count);
}

} // namespace apart
