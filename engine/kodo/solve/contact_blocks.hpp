// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/base/disorder.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/solve/contact_block.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Arranges contacts into blocks. Contacts that push the same body get different colours, the
/// lowest that is free, as they come; the passes go through colour by colour. Contacts with what
/// cannot be pushed come last, so that they have the last word.
///
/// A contact keeps its colour and its lane from step to step; what is kept there as well, as long
/// as its manifold is, saves most of the work. Only colours decide the outcome, not lanes: so a
/// snapshot holds those alone. What finds no colour gets a lane of its own, anew in each step.
class ContactBlocks {
public:
    /// So many bodies may overlap one deeply before their pushes are shared out: no more fit around
    /// it, and a few may stand in for them.
    static constexpr int kNeighbours = 8;

    /// Substeps are divided into so many parts from now on, a power of two. The impulses that
    /// contacts keep are those of a whole one.
    void refine(int parts, std::span<Contact> contacts, const Bodies& bodies);
    /// Before the contacts of a step are taken, of which some may be gone. With friction, with
    /// rolling resistance?
    void begin(const Bodies& bodies, std::span<Contact> contacts, bool friction, bool rolling);
    /// Before all that, carries the contacts that are lent on to the start of a step.
    void carry(Bodies& bodies, Crew& crew);
    /// Where they are, by row; empty if nothing is lent.
    std::span<const Carried> carried() const {
        return lent_ ? std::span<const Carried>(carried_) : std::span<const Carried>();
    }
    /// Before begin(): deals the lanes out anew, to so many shares, in the order of bodies, with
    /// the blocks of a colour one behind the other. So a pass goes through memory as it lies, and
    /// threads that each take a share push bodies of their own, for the most part. As contacts come
    /// and go, that gets lost.
    void dealAnew(const Bodies& bodies, ContactSet& contacts, std::uint32_t shares);
    /// Counts a step: is it time to deal them out anew? That changes how long a step takes, and
    /// nothing else.
    bool countDisorder() { return disorder_.countStep(rows_); }
    std::uint32_t shares() const { return static_cast<std::uint32_t>(cuts_.size()); }
    /// The share that a block belongs to.
    std::uint8_t shareOf(std::size_t block) const { return states_[block].share; }
    std::uint8_t shareOfBody(std::uint32_t body) const {
        return static_cast<std::uint8_t>(std::upper_bound(cuts_.begin(), cuts_.end(), body) -
                                         cuts_.begin() - 1);
    }
    /// Takes a contact that responds. False if it needs another lane and has to be given one by
    /// arrange(). Several threads may take contacts at once.
    bool take(const Bodies& bodies, Contact& contact);
    /// What take() does with a contact whose lane has all of it.
    void keep(std::uint32_t row) { taken_[row] = 1; }
    /// What the lanes hold is of no use in the next step: contacts have changed, or what bodies
    /// can be pushed.
    void startAnew() { anew_ = true; }
    /// May contacts that are kept be left to keep()? What is in their lanes goes for this step,
    /// too.
    bool keepsLanes() const { return lent_ && !anew_; }
    /// After the last one, with the places of those that need lanes, in order. `pushSpeed` (m/s) is
    /// shared out among those who crowd a body, if there are more than kNeighbours of them; `crowd`
    /// is by body, and empty when nobody is crowded.
    void arrange(const Bodies& bodies, std::span<Contact> contacts,
                 std::span<const std::uint32_t> newcomers, std::span<const std::uint16_t> crowd,
                 Real pushSpeed);

    /// Instead of all that, for a step in which no contact responds.
    void releaseAll(const Bodies& bodies);

    ContactPassArguments pass(Bodies& bodies, const PassSettings& settings);
    /// Blocks that may be solved at once, since no two contacts of them push the same body: so
    /// many, in the order of the pass. Colours come one after the other.
    struct Colour {
        std::size_t count = 0;
        bool oneByOne = false; // these, and in that order
    };
    std::span<const Colour> colours() const { return byColour_; }
    /// Are there so many contacts of a colour that threads win more by sharing a pass than they
    /// lose by waiting for what they have in common, and by pushing the same bodies in turn?
    bool worthSharing() const { return rows_ > kWorthSharing * byColour_.size(); }
    std::size_t size() const { return rows_; }
    std::size_t blockCount() const { return blocks_.size(); }
    /// Does the block hold one contact alone, which found no colour?
    bool isSingle(std::size_t block) const { return isSingleBin(states_[block].bin); }
    /// Grows by 1 with each begin(), and by more when the lanes are dealt out anew. If it has grown
    /// by 1, only the newcomers of arrange() have other lanes than before.
    std::uint64_t lanesState() const { return lanesState_; }

    /// After the passes, for touched(): a point that is not farther apart than `slop` (m) touches.
    void noteTouching(Real slop, Crew& crew);
    /// By row: did its contact touch in the last step? Behind the last row: no.
    std::span<const std::uint8_t> touched() const { return touching_; }

