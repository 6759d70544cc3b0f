// SPDX-License-Identifier: MIT
#pragma once

#include "base/reorder_policy.hpp"
#include "base/worker_team.hpp"
#include "contacts/contact_set.hpp"
#include "solve/contact_block.hpp"
#include "solve/refinement.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Constraint graph of the contacts, in blocks of eight lanes. Contacts that move the same body get
/// different colours. A new contact takes the lowest free colour. The passes go through the blocks
/// colour by colour. Contacts with a body of infinite mass come last, so that they dominate.
///
/// A contact keeps its colour and its lane from step to step. While its manifold is valid its state
/// is resident in the lane, which saves most of the work. Results depend on colours only, not on
/// lanes, so a snapshot stores only colours. A contact without a free colour gets a lane in a block
/// for its body, or a block of its own, newly assigned in every step.
class ContactBlocks {
public:
    /// Deep overlaps that a body may have before their contacts share the push speed. No more
    /// bodies fit around one.
    static constexpr int kNeighbours = 8;

    /// Blocks of one level of Refinement, and of one colour after the other.
    static constexpr std::uint32_t kLevels = Refinement::kLevels;
    /// Sets the levels of the bodies from now on, after these have changed. Contacts store the
    /// impulses of a whole substep, lanes those of its parts.
    void refine(const Refinement& refinement, ContactSet& contacts, const Bodies& bodies);
    /// Starts a step, before take(). Contacts of the last step may be gone. `friction` and
    /// `rolling` are true if that feature is on.
    void begin(const Bodies& bodies, std::span<Contact> contacts, bool friction, bool rolling);
    /// After the removal of contacts: forgets all lanes if blocks outnumber the contacts.
    void shrink(const Bodies& bodies, std::span<Contact> contacts);
    /// Before begin(): advances the resident contacts to the start of the step.
    void carry(Bodies& bodies, WorkerTeam& team);
    /// State of the resident contacts by row; empty if none is resident.
    std::span<const Carried> carried() const {
        return anyResident_ ? std::span<const Carried>(carried_) : std::span<const Carried>();
    }
    /// Before begin(): rebuilds the graph for a number of partitions. Lanes are assigned in the
    /// order of bodies, and the blocks of a colour are consecutive. So a pass reads memory in
    /// order, and each partition mostly moves bodies of its own. Contacts that come and go degrade
    /// this order.
    void rebuildGraph(const Bodies& bodies, ContactSet& contacts, std::uint32_t partitions);
    /// Counts a step. True if a rebuild is due, which affects only the duration of steps.
    bool countReorder() { return reorderPolicy_.countStep(rows_); }
    std::uint32_t partitions() const { return static_cast<std::uint32_t>(cuts_.size()); }
    std::uint8_t partitionOf(std::size_t block) const { return states_[block].partition; }
    std::uint8_t partitionOfBody(std::uint32_t body) const {
        return static_cast<std::uint8_t>(std::upper_bound(cuts_.begin(), cuts_.end(), body) -
                                         cuts_.begin() - 1);
    }
    /// Takes a contact that responds into the step. False if it needs another lane, which arrange()
    /// assigns. Several threads may take different contacts at once.
    bool take(const Bodies& bodies, Contact& contact);
    /// take() for a contact whose lane has all of its state.
    void keep(std::uint32_t row) { taken_[row] = 1; }
    /// Invalidates the lanes for the next step, after a change of contacts or of movable bodies.
    void discardLanes() { lanesStale_ = true; }
    /// True if kept contacts need only keep(): their lanes are valid in this step.
    bool keepsLanes() const { return anyResident_ && !lanesStale_; }
    /// After the last take(): assigns lanes to the newcomers, given by contact index in order.
    /// `crowd` is the number of deep overlaps by body, or empty if no body exceeds kNeighbours. The
    /// contacts of a body that exceeds it share `pushSpeed` (m/s).
    void arrange(const Bodies& bodies, std::span<Contact> contacts,
                 std::span<const std::uint32_t> newcomers, std::span<const std::uint16_t> crowd,
                 Real pushSpeed);

    /// Replaces begin() to arrange() in a step in which no contact responds.
    void releaseAll(const Bodies& bodies);

