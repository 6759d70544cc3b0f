// SPDX-License-Identifier: MIT
#include <kodo/contacts/part_bounds.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

constexpr Real kDt = Real(1) / 64;
constexpr Tolerances kDistances = Tolerances::forUnit(1);

/// Two discs, of which the second lies still. All numbers are multiples of 2^-8, so that nothing
/// is rounded.
struct Discs {
    Bodies bodies;
    PartBounds bounds;
    Crew crew{nullptr};

    Discs() {
        for (const Real x : {Real(0), Real(100)}) {
            const BodyDef def{.shape = Circle{Real(0.5)}, .position = {x, 0}};
            addBody(bodies, def, makeForm(partsOf(def)));
        }
        refreshAwake(bodies);
        bounds.renew(bodies, kDistances);
        bounds.clearChanged();
    }
    /// Are the bounds of the first new, and those of the second not?
    bool renewed() {
        const std::vector<std::uint32_t> changed(bounds.changed().begin(), bounds.changed().end());
        bounds.clearChanged();
        EXPECT_TRUE(changed.empty() || changed == std::vector<std::uint32_t>{0});
        return !changed.empty();
    }
    /// Is there room for the first and its margin?
    bool hold(Vec2 move) const {
        return bounds.grown()[0].contains(bounds.tight(0).moved(move).grown(kDistances.margin));
    }
};

// R10: who goes 1/64 m a step gets bounds that reach two such ways and the slack of 1/16 m ahead,
// and always needs one way. So they last for six steps, in which nobody asks for pairs.
TEST(PartBounds, AreNewOnlyWhenOutgrown) {
    Discs discs;
    discs.bodies.motion[0].velocity = {1, 0};
    for (int step = 0; step < 60; ++step) {
        discs.bounds.foresee(discs.bodies, kDistances, kDt, discs.crew);
        EXPECT_EQ(discs.renewed(), step % 6 == 0) << step;
        EXPECT_TRUE(discs.hold({kDt, 0})) << step;
        discs.bodies.pose[0].position.x += kDt;
    }
}

// A disc that spins about its middle stays within its bounds; what swings needs others.
TEST(PartBounds, AreNotOutgrownByTheSpinOfADisc) {
    Discs discs;
    discs.bodies.motion[0].angularVelocity = 100;
    discs.bodies.motion[0].turn = 1;
    for (const Real swing : {Real(0), Real(0.5)}) {
        EXPECT_TRUE(swing > 0 || discs.bodies.extent[0].swing == 0);
        discs.bodies.extent[0].swing = swing;
        discs.bounds.foresee(discs.bodies, kDistances, kDt, discs.crew);
        EXPECT_EQ(discs.renewed(), swing > 0);
        discs.bounds.coverMoves(discs.bodies, kDistances, discs.crew);
        EXPECT_FALSE(discs.renewed()); // the disc itself has not gone anywhere
    }
}

// R10: what the solver sends out of them gets new ones, what it moves within them does not.
TEST(PartBounds, CoverWhatTheSolverDid) {
    Discs discs;
    discs.bounds.foresee(discs.bodies, kDistances, kDt, discs.crew);
    for (const Real way : {kDistances.margin, Real(2)}) {
        discs.bodies.motion[0].move = {0, way};
        discs.bounds.coverMoves(discs.bodies, kDistances, discs.crew);
        EXPECT_EQ(discs.renewed(), way == 2);
        EXPECT_EQ(discs.hold({0, way}), way == 2); // the margin itself may be used up
    }
}

} // namespace
} // namespace kodo
