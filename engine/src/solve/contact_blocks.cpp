// SPDX-License-Identifier: MIT
#include "solve/contact_blocks.hpp"

#include "solve/contact_block_lanes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

void ContactBlocks::refine(const Refinement& refinement, ContactSet& contacts,
                           const Bodies& bodies) {
    refinedLevels_.assign(refinement.levels().begin(), refinement.levels().end());
    const std::span<const ContactSummary> summaries = contacts.summaries();
    for (std::uint32_t slot = 0; slot < summaries.size(); ++slot) {
        Contact& contact = contacts.contacts()[slot];
        if (summaries[slot].row != kNone &&
            levelOfBin(states_[blockOf(summaries[slot].row)].bin) != levelOf(contact)) {
            evict(contact, bodies);
            contact.carried = false; // so that take() requests another lane
            contacts.noteRow(slot);
        }
    }
}

bool ContactBlocks::worthPartitioning() const {
    for (std::uint32_t level = 0; level < kLevels; ++level) {
        if (worthPartitioning(level)) {
            return true;
        }
    }
    return false;
}

void ContactBlocks::begin(const Bodies& bodies, std::span<Contact> contacts, bool friction,
                          bool rolling) {
    resizeByBody(colours_, bodies);
    if (!refinedLevels_.empty()) {
        resizeByBody(refinedLevels_, bodies);
    }
    const std::size_t bins = kLevelBins * (refinedLevels_.empty() ? 1 : kLevels);
    if (order_.size() > singles_ + bins * cuts_.size() + rows_ / 4) { // most lanes are empty
        evictAll(contacts, bodies);
        forgetLanes();
    }
    shrink(bodies, contacts);
    singles_ = 0;
    ++lanesState_;
    if (!rowsAssigned_) {
        assignRows(contacts);
    }
    lanesStale_ = lanesStale_ || friction != frictionOn_;
    frictionOn_ = friction;
    if (std::exchange(rollingOn_, rolling) != rolling) {
        rolling_.clear();
        for (BlockUse& use : use_) {
            use.rolling = -1;
        }
        lanesStale_ = true;
    }
    if (orderStale_) {
        orderBlocks();
    }
    std::fill(taken_.begin(), taken_.end(), std::uint8_t{0});
}

void ContactBlocks::shrink(const Bodies& bodies, std::span<Contact> contacts) {
    if (blocks_.size() > kFewBlocks + contacts.size()) {
        writeBackAll(contacts, bodies);
        forgetLanes();
    }
}

/// True if the colour of the contact still fits its bodies.
bool ContactBlocks::keepsColour(const Bodies& bodies, const Contact& contact) const {
    const ContactRow& row = contact.row;
    const BodyVelocity& a = bodies.motion[contact.key.bodyA];
    const BodyVelocity& b = bodies.motion[contact.key.bodyB];
    const bool onLocked = a.invMass == 0 || b.invMass == 0;
    return row.colour != ContactRow::kNoColour && (row.colour >= kFreeColours) == onLocked &&
           row.fixedA == a.locked() && row.fixedB == b.locked();
}

/// True if the contact needs a RollingBlock that its block lacks.
bool ContactBlocks::needsRolling(const Contact& contact) const {
    return rollingOn_ && contact.material.rollingResistance > 0 &&
           use_[blockOf(contact.row.index)].rolling < 0;
}

bool ContactBlocks::take(const Bodies& bodies, Contact& contact) {
    ContactRow& row = contact.row;
    if (row.colour != ContactRow::kNoColour && contact.carried && !lanesStale_) {
        keep(row.index);
        if (!row.resident) {
            makeResident(contact);
        }
        return true;
    }
    evict(contact, bodies);
    if (!keepsColour(bodies, contact)) {
        return false;
    }
    taken_[row.index] = 1;
    if (states_[blockOf(row.index)].bin != binOf(row.colour, contact) || needsRolling(contact)) {
        return false;
    }
    fill(bodies, contact);
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
    // Backwards, so that the blocks of single contacts are assigned in order again.
    for (std::size_t k = order_.size(); k-- > 0;) {
        const std::uint32_t i = order_[k];
        for (std::uint32_t rest = removedLanes(i); rest != 0; rest &= rest - 1) {
            release(i * ContactBlock::kContacts +
                    static_cast<std::uint32_t>(std::countr_zero(rest)));
        }
    }
}

void ContactBlocks::releaseAll(const Bodies& bodies) {
    std::fill(taken_.begin(), taken_.end(), std::uint8_t{0});
    freeLanes(bodies);
    anyResident_ = false; // so that carry() skips the empty lanes
}

