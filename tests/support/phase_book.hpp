// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

#include <set>
#include <tuple>

namespace support {

/// Tracks the contact phase of every pair of parts. Fails if a phase is out of order or a record is
/// missing.
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
    /// True for a body that causes no records itself: asleep, outside the region, static or
    /// kinematic.
    static bool still(const kodo::World& world, kodo::BodyId id) {
        return world.contains(id) && ((world[id].flags() & (kodo::kAsleep | kodo::kOutside)) != 0 ||
                                      world[id].type() != kodo::BodyType::Dynamic);
    }

    std::set<PairKey> open_;
    std::set<PairKey> seen_;
};

} // namespace support
