// SPDX-License-Identifier: MIT
#pragma once

#include "base/reorder_policy.hpp"
#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "lanes/block_bins.hpp"
#include "lanes/body_partitions.hpp"
#include "lanes/contact_block.hpp"
#include "lanes/contact_lane.hpp"
#include "lanes/pass_order.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Constraint graph of the contacts, in blocks of eight lanes. Contacts that move the same body get
/// different colours. A new contact takes the lowest free colour. The passes go through the blocks
/// colour by colour. Contacts with a body of infinite mass come last, so that they dominate.
///
/// A contact keeps its colour and its lane from step to step. Results depend on colours only, not
/// on lanes, so a snapshot stores only colours. A contact without a free colour gets a
/// block of its own, newly assigned in every step. A contact that the
/// passes do not need has a waiting lane, which no pass visits, at the index of its slot.
class ContactBlocks : public ContactLanes {
public:
    /// Deep overlaps that a body may have before their contacts share the push speed. With 4,
    /// twenty bodies on one point part at 4.6 m/s instead of 3.
    static constexpr int kNeighbours = 2;
    /// Of more overlaps than this, a body has about as many that are solved: see
    /// SoftSolver::limitOverlaps().
    static constexpr int kMostOverlaps = 16;

    /// Blocks of one level of Refinement, and of one colour after the other.
    static constexpr std::uint32_t kLevels = BlockBins::kLevels;
    /// Sets the levels of the bodies from now on, after these have changed.
    void refine(std::span<const std::uint8_t> levels) {
        refinedLevels_.assign(levels.begin(), levels.end());
    }
    /// False for a contact in the passes that belongs to blocks of another level.
    bool hasLevel(const ContactSummary& summary) const {
        return !summary.inPasses() ||
               BlockBins::levelOf(states_[blockOf(summary.row.index)].bin) == levelOf(summary);
    }
    /// Starts a step, before take(). Contacts of the last step may be gone. `friction` and
    /// `rolling` are true if that feature is on.
    void begin(const ContactList& contacts, bool friction, bool rolling);
    /// Before begin(): advances the contacts in the passes to the start of the step.
    void advance(Bodies& bodies, WorkerTeam& team);
    /// Before begin(): assigns the lanes of the contacts `order` again, for a number of partitions.
    /// In the order of keys, a pass reads memory in order, and each partition mostly moves bodies
    /// of its own. Contacts that come and go degrade this order.
    void rebuildGraph(const Bodies& bodies, const ContactList& contacts,
                      std::span<const std::uint32_t> order, std::uint32_t partitions);
    /// Counts a step. True if a rebuild is due, which affects only the duration of steps.
    bool countReorder() {
        return reorderPolicy_.countStep(size()) || std::exchange(rebuildDue_, false);
    }
    /// A rebuild is due in the next step.
    void rebuildSoon() { rebuildDue_ = true; }
    const BodyPartitions& partitions() const { return partitions_; }
    const BlockState& stateOf(std::size_t block) const { return states_[block]; }
    /// Takes a contact that responds into the step. False if it needs another lane, which arrange()
    /// assigns. Several threads may take different contacts at once.
    bool take(const Bodies& bodies, const ContactEntry& entry);
    /// take() for a kept contact.
    void keep(std::uint32_t row) { taken_[row] = 1; }
    /// Invalidates the lanes for the next step, after a change of contacts or of movable bodies.
    void discardLanes() { lanesStale_ = true; }
    /// True if kept contacts need only keep(): their lanes are valid in this step.
    bool keepsLanes() const { return !lanesStale_; }
    /// Within the passes: takes a contact out of them until rearrange() assigns a lane again.
    void drop(const ContactEntry& entry) {
        if (const std::uint32_t row = entry.summary.row.index; entry.summary.inPasses()) {
            taken_[row] = 0;
            leave(entry);
            release(row);
        }
        entry.summary.row = {};
    }
    /// The same as arrange() for contacts that were dropped.
    void rearrange(const Bodies& bodies, const ContactList& contacts,
                   std::span<const std::uint32_t> newcomers, std::span<const std::uint16_t> crowd);
    /// After the last take(): assigns lanes to the newcomers, given by contact index in order.
    /// `crowd` is the number of deep overlaps by body, or empty if no body exceeds kNeighbours. The
    /// contacts of a body that exceeds it share `pushSpeed` (m/s).
    void arrange(const Bodies& bodies, const ContactList& contacts,
                 std::span<const std::uint32_t> newcomers, std::span<const std::uint16_t> crowd,
                 Real pushSpeed);

    /// Replaces begin() to arrange() in a step in which no contact is in the passes.
    void forgetLanes();

