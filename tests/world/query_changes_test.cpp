// SPDX-License-Identifier: MIT
// Queries between changes of a World: the bounds that they search must follow every change.
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>
#include <support/every_shape.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <thread>
#include <vector>

namespace kodo {
namespace {

std::vector<QueryHit> hitsByBruteForce(const World& world, const Ray& ray) {
    std::vector<QueryHit> hits;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            if (const auto hit = rayCast(body.part(i).convex, body.massFrame(), ray)) {
                hits.push_back({id, static_cast<std::uint16_t>(i), hit->fraction, {}, {}});
            }
        }
    }
    std::sort(hits.begin(), hits.end(), [](const QueryHit& a, const QueryHit& b) {
        return std::tie(a.fraction, a.body, a.part) < std::tie(b.fraction, b.body, b.part);
    });
    return hits;
}

std::vector<BodyId> overlapsByBruteForce(const World& world, const Circle& circle, Vec2 at) {
    std::vector<BodyId> found;
    const ConvexShape convex = convexShapeOf(circle, {});
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        bool overlaps = false;
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            overlaps |=
                distance(body.part(i).convex, body.massFrame(), convex, {at, {}}).distance <= 0;
        }
        if (overlaps) {
            found.push_back(id);
        }
    }
    return found;
}

void expectEqual(const std::vector<QueryHit>& found, const std::vector<QueryHit>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].body, expected[i].body);
        ASSERT_EQ(found[i].part, expected[i].part);
        ASSERT_EQ(found[i].fraction, expected[i].fraction);
    }
}

class Changes {
public:
    explicit Changes(std::uint64_t seed) : random_(seed) {
        WorldDef def;
        def.gravity = support::kEarth;
        world_ = World(def);
        world_.add({.shape = Plane{{0, 1}, -10}, .type = BodyType::Static});
        for (int i = 0; i < 30; ++i) {
            add();
        }
        saved_ = world_;
    }

    void change() {
        const std::vector<BodyId> ids = world_.bodies();
        const BodyId any = ids[1 + random_.below(ids.size() - 1)]; // not the plane
        switch (random_.below(11)) {
        case 0:
            return add();
        case 1:
            return ids.size() > 20 ? world_.remove(any) : add();
        case 2:
            return world_[any].setPosition(random_.point(10));
        case 3:
            return world_[any].setRotation(random_.rotation());
        case 4:
            world_.clone(any, random_.point(10));
            return;
        case 5:
            if (any != ids.back()) {
                world_.weld(any, ids.back());
            }
            return;
        case 6:
            if (world_[any].partCount() > 1) {
                world_.unweld(any, random_.below(world_[any].partCount()));
            }
            return;
        case 7: // parts stay where they are, but turn about another centre
            return world_[any].setMass(
                MassDef{1, world_[any].localCenter() + random_.point(0.3), {}});
        case 8:
            if (world_[any].type() == BodyType::Dynamic) {
                world_[any].setAngularVelocity(random_.between(-30, 30));
                world_[any].setVelocity(random_.point(20));
            }
            return;
        case 9:
            return random_.below(2) == 0 ? std::swap(world_, saved_) : void(world_ = saved_);
        default:
            return support::run(world_, 1 + static_cast<int>(random_.below(20)));
        }
    }

