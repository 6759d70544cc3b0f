// SPDX-License-Identifier: MIT
#pragma once

#include <support/same_records.hpp>

#include <gtest/gtest.h>

namespace support {
inline namespace KODO_PRECISION {

/// Succeeds if the shorter lists of a World are the records of `all` that they should have.
inline testing::AssertionResult areFiltered(const World& world,
                                            std::span<const CollisionRecord> all) {
    const auto phase = [&](kodo::TouchPhase is) {
        return recordsWith(all, [=](const CollisionRecord& r) { return r.phase == is; });
    };
    if (!sameRecords(world.begunCollisions(), phase(kodo::TouchPhase::Begin))) {
        return testing::AssertionFailure() << "begins differ";
    }
    if (!sameRecords(world.endedCollisions(), phase(kodo::TouchPhase::End))) {
        return testing::AssertionFailure() << "ends differ";
    }
    for (const kodo::Real speed : {kodo::Real(0), kodo::Real(0.1), kodo::Real(1), kodo::Real(5)}) {
        const auto isHit = [=](const CollisionRecord& r) {
            return r.maxImpulse > 0 && r.approachSpeed >= speed;
        };
        if (!sameRecords(world.hits(speed), recordsWith(all, isHit))) {
            return testing::AssertionFailure() << "hits from " << speed << " m/s on differ";
        }
    }
    for (const kodo::BodyId id : world.bodies()) {
        const auto own = [=](const CollisionRecord& r) { return r.involves(id); };
        if (!sameRecords(world.collisions(id), recordsWith(all, own))) {
            return testing::AssertionFailure() << "records of body " << id.index << " differ";
        }
    }
    return testing::AssertionSuccess();
}

/// Succeeds if the shorter lists agree with collisions(), whichever is read first. Reads copies of
/// the World.
inline testing::AssertionResult eventsMatchRecords(const World& world) {
    const World before = world;
    const World after = world;
    const std::span<const CollisionRecord> all = after.collisions();
    if (const auto result = areFiltered(before, all); !result) {
        return testing::AssertionFailure() << result.message() << " if they are read first";
    }
    if (const auto result = areFiltered(after, all); !result) {
        return testing::AssertionFailure() << result.message() << " if all were read before";
    }
    return sameRecords(before.collisions(), all)
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << "all records differ after the shorter lists";
}

} // namespace KODO_PRECISION
} // namespace support
