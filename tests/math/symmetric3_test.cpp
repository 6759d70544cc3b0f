// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include "math/symmetric3.hpp"

namespace kodo {
namespace {

TEST(Symmetric3, SolvingWithTheIdentityChangesNothing) {
    EXPECT_EQ(Symmetric3{}.solve({1, 2, 3}), (Triple{1, 2, 3}));
}

// A sum of three outer products of random vectors is positive definite. Solving inverts its product
// with a random vector. The outer products are 1 to 100 in size and not nearly parallel, so at most
// a few hundred roundings are lost.
TEST(Symmetric3, SolvingInvertsMultiplication) {
    support::RandomNumbers random(11);
    for (int i = 0; i < 1000; ++i) {
        Symmetric3 m{1, 0, 1, 0, 0, 1};
        for (int k = 0; k < 3; ++k) {
            const Triple v{random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)};
            m.xx += v[0] * v[0];
            m.yx += v[1] * v[0];
            m.yy += v[1] * v[1];
            m.zx += v[2] * v[0];
            m.zy += v[2] * v[1];
            m.zz += v[2] * v[2];
        }
        const Triple wanted{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const Triple found = m.solve(m.times(wanted));
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_TRUE(support::near(found[k], wanted[k], 1000 * support::kEpsilon))
                << "seed 11, " << i;
        }
    }
}

// Masses of 1e9 and 1e-9 in one matrix lose no digits, since each axis is solved by itself.
TEST(Symmetric3, SolvesAxesOfVeryDifferentSize) {
    const Triple found = Symmetric3{Real(1e9), 0, 1, 0, 0, Real(1e-9)}.solve({1, 1, 1});
    const Triple wanted{1 / Real(1e9), 1, 1 / Real(1e-9)};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(support::near(found[k], wanted[k], 4 * support::kEpsilon * wanted[k]));
    }
}

// A force at the hinge moves it as if the rotation were eliminated: the matrix of what hangs on it
// maps the motion of the hinge to that force, while the torque about the hinge is 0.
TEST(Symmetric3, WhatHangsOnAHingeFeelsItsForceAlone) {
    support::RandomNumbers random(12);
    for (int i = 0; i < 1000; ++i) {
        const Real mass = random.between(0.1, 10);
        const Real inertia = random.between(0.1, 10);
        const Vec2 arm{random.between(-2, 2), random.between(-2, 2)};
        const Symmetric3 felt = Symmetric3{mass, 0, mass, 0, 0, inertia}.hinged(arm);
        const Vec2 force{random.between(-1, 1), random.between(-1, 1)};
        // kg m/s of the force for 1 s, at the hinge: velocity of the centre and rotation about it
        const Vec2 moved = force / mass + cross(cross(arm, force) / inertia, arm);
        const Triple found = felt.times({moved.x, moved.y, 0});
        ASSERT_TRUE(support::near(found[0], force.x, 1000 * support::kEpsilon)) << "seed 12, " << i;
        ASSERT_TRUE(support::near(found[1], force.y, 1000 * support::kEpsilon)) << "seed 12, " << i;
    }
}

} // namespace
} // namespace kodo
