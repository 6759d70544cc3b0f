// SPDX-License-Identifier: MIT
#include "lanes/contact_blocks.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "lanes/contact_block_lanes.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// True if the colour of the contact still fits its bodies.
bool keepsColour(const Bodies& bodies, const ContactSummary& summary) {
    const ContactRow& row = summary.row;
    const BodyVelocity& a = bodies.motion[summary.bodyA];
    const BodyVelocity& b = bodies.motion[summary.bodyB];
    const bool onLocked = a.invMass == 0 || b.invMass == 0;
    return row.colour != ContactRow::kNoColour &&
           (row.colour >= BlockBins::kFreeColours) == onLocked && row.fixedA == a.locked() &&
           row.fixedB == b.locked();
}

/// Mask of the lanes of a block that are in use but were not taken in this step.
std::uint8_t removedLanes(const BlockState& state, const std::uint8_t* taken) {
    constexpr std::size_t kContacts = ContactBlock::kContacts;
    std::uint64_t marks = 0; // byte `lane` is 0 or 1
    for (std::uint32_t lane = 0; lane < kContacts; ++lane) {
        marks |= std::uint64_t{taken[lane]} << (8 * lane);
    }
    const std::uint64_t mask = (marks * 0x0102040810204080) >> 56; // bit `lane`
    return static_cast<std::uint8_t>(state.used & ~mask);
}

} // namespace

void ContactBlocks::begin(const ContactList& contacts, bool friction, bool rolling) {
    const std::size_t bins = BlockBins::kLevelBins * (refinedLevels_.empty() ? 1 : kLevels);
    const std::size_t full = uncoloured_ + bins * partitions_.count() + size() / 4;
    if (passOrder_.blocks().size() > full || blocks_.size() > kFewBlocks + contacts.size()) {
        // Most lanes are empty, as after a large pile has fallen asleep.
        leaveAll(contacts);
        forgetLanes();
    }
    uncoloured_ = 0;
    if (!rowsAssigned_) {
        assignRows(contacts);
    }
    const Features before = std::exchange(features_, {friction, rolling});
    lanesStale_ = lanesStale_ || features_ != before;
    if (rolling != before.rolling) {
        surfaces_.clear();
        for (BlockUse& use : use_) {
            use.surface = -1;
        }
    }
    if (std::exchange(orderStale_, false)) {
        passOrder_.build(states_);
    }
    std::fill(taken_.begin(), taken_.end(), std::uint8_t{0});
}

/// True if the block of the contact needs a SurfaceBlock.
bool ContactBlocks::needsSurface(const Contact& contact) const {
    return (features_.rolling && contact.material.rollingResistance > 0) ||
           contact.material.surfaceSpeed != 0;
}

bool ContactBlocks::take(const Bodies& bodies, const ContactEntry& entry) {
    auto& [contact, summary, slot] = entry;
    const bool valid =
        contact.filled && !lanesStale_ && summary.row.colour != ContactRow::kNoColour;
    if (!valid && !keepsColour(bodies, summary)) {
        leave(entry);
        return false;
    }
    taken_[summary.row.index] = 1;
    if (!valid) {
        const bool lacksSurface = use_[blockOf(summary.row.index)].surface < 0;
        if (!fitsBin(entry) || (lacksSurface && needsSurface(contact))) {
            return false;
        }
        fill(bodies, entry);
    }
    summary.kept = lane(slot, summary).impacts() == 0; // impacts are reset in the next step
    return true;
}

/// Frees the lanes that were not taken. Their contacts are gone, no longer respond, or need another
/// colour.
void ContactBlocks::freeLanes(const Bodies& bodies) {
    if (std::exchange(spare_, bodies.spare()) != bodies.spare()) {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
                if ((states_[i].used >> lane & 1) == 0) {
                    blocks_[i].a[lane] = blocks_[i].b[lane] = velocityOffset(spare_);
                }
            }
        }
    }
    // Backwards, so that a block of a single contact comes first among those that are open.
    const std::span<const std::uint32_t> order = passOrder_.blocks();
    for (std::size_t k = order.size(); k-- > 0;) {
        const std::uint32_t i = order[k];
        const std::uint8_t* const taken = &taken_[i * std::size_t{ContactBlock::kContacts}];
        for (std::uint32_t rest = removedLanes(states_[i], taken); rest != 0; rest &= rest - 1) {
            release(i * ContactBlock::kContacts +
                    static_cast<std::uint32_t>(std::countr_zero(rest)));
        }
    }
}

