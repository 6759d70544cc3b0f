// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kEpsilon;
using support::near;
using support::nearShare;
using support::Totals;
using support::totalsOf;

// R5: two unit squares side by side make one 2 x 1 box.
TEST(Weld, TwoSquaresMakeABox) {
    World world;
    const BodyId left = world.add(boxDef({0, 0}, 1, 1));
    const BodyId right = world.add(boxDef({1, 0}, 1, 1));
    EXPECT_EQ(world.weld(left, right), 1u);
    EXPECT_FALSE(world.contains(right));
    EXPECT_EQ(world.bodyCount(), 1u);
    EXPECT_EQ(world[left].partCount(), 2u);
    EXPECT_EQ(world[left].mass(), 2);
    EXPECT_EQ(world[left].area(), 2);
    EXPECT_EQ(world[left].center(), (Vec2{Real(0.5), 0}));
    EXPECT_EQ(world[left].position(), (Vec2{0, 0})); // the frame does not move
    EXPECT_TRUE(near(world[left].inertia(), 2.0L * 5 / 12, 4 * kEpsilon));
    EXPECT_EQ(world[left].bounds(), (Aabb{{Real(-0.5), Real(-0.5)}, {Real(1.5), Real(0.5)}}));
}

BodyDef randomDef(support::RandomNumbers& random) {
    BodyDef def;
    const Real size = random.between(0.3, 1.5);
    switch (random.below(6)) {
    case 0:
        def.shape = Circle{size, random.point(0.5)};
        break;
    case 1:
        def.shape = Box{size, 2 * size, random.point(0.5), random.rotation()};
        break;
    case 2:
        def.shape = Polygon{{{0, 0}, {size, 0}, {0, size}}};
        break;
    case 3:
        def.shape = Point{random.point(0.5)};
        break;
    case 4:
        def.shape = Segment{random.point(0.5), {size, 1}};
        break;
    default:
        def.shape = Compound{{Circle{size}, Box{1, size, {1, 0}}}};
    }
    def.position = random.point(3);
    def.rotation = random.rotation();
    def.velocity = random.point(5);
    def.angularVelocity = random.between(-5, 5);
    def.density = random.between(0.5, 2);
    return def;
}

// R5: welding random moving pairs conserves mass, centre, momentum and angular momentum. Values of
// up to 100, about twenty roundings.
TEST(Weld, KeepsMassAndBothMomenta) {
    constexpr std::uint64_t kSeed = 131;
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < 500; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        World world;
        const BodyId a = world.add(randomDef(random));
        const BodyId b = world.add(randomDef(random));
        const Totals before = totalsOf(world);
        const auto massA = static_cast<long double>(world[a].mass());
        const auto massB = static_cast<long double>(world[b].mass());
        const Vec2 toB = world[b].center() - world[a].center();
        const auto share = static_cast<Real>(massB / (massA + massB));
        const Vec2 center = world[a].center() + share * toB;
        const long double inertia =
            static_cast<long double>(world[a].inertia()) +
            static_cast<long double>(world[b].inertia()) +
            massA * massB / (massA + massB) * static_cast<long double>(lengthSquared(toB));
        world.weld(a, b);
        const Totals after = totalsOf(world);
        const Real tolerance = byPrecision(2e-4, 1e-12);
        ASSERT_TRUE(nearShare(world[a].mass(), massA + massB, 10 * kEpsilon));
        ASSERT_TRUE(nearShare(world[a].inertia(), inertia, 100 * kEpsilon));
        ASSERT_TRUE(near(world[a].center(), center, 50 * kEpsilon));
        ASSERT_TRUE(near(after.momentum, before.momentum, tolerance));
        ASSERT_TRUE(near(after.spin, before.spin, tolerance));
        ASSERT_LE(after.kinetic, before.kinetic * (1 + static_cast<long double>(tolerance)));
    }
}

