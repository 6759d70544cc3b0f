// SPDX-License-Identifier: MIT
#pragma once

#include "base/disjoint_sets.hpp"

#include <array>
#include <span>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Extra passes of a substep that remove the velocity which the separation of deep overlaps adds,
/// as after bodies were placed on one point. The single relax pass over all contacts would leave
/// some of it, and the bodies would fly apart.
///
/// Bodies connected by deep overlaps form a cluster. A contact takes part if all its movable bodies
/// are in one cluster. So the result does not depend on overlaps elsewhere. These contacts are few
/// and scattered in memory, so consecutive blocks hold copies of what the passes need. Contacts
/// without a colour are not copied, since each has a block of its own.
///
/// Even these passes leave much of the velocity in a crowd, where a body overlaps with many. Its
/// pushes are taken back after they have moved the bodies, so they leave none at all [Catto09,
/// split impulses]. They move no body faster than the push speed.
class OverlapRelaxation {
public:
    /// Separation (m) below which an overlap is deep.
    static Real deepBelow(Real slop) { return -8 * slop; }

    /// The contacts of a step, in the order and the colours of the passes over all of them.
    struct Contacts {
        const ContactPassArguments& all;
        std::span<const PassOrder::Colour> colours;
        Real deepBelow;                       // m
        std::span<const std::uint16_t> crowd; // by body: number of overlaps beyond four slops
    };

    /// Sizes the arrays by body.
    void makeRoom(const Bodies& bodies);
    /// Finds the contacts that take part.
    void find(const Contacts& contacts);
    /// For a step without deep overlaps.
    void clear();
    bool empty() const { return passes_ == 0; }
    /// Before the biased pass of a substep: stores the impulses in crowds.
    void notePushes(const ContactPassArguments& all);
    /// After the displacements of a substep of h (s): takes back what the biased pass added in
    /// crowds, and shortens displacements by more than `pushSpeed` (m/s).
    void takeBackPushes(const ContactPassArguments& all, Real h, Real pushSpeed);
    /// Runs the passes of a substep.
    void run(const ContactPassArguments& all);
    /// Visits of contacts in the passes of a substep.
    std::size_t visits() const { return visits_; }

private:
    static constexpr std::uint32_t kNone = ContactRow::kNone;
    static constexpr int kMostPasses = 10;
    static constexpr int kLargeCrowd = 600;    // crowd size times the passes beyond the first
    static constexpr std::size_t kBlocks = 64; // initial capacity: later steps seldom allocate

    struct Cluster {
        int deepContacts = 0;
        int crowd = 1; // largest of its bodies
    };
    /// A contact of the solver, and its copy.
    struct Copied {
        std::uint32_t block;
        std::uint32_t copyBlock;
        std::uint8_t lane;
        std::uint8_t copyLane;
    };
    /// A contact in a crowd.
    struct Push {
        std::uint32_t block;
        std::uint32_t lane;
        std::array<Real, 2> before; // N s, impulses at its points before the biased pass
    };
    /// A block that takes part in the first `passes` passes.
    struct Part {
        std::uint32_t block;
        bool isCopy; // in blocks_, else in those of the solver
        std::uint8_t passes;
    };
    /// By number of points and of passes: a block of copies with a free lane.
    using Open = std::array<std::array<std::uint32_t, kMostPasses + 1>, 2>;

    static int passesOf(const Cluster& cluster);
    static bool isCrowd(const Cluster& cluster) {
        return cluster.crowd > ContactBlocks::kNeighbours;
    }
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

    DisjointSets sets_;                 // clusters of bodies, never with the spare body
    std::vector<std::uint32_t> joined_; // bodies in clusters
    std::vector<Cluster> clusters_;     // by root
    std::vector<Copied> copied_;
    std::vector<Push> pushes_;
    std::vector<std::uint32_t> crowded_; // bodies in crowds
    std::vector<Vec2> velocities_;       // of these, before takeBackPushes(), as the next
    std::vector<Real> angularVelocities_;
    std::vector<ContactBlock> blocks_; // copies
    std::vector<BlockUse> use_;
    std::vector<Part> parts_;          // in the order of the passes
    std::vector<std::uint32_t> order_; // blocks of one pass
    int passes_ = 0;
    std::size_t visits_ = 0;
};

} // namespace KODO_PRECISION
} // namespace kodo