/// Frees a lane and the colour of its contact.
void ContactBlocks::release(std::uint32_t row) {
    const ContactBlock& block = blocks_[blockOf(row)];
    const BlockState& state = states_[blockOf(row)];
    const std::uint32_t group = BlockBins::groupOf(state.bin);
    if (!BlockBins::isSingle(state.bin)) {
        const std::uint64_t colour = std::uint64_t{1} << (group - (group > kFreeColours ? 1 : 0));
        colours_[bodyOfPlace(block.a[laneOf(row)])] &=
            ~((state.fixedA & laneMask(row)) != 0 ? 0 : colour);
        colours_[bodyOfPlace(block.b[laneOf(row)])] &=
            ~((state.fixedB & laneMask(row)) != 0 ? 0 : colour);
    }
    empty(row);
}

/// Frees a lane.
void ContactBlocks::empty(std::uint32_t row) {
    BlockState& state = states_[blockOf(row)];
    const bool wasFull = state.used == 0xff;
    state.used &= static_cast<std::uint8_t>(~laneMask(row));
    if (BlockBins::isSingle(state.bin) ? state.used == 0 : wasFull) {
        std::uint32_t* open = &openOf(state.bin, state.partition);
        while (BlockBins::isSingle(state.bin) && *open < blockOf(row)) { // in order again
            open = &states_[*open].nextOpen;
        }
        state.nextOpen = std::exchange(*open, static_cast<std::uint32_t>(blockOf(row)));
    }
    orderStale_ = orderStale_ || state.used == 0;
    --rows_[BlockBins::levelOf(state.bin)];
    ContactBlock& block = blocks_[blockOf(row)];
    const std::size_t lane = laneOf(row);
    clearLane(block, lane);
    block.a[lane] = block.b[lane] = velocityOffset(spare_);
    use_[blockOf(row)].movesA &= static_cast<std::uint8_t>(~laneMask(row));
    use_[blockOf(row)].movesB &= static_cast<std::uint8_t>(~laneMask(row));
    if (const std::int32_t surface = use_[blockOf(row)].surface; surface >= 0) {
        SurfaceBlock& own = surfaces_[static_cast<std::size_t>(surface)];
        own.rollingLever[lane] = own.rollingMass[lane] = own.speed[lane] = 0;
    }
}

void ContactBlocks::colourNewcomer(const Bodies& bodies, const ContactEntry& entry) {
    const std::uint32_t a = entry.summary.bodyA;
    const std::uint32_t b = entry.summary.bodyB;
    const BodyVelocity& motionA = bodies.motion[a];
    const BodyVelocity& motionB = bodies.motion[b];
    const bool onLocked = motionA.invMass == 0 || motionB.invMass == 0;
    ContactRow& row = entry.summary.row;
    row = {};
    row.fixedA = motionA.locked();
    row.fixedB = motionB.locked();
    constexpr std::uint64_t kFree = (std::uint64_t{1} << kFreeColours) - 1;
    const std::uint64_t taken = (row.fixedA ? 0 : colours_[a]) | (row.fixedB ? 0 : colours_[b]) |
                                (onLocked ? kFree : ~kFree);
    const auto colour = static_cast<std::uint32_t>(std::countr_one(taken));
    if (colour == BlockBins::kColours || (colour >= kFreeColours && !onLocked)) {
        const std::uint32_t group = onLocked ? BlockBins::kGroups - 1 : kFreeColours;
        ++uncoloured_;
        assignSingleLane(entry, binOf(group, entry));
    } else {
        row.colour = static_cast<std::uint8_t>(colour);
        colours_[a] |= row.fixedA ? 0 : std::uint64_t{1} << colour;
        colours_[b] |= row.fixedB ? 0 : std::uint64_t{1} << colour;
        assignLane(entry, binOf(entry));
    }
}

