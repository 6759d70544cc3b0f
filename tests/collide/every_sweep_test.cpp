// SPDX-License-Identifier: MIT
#include <kodo/collide/time_of_impact.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <tuple>

namespace kodo {
namespace {

using support::AnyKind;

constexpr Real kTarget = Real(1) / 1024;                       // m, the gap to stop at
constexpr Real kTolerance = support::byPrecision(1e-5, 1e-13); // ways of up to 8 m

class EverySweep : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    Convex randomShape(AnyKind kind) {
        return convexOf(support::randomPrimitive(random_, kind), {});
    }
    Sweep randomSweep(Vec2 near, double reach) {
        const Vec2 position = near + random_.point(reach);
        const Rot rotation = random_.rotation();
        const Vec2 move = random_.point(3);
        Sweep sweep{{position, rotation}, move, random_.between(-2, 2)};
        if (random_.below(3) == 0) { // stopped on its way, and perhaps pushed along
            sweep.stopAt = random_.between(0, 1);
            sweep.push = random_.below(2) == 0 ? Vec2{} : random_.point(2);
        }
        return sweep;
    }
    support::RandomNumbers random_{191};
};

// The moment of impact is never late: until then, whatever the pair, a fine sampling of its true
// distance finds no touch; and it is an impact: the two are near each other then.
TEST_P(EverySweep, IsNeverLateAndEndsNearTheOther) {
    int hits = 0;
    int crept = 0;
    const bool plane =
        std::get<0>(GetParam()) == AnyKind::Plane || std::get<1>(GetParam()) == AnyKind::Plane;
    const int sweeps = plane ? 1000 : support::draws(1000); // those of planes are cheap
    for (int i = 0; i < sweeps; ++i) {
        const Convex shapeA = randomShape(std::get<0>(GetParam()));
        const Convex shapeB = randomShape(std::get<1>(GetParam()));
        if (shapeA.isPlane() && shapeB.isPlane()) {
            break; // two planes always overlap, and never touch
        }
        const Sweep a = randomSweep({}, 4);
        const Sweep b = randomSweep(a.start.position, 4);
        const auto gapAt = [&](Real t) {
            return support::signedDistance(shapeA, a.at(t), shapeB, b.at(t));
        };
        if (gapAt(0) < static_cast<long double>(2 * kTarget)) {
            continue;
        }
        const Real t = timeOfImpact(shapeA, a, shapeB, b, kTarget);
        const Real end = std::min(t, Real(1));
        for (int k = 0; k <= 32; ++k) {
            ASSERT_GT(gapAt(end * static_cast<Real>(k) / 32), kTarget / 2 - kTolerance)
                << "sweep " << i << ", sample " << k << " of " << end;
        }
        if (t <= 1) {
            ++hits;
            // Along an axis of a face they are no farther apart; corner to corner they may be.
            crept += gapAt(t) > static_cast<long double>(4 * kTarget) ? 1 : 0;
        }
    }
    // A plane that turns sweeps fast far out, so the bound on its approach is a poor one.
    EXPECT_LE(crept, hits / (plane ? 10 : 50) + 1) << "of " << hits;
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EverySweep,
                         testing::Combine(testing::ValuesIn(support::kTwoSidedKinds),
                                          testing::ValuesIn(support::kTwoSidedKinds)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_and_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// A platform stops what flies at its front, or lets itself be flown at, before the two touch. What
// comes from behind may pass: there is no touch to be late for. (Whether two platforms meet is
// decided by their middles.)
TEST(PlatformSweep, IsNeverLateForWhatComesFromTheFront) {
    support::RandomNumbers random(192);
    int hits = 0;
    int crept = 0;
    for (const AnyKind kind : {AnyKind::Point, AnyKind::Circle, AnyKind::Box, AnyKind::Polygon,
                               AnyKind::Segment, AnyKind::Plane}) {
        for (int i = 0; i < support::draws(2000); ++i) {
            SCOPED_TRACE(testing::Message() << support::nameOf(kind) << ", sweep " << i);
            const Convex platform =
                convexOf(support::randomPrimitive(random, AnyKind::Platform), {});
            const Convex other = convexOf(support::randomPrimitive(random, kind), {});
            const Sweep a{{random.point(4), random.rotation()}, random.point(3), 0};
            const Vec2 start = a.start.position + random.point(4);
            const Sweep b{{start, random.rotation()}, random.point(3), 0};
            const auto gapAt = [&](Real t) {
                return support::signedDistance(platform, a.at(t), other, b.at(t));
            };
            const support::Passage passage =
                support::frontPassageOf(other, b.start, b.move - a.move, platform, a.start);
            if (gapAt(0) < static_cast<long double>(2 * kTarget) ||
                passage.end != support::Passage::End::Hits) {
                continue;
            }
            for (const Real t : {timeOfImpact(platform, a, other, b, kTarget),
                                 timeOfImpact(other, b, platform, a, kTarget)}) {
                ASSERT_LT(t, passage.fraction);
                ASSERT_GT(gapAt(t), kTarget / 2 - kTolerance);
                ++hits;
                crept += gapAt(t) > static_cast<long double>(4 * kTarget) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(hits, support::draws(2000) / 4);
    EXPECT_LE(crept, hits / 50) << "of " << hits;
}

} // namespace
} // namespace kodo
