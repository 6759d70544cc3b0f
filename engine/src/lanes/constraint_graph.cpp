// SPDX-License-Identifier: MIT
// Constraint graph of ContactBlocks: blocks and lanes of contacts, and its rebuild.
#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
/// Assigns a lane to every contact that has a colour, after a snapshot was read or most lanes were
/// empty.
void ContactBlocks::assignRows(std::span<Contact> contacts) {
    layOut(contacts);
    for (Contact& contact : contacts) {
        assignRow(contact);
    }
    rowsAssigned_ = true;
    lanesStale_ = true;
    reorderPolicy_ = {};
}

/// Adds as many blocks as the contacts need. The blocks of a partition and a colour are
/// consecutive, in the order of a pass.
void ContactBlocks::layOut(std::span<const Contact> contacts) {
    open_.assign(BlockBins::kBins * partitions_.count(), 0); // at first the numbers of contacts
    for (const Contact& contact : contacts) {
        if (contact.row.colour != ContactRow::kNoColour) {
            const std::uint32_t group = BlockBins::groupOfColour(contact.row.colour);
            ++openOf(binOf(group, contact), partitions_.of(contact.key.bodyA));
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

void ContactBlocks::rebuildGraph(const Bodies& bodies, ContactSet& contacts,
                                 std::uint32_t partitions) {
    partitions_.find(bodies, contacts.summaries(), partitions);
    evictAll(contacts.contacts(), bodies);
    forgetLanes();
    layOut(contacts.contacts());
    contacts.store().forEachInOrder(
        [&](std::uint32_t slot) { assignRow(contacts.contacts()[slot]); });
    rowsAssigned_ = true;
    lanesStale_ = true;
    reorderPolicy_ = {};
}

void ContactBlocks::assignRow(Contact& contact) {
    ContactRow& row = contact.row;
    row.index = kNone;
    if (row.colour == ContactRow::kNoColour) {
        return;
    }
    const std::uint64_t colour = std::uint64_t{1} << row.colour;
    const std::uint64_t colourA = row.fixedA ? 0 : colour;
    const std::uint64_t colourB = row.fixedB ? 0 : colour;
    std::uint64_t& ofA = colours_[contact.key.bodyA];
    std::uint64_t& ofB = colours_[contact.key.bodyB];
    if (((ofA & colourA) | (ofB & colourB)) != 0) {
        row = {}; // only for a forged snapshot
        return;
    }
    ofA |= colourA;
    ofB |= colourB;
    giveLane(contact, binOf(BlockBins::groupOfColour(row.colour), contact));
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
    carried_.resize(taken_.size());
    use_.reserve(blocks_.capacity());
    passOrder_.reserve(blocks_.capacity());
    std::fill_n(lanes.a, ContactBlock::kContacts, velocityOffset(spare_));
    std::fill_n(lanes.b, ContactBlock::kContacts, velocityOffset(spare_));
    states_.push_back({bin, kNone, 0, 0, 0, partition});
    use_.push_back({-1, bin % 2 == 1, BlockBins::groupOf(bin) > kFreeColours, 0, 0, Shared::None});
    return block;
}

/// Gives a contact without a colour a lane. Contacts of a body that has no free colour share
/// blocks.
void ContactBlocks::giveSingleLane(Contact& contact, std::uint32_t bin, Shared shared) {
    if (shared == Shared::None) {
        const std::uint32_t block = openBlock(bin, 0);
        use_[block].shared = shared;
        giveLaneOf(block, contact);
        openOf(bin, 0) = states_[block].nextOpen;
        return;
    }
    const bool isA = shared == Shared::BodyA;
    const std::uint32_t body = isA ? contact.key.bodyA : contact.key.bodyB;
    const std::uint32_t other = isA ? contact.key.bodyB : contact.key.bodyA;
    std::uint32_t& open = sharedOf_[body];
    const auto fits = [&](std::uint32_t block) {
        const ContactBlock& lanes = blocks_[block];
        const auto& others = isA ? lanes.b : lanes.a;
        const bool fixed = isA ? contact.row.fixedB : contact.row.fixedA;
        return states_[block].bin == bin && use_[block].shared == shared &&
               states_[block].used != 0xff &&
               (fixed || std::find(std::begin(others), std::end(others), velocityOffset(other)) ==
                             std::end(others));
    };
    if (open == kNone) {
        sharedBodies_.push_back(body);
    }
    if (open == kNone || !fits(open)) {
        open = openBlock(bin, 0);
        openOf(bin, 0) = states_[open].nextOpen;
        use_[open].shared = shared;
        ContactBlock& lanes = blocks_[open]; // also unused lanes have a copy
        std::fill_n(isA ? lanes.a : lanes.b, ContactBlock::kContacts, velocityOffset(body));
    }
    giveLaneOf(open, contact);
}

void ContactBlocks::giveLane(Contact& contact, std::uint32_t bin) {
    const std::uint8_t partition = partitions_.of(contact.key.bodyA);
    const std::uint32_t block = openBlock(bin, partition);
    giveLaneOf(block, contact);
    if (states_[block].used == 0xff) {
        openOf(bin, partition) = states_[block].nextOpen;
    }
    ++reorderPolicy_.strayed;
}

void ContactBlocks::giveLaneOf(std::uint32_t block, Contact& contact) {
    BlockState& state = states_[block];
    const auto lane = static_cast<std::uint32_t>(std::countr_one(state.used));
    orderStale_ = orderStale_ || state.used == 0;
    const auto mask = static_cast<std::uint8_t>(1u << lane);
    state.used |= mask;
    const auto put = [&](std::uint8_t& lanes, bool value) {
        lanes = static_cast<std::uint8_t>(value ? lanes | mask : lanes & ~mask);
    };
    put(state.fixedA, contact.row.fixedA);
    put(state.fixedB, contact.row.fixedB);
    put(use_[block].movesA, !contact.row.fixedA);
    put(use_[block].movesB, !contact.row.fixedB);
    ++rows_[BlockBins::levelOf(state.bin)];
    contact.row.index = block * ContactBlock::kContacts + lane;
    taken_[contact.row.index] = 1;
    blocks_[block].a[lane] = velocityOffset(contact.key.bodyA);
    blocks_[block].b[lane] = velocityOffset(contact.key.bodyB);
}

void ContactBlocks::forgetLanes() {
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
        for (std::uint32_t used = states_[block].used; used != 0; used &= used - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(used));
            colours_[bodyOfPlace(blocks_[block].a[lane])] = 0;
            colours_[bodyOfPlace(blocks_[block].b[lane])] = 0;
        }
    }
    carried_.clear();
    taken_.clear();
    blocks_.clear();
    use_.clear();
    states_.clear();
    rolling_.clear();
    passOrder_.clear();
    rows_ = {};
    lanesState_ += 2;
    orderStale_ = true;
    rowsAssigned_ = false;
}

} // namespace KODO_PRECISION
} // namespace kodo
