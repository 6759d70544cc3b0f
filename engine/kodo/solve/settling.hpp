// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/disjoint_sets.hpp>
#include <kodo/solve/contact_blocks.hpp>

#include <array>
#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The passes of a substep that take out the speed which deep overlaps get from being pushed apart,
/// as when bodies are put on one place. The one pass that relaxes all contacts would leave some of
/// it, and the bodies would burst apart.
///
/// Bodies that overlap deeply, one with another, make a cluster, and only its own contacts take
/// part: those of which each body that can be pushed belongs to it. So they do not depend on what
/// overlaps elsewhere. They are few and lie far apart in memory; copies of what the passes need lie
/// side by side, but for contacts without a colour, which have a block to themselves anyhow.
class Settling {
public:
    /// The separation (m) below which two overlap deeply.
    static Real deepBelow(Real slop) { return -8 * slop; }

    /// The contacts of a step, in the order and the colours of the passes over all of them.
    struct Contacts {
        const ContactPassArguments& all;
        std::span<const ContactBlocks::Colour> colours;
        Real deepBelow;                       // m
        std::span<const std::uint16_t> crowd; // by body: how many overlap it
    };

    /// Finds who takes part.
    void find(const Contacts& contacts);
    /// For a step in which nobody does.
    void clear();
    bool empty() const { return passes_ == 0; }
    /// Makes the passes of a substep.
    void settle(const ContactPassArguments& all);
    /// How often the passes of a substep look at a contact.
    std::size_t visits() const { return visits_; }

private:
    static constexpr std::uint32_t kNone = ContactRow::kNone;
    static constexpr int kMostPasses = 10;
    static constexpr int kLargeCrowd = 600;    // bodies on one, times the passes beyond the first
    static constexpr std::size_t kBlocks = 64; // room from the first: later steps seldom allocate

    struct Cluster {
        int deepContacts = 0;
        int crowd = 1; // the largest of its bodies
    };
    /// A contact of all, and where its copy is.
    struct Copied {
        std::uint32_t block;
        std::uint32_t copyBlock;
        std::uint8_t lane;
        std::uint8_t copyLane;
    };
    /// A block that takes part in so many passes.
    struct Part {
        std::uint32_t block;
        bool isCopy; // or one of all
        std::uint8_t passes;
    };
    /// By number of points and of passes: a block of copies that has a free lane.
    using Open = std::array<std::array<std::uint32_t, kMostPasses + 1>, 2>;

    static int passesOf(const Cluster& cluster);
    void begin(std::size_t bodies);
    void join(std::uint32_t bodyA, std::uint32_t bodyB, std::span<const std::uint16_t> crowd);
    void findClusters(const Contacts& contacts);
    unsigned inClusters(const ContactBlock& block, const BlockUse& use) const;
    template <typename Work>
    void forTogether(const ContactBlock& block, const BlockUse& use, Work work);
    void addPart(std::uint32_t block, bool isCopy, int passes);
    std::uint32_t openBlock(bool twoPoints, int passes);
    void copyLane(const ContactPassArguments& all, const Copied& copied);
    void copyLanes(const ContactPassArguments& all, std::uint32_t block, Open& open);
    void pass(const ContactPassArguments& all, int number);
    template <typename Work>
    void forImpulses(const ContactPassArguments& all, Work work);

    DisjointSets sets_;                 // bodies of clusters; the spare one is never in any
    std::vector<std::uint32_t> joined_; // those that are in one
    std::vector<Cluster> clusters_;     // by root
    std::vector<Copied> copied_;
    std::vector<ContactBlock> blocks_; // copies
    std::vector<BlockUse> use_;
    std::vector<Part> parts_;          // in the order of the passes
    std::vector<std::uint32_t> order_; // blocks of a pass
    int passes_ = 0;
    std::size_t visits_ = 0;
};

} // namespace kodo::inline KODO_PRECISION