    /// A pass over the blocks of a level.
    ContactPassArguments pass(Bodies& bodies, std::uint32_t level, const PassSettings& settings);
    const PassOrder& passOrder() const { return passOrder_; }
    /// True if the colours are large enough for parallel passes. These cost synchronisation at
    /// border blocks and cache misses for shared bodies.
    bool worthPartitioning(std::uint32_t level) const {
        return rows_[level] > kWorthPartitioning * passOrder_.colours(level).size();
    }
    /// Lanes in use, of all levels or of one.
    std::size_t size() const { return std::accumulate(rows_.begin(), rows_.end(), std::size_t{0}); }
    std::size_t size(std::uint32_t level) const { return rows_[level]; }
    std::size_t uncoloured() const { return uncoloured_; }
    std::size_t blockCount() const { return blocks_.size(); }

    /// After the passes: updates touched(). A point touches if it had an impulse, or if its
    /// separation is at most `slop` (m).
    void findTouching(Real slop, WorkerTeam& team);
    /// By row: true if the contact touched in the last step.
    std::span<const std::uint8_t> touched() const { return touching_; }

private:
    static constexpr std::uint32_t kFreeColours = BlockBins::kFreeColours;
    static constexpr std::uint32_t kNone = ContactRow::kNone;
    static constexpr std::size_t kBlocksPerPiece = 32;
    static constexpr std::size_t kFewBlocks = 256;         // so many are never forgotten
    static constexpr std::size_t kWorthPartitioning = 128; // mean number of contacts per colour
    // Bytes of blocks above which most lie outside the near cache, so that the passes prefetch.
    // Below, the hardware prefetches as well.
    static constexpr std::size_t kNearBytes = 3 << 20;

    std::uint32_t levelOf(const ContactSummary& summary) const {
        return refinedLevels_.empty()
                   ? 0u
                   : std::max(refinedLevels_[summary.bodyA], refinedLevels_[summary.bodyB]);
    }
    std::uint32_t binOf(std::uint32_t group, const ContactEntry& entry) const {
        return BlockBins::of(levelOf(entry.summary), group, entry.contact.manifold.count);
    }
    std::uint32_t binOf(const ContactEntry& entry) const {
        return binOf(BlockBins::groupOfColour(entry.summary.row.colour), entry);
    }
    bool fitsBin(const ContactEntry& entry) const {
        return states_[blockOf(entry.summary.row.index)].bin == binOf(entry);
    }
    bool areFar() const { return blocks_.size() * sizeof(ContactBlock) > kNearBytes; }
    bool needsSurface(const Contact& contact) const;
    void assignRows(const ContactList& contacts);
    void assignRow(const ContactEntry& entry);
    void leaveAll(const ContactList& contacts);
    void freeLanes(const Bodies& bodies);
    void colourNewcomer(const Bodies& bodies, const ContactEntry& entry);
    std::uint32_t& openOf(std::uint32_t bin, std::uint32_t partition) {
        return open_[partition * BlockBins::kBins + bin];
    }
    void layOut(const ContactList& contacts);
    std::uint32_t addBlock(std::uint32_t bin, std::uint8_t partition);
    std::uint32_t openBlock(std::uint32_t bin, std::uint8_t partition);
    void assignLane(const ContactEntry& entry, std::uint32_t bin);
    void assignSingleLane(const ContactEntry& entry, std::uint32_t bin);
    void assignLaneOf(std::uint32_t block, const ContactEntry& entry);
    void release(std::uint32_t row);
    void empty(std::uint32_t row);
    void setPushSpeeds(std::span<const std::uint16_t> crowd, Real pushSpeed);
    void setPushSpeed(ContactBlock& block, std::size_t lane,
                      std::span<const std::uint16_t> crowd) const;
    void fill(const Bodies& bodies, const ContactEntry& entry);

    struct Features {
        bool friction = true;
        bool rolling = false;
        bool operator==(const Features&) const = default;
    };
    struct PushLimit {
        Real speed = 0;      // m/s
        bool shared = false; // some lanes have a lower limit
    };

    std::vector<std::uint64_t> colours_; // by body: mask of the colours of its contacts
    std::vector<BlockUse> use_;          // by block
    std::vector<SurfaceBlock> surfaces_;
    PassOrder passOrder_;
    std::array<std::size_t, kLevels> rows_{}; // by level: lanes in use
    std::size_t uncoloured_ = 0;              // lanes in use without a colour
    std::vector<std::uint8_t> refinedLevels_; // by body; empty if all are 0
    std::vector<std::uint8_t> taken_;         // by row: taken in this step
    std::vector<std::uint8_t> touching_;      // by row: touched in the last step
    std::vector<std::uint32_t> open_;         // by partition and bin: a block with a free lane
    BodyPartitions partitions_;
    ReorderPolicy reorderPolicy_; // for lanes of contacts with a colour
    std::uint32_t spare_ = 0;
    PushLimit pushLimit_;
    Features features_;
    bool lanesStale_ = true;    // lanes are invalid in this step
    bool rowsAssigned_ = false; // every contact with a colour has a lane
    bool orderStale_ = true;
    bool rebuildDue_ = false;
};

} // namespace KODO_PRECISION
} // namespace kodo
