// SPDX-License-Identifier: MIT
#pragma once

#include "joints/joint_set.hpp"
#include "solve/revolute_block.hpp"

#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Revolute joints of nets and other loops, in blocks of eight lanes. Lanes are assigned in the
/// order of joints in every step, so that results do not depend on earlier steps. A joint takes the
/// lowest colour that no earlier joint of its bodies has. It goes to the last block of that colour.
class RevoluteBlocks {
public:
    /// Takes the joints of JointSet::takeRevolutes().
    void begin(Bodies& bodies, JointSet& joints);
    /// Writes the impulses back to the joints.
    void end(JointSet& joints);
    bool empty() const { return blocks_.empty(); }

    /// Updates arms, gaps and masses after the bodies have moved.
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

    std::size_t laneFor(const Bodies& bodies, const JointEnds& ends);
    void fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane);
    void run(Bodies& bodies, const JointPass& pass, RevolutePasses::Pass work);

    /// The last block of a colour. No two joints of a colour move the same body.
    struct Open {
        std::size_t block = 0;
        int lanes = RevoluteBlock::kPins; // in use
    };

    std::vector<RevoluteBlock> blocks_;
    std::vector<RevoluteUse> use_;       // by block
    std::vector<std::uint32_t> jointOf_; // by lane
    std::vector<Colours> colours_;       // by body: colours of its joints
    std::vector<Open> open_;             // by colour
};

} // namespace KODO_PRECISION
} // namespace kodo