    /// A pass over the blocks of a level.
    ContactPassArguments pass(Bodies& bodies, std::uint32_t level, const PassSettings& settings);
    /// Consecutive blocks in the order of the pass. No two of their contacts move the same body, so
    /// they may be solved in parallel, except where oneByOne is set.
    struct Colour {
        std::size_t count = 0;
        bool oneByOne = false; // contacts without a colour, to be solved in order
    };
    std::span<const Colour> colours(std::uint32_t level) const { return levels_[level].colours; }
    /// True if the colours are large enough for parallel passes. These cost synchronisation at
    /// border blocks and cache misses for shared bodies.
    bool worthPartitioning(std::uint32_t level) const {
        return levels_[level].rows > kWorthPartitioning * levels_[level].colours.size();
    }
    bool worthPartitioning() const;
    std::size_t size() const { return rows_; }
    std::size_t size(std::uint32_t level) const { return levels_[level].rows; }
    std::size_t blockCount() const { return blocks_.size(); }
    /// True for a block of a single contact without a colour.
    bool isSingle(std::size_t block) const { return isSingleBin(states_[block].bin); }
    /// Grows by 1 with each begin(), and by more with each rebuild. After growth by 1, only the
    /// newcomers of arrange() have other lanes than before.
    std::uint64_t lanesState() const { return lanesState_; }

    /// After the passes: updates touched(). A point touches if it had an impulse, or if its
    /// separation is at most `slop` (m).
    void noteTouching(Real slop, WorkerTeam& team);
    /// By row: true if the contact touched in the last step. The entry behind the last row is
    /// false.
    std::span<const std::uint8_t> touched() const { return touching_; }

    /// Coefficients and impulses of a contact in the passes.
    struct Lane {
        ContactBlock& block;
        RollingBlock* rolling; // or nullptr
        std::size_t lane;
    };
    Lane laneAt(std::uint32_t row);

    /// Writes the state of a resident contact back as far as the next step needs it. The contact is
    /// not resident then.
    void evict(Contact& contact, const Bodies& bodies) const;
    void evictAll(std::span<Contact> contacts, const Bodies& bodies);
    /// evict() that also writes the impulses of the last step, for the record.
    void writeBack(Contact& contact, const Bodies& bodies) const;
    /// Writes all resident contacts back, unless that was done since the last step.
    void writeBackAll(std::span<Contact> contacts, const Bodies& bodies);

private:
    static constexpr std::uint32_t kFreeColours = 48;
    static constexpr int kFewColours = 12; // of the other bodies of a shared one
    // Colours from kFreeColours on are for contacts with a body of infinite mass.
    static constexpr std::uint32_t kColours = 64;
    // A further group of each kind, behind its colours, is for single contacts without a colour.
    static constexpr std::uint32_t kGroups = kColours + 2;
    static constexpr std::uint32_t kLevelBins = 2 * kGroups; // by group: one point, two points
    static constexpr std::uint32_t kBins = kLevels * kLevelBins;
    static constexpr std::uint32_t kNone = ContactRow::kNone;
    static constexpr std::size_t kBlocksPerPiece = 32;
    static constexpr std::size_t kFewBlocks = 256;         // so many are never forgotten
    static constexpr std::size_t kWorthPartitioning = 128; // mean number of contacts per colour
    // Bytes of blocks above which most lie outside the near cache, so that the passes prefetch.
    // Below, the hardware prefetches as well.
    static constexpr std::size_t kNearBytes = 3 << 20;

    /// Place of a block in the graph, and its lanes.
    struct BlockState {
        std::uint32_t bin = 0;
        std::uint32_t nextOpen = kNone; // next block of the bin with a free lane
        std::uint8_t used = 0;          // lane mask
        std::uint8_t fixedA = 0;        // lane mask: a was locked when the lane was assigned
        std::uint8_t fixedB = 0;
        std::uint8_t partition = 0; // that of body a; 0 without a colour
    };

