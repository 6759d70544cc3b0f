// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include <cmath>
#include <tuple>

namespace kodo::every_pair_symmetry_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;

constexpr Real kMargin = Real(0.125);
constexpr Real kTolerance = byPrecision(5e-6, 1e-14); // distances of up to 8 m, twenty roundings
const int kPoses = support::poses();

struct Pair {
    Pair(const Primitive& first, const Primitive& second)
        : primitiveA(first),
          primitiveB(second),
          shapeA(convexShapeOf(first, {})),
          shapeB(convexShapeOf(second, {})) {}

    Manifold manifold(Real margin = kMargin) const {
        return collide(shapeA, a, shapeB, b, margin, 0);
    }
    /// Of normals and arms. The direction of a gap between cores has the rounding error of its
    /// ends, divided by its length.
    Real tolerance() const {
        const Real radii = shapeA.radius + shapeB.radius;
        const Real gap = radii + separation(shapeA, a, shapeB, b).distance;
        const bool rounded = !shapeA.isRound() || !shapeB.isRound();
        return radii > 0 && rounded && gap > 0 ? kTolerance * std::max(Real(1), 1 / gap)
                                               : kTolerance;
    }
    ClosestPoints nearness() const { return distance(shapeA, a, shapeB, b); }
    std::optional<CastHit> cast() const { return shapeCast(shapeB, b, move, shapeA, a); }

    Primitive primitiveA;
    Primitive primitiveB;
    ConvexShape shapeA;
    ConvexShape shapeB;
    Transform a{};
    Transform b{};
    Vec2 move{}; // of b
};

// C1: all kinds against each other, in both orders.
class EveryPairSymmetry : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    template <typename Body>
    void forRandomPairs(Body body) {
        support::RandomNumbers random(101);
        for (int i = 0; i < kPoses && !HasFatalFailure(); ++i) {
            SCOPED_TRACE(testing::Message() << "pose " << i);
            const Primitive first = support::randomPrimitive(random, std::get<0>(GetParam()));
            Pair p(first, support::randomPrimitive(random, std::get<1>(GetParam())));
            p.a = random.pose(4);
            p.b = {p.a.position + random.point(2), random.rotation()};
            p.move = random.point(4);
            body(p);
        }
    }
};

// The order of the bodies does not matter. Two one-sided lines are an exception: the rules of the
// first one decide.
TEST_P(EveryPairSymmetry, SwappedShapesNegateTheNormal) {
    forRandomPairs([](const Pair& p) {
        if (p.shapeA.oneSided && p.shapeB.oneSided) {
            return;
        }
        const Manifold forth = p.manifold();
        const Manifold back = collide(p.shapeB, p.b, p.shapeA, p.a, kMargin, 0);
        ASSERT_EQ(forth.count, back.count);
        ASSERT_EQ(forth.fromBehind, back.fromBehind);
        ASSERT_TRUE(near(forth.normal, -back.normal, p.tolerance()));
        for (std::size_t k = 0; k < static_cast<std::size_t>(forth.count); ++k) {
            ASSERT_TRUE(near(forth.points[k].armA, back.points[k].armB, p.tolerance()));
            ASSERT_TRUE(near(forth.points[k].separation, back.points[k].separation, kTolerance));
        }
    });
}

// The corners are in the opposite order, so heights are measured from the other end of an edge.
// Results are equal up to rounding, not bit-identical.
TEST_P(EveryPairSymmetry, AMirroredPairHasTheMirroredContact) {
    forRandomPairs([](const Pair& p) {
        Pair q(support::mirrored(p.primitiveA), support::mirrored(p.primitiveB));
        q.a = support::mirrored(p.a);
        q.b = support::mirrored(p.b);
        q.move = support::mirrored(p.move);
        ASSERT_TRUE(near(p.nearness().distance, q.nearness().distance, kTolerance));
        ASSERT_EQ(p.cast().has_value(), q.cast().has_value());
        const Manifold here = p.manifold();
        const Manifold there = q.manifold();
        ASSERT_EQ(here.count, there.count);
        ASSERT_EQ(here.fromBehind, there.fromBehind);
        ASSERT_TRUE(near(support::mirrored(here.normal), there.normal, p.tolerance()));
        for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
            ASSERT_TRUE(
                near(support::mirrored(here.points[k].armA), there.points[k].armA, p.tolerance()));
        }
    });
}

