// SPDX-License-Identifier: MIT
#include "history.hpp"

#include <algorithm>

namespace destructoooor {

void History::record(const kodo::World& world, bool changed) {
    const std::uint64_t tick = world.stepCount();
    const bool due = copies_.empty() || tick >= copies_.back().stepCount() + kEvery;
    if (!changed && !due) {
        return;
    }
    if (!copies_.empty() && copies_.back().stepCount() == tick) {
        copies_.back() = world;
        return;
    }
    copies_.push_back(world);
    while (copies_.size() > 1 &&
           (copies_.size() > kMost || copies_.size() * world.bodyCount() > kMostBodies)) {
        copies_.pop_front();
    }
}

const kodo::World& History::before(std::uint64_t tick) const {
    const auto later = std::upper_bound(
        copies_.begin(), copies_.end(), tick,
        [](std::uint64_t at, const kodo::World& copy) { return at < copy.stepCount(); });
    return later == copies_.begin() ? copies_.front() : *std::prev(later);
}

void History::forgetAfter(std::uint64_t tick) {
    while (copies_.size() > 1 && copies_.back().stepCount() > tick) {
        copies_.pop_back();
    }
}

std::uint64_t History::first() const {
    return copies_.empty() ? 0 : copies_.front().stepCount();
}

} // namespace destructoooor
