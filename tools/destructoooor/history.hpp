// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstdint>
#include <deque>

namespace destructoooor {

/// Copies of a World at some of its ticks. The steps between them can be made again with the same
/// bits, so a copy is needed at times, and after each change that was not a step.
class History {
public:
    void clear() { copies_.clear(); }
    /// Keeps a copy if one is due, or at once if the World has been changed.
    void record(const kodo::World& world, bool changed);
    /// The latest copy at this tick or before; the first one if all are later. There must be one.
    const kodo::World& before(std::uint64_t tick) const;
    /// Forgets copies of later ticks.
    void forgetAfter(std::uint64_t tick);
    std::uint64_t first() const;
    std::size_t size() const { return copies_.size(); }

private:
    static constexpr std::uint64_t kEvery = 30; // ticks
    // Beyond these the oldest copies are dropped. A body takes about 0.5 kB of a copy.
    static constexpr std::size_t kMost = 400;
    static constexpr std::size_t kMostBodies = 1000000; // of all copies

    std::deque<kodo::World> copies_; // by stepCount()
};

} // namespace destructoooor
