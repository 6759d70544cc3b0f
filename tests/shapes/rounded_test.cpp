// SPDX-License-Identifier: MIT
#include <kodo/force_field.hpp>
#include <kodo/ray.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <numbers>

namespace kodo::rounded_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::LongPoint;
using support::near;
using support::nearShare;

constexpr Real kExact = byPrecision(2e-6, 4e-15); // some ten roundings of the result
constexpr long double kPi = std::numbers::pi_v<long double>;
constexpr AnyKind kRounded[] = {AnyKind::Circle, AnyKind::Capsule, AnyKind::RoundBox,
                                AnyKind::RoundPolygon};

/// Area, centroid and second moment about the centroid of a closed polygon, by Green's theorem.
struct Moments {
    long double area = 0;
    LongPoint center;
    long double second = 0;
};
Moments momentsOf(const std::vector<LongPoint>& outline) {
    Moments sum;
    LongPoint first;
    const LongPoint origin = outline[0];
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const LongPoint p = outline[i] - origin;
        const LongPoint q = outline[(i + 1) % outline.size()] - origin;
        const long double d = cross(p, q);
        sum.area += d / 2;
        first += d / 6 * (p + q);
        sum.second += d / 12 * (dot(p, p) + dot(p, q) + dot(q, q));
    }
    sum.center = first / sum.area;
    sum.second -= sum.area * dot(sum.center, sum.center);
    sum.center += origin;
    return sum;
}

/// The outline in long double, with 4,000 sides in a full turn: its area is small by a share of at
/// most 5e-7. It walks around the normals of the core by angles, unlike the engine.
constexpr Real kShare = Real(1e-6);
std::vector<LongPoint> fineOutline(const ConvexShape& convex, const Transform& t) {
    const std::vector<LongPoint> core = support::wrapped(support::placedCorners(convex, t));
    const std::size_t n = core.size();
    const auto radius = static_cast<long double>(convex.radius);
    const auto edgeAngle = [&](std::size_t i) {
        const LongPoint edge = core[(i + 1) % n] - core[i];
        return std::atan2(edge.y, edge.x) - kPi / 2;
    };
    std::vector<LongPoint> outline;
    for (std::size_t i = 0; i < n; ++i) {
        const long double start = n == 1 ? 0 : edgeAngle((i + n - 1) % n);
        long double turn = n == 1 ? 2 * kPi : edgeAngle(i) - start;
        turn += turn < 0 ? 2 * kPi : 0;
        const int pieces = 1 + static_cast<int>(turn / (2 * kPi) * 4000);
        for (int k = 0; k <= pieces; ++k) {
            const long double angle = start + turn * k / pieces;
            outline.push_back(core[i] + radius * LongPoint{std::cos(angle), std::sin(angle)});
        }
    }
    return outline;
}

template <typename Body>
void forRandomShapes(std::uint64_t seed, int count, Body body) {
    support::RandomNumbers random(seed);
    for (int i = 0; i < support::draws(count); ++i) {
        for (const AnyKind kind : kRounded) {
            SCOPED_TRACE(testing::Message()
                         << support::nameOf(kind) << ' ' << i << " of seed " << seed);
            body(support::randomPrimitive(random, kind), random);
        }
    }
}

// R4: the closed forms of a stadium. Its two half discs have their centroids 4 r / (3 pi) beyond
// the ends of the line.
TEST(RoundedMass, OfACapsuleIsTheClosedForm) {
    const long double disc = kPi / 4;
    const long double reach = 1 + 2 / (3 * kPi); // of the centroid of a half disc, r = 1/2, L = 2
    const long double own = disc / 2 * (0.125L - 4 / (9 * kPi * kPi));
    const long double expected =
        2 * (4 + 1) / 12.0L + 2 * (own + disc / 2 * reach * reach); // rectangle and half discs
    for (const Primitive& shape : {Primitive(Capsule{{1, 1}, {1, 3}, Real(0.5)}),
                                   Primitive(Segment{{1, 1}, {1, 3}, false, Real(0.5)})}) {
        const Mass mass = std::visit([](const auto& kind) { return massOf(kind, Real(3)); }, shape);
        EXPECT_TRUE(nearShare(mass.mass, 3 * (2 + disc), kExact));
        EXPECT_TRUE(nearShare(mass.inertia, 3 * expected, kExact));
        EXPECT_EQ(mass.center, (Vec2{1, 2}));
    }
}

