// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_set.hpp"

#include <array>
#include <span>
#include <vector>

#include "soft/revolute_block.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Revolute joints that belong to no articulated tree, in blocks of eight lanes. Lanes are assigned
/// in the order of joints in every step, so that results do not depend on earlier steps. A joint
/// takes the lowest colour that no earlier joint of its bodies has. Blocks are in the order of
/// their colours, so that the order within an island does not depend on other islands. Joints with
/// a motor or limits have blocks of their own.
class RevoluteBlocks {
public:
    /// Takes the joints of JointSet::takeRevolutes().
    void begin(Bodies& bodies, JointSet& joints);
    /// Writes the impulses of a substep of h (s), and their loads, back to the joints.
    void end(const Bodies& bodies, JointSet& joints, Real h, Real slop);
    bool empty() const { return blocks_.empty(); }

    /// Updates arms, gaps, masses and angles after the bodies have moved.
    void rotate(Bodies& bodies) { run(bodies, {}, RevolutePasses::best().rotate); }
    void warmStart(Bodies& bodies, const JointPass& pass) {
        run(bodies, pass, RevolutePasses::best().warmStart);
    }
    void solve(Bodies& bodies, const JointPass& pass) {
        run(bodies, pass,
            pass.biased ? RevolutePasses::best().solve : RevolutePasses::best().relax);
    }

private:
    using Colours = std::uint64_t;

    /// The joints of one colour: no two of them move the same body. One more list holds those for
    /// which their bodies have no colour left; each of these gets a block of its own.
    struct Batch {
        std::size_t lanes = 0;
        std::size_t firstBlock = 0;
    };
    static constexpr std::size_t kNoColour = 64;
    using Batches = std::array<Batch, kNoColour + 1>; // by colour

    std::size_t colourFor(const Bodies& bodies, const JointEnds& ends);
    void assignColours(const Bodies& bodies, JointSet& joints, std::span<const std::uint32_t> list);
    void openBlocks(const Bodies& bodies);
    std::size_t takeLane(std::size_t colour, bool angular);
    void fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane);
    void fillAngles(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane);
    void run(Bodies& bodies, const JointPass& pass, RevolutePasses::Pass work);

    std::vector<RevoluteBlock> blocks_;
    std::vector<RevoluteAngles> angles_;
    std::vector<RevoluteUse> use_;       // by block
    std::vector<std::uint32_t> jointOf_; // by lane
    std::vector<std::uint8_t> colourOf_; // by joint in the order of takeRevolutes()
    std::vector<Colours> colours_;       // by body: colours of its joints
    std::array<Batches, 2> batches_;     // without motors and limits, and with them
};

} // namespace KODO_PRECISION
} // namespace kodo