void ContactBlocks::arrange(const Bodies& bodies, const ContactList& contacts,
                            std::span<const std::uint32_t> newcomers,
                            std::span<const std::uint16_t> crowd, Real pushSpeed) {
    freeLanes(bodies);
    setPushSpeeds(crowd, pushSpeed);
    rearrange(bodies, contacts, newcomers, crowd);
    lanesStale_ = false;
}

void ContactBlocks::rearrange(const Bodies& bodies, const ContactList& contacts,
                              std::span<const std::uint32_t> newcomers,
                              std::span<const std::uint16_t> crowd) {
    for (const std::uint32_t slot : newcomers) {
        const ContactEntry entry = contacts[slot];
        auto& [contact, summary, place] = entry;
        if (!summary.inPasses()) {
            colourNewcomer(bodies, entry);
        } else if (!fitsBin(entry)) {
            const std::uint32_t before = summary.row.index;
            leave(entry);
            empty(before);
            assignLane(entry, binOf(entry));
        }
        fill(bodies, entry);
        setPushSpeed(blocks_[blockOf(summary.row.index)], laneOf(summary.row.index), crowd);
        summary.kept =
            summary.row.colour != ContactRow::kNoColour && lane(slot, summary).impacts() == 0;
    }
    if (std::exchange(orderStale_, false)) {
        passOrder_.build(states_);
    }
}

void ContactBlocks::setPushSpeeds(std::span<const std::uint16_t> crowd, Real pushSpeed) {
    if (crowd.empty() && !pushLimit_.shared && pushSpeed == pushLimit_.speed) {
        return;
    }
    pushLimit_ = {pushSpeed, !crowd.empty()};
    for (const std::uint32_t i : passOrder_.blocks()) {
        ContactBlock& block = blocks_[i];
        for (std::uint32_t used = states_[i].used; used != 0; used &= used - 1) {
            setPushSpeed(block, static_cast<std::size_t>(std::countr_zero(used)), crowd);
        }
    }
}

/// The overlaps of the more crowded body of a lane share the push speed.
void ContactBlocks::setPushSpeed(ContactBlock& block, std::size_t lane,
                                 std::span<const std::uint16_t> crowd) const {
    const int most = pushLimit_.shared ? std::max(crowd[bodyOfPlace(block.a[lane])],
                                                  crowd[bodyOfPlace(block.b[lane])])
                                       : 0;
    const int crowded = std::min(most, kMostOverlaps);
    block.pushSpeed[lane] = crowded > kNeighbours
                                ? pushLimit_.speed / static_cast<Real>(crowded + 1 - kNeighbours)
                                : pushLimit_.speed;
}

void ContactBlocks::fill(const Bodies& bodies, const ContactEntry& entry) {
    Contact& contact = entry.contact;
    const std::uint32_t row = entry.summary.row.index;
    const std::size_t lane = laneOf(row);
    ContactBlock& block = blocks_[blockOf(row)];
    BlockUse& use = use_[blockOf(row)];
    const LaneRules rules{pushLimit_.speed, features_.rolling};
    fillLane(block, lane, bodies, contact, rules);
    if (contact.material.staticFriction > contact.material.kineticFriction ||
        contact.material.surfaceSpeed != 0) {
        use.rareFriction = true;
    }
    if (use.surface < 0 && needsSurface(contact)) {
        use.surface = static_cast<std::int32_t>(surfaces_.size());
        surfaces_.emplace_back();
    }
    if (use.surface >= 0) {
        fillLane(surfaces_[static_cast<std::size_t>(use.surface)], block, lane, bodies, contact,
                 rules);
    } else {
        block.rolling[lane] = 0;
    }
    contact.filled = true;
}

ContactPassArguments ContactBlocks::pass(Bodies& bodies, std::uint32_t level,
                                         const PassSettings& settings) {
    const std::span<const std::uint32_t> order = passOrder_.blocks(level);
    return {blocks_.data(), surfaces_.data(),     use_.data(), order.data(),
            order.size(),   bodies.motion.data(), settings,    areFar()};
}

} // namespace KODO_PRECISION
} // namespace kodo
