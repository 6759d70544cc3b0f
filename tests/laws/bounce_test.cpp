// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::nearShare;
using support::slippery;

/// Peak heights (m, of the ball's lowest point) of a ball dropped from 5 m.
std::vector<long double> peaksOf(Real restitution, Real rate, std::size_t count) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, slippery(restitution));
    const BodyId ball = world.add(ballDef({0, Real(5.5)}, Real(0.5), slippery(restitution)));
    std::vector<long double> peaks;
    bool rising = false;
    for (int i = 0; i < static_cast<int>(20 * rate) && peaks.size() < count; ++i) {
        world.step(1 / rate);
        const auto v = static_cast<long double>(world[ball].velocity().y);
        // The peak lies between two steps; its height follows from the energy.
        if (rising && v <= 0) {
            const auto height = static_cast<long double>(world[ball].position().y) - 0.5L;
            peaks.push_back(height + v * v / 20);
        }
        rising = v > 0;
    }
    return peaks;
}

// Peak n has the height h0 e^(2 n). The first three are within 5 % while the rebound is faster than
// 10 g dt.
TEST(Bounce, PeaksFallWithTheSquareOfRestitution) {
    for (const Real rate : {Real(60), Real(240)}) {
        for (const Real e : {Real(0.5), Real(0.8), Real(0.9)}) {
            const std::vector<long double> peaks = peaksOf(e, rate, 3);
            ASSERT_EQ(peaks.size(), 3u);
            long double expected = 5;
            for (std::size_t n = 0; n < 3; ++n) {
                SCOPED_TRACE(testing::Message() << rate << " Hz, e " << e << ", peak " << n + 1);
                expected *= static_cast<long double>(e) * static_cast<long double>(e);
                const long double rebound = std::sqrt(20 * expected);
                if (rebound > 100 / static_cast<long double>(rate)) {
                    EXPECT_TRUE(nearShare(peaks[n], expected, 0.05L));
                }
            }
        }
    }
}

// Impacts occur after sqrt(2 h / g) = 1 s and then after 2 e v / g for each rise. An impact is
// resolved in the step after the touch and the ball waits for it. Each impact may add a delay of
// one step, but none is early.
TEST(Bounce, HitsTheFloorAtTheExactTime) {
    for (const Real rate : {Real(60), Real(120), Real(240), Real(480)}) {
        SCOPED_TRACE(rate);
        World world({.gravity = support::kEarth});
        support::addFloor(world, slippery(Real(0.8)));
        const BodyId ball = world.add(ballDef({0, Real(5.5)}, Real(0.5), slippery(Real(0.8))));
        long double expected = 1;
        long double rise = 1;
        int blows = 0;
        Real before = 0;
        for (int i = 1; blows < 4 && i < static_cast<int>(20 * rate); ++i) {
            world.step(1 / rate);
            const Real now = world[ball].velocity().y;
            if (before < 0 && now > 0) {
                ++blows;
                const long double time = i / static_cast<long double>(rate);
                EXPECT_GT(time, expected - 0.001L) << blows;
                EXPECT_LT(time, expected + (blows + 1) / static_cast<long double>(rate)) << blows;
                rise *= 0.8L;
                expected += 2 * rise;
            }
            before = now;
        }
        EXPECT_EQ(blows, 4);
    }
}

// Without loss the energy stays within 3 % for one minute.
TEST(Bounce, WithoutLossKeepsItsEnergyForAMinute) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, slippery(1));
    const BodyId ball = world.add(ballDef({0, Real(5.5)}, Real(0.5), slippery(1)));
    for (int i = 0; i < 3600; ++i) {
        world.step(support::kDt);
        const auto v = static_cast<long double>(world[ball].velocity().y);
        const auto height = static_cast<long double>(world[ball].position().y) - 0.5L;
        ASSERT_TRUE(nearShare(10 * height + v * v / 2, 50, 0.03L)) << "step " << i;
    }
}

// S3, the thesis's rule: the smaller restitution of a pair applies.
TEST(Bounce, TheSmallerRestitutionApplies) {
    for (const auto& [floor, ball] : {std::pair<Real, Real>{1, Real(0.5)}, {Real(0.5), 1}}) {
        World world({.gravity = support::kEarth});
        support::addFloor(world, slippery(floor));
        BodyDef def = ballDef({0, Real(0.51)}, Real(0.5), slippery(ball));
        def.velocity = {0, -8};
        const BodyId id = world.add(def);
        Real fastest = 0;
        for (int i = 0; i < 30; ++i) {
            world.step(support::kDt);
            fastest = std::max(fastest, world[id].velocity().y);
        }
        EXPECT_TRUE(nearShare(fastest, 4, 0.05L)); // gravity in one step is 2 % of 8 m/s
    }
}

// With e = 1, a box that lands flat rises without rotation: both corners are hit at once.
TEST(Bounce, ABoxThatLandsFlatRisesFlat) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, slippery(1));
    const BodyId box = world.add(support::boxDef({0, 2}, 1, 1, slippery(1)));
    for (int i = 0; i < 600; ++i) {
        world.step(support::kDt);
        ASSERT_EQ(world[box].angularVelocity(), 0);
        ASSERT_EQ(world[box].velocity().x, 0);
    }
    EXPECT_LT(world[box].position().y, Real(2.1));
}

// A ball with e = 0 does not bounce.
TEST(Bounce, DoesNotHappenWithoutRestitution) {
    World world({.gravity = support::kEarth});
    support::addFloor(world, slippery(0));
    const BodyId ball = world.add(ballDef({0, 3}, Real(0.5), slippery(0)));
    Real fastest = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(support::kDt);
        fastest = std::max(fastest, world[ball].velocity().y);
    }
    EXPECT_LT(fastest, Real(0.01)); // of an impact speed of 7 m/s
}

} // namespace
} // namespace kodo