Transform quarterTurned(const Transform& t) {
    return {perp(t.position), Rot{0, 1} * t.rotation};
}

// A rotation by 90 degrees only exchanges coordinates and signs: the same bits.
TEST_P(EveryPairSymmetry, AQuarterTurnChangesNoBit) {
    forRandomPairs([](const Pair& p) {
        Pair q = p;
        q.a = quarterTurned(p.a);
        q.b = quarterTurned(p.b);
        q.move = perp(p.move);
        const Manifold here = p.manifold();
        const Manifold there = q.manifold();
        ASSERT_EQ(here.count, there.count);
        ASSERT_EQ(here.fromBehind, there.fromBehind);
        ASSERT_EQ(perp(here.normal), there.normal);
        for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
            ASSERT_EQ(perp(here.points[k].armA), there.points[k].armA);
            ASSERT_EQ(perp(here.points[k].armB), there.points[k].armB);
            ASSERT_EQ(here.points[k].separation, there.points[k].separation);
            ASSERT_EQ(here.points[k].feature, there.points[k].feature);
        }
        ASSERT_EQ(perp(p.nearness().onA), q.nearness().onA);
        ASSERT_EQ(p.nearness().distance, q.nearness().distance);
        const std::optional<CastHit> hit = p.cast();
        const std::optional<CastHit> other = q.cast();
        ASSERT_EQ(hit.has_value(), other.has_value());
        ASSERT_EQ(hit ? hit->fraction : 0, other ? other->fraction : 0);
        ASSERT_EQ(hit ? perp(hit->point) : Vec2{}, other ? other->point : Vec2{});
    });
}

// There is no absolute length: a power of two scales every length exactly.
TEST_P(EveryPairSymmetry, APowerOfTwoScalesExactly) {
    for (const Real s : {Real(1024), Real(1) / 4096}) {
        forRandomPairs([s](const Pair& p) {
            Pair q(support::scaled(p.primitiveA, s), support::scaled(p.primitiveB, s));
            q.a = {s * p.a.position, p.a.rotation};
            q.b = {s * p.b.position, p.b.rotation};
            q.move = s * p.move;
            const Manifold here = p.manifold();
            const Manifold there = q.manifold(s * kMargin);
            ASSERT_EQ(here.count, there.count);
            ASSERT_EQ(here.fromBehind, there.fromBehind);
            ASSERT_EQ(here.normal, there.normal);
            for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
                ASSERT_EQ(s * here.points[k].armA, there.points[k].armA);
                ASSERT_EQ(s * here.points[k].separation, there.points[k].separation);
                ASSERT_EQ(here.points[k].feature, there.points[k].feature);
            }
            ASSERT_EQ(s * p.nearness().distance, q.nearness().distance);
            const std::optional<CastHit> hit = p.cast();
            const std::optional<CastHit> other = q.cast();
            ASSERT_EQ(hit.has_value(), other.has_value());
            ASSERT_EQ(hit ? hit->fraction : 0, other ? other->fraction : 0);
        });
    }
}

Vec2 onGrid(Vec2 v) {
    return {std::floor(v.x * 256) / 256, std::floor(v.y * 256) / 256};
}

// Contacts are computed in one body's frame, so distance from the origin costs no precision while
// the positions are representable. Here they are multiples of 1/256 m.
TEST_P(EveryPairSymmetry, TranslatingBothChangesNoBit) {
    forRandomPairs([](const Pair& p) {
        Pair here = p;
        here.a.position = onGrid(p.a.position);
        here.b.position = onGrid(p.b.position);
        Pair there = here;
        there.a.position += Vec2{4096, -2048};
        there.b.position += Vec2{4096, -2048};
        const Manifold near = here.manifold();
        const Manifold far = there.manifold();
        ASSERT_EQ(near.count, far.count);
        ASSERT_EQ(near.normal, far.normal);
        for (std::size_t k = 0; k < static_cast<std::size_t>(near.count); ++k) {
            ASSERT_EQ(near.points[k].armA, far.points[k].armA);
            ASSERT_EQ(near.points[k].separation, far.points[k].separation);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EveryPairSymmetry,
                         testing::Combine(testing::ValuesIn(support::kEveryKind),
                                          testing::ValuesIn(support::kEveryKind)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_on_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

} // namespace
} // namespace kodo::every_pair_symmetry_test