    void query() {
        const Ray ray{random_.point(12), random_.point(12)};
        const std::vector<QueryHit> expected = hitsByBruteForce(world_, ray);
        expectEqual(rayCastAll(world_, ray.from, ray.to), expected);
        const auto first = rayCast(world_, ray.from, ray.to);
        ASSERT_EQ(first.has_value(), !expected.empty());
        std::vector<QueryHit> visited;
        visitRay(world_, ray.from, ray.to, [&](const QueryHit& hit) {
            visited.push_back(hit);
            return visited.size() < 2;
        });
        expectEqual(visited, {expected.begin(), expected.begin() + std::min<std::ptrdiff_t>(
                                                                       2, std::ssize(expected))});
        const Circle circle{random_.between(0.1, 3)};
        const Vec2 at = random_.point(12);
        const std::vector<BodyId> overlaps = overlapsByBruteForce(world_, circle, at);
        ASSERT_EQ(overlap(world_, Shape(circle), {at, {}}), overlaps);
        if (!overlaps.empty()) {
            const std::vector<BodyId> others(overlaps.begin() + 1, overlaps.end());
            ASSERT_EQ(overlap(world_, Shape(circle), {at, {}}, {}, {overlaps.data(), 1}), others);
            std::vector<BodyId> seen;
            visitOverlaps(world_, Shape(circle), {at, {}}, [&](BodyId id) {
                seen.push_back(id);
                return false;
            });
            ASSERT_EQ(seen, std::vector<BodyId>{overlaps.front()});
        }
        if (first) {
            const BodyId gone = first->body;
            const auto second = rayCast(world_, ray.from, ray.to, {}, {&gone, 1});
            const auto next = std::find_if(expected.begin(), expected.end(),
                                           [&](const QueryHit& hit) { return hit.body != gone; });
            ASSERT_EQ(second.has_value(), next != expected.end());
            ASSERT_TRUE(!second || (second->body == next->body && second->part == next->part));
        }
    }

private:
    void add() {
        BodyDef def;
        def.shape = Compound{{support::randomPrimitive(random_, support::Kind::Box),
                              support::randomPrimitive(random_, support::Kind::Polygon)}};
        def.position = random_.point(10);
        def.velocity = random_.point(20);
        def.type = random_.below(3) == 0 ? BodyType::Static : BodyType::Dynamic;
        if (def.type == BodyType::Static) {
            def.velocity = {};
        }
        world_.add(def);
    }

    support::RandomNumbers random_;
    World world_;
    World saved_;
};

TEST(QueriesAfterChanges, AgreeWithBruteForce) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Changes changes(seed);
        for (int i = 0; i < 150; ++i) {
            changes.change();
            if (i % 3 == 0) {
                changes.query();
                ASSERT_FALSE(testing::Test::HasFatalFailure());
            }
        }
    }
}

// The first query after a step updates the bounds, on whatever thread it runs.
TEST(QueriesAfterChanges, MayRunOnSeveralThreadsAtOnce) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    for (int i = 0; i < 200; ++i) {
        world.add(support::ballDef({static_cast<Real>(i % 20) - 10, static_cast<Real>(i / 20) + 1},
                                   Real(0.3)));
    }
    for (int step = 0; step < 20; ++step) {
        support::run(world, 1);
        std::vector<std::vector<QueryHit>> found(4);
        std::vector<std::thread> threads;
        for (std::vector<QueryHit>& hits : found) {
            threads.emplace_back([&] {
                hits = rayCastAll(std::as_const(world), {-12, 1}, {12, 4});
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        const std::vector<QueryHit> expected = hitsByBruteForce(world, {{-12, 1}, {12, 4}});
        for (const std::vector<QueryHit>& hits : found) {
            expectEqual(hits, expected);
        }
    }
}

// A new body in the slot of one that was removed: a query had seen it at rest.
TEST(Queries, ABodyThatStartsInTheSlotOfARemovedOneMeetsTheGround) {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = Box{20, 1}, .type = BodyType::Static});
    const BodyId former = world.add({.shape = Circle{Real(0.5)}, .position = {0, 5}});
    world.step(Real(1) / 60);
    world.remove(former);
    const BodyId ball =
        world.add({.shape = Circle{Real(0.5)}, .position = {3, 2}, .type = BodyType::Kinematic});
    EXPECT_EQ(ball.index, former.index);
    EXPECT_TRUE(rayCast(world, {3, 4}, {0, -8}));
    world[ball].setType(BodyType::Dynamic);
    for (int i = 0; i < 120; ++i) {
        world.step(Real(1) / 60);
    }
    EXPECT_NEAR(world[ball].position().y, Real(1), Real(0.02));
}

} // namespace
} // namespace kodo
