// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include "math/lane_rotations.hpp"

#include <cmath>
#include <numbers>

namespace kodo {
namespace {

/// Equal, or both NaN.
void expectSame(Real a, Real b, Real angle) {
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << angle << ": " << a << " and " << b;
}

/// All lanes have `angle` except the first, so that lanes with near and far angles are mixed.
void expectAsAlone(Real angle, Real first) {
    Lanes angles = all(angle);
    angles[0] = first;
    const Couple both = cosSin(angles);
    for (int i = 0; i < kLanes; ++i) {
        const SinCos<Real> alone = sinCos(static_cast<Real>(angles[i]));
        expectSame(both.x[i], alone.cos, angles[i]);
        expectSame(both.y[i], alone.sin, angles[i]);
    }
}

// B4: a body's orientation must not depend on the other lanes.
TEST(CosSin, OfLanesHasTheBitsOfASingleAngle) {
    support::RandomNumbers random(11);
    for (int i = 0; i < 20000; ++i) {
        expectAsAlone(random.between(-1, 1), random.between(-1, 1));
        expectAsAlone(random.between(-100, 100), random.between(-1, 1));
        expectAsAlone(random.between(-1e-3, 1e-3), random.between(-1e-8, 1e-8));
    }
    for (int eighths = -40; eighths <= 40; ++eighths) { // at the borders of quadrants
        Real angle = static_cast<Real>(eighths) * std::numbers::pi_v<Real> / 4;
        for (int step = 0; step < 5; ++step) {
            angle = std::nextafter(angle, -support::kInf);
        }
        for (int step = 0; step < 10; ++step) {
            expectAsAlone(angle, random.between(-1, 1));
            angle = std::nextafter(angle, support::kInf);
        }
    }
    for (const Real angle : {Real(0), Real(1e5), Real(-3e6), Real(5e6), Real(-1e30), support::kInf,
                             -support::kInf, support::kNan}) {
        expectAsAlone(angle, Real(0.1));
        expectAsAlone(angle, 3);
    }
}

} // namespace
} // namespace kodo
