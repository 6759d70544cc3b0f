// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

#include <set>
#include <tuple>

namespace support {

/// Follows the phases of every pair of parts and fails at the first that is out of turn.
class PhaseBook {
    using PairKey = std::tuple<kodo::BodyId, std::uint16_t, kodo::BodyId, std::uint16_t>;

public:
    void read(const kodo::World& world) {
        for (const kodo::CollisionRecord& r : world.collisions()) {
            const PairKey key{r.a, r.partA, r.b, r.partB};
            const bool open = open_.count(key) > 0;
            EXPECT_EQ(open, r.phase != kodo::TouchPhase::Begin) << "out of turn";
            if (r.phase == kodo::TouchPhase::End) {
                EXPECT_EQ(r.pointCount, 0);
                open_.erase(key);
                ++ended;
            } else {
                EXPECT_GE(r.pointCount, 1);
                open_.insert(key);
                seen_.insert(key);
            }
        }
        for (const PairKey& key : open_) {
            const bool silent = still(world, std::get<0>(key)) && still(world, std::get<2>(key));
            EXPECT_TRUE(silent || seen_.count(key) == 1)
                << "touched, and then silent for no reason";
        }
        seen_.clear();
    }
    std::size_t openCount() const { return open_.size(); }
    int ended = 0;

private:
    /// What rests, waits or is locked has no record of its own accord.
    static bool still(const kodo::World& world, kodo::BodyId id) {
        return world.contains(id) &&
               (world[id].flags() & (kodo::kResting | kodo::kLocked | kodo::kOutside)) != 0;
    }

    std::set<PairKey> open_;
    std::set<PairKey> seen_;
};

} // namespace support