TEST(RoundedMass, OfACapsuleOfLengthZeroIsThatOfADisc) {
    const Mass mass = massOf(Capsule{{1, 2}, {1, 2}, 2}, Real(1));
    EXPECT_TRUE(nearShare(mass.mass, 4 * kPi, kExact));
    EXPECT_TRUE(nearShare(mass.inertia, 8 * kPi, kExact));
    EXPECT_TRUE(convexShapeOf(Capsule{{1, 2}, {1, 2}, 2}, {}).isRound());
}

// A = A of the core + its perimeter r + pi r^2.
TEST(RoundedMass, OfAPolygonHasTheAreaOfTheMinkowskiSum) {
    support::RandomNumbers random(711);
    for (int i = 0; i < support::draws(2000); ++i) {
        Polygon polygon = support::randomPolygon(random, 3 + random.below(18));
        const long double core = static_cast<long double>(areaOf(polygon));
        long double perimeter = 0;
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            perimeter +=
                length(support::widened(polygon.corners[k]) -
                       support::widened(polygon.corners[(k + 1) % polygon.corners.size()]));
        }
        polygon.radius = support::randomRadius(random);
        const auto r = static_cast<long double>(polygon.radius);
        ASSERT_TRUE(nearShare(areaOf(polygon), core + perimeter * r + kPi * r * r, 4 * kExact));
    }
}

// Two ways to the same mass: four corners, or strips and sectors.
TEST(RoundedMass, OfABoxAsAPolygonIsThatOfTheBox) {
    support::RandomNumbers random(712);
    for (int i = 0; i < support::draws(2000); ++i) {
        const auto box = std::get<Box>(support::randomPrimitive(random, AnyKind::RoundBox));
        const Mass expected = massOf(box, Real(2));
        const Mass found = massOf(polygonOf(box), Real(2));
        ASSERT_TRUE(nearShare(found.mass, expected.mass, 8 * kExact));
        ASSERT_TRUE(nearShare(found.inertia, expected.inertia, 16 * kExact));
        ASSERT_TRUE(near(found.center, expected.center, 8 * kExact));
    }
}

TEST(RoundedMass, OfRandomShapesAgreesWithTheBoundaryIntegral) {
    forRandomShapes(713, 100, [](const Primitive& shape, support::RandomNumbers&) {
        const Moments expected = momentsOf(fineOutline(convexShapeOf(shape, {}), {}));
        const Mass mass = std::visit([](const auto& kind) { return massOf(kind, Real(1)); }, shape);
        ASSERT_TRUE(nearShare(mass.mass, expected.area, kShare + 8 * kExact));
        ASSERT_TRUE(nearShare(mass.inertia, expected.second, 2 * kShare + 16 * kExact));
        ASSERT_TRUE(near(mass.center, expected.center, kShare + 8 * kExact));
    });
}

// The fine outline, clipped corner by corner at the surface.
TEST(RoundedBuoyancy, AgreesWithTheClippedOutline) {
    forRandomShapes(714, 300, [](const Primitive& shape, support::RandomNumbers& random) {
        const ConvexShape convex = convexShapeOf(shape, {});
        const Transform t = random.pose(2);
        const Vec2 up = random.rotation().xAxis();
        const Vec2 surface = t * (convex.middle + random.point(1.5));
        std::vector<LongPoint> wet;
        const std::vector<LongPoint> outline = fineOutline(convex, t);
        const auto height = [&](LongPoint p) {
            return dot(support::widened(up), p - support::widened(surface));
        };
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const LongPoint p = outline[i];
            const LongPoint q = outline[(i + 1) % outline.size()];
            if (height(p) < 0) {
                wet.push_back(p);
            }
            if ((height(p) < 0) != (height(q) < 0)) {
                wet.push_back(p + (height(p) / (height(p) - height(q))) * (q - p));
            }
        }
        const Moments expected = wet.size() < 3 ? Moments{} : momentsOf(wet);
        const Submerged found = submerged(convex, t, surface, up);
        ASSERT_TRUE(near(found.area, expected.area, byPrecision(2e-5, 1e-5)));
        if (expected.area > 0.01L) {
            ASSERT_TRUE(near(found.centroid, expected.center, byPrecision(3e-4, 1e-5)));
        }
    });
}