// R5: a particle has no moment of inertia, but the welded body has. It takes over the angular
// momentum of the pair, unless kLockRotate is set.
TEST(Weld, OntoAParticleKeepsTheAngularMomentumOfThePair) {
    for (const bool locked : {false, true}) {
        World world;
        BodyDef particle{.shape = Point{}, .flags = locked ? kLockRotate : 0};
        const BodyId id = world.add(particle);
        BodyDef box = boxDef({2, 0}, 1, 1);
        box.velocity = {0, 3};
        box.angularVelocity = 6;
        world.weld(id, world.add(box)); // both of 1 kg
        EXPECT_EQ(world[id].velocity(), (Vec2{0, Real(1.5)}));
        // About the common centre: I w of the box and 1 kg at 1 m and 3 m/s, over the total I.
        const long double spin = (1.0L / 6 * 6 + 3) / (1.0L / 6 + 2);
        EXPECT_TRUE(near(world[id].angularVelocity(), locked ? 0 : spin, 8 * kEpsilon));
    }
}

// R5: every corner of the welded part keeps its world position.
TEST(Weld, ThePartKeepsItsWorldPose) {
    constexpr std::uint64_t kSeed = 132;
    support::RandomNumbers random(kSeed);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", pair " << i);
        World world;
        const BodyId target = world.add(randomDef(random));
        BodyDef arrow = boxDef(random.point(3), 2, Real(0.1));
        arrow.rotation = random.rotation();
        const BodyId id = world.add(arrow);
        std::vector<Vec2> before;
        for (const Vec2 vertex : world[id].part(0).convex.vertices) {
            before.push_back(world[id].massFrame() * vertex);
        }
        const std::size_t part = world.weld(target, id);
        const ConvexShape& welded = world[target].part(part).convex;
        ASSERT_EQ(welded.vertices.size(), before.size());
        for (std::size_t k = 0; k < before.size(); ++k) {
            ASSERT_TRUE(
                near(world[target].massFrame() * welded.vertices[k], before[k], 60 * kEpsilon));
        }
    }
}

// R5: a kinematic body stays kinematic and keeps its velocity; the part moves with it.
TEST(Weld, OntoAKinematicBodyKeepsItsVelocity) {
    World world({.gravity = support::kEarth});
    BodyDef paddle = boxDef({0, 0}, 4, 1);
    paddle.type = BodyType::Kinematic;
    paddle.velocity = {2, 0};
    const BodyId id = world.add(paddle);
    BodyDef part = boxDef({3, 1}, 1, 1);
    part.velocity = {0, -7};
    world.weld(id, world.add(part));
    EXPECT_EQ(world[id].velocity(), (Vec2{2, 0}));
    EXPECT_TRUE(near(world[id].position(), Vec2{0, 0}, kEpsilon));
    support::run(world, 60);
    EXPECT_TRUE(near(world[id].position(), Vec2{2, 0}, byPrecision(2e-5, 1e-13)));
    EXPECT_TRUE(near(world[id].mass(), 5, kEpsilon)); // a kinematic body reports its mass
}

// The centre of mass shifts within a rotating kinematic body, but its points keep their velocities.
TEST(Weld, OntoARotatingKinematicBodyKeepsTheVelocityOfEveryPoint) {
    World world;
    BodyDef wheel = ballDef({0, 0}, 2);
    wheel.type = BodyType::Kinematic;
    wheel.angularVelocity = 1;
    const BodyId id = world.add(wheel);
    const Vec2 before = world[id].velocityAt({0, 2});
    world.weld(id, world.add(boxDef({3, 0}, 2, 2)));
    EXPECT_TRUE(near(world[id].velocityAt({0, 2}), before, 10 * kEpsilon));
    EXPECT_TRUE(near(world[id].velocityAt({0, 0}), Vec2{}, 10 * kEpsilon));
}