    /// Gives a contact back all that the next step starts from, if it is lent.
    void reclaim(Contact& contact, const Bodies& bodies) const;
    void reclaimAll(std::span<Contact> contacts, const Bodies& bodies);
    /// And what the last step pushed, for its record.
    void fetch(Contact& contact, const Bodies& bodies) const;
    /// Fetches all, unless that was done since the last step.
    void fetchAll(std::span<Contact> contacts, const Bodies& bodies);

private:
    static constexpr std::uint32_t kFreeColours = 48;
    static constexpr std::uint32_t kColours = 64; // the others are for what cannot be pushed
    // What finds no colour has a block to itself; those come behind the colours of their kind.
    static constexpr std::uint32_t kGroups = kColours + 2;
    static constexpr std::uint32_t kBins = 2 * kGroups; // with one point, with two
    static constexpr std::uint32_t kNone = ContactRow::kNone;
    static constexpr std::size_t kBlocksAPiece = 32;
    static constexpr std::size_t kWorthSharing = 128; // contacts of a colour, in the mean
    // With more than that, most blocks lie in a far cache; from a nearer one the machine fetches
    // what comes next as fast by itself.
    static constexpr std::size_t kNearBytes = 3 << 20;

    /// Where a block belongs, and what its lanes hold.
    struct BlockState {
        std::uint32_t bin = 0;
        std::uint32_t nextOpen = kNone; // of those of the bin that have a free lane
        std::uint8_t used = 0;          // by lane
        std::uint8_t fixedA = 0;        // at the time it was taken, a could not be pushed
        std::uint8_t fixedB = 0;
        std::uint8_t share = 0; // that of body A of all its contacts; 0 for those without a colour
    };

    /// Rows are numbered through all blocks.
    static constexpr std::size_t blockOf(std::uint32_t row) {
        return row / ContactBlock::kContacts;
    }
    static constexpr std::size_t laneOf(std::uint32_t row) { return row % ContactBlock::kContacts; }
    static constexpr std::uint8_t maskOf(std::uint32_t row) {
        return static_cast<std::uint8_t>(1u << laneOf(row));
    }
    /// What found no colour: its blocks hold one contact each.
    static bool isSingleBin(std::uint32_t bin) {
        return bin / 2 == kFreeColours || bin / 2 == kGroups - 1;
    }
    static std::uint32_t binOf(std::uint32_t colour, const Contact& contact) {
        const std::uint32_t group = colour < kFreeColours ? colour : colour + 1;
        return 2 * group + (contact.manifold.count == 2 ? 1 : 0);
    }
    bool areFar() const { return blocks_.size() * sizeof(ContactBlock) > kNearBytes; }
    bool keepsColour(const Bodies& bodies, const Contact& contact) const;
    bool needsRolling(const Contact& contact) const;
    std::uint8_t goneFrom(std::uint32_t block) const;
    void lend(Contact& contact);
    void assignRows(std::span<Contact> contacts);
    void assignRow(Contact& contact);
    void finishDealing();
    void forgetLanes();
    void freeLanes(const Bodies& bodies);
    void colourNewcomer(const Bodies& bodies, Contact& contact);
    void findCuts(const Bodies& bodies, ContactSet& contacts, std::uint32_t shares);
    std::uint32_t& openOf(std::uint32_t bin, std::uint32_t share) {
        return open_[share * kBins + bin];
    }
    void layOut(std::span<const Contact> contacts);
    std::uint32_t addBlock(std::uint32_t bin, std::uint8_t share);
    std::uint32_t openBlock(std::uint32_t bin, std::uint8_t share);
    void giveLane(Contact& contact, std::uint32_t bin);
    void release(std::uint32_t row);
    void empty(std::uint32_t row);
    void orderBlocks();
    void setPushSpeeds(std::span<const std::uint16_t> crowd, Real pushSpeed);
    void fill(const Bodies& bodies, Contact& contact);

    std::vector<std::uint64_t> colours_; // by body: those that it has
    std::vector<ContactBlock> blocks_;
    std::vector<BlockUse> use_;
    std::vector<BlockState> states_;   // of the blocks
    std::vector<std::uint32_t> order_; // of the blocks, by bin
    std::vector<std::uint32_t> inUse_; // the same, as they lie in memory
    std::vector<RollingBlock> rolling_;
    std::vector<Colour> byColour_;
    std::vector<Carried> carried_;             // by row
    std::vector<std::uint8_t> taken_;          // by row: in this step
    std::vector<std::uint8_t> touching_ = {0}; // by row: in the last step; behind the last, false
    std::vector<std::uint32_t> open_;          // by share and bin: a block that has a free lane
    std::vector<std::uint32_t> cuts_ = {0};    // by share: its first body
    Disorder disorder_;                        // of lanes that have a colour
    std::size_t rows_ = 0;                     // lanes in use
    std::size_t singles_ = 0;                  // of those, without a colour
    std::uint64_t lanesState_ = 0;
    std::uint32_t spare_ = 0;
    Real pushSpeed_ = 0;
    Real parts_ = 1;      // of a substep
    bool shared_ = false; // some lanes have less than pushSpeed_
    bool lent_ = false;   // some contacts are
    bool frictionOn_ = true;
    bool rollingOn_ = false;
    bool anew_ = true;          // what the lanes hold is of no use in this step
    bool rowsAssigned_ = false; // contacts that have a colour have a lane
    bool orderStale_ = true;
};

} // namespace kodo::inline KODO_PRECISION