/// Mask of the lanes of a block that are in use but were not taken in this step.
std::uint8_t ContactBlocks::removedLanes(std::uint32_t block) const {
    constexpr std::size_t kContacts = ContactBlock::kContacts;
    const std::uint8_t* const taken = &taken_[block * kContacts];
    std::uint64_t marks = 0; // byte `lane` is 0 or 1
    for (std::uint32_t lane = 0; lane < kContacts; ++lane) {
        marks |= std::uint64_t{taken[lane]} << (8 * lane);
    }
    const std::uint64_t mask = (marks * 0x0102040810204080) >> 56; // bit `lane`
    return static_cast<std::uint8_t>(states_[block].used & ~mask);
}

/// Frees a lane and the colour of its contact.
void ContactBlocks::release(std::uint32_t row) {
    const ContactBlock& block = blocks_[blockOf(row)];
    const BlockState& state = states_[blockOf(row)];
    const std::uint32_t group = groupOf(state.bin);
    if (!isSingleBin(state.bin)) {
        const std::uint64_t colour = std::uint64_t{1} << (group - (group > kFreeColours ? 1 : 0));
        colours_[bodyOfPlace(block.a[laneOf(row)])] &=
            ~((state.fixedA & maskOf(row)) != 0 ? 0 : colour);
        colours_[bodyOfPlace(block.b[laneOf(row)])] &=
            ~((state.fixedB & maskOf(row)) != 0 ? 0 : colour);
    }
    empty(row);
}

/// Frees a lane.
void ContactBlocks::empty(std::uint32_t row) {
    BlockState& state = states_[blockOf(row)];
    const bool wasFull = state.used == 0xff;
    state.used &= static_cast<std::uint8_t>(~maskOf(row));
    if (isSingleBin(state.bin) ? state.used == 0 : wasFull) {
        state.nextOpen = std::exchange(openOf(state.bin, state.partition),
                                       static_cast<std::uint32_t>(blockOf(row)));
    }
    orderStale_ = orderStale_ || state.used == 0;
    --rows_;
    --levels_[levelOfBin(state.bin)].rows;
    ContactBlock& block = blocks_[blockOf(row)];
    const std::size_t lane = laneOf(row);
    clearLane(block, lane);
    carried_[row] = {}; // else carry() would restore the old separations
    block.a[lane] = block.b[lane] = velocityOffset(spare_);
    use_[blockOf(row)].movesA &= static_cast<std::uint8_t>(~maskOf(row));
    use_[blockOf(row)].movesB &= static_cast<std::uint8_t>(~maskOf(row));
    if (const std::int32_t rolling = use_[blockOf(row)].rolling; rolling >= 0) {
        RollingBlock& own = rolling_[static_cast<std::size_t>(rolling)];
        own.lever[lane] = own.mass[lane] = own.impulse[lane] = 0;
    }
}

void ContactBlocks::colourNewcomer(const Bodies& bodies, Contact& contact) {
    const std::uint32_t a = contact.key.bodyA;
    const std::uint32_t b = contact.key.bodyB;
    const BodyVelocity& motionA = bodies.motion[a];
    const BodyVelocity& motionB = bodies.motion[b];
    const bool onLocked = motionA.invMass == 0 || motionB.invMass == 0;
    ContactRow& row = contact.row;
    row = {};
    row.fixedA = motionA.locked();
    row.fixedB = motionB.locked();
    constexpr std::uint64_t kFree = (std::uint64_t{1} << kFreeColours) - 1;
    const std::uint64_t taken = (row.fixedA ? 0 : colours_[a]) | (row.fixedB ? 0 : colours_[b]) |
                                (onLocked ? kFree : ~kFree);
    const auto colour = static_cast<std::uint32_t>(std::countr_one(taken));
    if (colour == kColours || (colour >= kFreeColours && !onLocked)) {
        const std::uint32_t group = onLocked ? kGroups - 1 : kFreeColours;
        const std::uint64_t allowed = onLocked ? ~kFree : kFree;
        // In a crowd both bodies have many contacts: copies would push them apart too far.
        const auto isFull = [&](std::uint32_t body) {
            return (colours_[body] & allowed) == allowed;
        };
        const auto hasFew = [&](std::uint32_t body) {
            return std::popcount(colours_[body]) <= kFewColours;
        };
        ++singles_;
        giveSingleLane(contact, binOfGroup(group, contact),
                       isFull(a) && !row.fixedA && hasFew(b)   ? Shared::BodyA
                       : isFull(b) && !row.fixedB && hasFew(a) ? Shared::BodyB
                                                               : Shared::None);
    } else {
        row.colour = static_cast<std::uint8_t>(colour);
        colours_[a] |= row.fixedA ? 0 : std::uint64_t{1} << colour;
        colours_[b] |= row.fixedB ? 0 : std::uint64_t{1} << colour;
        giveLane(contact, binOf(colour, contact));
    }
}

