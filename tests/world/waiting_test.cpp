// SPDX-License-Identifier: MIT
#include <support/phase_book.hpp>

namespace kodo {
namespace {

using support::addFloor;
using support::ballDef;
using support::boxDef;
using support::kDt;
using support::near;
using support::run;

bool waits(const World& world, BodyId id) {
    return (world[id].flags() & kOutside) != 0;
}

/// Pose and motion, to be compared bit by bit.
struct State {
    Vec2 center;
    Rot rotation;
    Vec2 velocity;
    Real spin;
    friend bool operator==(const State&, const State&) = default;
};
State stateOf(const World& world, BodyId id) {
    const BodyView body = world[id];
    return {body.center(), body.rotation(), body.velocity(), body.angularVelocity()};
}

// What waits is like a wall to what is inside: it is not pushed, and it lets nothing through.
TEST(Waiting, IsAWallToWhatIsInside) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const BodyId tower = world.add(boxDef({0, Real(2.5)}, 1, 5));
    BodyDef def = boxDef({0, 8}, 1, 1);
    def.velocity = {0, -5};
    const BodyId falling = world.add(def);
    BodyDef ball = ballDef({6, 6}, Real(0.25));
    ball.velocity = {-8, 0};
    const BodyId thrown = world.add(ball);
    world.setRegion(Aabb{{-10, Real(5.2)}, {10, 20}});
    ASSERT_TRUE(waits(world, tower));
    run(world, 120);
    EXPECT_EQ(stateOf(world, tower), (State{{0, Real(2.5)}, {}, {}, 0}));
    EXPECT_TRUE(near(world[falling].position(), Vec2{0, Real(5.5)}, Real(0.02)));
    EXPECT_FALSE(waits(world, falling));
    EXPECT_LT(world[thrown].position().y, Real(5.2)); // fell out of it
}

// While a region wanders over a heap, every Begin is still followed by one End, and nothing falls
// through what waits.
TEST(Waiting, PhasesStayPairedWhileTheRegionWanders) {
    for (std::uint64_t seed = 191; seed < 195; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        support::RandomNumbers random(seed);
        World world({.gravity = support::kEarth});
        support::addHeap(world, seed, 40);
        support::PhaseBook book;
        for (int step = 0; step < 600; ++step) {
            if (step % 20 == 0) {
                const Vec2 corner{random.between(-6, 4), random.between(-1, 6)};
                world.setRegion(Aabb{corner, corner + Vec2{4, 4}});
            }
            world.step(kDt);
            book.read(world);
            ASSERT_FALSE(HasFailure()) << "step " << step;
        }
        world.setRegion(std::nullopt);
        for (int step = 0; step < 600; ++step) {
            world.step(kDt);
            book.read(world);
            ASSERT_FALSE(HasFailure()) << "step " << step << " of the rest";
        }
        for (const BodyId id : world.bodies()) {
            ASSERT_GT(world[id].position().y, Real(-0.51)); // the floor itself lies there
        }
    }
}

} // namespace
} // namespace kodo
