// SPDX-License-Identifier: MIT
#include <kodo/ray.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

namespace kodo {
namespace {

using support::near;

using Wide = long double;
using WideRay = BasicRay<Wide>;
using WideVec = BasicVec2<Wide>;
constexpr Wide kWideTolerance = 1e-17L; // a dozen roundings of values near 1

template <typename Shape>
void expectHit(const Shape& shape, const WideRay& ray, Wide fraction, WideVec normal) {
    const auto hit = rayCast(shape, ray);
    ASSERT_TRUE(hit);
    EXPECT_TRUE(near(hit->fraction, fraction, kWideTolerance));
    EXPECT_TRUE(near(hit->normal, normal, kWideTolerance));
}

BasicPolygon<Wide> square() {
    return {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
}

// P1: closed forms, in long double.
TEST(RayCast, HitsEachPrimitiveAtTheClosedFormPoint) {
    const WideRay down{{0.6L, 5}, {0.6L, -5}};
    expectHit(BasicCircle<Wide>{1, {0, 0}}, down, 0.42L, {0.6L, 0.8L});
    expectHit(square(), down, 0.4L, {0, 1});
    expectHit(BasicBox<Wide>{2, 2, {0, 0}, {}}, down, 0.4L, {0, 1});
    expectHit(BasicAabb<Wide>{{-1, -1}, {1, 1}}, down, 0.4L, {0, 1});
    expectHit(BasicPlane<Wide>{{0, 1}, 1}, down, 0.4L, {0, 1});
    expectHit(BasicSegment<Wide>{{-1, 0}, {1, 0}}, down, 0.5L, {0, 1});
    expectHit(BasicPoint<Wide>{{0.6L, 0}}, down, 0.5L, {0, 1});
    expectHit(BasicBox<Wide>{2, 2, {0, 0}, {0.6L, 0.8L}}, {{0, 5}, {0, -5}}, 0.375L, {0.6L, 0.8L});
}

TEST(RayCast, MissesShapesBesideBehindOrBeyondTheRay) {
    const WideRay right{{2, 0}, {5, 0}};
    EXPECT_FALSE(rayCast(BasicCircle<Wide>{1, {0, 0}}, right)) << "behind";
    EXPECT_FALSE(rayCast(square(), right));
    EXPECT_FALSE(rayCast(BasicCircle<Wide>{1, {7, 0}}, right)) << "beyond";
    EXPECT_FALSE(rayCast(BasicBox<Wide>{2, 2, {7, 0}, {}}, right));
    EXPECT_FALSE(rayCast(BasicCircle<Wide>{1, {3, 2}}, right)) << "beside";
    EXPECT_FALSE(rayCast(BasicBox<Wide>{2, 2, {3, 2}, {}}, right));
    EXPECT_FALSE(rayCast(BasicPlane<Wide>{{0, 1}, -1}, right)) << "along the surface";
    EXPECT_FALSE(rayCast(BasicSegment<Wide>{{3, 1}, {3, 2}}, right));
    EXPECT_FALSE(rayCast(BasicPoint<Wide>{{3, 1e-15L}}, right));
}

// Touching counts: tangent to a circle, along a side, through a corner, up to the surface.
TEST(RayCast, CountsATouchAsAHit) {
    expectHit(BasicCircle<Wide>{1, {0, 0}}, {{-2, 1}, {2, 1}}, 0.5L, {0, 1});
    expectHit(square(), {{-2, 1}, {2, 1}}, 0.25L, {-1, 0});
    expectHit(BasicBox<Wide>{2, 2, {0, 0}, {}}, {{-2, 1}, {2, 1}}, 0.25L, {-1, 0});
    EXPECT_TRUE(rayCast(square(), WideRay{{-2, 0}, {0, 2}})) << "the corner at (-1, 1)";
    expectHit(BasicPlane<Wide>{{0, 1}, 0}, {{0, 1}, {0, 0}}, 1, {0, 1});
    expectHit(BasicCircle<Wide>{1, {0, 0}}, {{-3, 0}, {-1, 0}}, 1, {-1, 0});
    const WideRay atEnd{{1, 1}, {1, -1}};
    expectHit(BasicSegment<Wide>{{-1, 0}, {1, 0}}, atEnd, 0.5L, {0, 1});
}

TEST(RayCast, HitsAtZeroIfItStartsInside) {
    const WideRay out{{0, 0}, {5, 0}};
    expectHit(BasicCircle<Wide>{1, {0, 0}}, out, 0, {});
    expectHit(square(), out, 0, {});
    expectHit(BasicBox<Wide>{2, 2, {0, 0}, {}}, out, 0, {});
    expectHit(BasicPlane<Wide>{{1, 0}, 1}, out, 0, {});
    const BasicSegment<Wide> segment{{-1, 0}, {1, 0}};
    expectHit(segment, out, 0, {});
    expectHit(segment, {{0, 0}, {0, 5}}, 0, {}); // across it
    expectHit(segment, {{0, 0}, {3, -5}}, 0, {});
    expectHit(segment, {{1, 0}, {1, 5}}, 0, {}); // from an end
    expectHit(segment, {{0, 0}, {0, 0}}, 0, {});
    expectHit(BasicSegment<Wide>{{-1, 0}, {1, 0}, true}, {{0, 0}, {0, -5}}, 0, {});
}

TEST(RayCast, AlongASegmentHitsTheNearerEnd) {
    const BasicSegment<Wide> segment{{-1, 0}, {1, 0}};
    expectHit(segment, {{-5, 0}, {5, 0}}, 0.4L, {-1, 0});
    expectHit(segment, {{5, 0}, {-5, 0}}, 0.4L, {1, 0});
    EXPECT_FALSE(rayCast(segment, WideRay{{-5, 1}, {5, 1}})) << "parallel, beside it";
    EXPECT_FALSE(rayCast(segment, WideRay{{-5, 0}, {-2, 0}})) << "too short";
}

TEST(RayCast, HitsAOneSidedSegmentOnlyFromTheFront) {
    const BasicSegment<Wide> segment{{-1, 0}, {1, 0}, true};
    expectHit(segment, {{0, 1}, {0, -1}}, 0.5L, {0, 1});
    EXPECT_FALSE(rayCast(segment, WideRay{{0, -1}, {0, 1}}));
    EXPECT_FALSE(rayCast(segment, WideRay{{-5, 0}, {5, 0}}));
}

TEST(RayCast, OfZeroLengthHitsOnlyShapesThatContainIt) {
    const WideRay here{{0, 0}, {0, 0}};
    EXPECT_TRUE(rayCast(square(), here));
    EXPECT_FALSE(rayCast(BasicCircle<Wide>{1, {3, 0}}, here));
    EXPECT_FALSE(rayCast(BasicBox<Wide>{1, 1, {3, 0}, {}}, here));
    EXPECT_FALSE(rayCast(BasicSegment<Wide>{{1, -1}, {1, 1}}, here));
}

// The hit point is on the boundary, and no earlier point of the ray is inside, by 200 samples.
// 10,000 rays for each primitive.
TEST(RayCast, AgreesWithFineSampling) {
    support::RandomNumbers random(151);
    const Real tolerance = support::byPrecision(1e-5, 1e-13);
    const auto tryOne = [&](const auto& shape, const Ray& ray) {
        const auto hit = rayCast(shape, ray);
        Real first = 2;
        for (int i = 200; i >= 0; --i) {
            const Real at = static_cast<Real>(i) / 200;
            first = contains(shape, ray.at(at)) ? at : first;
        }
        if (!hit) {
            ASSERT_EQ(first, 2) << "the ray passes through";
            return;
        }
        ASSERT_LE(hit->fraction, first + tolerance);
        if (hit->normal != Vec2{}) {
            ASSERT_FALSE(contains(shape, ray.at(hit->fraction) + tolerance * hit->normal));
            ASSERT_LT(dot(hit->normal, ray.way()), tolerance);
        }
        if (first < 2 && first > 0) { // between two samples
            ASSERT_GT(hit->fraction, first - Real(1) / 200 - tolerance);
        }
    };
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        const Ray ray{random.point(3), random.point(3)};
        tryOne(support::randomPolygon(random, 3 + random.below(14)), ray);
        tryOne(Circle{random.between(0.2, 1.5), random.point(0.5)}, ray);
        tryOne(Box{random.between(0.2, 3), random.between(0.2, 3), random.point(0.5),
                   random.rotation()},
               ray);
        tryOne(Plane{random.rotation().xAxis(), random.between(-1, 1)}, ray);
    }
}

// A ray crosses a segment if the ends of each lie on different sides of the other. A one-sided
// segment is hit only from its front. Nearly collinear cases are skipped, since either answer is
// valid.
TEST(RayCast, HitsASegmentExactlyWhenTheyCross) {
    support::RandomNumbers random(152);
    const auto wide = [](Vec2 v) {
        return WideVec{static_cast<Wide>(v.x), static_cast<Wide>(v.y)};
    };
    int hits = 0;
    for (int i = 0; i < 10000; ++i) {
        const Ray ray{random.point(3), random.point(3)};
        Segment segment = support::randomSegment(random);
        segment.oneSided = i % 2 == 0;
        const WideVec along = wide(segment.to) - wide(segment.from);
        const WideVec way = wide(ray.to) - wide(ray.from);
        const Wide start = cross(along, wide(ray.from) - wide(segment.from));
        const Wide end = cross(along, wide(ray.to) - wide(segment.from));
        const Wide from = cross(way, wide(segment.from) - wide(ray.from));
        const Wide to = cross(way, wide(segment.to) - wide(ray.from));
        if (std::min({std::abs(start), std::abs(end), std::abs(from), std::abs(to)}) <
            64 * static_cast<Wide>(support::kEpsilon)) {
            continue;
        }
        const bool crosses = (start > 0) != (end > 0) && (from > 0) != (to > 0);
        const auto hit = rayCast(segment, ray);
        ASSERT_EQ(hit.has_value(), crosses && (start > 0 || !segment.oneSided)) << "ray " << i;
        if (hit) {
            ++hits;
            // At a flat angle the same rounding is a larger error along the ray.
            const auto off = cross(along, wide(ray.at(hit->fraction)) - wide(segment.from));
            ASSERT_LT(std::abs(off), 64 * static_cast<Wide>(support::kEpsilon)) << "ray " << i;
            ASSERT_LT(dot(hit->normal, ray.way()), 0) << "ray " << i;
        }
    }
    EXPECT_GT(hits, 500);
}

} // namespace
} // namespace kodo
