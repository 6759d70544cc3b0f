// SPDX-License-Identifier: MIT
// Lanes of ContactBlocks as the home of contacts from step to step.
#include "base/vector_reuse.hpp"

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

void ContactBlocks::leaveAll(const ContactList& contacts) {
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        leave(contacts[slot]);
    }
}

void ContactBlocks::findTouching(Real slop, WorkerTeam& team) {
    touching_.resize(taken_.size());
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

void ContactBlocks::advance(Bodies& bodies, WorkerTeam& team) {
    // In the step after bodies were added, so that no first contact costs a step as much as all.
    if (colours_.size() != bodies.size()) {
        resizeByBody(colours_, bodies);
        if (!refinedLevels_.empty()) {
            resizeByBody(refinedLevels_, bodies);
        }
    }
    if (size() == 0) {
        return;
    }
    const std::span<const std::uint32_t> inUse = passOrder_.inMemory();
    team.forEach(inUse.size(), kBlocksPerPiece, [&](std::size_t first, std::size_t last) {
        ContactPasses::best().advance({blocks_.data(), use_.data(), inUse.data() + first,
                                       last - first, bodies.motion.data(), bodies.extent.data(),
                                       areFar()});
    });
}

} // namespace KODO_PRECISION
} // namespace kodo
