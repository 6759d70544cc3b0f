// SPDX-License-Identifier: MIT
// How ContactBlocks deals out all lanes anew.
#include <kodo/solve/contact_blocks.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

constexpr std::size_t kCutBins = 256; // that bodies are counted in, to find where to cut

} // namespace

/// Gives lanes to all contacts that have a colour: they were read from a snapshot, or most lanes
/// were empty.
void ContactBlocks::assignRows(std::span<Contact> contacts) {
    layOut(contacts);
    for (Contact& contact : contacts) {
        assignRow(contact);
    }
    finishDealing();
}

void ContactBlocks::finishDealing() {
    rowsAssigned_ = true;
    anew_ = true;
    disorder_ = {};
}

/// Cuts the bodies, in their order, so that each share has about as many contacts.
void ContactBlocks::findCuts(const Bodies& bodies, ContactSet& contacts, std::uint32_t shares) {
    const std::uint32_t width = static_cast<std::uint32_t>(bodies.size() / kCutBins) + 1;
    std::array<std::uint32_t, kCutBins> counts{};
    for (const ContactHead& head : contacts.heads()) {
        counts[head.bodyA / width] += head.row != kNone ? 1 : 0;
    }
    const std::size_t all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    cuts_.assign(1, 0);
    std::size_t before = 0;
    for (std::uint32_t bin = 0; cuts_.size() < shares; ++bin) {
        before += counts[bin];
        while (cuts_.size() < shares && (before * shares >= all * cuts_.size())) {
            cuts_.push_back((bin + 1) * width);
        }
    }
}

/// Opens as many blocks as the contacts need, those of a share and a colour one behind the other,
/// as a pass goes through them.
void ContactBlocks::layOut(std::span<const Contact> contacts) {
    open_.assign(kBins * cuts_.size(), 0); // at first, how many contacts there are
    for (const Contact& contact : contacts) {
        if (contact.row.colour != ContactRow::kNoColour) {
            ++openOf(binOf(contact.row.colour, contact), shareOfBody(contact.key.bodyA));
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

void ContactBlocks::dealAnew(const Bodies& bodies, ContactSet& contacts, std::uint32_t shares) {
    findCuts(bodies, contacts, shares);
    colours_.resize(bodies.size());
    reclaimAll(contacts.contacts(), bodies);
    forgetLanes();
    layOut(contacts.contacts());
    contacts.forEachInOrder([&](Contact& contact) { assignRow(contact); });
    finishDealing();
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
        row = {}; // only where a snapshot was forged
        return;
    }
    ofA |= colourA;
    ofB |= colourB;
    giveLane(contact, binOf(row.colour, contact));
}

void ContactBlocks::forgetLanes() {
    colours_.assign(colours_.size(), 0);
    carried_.assign(carried_.size(), {});
    blocks_.clear();
    use_.clear();
    states_.clear();
    rolling_.clear();
    order_.clear();
    inUse_.clear();
    rows_ = 0;
    lanesState_ += 2;
    orderStale_ = true;
    rowsAssigned_ = false;
}

} // namespace kodo::inline KODO_PRECISION
