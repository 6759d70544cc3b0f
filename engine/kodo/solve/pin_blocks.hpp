// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint_set.hpp>
#include <kodo/solve/pin_block.hpp>

#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The pins of nets and other loops, eight at a time. They are dealt to lanes anew in each step, in
/// their order, so that nothing depends on the steps before. Each gets the lowest colour that none
/// of the pins before it has that push its bodies, and goes to the last block of that colour.
class PinBlocks {
public:
    /// Takes the pins that can be lent.
    void begin(Bodies& bodies, JointSet& joints);
    /// Gives them back with what they have learned.
    void end(JointSet& joints);
    bool empty() const { return blocks_.empty(); }

    /// Once the bodies have moved.
    void turn(Bodies& bodies) { run(bodies, {}, PinPasses::best().turn); }
    void warmStart(Bodies& bodies, const JointPass& pass) {
        run(bodies, pass, PinPasses::best().warmStart);
    }
    void solve(Bodies& bodies, const JointPass& pass) {
        run(bodies, pass, pass.biased ? PinPasses::best().solve : PinPasses::best().relax);
    }

private:
    using Colours = std::uint64_t;

    std::size_t laneFor(const Bodies& bodies, const JointEnds& ends);
    void fill(const Bodies& bodies, const JointSet::Joint& joint, std::size_t lane);
    void run(Bodies& bodies, const JointPass& pass, PinPasses::Pass work);

    /// The last block of a colour. No two pins of one colour push the same body.
    struct Open {
        std::size_t block = 0;
        int lanes = PinBlock::kPins; // in use
    };

    std::vector<PinBlock> blocks_;
    std::vector<PinUse> use_;            // by block
    std::vector<std::uint32_t> jointOf_; // by lane
    std::vector<Colours> colours_;       // by body: of the pins that push it
    std::vector<Open> open_;             // by colour
};

} // namespace kodo::inline KODO_PRECISION
