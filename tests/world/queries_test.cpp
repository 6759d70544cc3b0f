// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace kodo {
namespace {

using support::near;

constexpr Flags kRed = 1;
constexpr Flags kBlue = 2;
constexpr CollisionFilter kRedOnly{kMatchAny, kRed};

/// 60 bodies with every kind of shape, some of them compounds, some disabled.
World crowd(std::uint64_t seed) {
    support::RandomNumbers random(seed);
    World world;
    for (int i = 0; i < 60; ++i) {
        BodyDef def;
        const support::AnyKind kind =
            support::kEveryKind[random.below(std::size(support::kEveryKind))];
        const Primitive primitive = support::randomPrimitive(random, kind);
        if (i % 5 == 0) {
            def.shape = Compound{{primitive, support::randomPrimitive(random, support::Kind::Box)}};
        } else {
            def.shape = Compound{{primitive}};
        }
        def.position = random.point(12);
        def.rotation = random.rotation();
        def.type = BodyType::Static;
        def.flags = (i % 2 == 0 ? kRed : kBlue) | (i % 7 == 0 ? kDisabled : 0);
        if (kind != support::AnyKind::Plane || i % 9 == 0) { // few planes, since they are infinite
            world.add(def);
        }
    }
    return world;
}

/// Visits every part of every body that a query may return.
template <typename Visit>
void forAsked(const World& world, CollisionFilter which, Visit visit) {
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        if ((body.flags() & kDisabled) == 0 && accepts(which, body.flags())) {
            for (std::size_t i = 0; i < body.partCount(); ++i) {
                visit(body, i);
            }
        }
    }
}

// Brute force tests all parts of all bodies, without bounds.
TEST(Queries, RayCastAllAgreesWithBruteForce) {
    support::RandomNumbers random(181);
    std::size_t hits = 0;
    for (int k = 0; k < 20; ++k) {
        const World world = crowd(static_cast<std::uint64_t>(k));
        for (int i = 0; i < 50; ++i) {
            const Vec2 from = random.point(15);
            const Vec2 to = random.point(15);
            const CollisionFilter which = i % 2 == 0 ? CollisionFilter{} : kRedOnly;
            std::vector<QueryHit> expected;
            forAsked(world, which, [&](const BodyView& body, std::size_t part) {
                const auto hit = rayCast(body.part(part).convex, body.massFrame(), Ray{from, to});
                if (hit) {
                    expected.push_back(
                        {body.id(), static_cast<std::uint16_t>(part), hit->fraction, {}, {}});
                }
            });
            std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
                return std::tie(a.fraction, a.body, a.part) < std::tie(b.fraction, b.body, b.part);
            });
            const std::vector<QueryHit> found = rayCastAll(world, from, to, which);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t n = 0; n < found.size(); ++n) {
                ASSERT_EQ(found[n].body, expected[n].body);
                ASSERT_EQ(found[n].part, expected[n].part);
                ASSERT_EQ(found[n].fraction, expected[n].fraction);
            }
            const auto first = rayCast(world, from, to, which);
            ASSERT_EQ(first.has_value(), !found.empty());
            ASSERT_TRUE(!first || (first->body == found[0].body && first->part == found[0].part));
            hits += found.size();
        }
    }
    EXPECT_GT(hits, 1000u);
}

