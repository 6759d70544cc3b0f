// SPDX-License-Identifier: MIT
// Joints that hold two bodies where they overlap, and let them collide: contact and joint exclude
// each other.
#include <kodo/kodo.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace kodo {
namespace {

enum class Hold { Pin, Weld, Rope };

/// Largest kinetic energy (J) in 5 s of two bodies of about 1 kg at rest, which overlap.
Real mostEnergy(const StepSettings& settings, Hold hold, Real rate, std::uint64_t seed) {
    support::RandomNumbers random(seed);
    World world({.settings = settings});
    const Shape shapes[] = {Box{1, 1}, Circle{Real(0.5)}};
    const BodyId a = world.add({.shape = shapes[seed % 3 / 2]});
    BodyDef def{.shape = shapes[seed % 3 > 0 ? 1 : 0]};
    def.position.x = random.between(0, 0.8);
    def.position.y = random.between(0, 0.8);
    const Real angle = random.between(0, 1);
    def.rotation = Rot::fromAngle(angle);
    const BodyId b = world.add(def);
    JointEnds ends{.a = a, .b = b, .collide = true};
    if (hold == Hold::Rope) {
        world.add(DistanceJoint{.ends = ends, .limits = Range{0, length(def.position)}});
    } else {
        ends.anchorB.x = random.between(-0.5, 0.5);
        ends.anchorB.y = random.between(-0.5, 0.5);
        ends.anchorA = def.position + def.rotation * ends.anchorB;
        if (hold == Hold::Pin) {
            world.add(RevoluteJoint{.ends = ends});
        } else {
            world.add(FixedJoint{.ends = ends, .reference = angle});
        }
    }
    Real most = 0;
    for (int step = 0; step < static_cast<int>(5 * rate); ++step) {
        world.step(1 / rate);
        most = std::max(most, static_cast<Real>(support::totalsOf(world).kinetic));
    }
    return most;
}

// Parting at the push speed may give 9 J. What is above that remains an error; a joint that closed
// without a bound against a touching contact gave up to 98 kJ with accurate(), 991 J with the
// defaults, and 2.3 kJ with thesis2006(). Now the largest of 120 is 118, 50 and 24 J. Pins and
// fixed joints under thesis2006() give 0: it removes overlaps and errors by displacements.
TEST(OverlappingJoint, GainsLittle) {
    const struct {
        StepSettings settings;
        Real most; // J
    } profiles[] = {{fast(), 90}, {balanced(), 90}, {accurate(), 180}, {thesis2006(), 60}};
    for (const auto& profile : profiles) {
        for (const Hold hold : {Hold::Pin, Hold::Weld, Hold::Rope}) {
            for (int seed = 1; seed <= support::draws(20); ++seed) {
                EXPECT_LT(mostEnergy(profile.settings, hold, 60, static_cast<std::uint64_t>(seed)),
                          profile.most)
                    << "profile " << &profile - profiles << ", hold " << static_cast<int>(hold)
                    << ", seed " << seed;
            }
        }
    }
}

TEST(OverlappingJoint, GainsLittleAtOtherRates) {
    for (const Real rate : {Real(30), Real(120), Real(240)}) {
        for (const Hold hold : {Hold::Pin, Hold::Weld, Hold::Rope}) {
            for (int seed = 101; seed <= 100 + support::draws(10); ++seed) {
                EXPECT_LT(mostEnergy(balanced(), hold, rate, static_cast<std::uint64_t>(seed)), 90)
                    << "rate " << rate << ", hold " << static_cast<int>(hold) << ", seed " << seed;
            }
        }
    }
}

} // namespace
} // namespace kodo
