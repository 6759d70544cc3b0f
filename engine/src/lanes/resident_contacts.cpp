// SPDX-License-Identifier: MIT
// Residency of contacts in ContactBlocks across steps, and their write-back.
#include <utility>

#include "lanes/contact_block_lanes.hpp"
#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void ContactBlocks::noteTouching(Real slop, WorkerTeam& team) {
    touching_.resize(taken_.size() + 1); // the last entry is false
    touching_.back() = 0;
    const std::span<const std::uint32_t> inUse = passOrder_.inMemory();
    team.forEach(inUse.size(), kBlocksPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const ContactBlock& block = blocks_[inUse[k]];
            std::uint8_t* const touching =
                &touching_[inUse[k] * std::size_t{ContactBlock::kContacts}];
            const auto touches = [&](const ContactBlock::Point& point, std::size_t lane) {
                return point.separation[lane] <= slop || point.largest[lane] > 0;
            };
            const bool two = use_[inUse[k]].twoPoints;
            for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
                touching[lane] =
                    touches(block.points[0], lane) || (two && touches(block.points[1], lane));
            }
        }
    });
}

void ContactBlocks::carry(Bodies& bodies, WorkerTeam& team) {
    // In the step after bodies were added, so that no first contact costs a step as much as all.
    if (colours_.size() != bodies.size()) {
        resizeByBody(colours_, bodies);
        resizeByBody(sharedOf_, bodies, kNone); // all kNone between steps
        if (!refinedLevels_.empty()) {
            resizeByBody(refinedLevels_, bodies);
        }
    }
    if (!anyResident_) {
        return;
    }
    const std::span<const std::uint32_t> inUse = passOrder_.inMemory();
    team.forEach(inUse.size(), kBlocksPerPiece, [&](std::size_t first, std::size_t last) {
        ContactPasses::best().carry({blocks_.data(), carried_.data(), use_.data(),
                                     inUse.data() + first, last - first, bodies.motion.data(),
                                     bodies.extent.data(), areFar()});
    });
}

/// From now on the lane holds all state of the contact that changes from step to step.
void ContactBlocks::makeResident(Contact& contact) {
    const std::uint32_t row = contact.row.index;
    ContactBlock& block = blocks_[blockOf(row)];
    carried_[row] = {separationsOf(contact.manifold), contact.approachSpeed,
                     contact.relativeDisplacement};
    for (std::size_t i = 0; i < carried_[row].separation.size(); ++i) {
        block.points[i].separation[laneOf(row)] = carried_[row].separation[i];
    }
    contact.row.resident = true;
}

void ContactBlocks::evict(Contact& contact, const Bodies& bodies) const {
    if (!std::exchange(contact.row.resident, false)) {
        return;
    }
    const Carried& carried = carried_[contact.row.index];
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        contact.manifold.points[i].separation = carried.separation[i];
    }
    contact.approachSpeed = carried.approachSpeed;
    contact.relativeDisplacement = carried.relativeDisplacement;
    contact.centerA = bodies.start[contact.key.bodyA];
    const std::size_t block = blockOf(contact.row.index);
    const std::size_t lane = laneOf(contact.row.index);
    const Real parts = BlockBins::partsOf(states_[block].bin);
    readImpulses(blocks_[block], lane, contact, parts);
    const std::int32_t rolling = use_[block].rolling;
    contact.rolling =
        rolling < 0 ? Real(0) : parts * rolling_[static_cast<std::size_t>(rolling)].impulse[lane];
}

ContactBlocks::Lane ContactBlocks::laneAt(std::uint32_t row) {
    const std::int32_t rolling = use_[blockOf(row)].rolling;
    return {blocks_[blockOf(row)],
            rolling < 0 ? nullptr : &rolling_[static_cast<std::size_t>(rolling)], laneOf(row)};
}

void ContactBlocks::evictAll(std::span<Contact> contacts, const Bodies& bodies) {
    if (std::exchange(anyResident_, false)) {
        for (Contact& contact : contacts) {
            evict(contact, bodies);
        }
    }
}

void ContactBlocks::writeBack(Contact& contact, const Bodies& bodies) const {
    if (contact.row.resident) {
        evict(contact, bodies);
        const std::uint32_t row = contact.row.index;
        readImpactImpulses(blocks_[blockOf(row)], laneOf(row), contact,
                           BlockBins::partsOf(states_[blockOf(row)].bin));
    }
}

void ContactBlocks::writeBackAll(std::span<Contact> contacts, const Bodies& bodies) {
    if (std::exchange(anyResident_, false)) {
        for (Contact& contact : contacts) {
            writeBack(contact, bodies);
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