TEST(Queries, ShapeCastAgreesWithBruteForce) {
    support::RandomNumbers random(182);
    int hits = 0;
    for (int k = 0; k < 20; ++k) {
        const World world = crowd(static_cast<std::uint64_t>(k));
        for (int i = 0; i < 50; ++i) {
            const Primitive primitive =
                support::randomPrimitive(random, support::kTwoSidedKinds[random.below(5)]);
            const Transform start = random.pose(15);
            const Vec2 move = random.point(20);
            const ConvexShape moving = convexShapeOf(primitive, {});
            std::optional<std::tuple<Real, BodyId, std::uint16_t>> best;
            forAsked(world, {}, [&](const BodyView& body, std::size_t part) {
                const auto hit =
                    shapeCast(moving, start, move, body.part(part).convex, body.massFrame());
                if (hit) {
                    const std::tuple now(hit->fraction, body.id(),
                                         static_cast<std::uint16_t>(part));
                    best = best ? std::min(*best, now) : now;
                }
            });
            const auto found = shapeCast(world, Shape(Compound{{primitive}}), start, move);
            ASSERT_EQ(found.has_value(), best.has_value());
            if (found) {
                ASSERT_EQ(std::tuple(found->fraction, found->body, found->part), *best);
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 300);
}

TEST(Queries, OverlapAgreesWithBruteForce) {
    support::RandomNumbers random(183);
    std::size_t count = 0;
    for (int k = 0; k < 20; ++k) {
        const World world = crowd(static_cast<std::uint64_t>(k));
        for (int i = 0; i < 50; ++i) {
            const Transform at = random.pose(12);
            const support::AnyKind kind =
                support::kEveryKind[static_cast<std::size_t>(i) % std::size(support::kEveryKind)];
            const Compound shape{{support::randomPrimitive(random, kind),
                                  support::randomPrimitive(random, support::Kind::Polygon)}};
            std::vector<BodyId> expected;
            forAsked(world, kRedOnly, [&](const BodyView& body, std::size_t part) {
                for (const Primitive& primitive : shape.parts) {
                    const ConvexShape convex = convexShapeOf(primitive, {});
                    if (distance(body.part(part).convex, body.massFrame(), convex, at).distance <=
                            0 &&
                        (expected.empty() || expected.back() != body.id())) {
                        expected.push_back(body.id());
                    }
                }
            });
            ASSERT_EQ(overlap(world, Shape(shape), at, kRedOnly), expected);
            count += expected.size();
        }
    }
    EXPECT_GT(count, 500u);
}

TEST(Queries, OverlapWithABoxTestsShapesNotBounds) {
    World world;
    const BodyId ball = world.add({.shape = Circle{1}});
    const BodyId box = world.add({.shape = Box{2, 2}, .position = {4, 0}});
    EXPECT_EQ(overlap(world, Aabb{{Real(0.9), Real(0.9)}, {3, 3}}), (std::vector<BodyId>{box}))
        << "the corner of the ball's bounds is empty; touching the box counts";
    EXPECT_EQ(overlap(world, Aabb{{-5, -5}, {5, 5}}), (std::vector<BodyId>{ball, box}));
    EXPECT_EQ(overlap(world, Aabb{{0, 0}, {0, 0}}), (std::vector<BodyId>{ball})) << "a point";
    EXPECT_EQ(overlap(world, Aabb{{0, 0}, {9, 0}}), (std::vector<BodyId>{ball, box})) << "a line";
}

TEST(Queries, ClosestPointAgreesWithBruteForce) {
    support::RandomNumbers random(184);
    int found = 0;
    for (int k = 0; k < 20; ++k) {
        const World world = crowd(static_cast<std::uint64_t>(k));
        for (int i = 0; i < 50; ++i) {
            const Vec2 point = random.point(15);
            const Real most = random.between(0, 4);
            std::optional<QueryPoint> best;
            forAsked(world, {}, [&](const BodyView& body, std::size_t part) {
                const ClosestPoints near =
                    distance(body.part(part).convex, body.massFrame(), point);
                if (near.distance <= most && (!best || near.distance < best->distance)) {
                    best = {body.id(), static_cast<std::uint16_t>(part), near.onA, near.normal,
                            near.distance};
                }
            });
            const auto answer = closestPoint(world, point, most);
            ASSERT_EQ(answer.has_value(), best.has_value());
            if (answer) {
                ASSERT_EQ(answer->body, best->body);
                ASSERT_EQ(answer->part, best->part);
                ASSERT_EQ(answer->distance, best->distance);
                ASSERT_TRUE(near(answer->point + answer->distance * answer->normal, point,
                                 support::byPrecision(1e-5, 1e-14)));
                ++found;
            }
        }
    }
    EXPECT_GT(found, 500);
}

// Two equal bodies at one position.
TEST(Queries, TiesGoToTheLowerId) {
    World world;
    const BodyId first = world.add({.shape = Box{2, 2}});
    const BodyId second = world.add({.shape = Box{2, 2}});
    EXPECT_EQ(rayCast(world, {-5, 0}, {5, 0})->body, first);
    const std::vector<QueryHit> all = rayCastAll(world, {-5, 0}, {5, 0});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1].body, second);
    EXPECT_EQ(shapeCast(world, Circle{1}, {{-5, 0}, {}}, {9, 0})->body, first);
    EXPECT_EQ(closestPoint(world, {3, 0}, 5)->body, first);
}

TEST(Queries, WorkOnACopyAndChangeNothing) {
    const World world = crowd(7);
    const World copy = world;
    const std::uint64_t before = world.stateHash();
    const auto here = rayCastAll(world, {-15, -3}, {15, 4});
    const auto there = rayCastAll(copy, {-15, -3}, {15, 4});
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(here[i].body, there[i].body);
        EXPECT_EQ(here[i].fraction, there[i].fraction);
    }
    EXPECT_EQ(world.stateHash(), before);
}