    /// A row numbers the lanes of all blocks.
    static constexpr std::size_t blockOf(std::uint32_t row) {
        return row / ContactBlock::kContacts;
    }
    static constexpr std::size_t laneOf(std::uint32_t row) { return row % ContactBlock::kContacts; }
    static constexpr std::uint8_t maskOf(std::uint32_t row) {
        return static_cast<std::uint8_t>(1u << laneOf(row));
    }
    /// Bins of contacts without a colour: one contact per block.
    static bool isSingleBin(std::uint32_t bin) {
        return groupOf(bin) == kFreeColours || groupOf(bin) == kGroups - 1;
    }
    static std::uint32_t groupOf(std::uint32_t bin) { return bin % kLevelBins / 2; }
    static std::uint32_t levelOfBin(std::uint32_t bin) { return bin / kLevelBins; }
    std::uint32_t levelOf(const Contact& contact) const {
        return refinedLevels_.empty()
                   ? 0u
                   : std::max(refinedLevels_[contact.key.bodyA], refinedLevels_[contact.key.bodyB]);
    }
    std::uint32_t binOfGroup(std::uint32_t group, const Contact& contact) const {
        return levelOf(contact) * kLevelBins + 2 * group + (contact.manifold.count == 2 ? 1 : 0);
    }
    std::uint32_t binOf(std::uint32_t colour, const Contact& contact) const {
        return binOfGroup(colour < kFreeColours ? colour : colour + 1, contact);
    }
    /// Parts of a substep.
    Real partsOf(std::size_t block) const {
        return static_cast<Real>(1u << levelOfBin(states_[block].bin));
    }
    bool areFar() const { return blocks_.size() * sizeof(ContactBlock) > kNearBytes; }
    bool keepsColour(const Bodies& bodies, const Contact& contact) const;
    bool needsRolling(const Contact& contact) const;
    std::uint8_t removedLanes(std::uint32_t block) const;
    void makeResident(Contact& contact);
    void assignRows(std::span<Contact> contacts);
    void assignRow(Contact& contact);
    void finishGraph();
    void forgetLanes();
    void freeLanes(const Bodies& bodies);
    void colourNewcomer(const Bodies& bodies, Contact& contact);
    void findCuts(const Bodies& bodies, ContactSet& contacts, std::uint32_t partitions);
    std::uint32_t& openOf(std::uint32_t bin, std::uint32_t partition) {
        return open_[partition * kBins + bin];
    }
    void layOut(std::span<const Contact> contacts);
    std::uint32_t addBlock(std::uint32_t bin, std::uint8_t partition);
    std::uint32_t openBlock(std::uint32_t bin, std::uint8_t partition);
    void giveLane(Contact& contact, std::uint32_t bin);
    void giveSingleLane(Contact& contact, std::uint32_t bin, Shared shared);
    void giveLaneOf(std::uint32_t block, Contact& contact);
    void release(std::uint32_t row);
    void empty(std::uint32_t row);
    void orderBlocks();
    void setPushSpeeds(std::span<const std::uint16_t> crowd, Real pushSpeed);
    void fill(const Bodies& bodies, Contact& contact);

    std::vector<std::uint64_t> colours_; // by body: mask of the colours of its contacts
    std::vector<ContactBlock> blocks_;
    std::vector<BlockUse> use_;
    std::vector<BlockState> states_;   // by block
    std::vector<std::uint32_t> order_; // block indices by bin
    std::vector<std::uint32_t> inUse_; // the same in the order of memory
    std::vector<RollingBlock> rolling_;
    /// Blocks of a level: a range of order_.
    struct Level {
        std::size_t first = 0;
        std::size_t count = 0;
        std::size_t rows = 0; // lanes in use
        std::vector<Colour> colours;
    };
    std::array<Level, kLevels> levels_;
    std::vector<std::uint32_t> sharedOf_;      // by body without a free colour: its open block
    std::vector<std::uint32_t> sharedBodies_;  // scratch of arrange(): bodies in sharedOf_
    std::vector<std::uint8_t> refinedLevels_;  // by body; empty if all are 0
    std::vector<Carried> carried_;             // by row
    std::vector<std::uint8_t> taken_;          // by row: taken in this step
    std::vector<std::uint8_t> touching_ = {0}; // by row: touched in the last step; one more: false
    std::vector<std::uint32_t> open_;          // by partition and bin: a block with a free lane
    std::vector<std::uint32_t> cuts_ = {0};    // by partition: its first body
    ReorderPolicy reorderPolicy_;              // for lanes of contacts with a colour
    std::size_t rows_ = 0;                     // lanes in use
    std::size_t singles_ = 0;                  // of these, without a colour
    std::uint64_t lanesState_ = 0;
    std::uint32_t spare_ = 0;
    Real pushSpeed_ = 0;
    bool shared_ = false; // some lanes have a lower limit than pushSpeed_
    bool anyResident_ = false;
    bool frictionOn_ = true;
    bool rollingOn_ = false;
    bool lanesStale_ = true;    // lanes are invalid in this step
    bool rowsAssigned_ = false; // every contact with a colour has a lane
    bool orderStale_ = true;
};

} // namespace KODO_PRECISION
} // namespace kodo