// The records of the last step stay readable. A body on the welded part then lies on the joined
// body.
TEST(Weld, ABodyOnThePartLiesOnTheJoinedBody) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const BodyId left = world.add(boxDef({0, Real(0.5)}, 1, 1));
    const BodyId right = world.add(boxDef({1, Real(0.5)}, 1, 1));
    BodyDef small = boxDef({1, Real(1.25)}, Real(0.5), Real(0.5));
    small.flags = kNeverSleep; // a sleeping body has no records
    const BodyId rider = world.add(small);
    support::run(world, 20);
    const CollisionRecord record = *support::recordOf(world, right, rider);
    world.weld(left, right);
    EXPECT_EQ(world.collisions().size(), 4u); // two with the floor, one between the boxes, one of
                                              // the rider
    EXPECT_EQ(support::recordOf(world, right, rider)->maxImpulse, record.maxImpulse);
    support::run(world, 60);
    ASSERT_NE(support::recordOf(world, left, rider), nullptr);
    EXPECT_TRUE(near(world[rider].position(), Vec2{1, Real(1.25)}, Real(0.01)));
}

// R5: a row of welds conserves momentum and angular momentum.
TEST(Weld, AHundredPartsKeepBothMomenta) {
    support::RandomNumbers random(133);
    World world;
    const BodyId core = world.add(ballDef({}, 1));
    for (int i = 0; i < 100; ++i) {
        world.add(randomDef(random));
    }
    const Totals before = totalsOf(world);
    for (const BodyId id : world.bodies()) {
        if (id != core) {
            world.weld(core, id);
        }
    }
    const Totals after = totalsOf(world);
    EXPECT_EQ(world.bodyCount(), 1u);
    // A hundred sums of up to 1000.
    EXPECT_TRUE(near(after.momentum, before.momentum, byPrecision(5e-3, 1e-11)));
    EXPECT_TRUE(near(after.spin, before.spin, byPrecision(2e-2, 1e-11)));
}

// Otherwise its snapshot could not be read.
TEST(Weld, IsRefusedIfAPartOrAJointWouldBeTooFarFromTheBody) {
    World world;
    const Real most = kMaxCoordinate;
    const BodyId body = world.add({});
    const BodyId far = world.add({.position = {-most, 0}});
    const BodyId farther = world.add({.position = {most, 0}});
    const BodyId near = world.add({.position = {10, 0}});
    world.add(RevoluteJoint{.ends = {.a = near, .b = far, .anchorA = {most - 5, 0}}});
    const std::uint64_t before = world.stateHash();
    EXPECT_THROW(world.weld(far, farther), BadDefinition);
    EXPECT_THROW(world.weld(body, near), BadDefinition);
    EXPECT_EQ(world.stateHash(), before);
    world[near].setPosition({5, 0});
    EXPECT_NO_THROW(world.weld(body, near));
    EXPECT_EQ(fromBytes(toBytes(world)).stateHash(), world.stateHash());
}

// The corners of a tiny part coincide by rounding in the frame of a distant body. Such a weld gave
// NaN poses, or a World whose bytes were refused.
TEST(Weld, IsRefusedIfAPartIsTooSmallForItsDistance) {
    int refused = 0;
    for (const Real distance : {Real(10), Real(1000), Real(60000)}) {
        for (const Real share : {byPrecision(1e-8, 1e-17), byPrecision(1e-7, 1e-16), Real(1e-3)}) {
            for (int angle = 0; angle < 12; ++angle) {
                const Real size = share * distance;
                const Shape shapes[] = {Polygon{{{0, 0}, {size, 0}, {0, size}}},
                                        Segment{.from = {0, 0}, .to = {size, 0}}};
                for (const Shape& shape : shapes) {
                    World world;
                    const BodyId body = world.add({});
                    BodyDef def{.shape = shape, .position = {distance, distance / 3}};
                    def.rotation = Rot::fromAngle(static_cast<Real>(angle) / 2);
                    def.mass = MassDef{.mass = 1};
                    if (check(def)) {
                        continue; // too small by itself
                    }
                    const BodyId part = world.add(def);
                    try {
                        world.weld(body, part);
                        EXPECT_TRUE(std::isfinite(world[body].position().x));
                        EXPECT_EQ(fromBytes(toBytes(world)).stateHash(), world.stateHash());
                    } catch (const BadDefinition&) {
                        ++refused;
                        EXPECT_TRUE(world.contains(part));
                    }
                }
            }
        }
    }
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace kodo
