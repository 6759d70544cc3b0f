// SPDX-License-Identifier: MIT
// Constraint graph of ContactBlocks: blocks and lanes of contacts, and its rebuild.
#include <algorithm>
#include <bit>
#include <utility>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
/// Assigns a lane to every contact that has a colour, after a snapshot was read or most lanes were
/// empty.
void ContactBlocks::assignRows(const ContactList& contacts) {
    layOut(contacts);
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        assignRow(contacts[slot]);
    }
    rowsAssigned_ = true;
    lanesStale_ = true;
    reorderPolicy_ = {};
}

/// Adds as many blocks as the contacts need. The blocks of a partition and a colour are
/// consecutive, in the order of a pass.
void ContactBlocks::layOut(const ContactList& contacts) {
    open_.assign(BlockBins::kBins * partitions_.count(), 0); // at first the numbers of contacts
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        const ContactEntry entry = contacts[slot];
        if (entry.summary.row.colour != ContactRow::kNoColour) {
            ++openOf(binOf(entry), partitions_.of(entry.summary.bodyA));
        }
    }
    for (std::uint32_t place = 0; place < open_.size(); ++place) {
        const std::size_t count = std::exchange(open_[place], kNone);
        std::uint32_t before = kNone;
        for (std::size_t first = 0; first < count; first += ContactBlock::kContacts) {
            const std::uint32_t block = addBlock(
                place % BlockBins::kBins, static_cast<std::uint8_t>(place / BlockBins::kBins));
            (before == kNone ? open_[place] : states_[before].nextOpen) = block;
            before = block;
        }
    }
}

void ContactBlocks::rebuildGraph(const Bodies& bodies, const ContactList& contacts,
                                 std::span<const std::uint32_t> order, std::uint32_t partitions) {
    partitions_.find(bodies, contacts.summaries, partitions);
    leaveAll(contacts);
    forgetLanes();
    layOut(contacts);
    for (const std::uint32_t slot : order) {
        assignRow(contacts[slot]);
    }
    rowsAssigned_ = true;
    lanesStale_ = true;
    reorderPolicy_ = {};
}

void ContactBlocks::assignRow(const ContactEntry& entry) {
    ContactRow& row = entry.summary.row;
    if (row.colour == ContactRow::kNoColour) {
        return;
    }
    const std::uint64_t colour = std::uint64_t{1} << row.colour;
    const std::uint64_t colourA = row.fixedA ? 0 : colour;
    const std::uint64_t colourB = row.fixedB ? 0 : colour;
    std::uint64_t& ofA = colours_[entry.summary.bodyA];
    std::uint64_t& ofB = colours_[entry.summary.bodyB];
    if (((ofA & colourA) | (ofB & colourB)) != 0) {
        row = {}; // only for a forged snapshot
        return;
    }
    ofA |= colourA;
    ofB |= colourB;
    assignLane(entry, binOf(entry));
}

/// Index of a block of the bin that has a free lane.
std::uint32_t ContactBlocks::openBlock(std::uint32_t bin, std::uint8_t partition) {
    std::uint32_t& open = openOf(bin, partition);
    return open != kNone ? open : open = addBlock(bin, partition);
}

std::uint32_t ContactBlocks::addBlock(std::uint32_t bin, std::uint8_t partition) {
    const auto block = static_cast<std::uint32_t>(blocks_.size());
    ContactBlock& lanes = blocks_.emplace_back();
    states_.reserve(blocks_.capacity());
    taken_.resize(blocks_.size() * ContactBlock::kContacts);
    use_.reserve(blocks_.capacity());
    passOrder_.reserve(blocks_.capacity());
    std::fill_n(lanes.a, ContactBlock::kContacts, velocityOffset(spare_));
    std::fill_n(lanes.b, ContactBlock::kContacts, velocityOffset(spare_));
    states_.push_back({bin, kNone, 0, 0, 0, partition});
    use_.push_back({-1, bin % 2 == 1, BlockBins::groupOf(bin) > kFreeColours, 0, 0});
    return block;
}

/// Gives a contact without a colour a block of its own.
void ContactBlocks::assignSingleLane(const ContactEntry& entry, std::uint32_t bin) {
    const std::uint32_t block = openBlock(bin, 0);
    assignLaneOf(block, entry);
    openOf(bin, 0) = states_[block].nextOpen;
}

void ContactBlocks::assignLane(const ContactEntry& entry, std::uint32_t bin) {
    const std::uint8_t partition = partitions_.of(entry.summary.bodyA);
    const std::uint32_t block = openBlock(bin, partition);
    assignLaneOf(block, entry);
    if (states_[block].used == 0xff) {
        openOf(bin, partition) = states_[block].nextOpen;
    }
    ++reorderPolicy_.strayed;
}

/// Moves a contact from its waiting lane to one of the block.
void ContactBlocks::assignLaneOf(std::uint32_t block, const ContactEntry& entry) {
    const ContactNumbers numbers = waiting(entry.slot).numbers();
    ContactRow& row = entry.summary.row;
    BlockState& state = states_[block];
    const auto lane = static_cast<std::uint32_t>(std::countr_one(state.used));
    orderStale_ = orderStale_ || state.used == 0;
    const auto mask = static_cast<std::uint8_t>(1u << lane);
    state.used |= mask;
    const auto put = [&](std::uint8_t& lanes, bool value) {
        lanes = static_cast<std::uint8_t>(value ? lanes | mask : lanes & ~mask);
    };
    put(state.fixedA, row.fixedA);
    put(state.fixedB, row.fixedB);
    put(use_[block].movesA, !row.fixedA);
    put(use_[block].movesB, !row.fixedB);
    ++rows_[BlockBins::levelOf(state.bin)];
    row.index = block * ContactBlock::kContacts + lane;
    taken_[row.index] = 1;
    blocks_[block].a[lane] = velocityOffset(entry.summary.bodyA);
    blocks_[block].b[lane] = velocityOffset(entry.summary.bodyB);
    this->lane(entry.slot, entry.summary) = numbers;
}

void ContactBlocks::forgetLanes() {
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
        for (std::uint32_t used = states_[block].used; used != 0; used &= used - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(used));
            colours_[bodyOfPlace(blocks_[block].a[lane])] = 0;
            colours_[bodyOfPlace(blocks_[block].b[lane])] = 0;
        }
    }
    taken_.clear();
    blocks_.clear();
    use_.clear();
    states_.clear();
    surfaces_.clear();
    passOrder_.clear();
    rows_ = {};
    orderStale_ = true;
    rowsAssigned_ = false;
}

} // namespace KODO_PRECISION
} // namespace kodo
