// SPDX-License-Identifier: MIT
// Loads on limits of joints, and light bodies far away.
#include <support/draws.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

/// A static top, a link of 1 kg, and a load below it. Returns the load.
BodyId hang(World& world, Real load, bool slider) {
    const BodyId top = world.add({.position = {0, 10}, .type = BodyType::Static});
    const BodyId link = world.add({.position = {0, 8}, .mass = MassDef{.mass = 1}});
    const BodyId box = world.add({.position = {0, 6}, .mass = MassDef{.mass = load}});
    const JointEnds upper{.a = top, .b = link};
    const JointEnds lower{.a = link, .b = box};
    if (slider) {
        world.add(PrismaticJoint{.ends = upper, .axis = {0, 1}, .limits = Range{-2, 0}});
        world.add(PrismaticJoint{.ends = lower, .axis = {0, 1}, .limits = Range{-2, 0}});
    } else {
        world.add(DistanceJoint{.ends = upper, .limits = Range{0, 2}});
        world.add(DistanceJoint{.ends = lower, .limits = Range{0, 2}});
    }
    return box;
}

// The refinement of loaded limits does not depend on the lightest body of the World: a disc of
// 0.1 kg, 5 km away, moved such a load by up to 8 mm.
TEST(LocalLimits, ALightBodyFarAwayChangesNoBit) {
    for (const bool slider : {false, true}) {
        for (const Real load :
             support::variants({Real(60), Real(40), Real(50), Real(80), Real(90)})) {
            for (const bool onGround : {false, true}) {
                World alone({.gravity = support::kEarth});
                World beside({.gravity = support::kEarth});
                const BodyId here = hang(alone, load, slider);
                const BodyId there = hang(beside, load, slider);
                beside.add({.shape = Box{1, 1},
                            .position = {5000, Real(0.5)},
                            .mass = MassDef{.mass = Real(0.1)}});
                if (onGround) {
                    beside.add({.shape = Box{3, 1},
                                .position = {5000, Real(-0.5)},
                                .type = BodyType::Static});
                }
                for (int step = 0; step < 60; ++step) {
                    alone.step(support::kDt);
                    beside.step(support::kDt);
                    ASSERT_EQ(alone[here].position(), beside[there].position())
                        << "load " << load << ", slider " << slider << ", step " << step;
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