/// Lists the blocks in use: order_ by bin, inUse_ in the order of memory.
void ContactBlocks::orderBlocks() {
    std::array<std::uint32_t, kBins + 1> next{};
    std::uint32_t lowest = kBins - 1; // of the bins with a block
    std::uint32_t highest = 0;
    for (const BlockState& state : states_) {
        next[state.bin + 1] += state.used != 0 ? 1 : 0;
        lowest = std::min(lowest, state.bin);
        highest = std::max(highest, state.bin);
    }
    lowest = std::min(lowest, highest);
    std::partial_sum(next.begin() + lowest, next.begin() + highest + 2, next.begin() + lowest);
    const auto firstOf = [&](std::uint32_t bin) {
        return next[std::clamp(bin, lowest, highest + 1)];
    };
    for (std::uint32_t number = 0; number < kLevels; ++number) {
        Level& level = levels_[number];
        const std::uint32_t end = (number + 1) * kLevelBins;
        level.first = firstOf(end - kLevelBins);
        level.count = firstOf(end) - level.first;
        level.colours.clear();
        for (std::uint32_t bin = std::max(end - kLevelBins, lowest / 2 * 2);
             bin < std::min(end, highest + 1); bin += 2) {
            if (const std::uint32_t count = firstOf(bin + 2) - firstOf(bin); count > 0) {
                level.colours.push_back({count, isSingleBin(bin)});
            }
        }
    }
    order_.resize(firstOf(kBins));
    inUse_.clear();
    for (std::uint32_t i = 0; i < states_.size(); ++i) {
        if (states_[i].used != 0) {
            order_[next[states_[i].bin]++] = i;
            inUse_.push_back(i);
        }
    }
    orderStale_ = false;
}

void ContactBlocks::arrange(const Bodies& bodies, std::span<Contact> contacts,
                            std::span<const std::uint32_t> newcomers,
                            std::span<const std::uint16_t> crowd, Real pushSpeed) {
    freeLanes(bodies);
    resizeByBody(sharedOf_, bodies, kNone); // all kNone between steps
    for (const std::uint32_t place : newcomers) {
        Contact& contact = contacts[place];
        if (!keepsColour(bodies, contact)) {
            colourNewcomer(bodies, contact);
        } else if (const std::uint32_t bin = binOf(contact.row.colour, contact);
                   states_[blockOf(contact.row.index)].bin != bin) {
            empty(contact.row.index);
            giveLane(contact, bin);
        }
        fill(bodies, contact);
    }
    for (const std::uint32_t body : sharedBodies_) {
        sharedOf_[body] = kNone;
    }
    sharedBodies_.clear();
    if (orderStale_) {
        orderBlocks();
    }
    setPushSpeeds(crowd, pushSpeed);
    lanesStale_ = false;
    anyResident_ = true;
}

void ContactBlocks::setPushSpeeds(std::span<const std::uint16_t> crowd, Real pushSpeed) {
    if (crowd.empty() && !shared_ && pushSpeed == pushSpeed_) {
        return;
    }
    pushSpeed_ = pushSpeed;
    shared_ = !crowd.empty();
    for (const std::uint32_t i : order_) {
        ContactBlock& block = blocks_[i];
        for (std::uint32_t used = states_[i].used; used != 0; used &= used - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(used));
            const int crowded = shared_ ? std::max(crowd[bodyOfPlace(block.a[lane])],
                                                   crowd[bodyOfPlace(block.b[lane])])
                                        : 0;
            block.pushSpeed[lane] =
                pushSpeed / static_cast<Real>(std::max(1, crowded + 1 - kNeighbours));
        }
    }
}

void ContactBlocks::fill(const Bodies& bodies, Contact& contact) {
    const std::size_t lane = laneOf(contact.row.index);
    ContactBlock& block = blocks_[blockOf(contact.row.index)];
    const LaneRules rules{pushSpeed_, partsOf(blockOf(contact.row.index)),
                          use_[blockOf(contact.row.index)].shared};
    fillLane(block, lane, bodies, contact, rules);
    if (contact.material.staticFriction > contact.material.kineticFriction) {
        use_[blockOf(contact.row.index)].unlike = true;
    }
    std::int32_t& place = use_[blockOf(contact.row.index)].rolling;
    const bool rolls = rollingOn_ && contact.material.rollingResistance > 0;
    if (rolls && place < 0) {
        place = static_cast<std::int32_t>(rolling_.size());
        rolling_.emplace_back();
    }
    if (place >= 0) {
        fillLane(rolling_[static_cast<std::size_t>(place)], lane, bodies, contact, rules);
    }
    contact.carried = true;
    makeResident(contact);
}

ContactPassArguments ContactBlocks::pass(Bodies& bodies, std::uint32_t level,
                                         const PassSettings& settings) {
    return {blocks_.data(),
            rolling_.data(),
            use_.data(),
            order_.data() + levels_[level].first,
            levels_[level].count,
            bodies.motion.data(),
            settings,
            areFar()};
}

} // namespace KODO_PRECISION
} // namespace kodo
