// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include <algorithm>
#include <cstdlib>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;

constexpr Real kMargin = Real(0.125);
constexpr Real kTolerance = byPrecision(5e-6, 1e-14);

struct Pair {
    Primitive primitiveA;
    Primitive primitiveB;
    Transform a;
    Transform b;

    Manifold manifold(Real margin = kMargin) const {
        return collide(convexOf(primitiveA, {}), a, convexOf(primitiveB, {}), b, margin, 0);
    }
};

/// Random pairs of all kinds, in turn.
template <typename Body>
void forRandomPairs(int count, Body body) {
    constexpr std::uint64_t kSeed = 81;
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        Pair p;
        p.primitiveA = support::randomPrimitive(random, support::kAllKinds[random.below(3)]);
        p.primitiveB = support::randomPrimitive(random, support::kAllKinds[random.below(3)]);
        p.a = random.pose(4);
        p.b = {p.a.position + random.point(2), random.rotation()};
        body(p);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

// C1: no body is first by right. Which of two points is "deepest" may change in a tie only.
TEST(CollideSymmetry, SwappedArgumentsTurnTheNormal) {
    forRandomPairs(10000, [](const Pair& p) {
        const Manifold forth = p.manifold();
        const Manifold back = Pair{p.primitiveB, p.primitiveA, p.b, p.a}.manifold();
        ASSERT_EQ(forth.count, back.count);
        if (forth.count == 0) {
            return;
        }
        ASSERT_TRUE(near(forth.normal, -back.normal, kTolerance));
        for (std::size_t k = 0; k < static_cast<std::size_t>(forth.count); ++k) {
            ASSERT_TRUE(near(forth.points[k].armA, back.points[k].armB, kTolerance));
            ASSERT_TRUE(near(forth.points[k].separation, back.points[k].separation, kTolerance));
        }
    });
}

Vec2 mirrored(Vec2 v) {
    return {-v.x, v.y};
}

Primitive mirrored(const Primitive& primitive) {
    if (const auto* circle = std::get_if<Circle>(&primitive)) {
        return Circle{circle->radius, mirrored(circle->center)};
    }
    if (const auto* box = std::get_if<Box>(&primitive)) {
        return Box{box->width, box->height, mirrored(box->center), box->rotation.inverse()};
    }
    Polygon polygon = std::get<Polygon>(primitive);
    std::reverse(polygon.corners.begin(), polygon.corners.end());
    for (Vec2& corner : polygon.corners) {
        corner = mirrored(corner);
    }
    return polygon;
}

Transform mirrored(const Transform& t) {
    return {mirrored(t.position), t.rotation.inverse()};
}

// The corners come in the opposite order, so heights are taken from the other end of an edge: equal
// up to rounding, not to the bit.
TEST(CollideSymmetry, AMirroredPairHasTheMirroredContact) {
    forRandomPairs(10000, [](const Pair& p) {
        const Manifold here = p.manifold();
        const Manifold there =
            Pair{mirrored(p.primitiveA), mirrored(p.primitiveB), mirrored(p.a), mirrored(p.b)}
                .manifold();
        ASSERT_EQ(here.count, there.count);
        if (here.count == 0) {
            return;
        }
        ASSERT_TRUE(near(mirrored(here.normal), there.normal, kTolerance));
        for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
            ASSERT_TRUE(near(mirrored(here.points[k].armA), there.points[k].armA, kTolerance));
        }
    });
}

Transform quarterTurned(const Transform& t) {
    return {perp(t.position), Rot{0, 1} * t.rotation};
}

// A quarter turn only swaps coordinates and signs: the same bits.
TEST(CollideSymmetry, AQuarterTurnChangesNoBit) {
    forRandomPairs(10000, [](const Pair& p) {
        const Manifold here = p.manifold();
        const Manifold there =
            Pair{p.primitiveA, p.primitiveB, quarterTurned(p.a), quarterTurned(p.b)}.manifold();
        ASSERT_EQ(here.count, there.count);
        ASSERT_EQ(perp(here.normal), there.normal);
        for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
            ASSERT_EQ(perp(here.points[k].armA), there.points[k].armA);
            ASSERT_EQ(perp(here.points[k].armB), there.points[k].armB);
            ASSERT_EQ(here.points[k].separation, there.points[k].separation);
            ASSERT_EQ(here.points[k].feature, there.points[k].feature);
        }
    });
}

Primitive scaled(const Primitive& primitive, Real s) {
    if (const auto* circle = std::get_if<Circle>(&primitive)) {
        return Circle{s * circle->radius, s * circle->center};
    }
    if (const auto* box = std::get_if<Box>(&primitive)) {
        return Box{s * box->width, s * box->height, s * box->center, box->rotation};
    }
    Polygon polygon = std::get<Polygon>(primitive);
    for (Vec2& corner : polygon.corners) {
        corner *= s;
    }
    return polygon;
}

// No hidden length: a power of two scales every length and changes no other bit.
TEST(CollideSymmetry, APowerOfTwoScalesExactly) {
    for (const Real s : {Real(1024), Real(1) / 4096}) {
        forRandomPairs(5000, [s](const Pair& p) {
            const Manifold here = p.manifold();
            const Manifold there = Pair{
                scaled(p.primitiveA, s),
                scaled(p.primitiveB, s),
                {s * p.a.position, p.a.rotation},
                {s * p.b.position,
                 p.b.rotation}}.manifold(s * kMargin);
            ASSERT_EQ(here.count, there.count);
            ASSERT_EQ(here.normal, there.normal);
            for (std::size_t k = 0; k < static_cast<std::size_t>(here.count); ++k) {
                ASSERT_EQ(s * here.points[k].armA, there.points[k].armA);
                ASSERT_EQ(s * here.points[k].separation, there.points[k].separation);
                ASSERT_EQ(here.points[k].feature, there.points[k].feature);
            }
        });
    }
}

Vec2 onGrid(Vec2 v) {
    return {std::floor(v.x * 256) / 256, std::floor(v.y * 256) / 256};
}

// Contacts are found from one body's frame, so going far away loses nothing while the positions
// themselves can be written down: here they lie on a grid of 1/256 m.
TEST(CollideSymmetry, AMoveOfBothChangesNoBit) {
    forRandomPairs(10000, [](const Pair& p) {
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

} // namespace
} // namespace kodo