TEST(RoundedShape, ContainsWhatTheOracleContains) {
    const ConvexShape dot = convexShapeOf(Point{}, {});
    forRandomShapes(715, 1000, [&](const Primitive& shape, support::RandomNumbers& random) {
        const ConvexShape convex = convexShapeOf(shape, {});
        const Vec2 p = random.point(3);
        const long double gap = support::signedDistance(convex, {}, dot, {p, {}});
        if (std::abs(gap) > static_cast<long double>(byPrecision(4e-6, 1e-14))) {
            ASSERT_EQ(contains(convex, {}, p), gap < 0);
            ASSERT_EQ(std::visit([&](const auto& kind) { return contains(kind, p); }, shape),
                      gap < 0);
        }
    });
}

// The support point is on the edge of the bounds, and nothing is beyond it.
TEST(RoundedShape, SupportAndBoundsTouchTheOutline) {
    forRandomShapes(716, 20, [](const Primitive& shape, support::RandomNumbers& random) {
        const ConvexShape convex = convexShapeOf(shape, {});
        const std::vector<LongPoint> outline = fineOutline(convex, {});
        const Vec2 way = random.rotation().xAxis();
        const auto farthest = [&](Vec2 direction) {
            long double most = -100;
            for (const LongPoint p : outline) {
                most = std::max(most, ::kodo::dot(p, support::widened(direction)));
            }
            return most;
        };
        std::visit(
            [&](const auto& kind) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, Plane>) {
                    const Vec2 support = supportOf(kind, way);
                    EXPECT_TRUE(near(::kodo::dot(support, way), farthest(way), 4 * kShare));
                    for (const Aabb& box : {boundsOf(kind), boundsOf(convex, Transform{})}) {
                        EXPECT_TRUE(near(box.upper.x, farthest({1, 0}), 4 * kShare));
                        EXPECT_TRUE(near(-box.lower.y, farthest({0, -1}), 4 * kShare));
                    }
                }
            },
            shape);
    });
}

/// The primitives themselves, against their convex shapes.
TEST(RoundedRay, OfAPrimitiveAgreesWithItsConvexShape) {
    forRandomShapes(718, 1000, [](const Primitive& shape, support::RandomNumbers& random) {
        const Ray ray{random.point(4), random.point(4)};
        const auto own = std::visit([&](const auto& kind) { return rayCast(kind, ray); }, shape);
        const ConvexShape convex = convexShapeOf(shape, {});
        const auto other = rayCast(convex, {}, ray);
        if (own.has_value() != other.has_value()) { // a tangent
            const ConvexShape line = convexShapeOf(Segment{ray.from, ray.to, false, {}}, {});
            ASSERT_TRUE(near(support::signedDistance(convex, {}, line, {}), 0, 8 * kExact));
        } else if (own) {
            ASSERT_TRUE(
                near(ray.at(own->fraction), ray.at(other->fraction), byPrecision(1e-3, 1e-6)));
        }
    });
}

TEST(RoundedShape, RefusalsNameTheRadius) {
    const auto fieldOf = [](const Shape& shape) {
        const auto problem = check(shape);
        return problem ? problem->field : "";
    };
    for (const Real bad : {Real(-1), support::kNan, support::kInf}) {
        EXPECT_EQ(fieldOf(Capsule{{0, 0}, {1, 0}, bad}), "radius");
        EXPECT_EQ(fieldOf(Box{1, 1, {}, {}, bad}), "radius");
        EXPECT_EQ(fieldOf(Polygon{{{0, 0}, {1, 0}, {0, 1}}, bad}), "radius");
        EXPECT_EQ(fieldOf(Segment{{0, 0}, {1, 0}, false, bad}), "radius");
    }
    EXPECT_EQ(fieldOf(Capsule{{0, 0}, {1, 0}, 0}), "radius");
    EXPECT_EQ(fieldOf(Capsule{{support::kNan, 0}, {1, 0}, 1}), "from");
    EXPECT_EQ(fieldOf(Capsule{{0, 0}, {support::kInf, 0}, 1}), "to");
    EXPECT_EQ(fieldOf(Segment{{0, 0}, {1, 0}, true, 1}), "radius");
    EXPECT_EQ(fieldOf(Capsule{{1, 0}, {1, 0}, 1}), "") << "a disc";
}

} // namespace
} // namespace kodo::rounded_test
