// SPDX-License-Identifier: MIT
// Rebuild of the constraint graph of ContactBlocks: assigns all lanes.
#include "solve/contact_blocks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kCutBins = 256; // bins of the histogram of bodies in findCuts()

} // namespace

/// Assigns a lane to every contact that has a colour, after a snapshot was read or most lanes were
/// empty.
void ContactBlocks::assignRows(std::span<Contact> contacts) {
    layOut(contacts);
    for (Contact& contact : contacts) {
        assignRow(contact);
    }
    finishGraph();
}

void ContactBlocks::finishGraph() {
    rowsAssigned_ = true;
    lanesStale_ = true;
    reorderPolicy_ = {};
}

/// Finds the first body of each partition, so that all partitions have about as many contacts.
void ContactBlocks::findCuts(const Bodies& bodies, ContactSet& contacts, std::uint32_t partitions) {
    const std::uint32_t width = static_cast<std::uint32_t>(bodies.size() / kCutBins) + 1;
    std::array<std::uint32_t, kCutBins> counts{};
    for (const ContactSummary& summary : contacts.summaries()) {
        counts[summary.bodyA / width] += summary.row != kNone ? 1 : 0;
    }
    const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    cuts_.assign(1, 0);
    std::size_t before = 0;
    for (std::uint32_t bin = 0; cuts_.size() < partitions; ++bin) {
        before += counts[bin];
        while (cuts_.size() < partitions && (before * partitions >= all * cuts_.size())) {
            cuts_.push_back((bin + 1) * width);
        }
    }
}

/// Adds as many blocks as the contacts need. The blocks of a partition and a colour are
/// consecutive, in the order of a pass.
void ContactBlocks::layOut(std::span<const Contact> contacts) {
    open_.assign(kBins * cuts_.size(), 0); // at first the numbers of contacts
    for (const Contact& contact : contacts) {
        if (contact.row.colour != ContactRow::kNoColour) {
            ++openOf(binOf(contact.row.colour, contact), partitionOfBody(contact.key.bodyA));
        }
    }
    for (std::uint32_t place = 0; place < open_.size(); ++place) {
        const std::size_t count = std::exchange(open_[place], kNone);
        std::uint32_t before = kNone;
        for (std::size_t first = 0; first < count; first += ContactBlock::kContacts) {
            const std::uint32_t block =
                addBlock(place % kBins, static_cast<std::uint8_t>(place / kBins));
            (before == kNone ? open_[place] : states_[before].nextOpen) = block;
            before = block;
        }
    }
}

void ContactBlocks::rebuildGraph(const Bodies& bodies, ContactSet& contacts,
                                 std::uint32_t partitions) {
    findCuts(bodies, contacts, partitions);
    colours_.resize(bodies.size());
    evictAll(contacts.contacts(), bodies);
    forgetLanes();
    layOut(contacts.contacts());
    contacts.forEachInOrder([&](std::uint32_t slot) { assignRow(contacts.contacts()[slot]); });
    finishGraph();
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
    giveLane(contact, binOf(row.colour, contact));
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
    order_.clear();
    inUse_.clear();
    rows_ = 0;
    for (Level& level : levels_) {
        level.rows = 0;
    }
    lanesState_ += 2;
    orderStale_ = true;
    rowsAssigned_ = false;
}

} // namespace KODO_PRECISION
} // namespace kodo