// D2: each bad value is refused with a sentence that names it.
TEST(Queries, RefuseInvalidValues) {
    const World world = crowd(8);
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real infinity = std::numeric_limits<Real>::infinity();
    EXPECT_THROW(shapeCast(world, Circle{-1}, {}, {1, 0}), BadDefinition);
    EXPECT_THROW(overlap(world, Shape(Polygon{}), {}), BadDefinition);
    for (const Real bad : {nan, infinity, -infinity}) {
        EXPECT_THROW(rayCast(world, {bad, 0}, {1, 0}), BadDefinition);
        EXPECT_THROW(rayCastAll(world, {0, 0}, {1, bad}), BadDefinition);
        EXPECT_THROW(visitRay(world, {0, bad}, {1, 0}, [](auto) { return true; }), BadDefinition);
        EXPECT_THROW(shapeCast(world, Circle{1}, {{bad, 0}, {}}, {1, 0}), BadDefinition);
        EXPECT_THROW(shapeCast(world, Circle{1}, {}, {1, bad}), BadDefinition);
        EXPECT_THROW(overlap(world, Aabb{{bad, 0}, {1, 1}}), BadDefinition);
        EXPECT_THROW(overlap(world, Shape(Circle{1}), {{bad, 0}, {}}), BadDefinition);
        EXPECT_THROW(closestPoint(world, {0, bad}, 100), BadDefinition);
    }
    EXPECT_THROW(rayCast(world, {1, 2}, {1, 2}), BadDefinition);
    EXPECT_THROW(overlap(world, Aabb{{1, 0}, {0, 1}}), BadDefinition);
    EXPECT_THROW(overlap(world, Shape(Circle{1}), {{}, {2, 0}}), BadDefinition);
    EXPECT_THROW(closestPoint(world, {0, 0}, nan), BadDefinition);
    EXPECT_THROW(closestPoint(world, {0, 0}, -1), BadDefinition);
    EXPECT_TRUE(closestPoint(world, {0, 0}, infinity));
    EXPECT_NO_THROW(shapeCast(world, Circle{1}, {}, {0, 0})); // a hero that stands still
}

// Lines that move along each other meet at their ends, which no side of theirs tells. Along an
// axis: elsewhere rounding decides whether they are on one line.
TEST(Queries, ALineThatIsCastAlongAnotherMeetsItsEnd) {
    for (const Vec2 along : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        SCOPED_TRACE(testing::Message() << along.x << ", " << along.y);
        World world;
        world.add({.shape = Segment{{0, 0}, along}, .type = BodyType::Static});
        const Segment line{Real(-0.5) * along, Real(0.5) * along};
        const auto castFrom = [&](Real behind, Real beside, Real way) {
            return shapeCast(world, line, {-behind * along + beside * perp(along), {}},
                             way * along);
        };
        const auto ahead = castFrom(3, 0, 5);
        ASSERT_TRUE(ahead);
        EXPECT_NEAR(ahead->fraction, 0.5, 1e-5);
        EXPECT_FALSE(castFrom(3, 0, 2)) << "too short";
        EXPECT_FALSE(castFrom(3, 0, -5)) << "away";
        EXPECT_FALSE(castFrom(3, Real(0.1), 5)) << "beside it";
    }
}

// A torque turns a rod within the step, which its velocity before did not tell.
TEST(Queries, FindABodyThatATorqueHasTurnedInTheStep) {
    for (const Features leaveOut : {Features{}, Features{Feature::ContinuousCollision}}) {
        for (const Real angle : {Real(0.05), Real(0.3), Real(1), Real(2)}) { // rad in the step
            StepSettings settings;
            settings.leaveOut = leaveOut;
            World world({.settings = settings});
            const BodyId rod = world.add({.shape = Box{4, Real(0.1)}});
            world.step(Real(1) / 60);
            world[rod].applyTorque(angle * 3600 * world[rod].inertia());
            world.step(Real(1) / 60);
            EXPECT_GT(world[rod].rotation().angle(), angle / 3);
            for (const Real end : {Real(-1.99), Real(1.99)}) {
                const Vec2 tip = world[rod].transform() * Vec2{end, 0};
                EXPECT_EQ(overlap(world, Point{}, {tip, {}}), std::vector{rod}) << angle;
                EXPECT_TRUE(rayCast(world, tip, tip + Vec2{0, Real(0.01)})) << angle;
            }
        }
    }
}

// One-sided ground is hit from its front only.
TEST(Queries, HitGroundFromAboveOnly) {
    World world;
    const BodyId ground =
        world.add({.shape = Heightmap{{-2, 0}, 1, {0, 0, 1, 0, 0}}, .type = BodyType::Static});
    const auto down = rayCast(world, {Real(0.5), 3}, {Real(0.5), -3});
    ASSERT_TRUE(down);
    EXPECT_EQ(down->body, ground);
    EXPECT_EQ(down->part, 2);
    EXPECT_TRUE(near(down->point, Vec2{Real(0.5), Real(0.5)}, 8 * support::kEpsilon));
    EXPECT_FALSE(rayCast(world, {Real(0.5), -3}, {Real(0.5), 3})) << "from behind";
    EXPECT_EQ(shapeCast(world, Circle{Real(0.5)}, {{0, 4}, {}}, {0, -5})->fraction, Real(0.5));
}

} // namespace
} // namespace kodo
