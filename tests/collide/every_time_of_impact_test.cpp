// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include "collide/time_of_impact.hpp"

#include <tuple>

namespace kodo::every_time_of_impact_test {
namespace {

using support::AnyKind;

constexpr Real kTarget = Real(1) / 1024;                       // m, the separation at the impact
constexpr Real kTolerance = support::byPrecision(1e-5, 1e-13); // paths of up to 8 m

class EveryTimeOfImpact : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    ConvexShape randomShape(AnyKind kind) {
        return convexShapeOf(support::randomPrimitive(random_, kind), {});
    }
    MotionPath randomSweep(Vec2 near, double reach) {
        const Vec2 position = near + random_.point(reach);
        const Rot rotation = random_.rotation();
        const Vec2 move = random_.point(3);
        MotionPath sweep{{position, rotation}, move, random_.between(-2, 2)};
        if (random_.below(3) == 0) { // stopped on its path, and possibly pushed
            sweep.stopAt = random_.between(0, 1);
            sweep.push = random_.below(2) == 0 ? Vec2{} : random_.point(2);
        }
        return sweep;
    }
    support::RandomNumbers random_{191};
};

// The time of impact is never late: until then, samples of the true distance find no touch. It is
// an impact: the two are near each other then.
TEST_P(EveryTimeOfImpact, IsNeverLateAndEndsNearContact) {
    int hits = 0;
    int crept = 0;
    const bool plane =
        std::get<0>(GetParam()) == AnyKind::Plane || std::get<1>(GetParam()) == AnyKind::Plane;
    const int sweeps = plane ? 1000 : support::poses() / 5; // planes are cheap
    for (int i = 0; i < sweeps; ++i) {
        const ConvexShape shapeA = randomShape(std::get<0>(GetParam()));
        const ConvexShape shapeB = randomShape(std::get<1>(GetParam()));
        if (shapeA.isPlane() && shapeB.isPlane()) {
            break; // two planes always overlap and never touch
        }
        const MotionPath a = randomSweep({}, 4);
        const MotionPath b = randomSweep(a.start.position, 4);
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
                << "path " << i << ", sample " << k << " of " << end;
        }
        if (t <= 1) {
            ++hits;
            // Along a face axis the gap is not wider; corner to corner it may be.
            crept += gapAt(t) > static_cast<long double>(4 * kTarget) ? 1 : 0;
        }
    }
    // A rotating plane is fast far from its centre, so the bound of its approach is poor. Round
    // corners meet along no face axis more often.
    const bool round =
        std::get<0>(GetParam()) >= AnyKind::Capsule || std::get<1>(GetParam()) >= AnyKind::Capsule;
    EXPECT_LE(crept, hits / (plane ? 10 : round ? 10 : 50) + 1) << "of " << hits;
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EveryTimeOfImpact,
                         testing::Combine(testing::ValuesIn(support::kTwoSidedKinds),
                                          testing::ValuesIn(support::kTwoSidedKinds)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_and_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// A platform and a shape at its front have a time of impact before they touch, whichever of them
// moves. A shape from behind may pass, so no touch can be missed. Two platforms are excluded, since
// their middles decide.
TEST(PlatformTimeOfImpact, IsNeverLateForShapesFromTheFront) {
    support::RandomNumbers random(192);
    int hits = 0;
    int crept = 0;
    for (const AnyKind kind : {AnyKind::Point, AnyKind::Circle, AnyKind::Box, AnyKind::Polygon,
                               AnyKind::Segment, AnyKind::Plane}) {
        for (int i = 0; i < support::draws(2000); ++i) {
            SCOPED_TRACE(testing::Message() << support::nameOf(kind) << ", path " << i);
            const ConvexShape platform =
                convexShapeOf(support::randomPrimitive(random, AnyKind::Platform), {});
            const ConvexShape other = convexShapeOf(support::randomPrimitive(random, kind), {});
            const MotionPath a{{random.point(4), random.rotation()}, random.point(3), 0};
            const Vec2 start = a.start.position + random.point(4);
            const MotionPath b{{start, random.rotation()}, random.point(3), 0};
            const auto gapAt = [&](Real t) {
                return support::signedDistance(platform, a.at(t), other, b.at(t));
            };
            const support::Passage passage = support::frontPassageOf(
                other, b.start, b.deltaPosition - a.deltaPosition, platform, a.start);
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
} // namespace kodo::every_time_of_impact_test
