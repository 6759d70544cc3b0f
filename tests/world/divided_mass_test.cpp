// SPDX-License-Identifier: MIT
// X3: what unweld(), weld() and copyFrom() make of a set mass, of its centre and its inertia.
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include <cmath>
#include <string>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;
using support::Totals;
using support::totalsOf;

/// Set masses of a body of several parts: centres off those of the shapes, small and large inertia.
std::vector<MassDef> setMasses() {
    std::vector<MassDef> masses;
    for (const Vec2 center :
         {Vec2{}, Vec2{Real(0.25), Real(-0.5)}, Vec2{Real(-1.5), 0}, Vec2{0, 6}}) {
        for (const Real share : {Real(0.02), Real(0.2), Real(1), Real(40)}) {
            const Real rim = length(center) + 3; // m, at least that of the shapes below
            masses.push_back({.mass = 20, .center = center, .inertia = 20 * share * rim * rim});
        }
    }
    return masses;
}

std::vector<Compound> compounds() {
    return {{{Box{1, 1, {-1, 0}}, Box{1, 3, {1, 0}}}},
            {{Box{1, 1, {-1, 0}}, Point{{1, Real(0.5)}}, Circle{Real(0.5), {0, 1}}}},
            {{Point{{-1, 0}}, Point{{1, 0}}}},
            {{Segment{{-2, 0}, {0, 0}}, Segment{{0, 0}, {1, 1}}}}};
}

BodyDef spinning(const Compound& shape, const MassDef& mass) {
    return {.shape = shape,
            .position = {2, -1},
            .rotation = Rot::fromAngle(Real(0.4)),
            .velocity = {8, -5},
            .angularVelocity = 3,
            .mass = mass};
}

void expectSameTotals(const Totals& before, const Totals& after) {
    const auto size = static_cast<long double>(byPrecision(2e-5, 1e-13));
    const long double momentum = length(before.momentum) * size;
    EXPECT_LT(length(after.momentum - before.momentum), momentum);
    // About the origin; the scale is that of the spin of all shapes here.
    EXPECT_TRUE(near(after.spin, before.spin, 50 * momentum));
    EXPECT_LT(after.kinetic, before.kinetic * (1 + 4 * size));
}

// Momentum and angular momentum stay, and no energy is gained, wherever the centre was set. Before,
// the parts had the centres and moments of inertia of their shapes, and the momenta changed.
TEST(DividedMass, AnUnweldKeepsBothMomenta) {
    for (const Compound& shape : compounds()) {
        for (const MassDef& mass : setMasses()) {
            World world;
            const BodyId whole = world.add(spinning(shape, mass));
            while (world[whole].partCount() > 1) {
                SCOPED_TRACE(testing::Message()
                             << shape.parts.size() << " parts, center " << mass.center->x << ' '
                             << mass.center->y << ", inertia " << *mass.inertia);
                const Totals before = totalsOf(world);
                world.unweld(whole, 1);
                expectSameTotals(before, totalsOf(world));
            }
            World loaded = fromBytes(toBytes(world));
            EXPECT_EQ(loaded.stateHash(), world.stateHash());
            for (const BodyId id : world.bodies()) { // a setter accepts what was divided
                const BodyView body = world[id];
                if (body.inertia() > 0) {
                    EXPECT_NO_THROW(
                        loaded[id].setMass({body.mass(), body.localCenter(), body.inertia()}));
                }
                EXPECT_NO_THROW(loaded[id].copyFrom(body));
            }
        }
    }
}

// Parts of a group that was welded at an angle: rounding of its centre is no shift, so a Point
// stays a particle.
TEST(DividedMass, APointStaysAParticle) {
    for (int i = 0; i < 50; ++i) {
        World world;
        const BodyId into = world.add({});
        const BodyId group = world.add({.shape = Compound{{Point{{Real(0.3), 7}}, Circle{1}}},
                                        .position = {Real(-41.3), Real(12.7)},
                                        .rotation = Rot::fromAngle(Real(0.1) * Real(i)),
                                        .mass = MassDef{3}});
        world.weld(into, group);
        const BodyId point = world.unweld(into, 1);
        EXPECT_EQ(world[point].inertia(), 0);
        EXPECT_TRUE(nearShare(world[point].mass(), 3 / (1 + std::acos(-1.0L)), Real(1e-5)));
    }
}

// A locked part keeps the spin of the whole, as without a set mass.
TEST(DividedMass, ALockedPartKeepsTheSpin) {
    World world;
    const MassDef mass{.mass = 9, .center = Vec2{0, Real(0.5)}, .inertia = Real(0.5)};
    const BodyId whole = world.add(spinning(compounds()[0], mass));
    const BodyId part = world.unweld(whole, 0, kLockRotate);
    EXPECT_EQ(world[whole].angularVelocity(), 3);
    EXPECT_EQ(world[part].angularVelocity(), 3);
}

std::string fieldOf(const std::function<void()>& call) {
    try {
        call();
        return "accepted";
    } catch (const BadDefinition& bad) {
        EXPECT_FALSE(bad.problem().reason.empty());
        return bad.problem().field;
    }
}

// A particle has no lever arm: a centre beside its point needs a moment of inertia.
TEST(DividedMass, ACentreBesideAParticleIsRefused) {
    World world;
    const Vec2 at{1, 2};
    const BodyId point = world.add({.shape = Point{at}});
    EXPECT_EQ(fieldOf([&] { world[point].setMass({.mass = 1, .center = Vec2{}}); }), "mass.center");
    EXPECT_EQ(fieldOf([&] {
                  world.add({.shape = Point{at}, .mass = MassDef{.mass = 1, .center = Vec2{}}});
              }),
              "mass.center");
    EXPECT_NO_THROW(world[point].setMass({.mass = 1, .center = at}));
    EXPECT_NO_THROW(world[point].setMass({.mass = 1, .center = Vec2{}, .inertia = 5}));
    EXPECT_EQ(world[point].localCenter(), Vec2{});
}

TEST(DividedMass, OfAPlaneIsRefusedByEachSetter) {
    World world;
    const BodyId ground = world.add({.shape = Plane{}, .type = BodyType::Static});
    EXPECT_EQ(fieldOf([&] { world[ground].setMassFromDensity(); }), "mass");
    EXPECT_EQ(fieldOf([&] { world[ground].setMass(1); }), "mass");
}

// Flags with which the part would collide with nothing, as `required` is 0 then.
TEST(DividedMass, UnweldRefusesAModeWithoutCategories) {
    World world;
    const BodyId body = world.add({.shape = compounds()[0]});
    for (const Flags mode : {kMatchAny, kMatchAll}) {
        EXPECT_EQ(fieldOf([&] { world.unweld(body, 1, mode | 1); }), "flags");
    }
    EXPECT_NO_THROW(world.unweld(body, 1, kMatchEqual | 1));
}

// A heavy disc with a light plank welded to it has a soft rim, by the law of levers. A body of the
// same shapes takes that mass over; a smaller share than both is refused.
TEST(DividedMass, CopyFromTakesWhatAWeldMade) {
    World world;
    const BodyId body = world.add({.shape = Circle{Real(0.1)}, .mass = MassDef{1000}});
    const BodyId plank =
        world.add({.shape = Box{6, Real(0.1)}, .position = {0, 1}, .mass = MassDef{1}});
    world.weld(body, plank);
    const World before = world;
    const Real share = before[body].inertia() / (before[body].mass() * 9);
    ASSERT_LT(share, kMinInertiaShare);
    world[body].setMass(5);
    world[body].copyFrom(before[body]);
    EXPECT_EQ(world[body].mass(), before[body].mass());
    EXPECT_EQ(world[body].inertia(), before[body].inertia());
    EXPECT_EQ(fromBytes(toBytes(world)).stateHash(), world.stateHash());
    const BodyId longer = world.add({.shape = Box{60, 1}});
    EXPECT_EQ(fieldOf([&] { world[longer].copyFrom(before[body]); }), "other.mass.inertia");
}

// The mass of a static or kinematic body is not used: one that its parts cannot have is not copied.
TEST(DividedMass, CopyFromOntoABodyThatStandsNeedsNoMass) {
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
        World world;
        const BodyId plane = world.add({.shape = Plane{}, .position = {3, 4}, .type = type});
        const BodyId box = world.add({.shape = Box{1, 1}, .position = {7, 8}, .type = type});
        const MassDef heavy{.mass = 3, .center = Vec2{Real(0.25), 0}};
        const BodyId ball = world.add({.shape = Circle{1}, .mass = heavy});
        const Vec2 velocity = type == BodyType::Static ? Vec2{} : Vec2{1, 2};
        world[plane].setVelocity(velocity);
        world[ball].copyFrom(world[plane]);
        EXPECT_EQ(world[ball].type(), type);
        EXPECT_EQ(world[ball].mass(), 3);
        EXPECT_TRUE(near(world[ball].position(), Vec2{3, 4}, Real(1e-6)));
        EXPECT_EQ(world[ball].velocity(), velocity);
        world[plane].copyFrom(world[box]);
        EXPECT_TRUE(near(world[plane].position(), Vec2{7, 8}, Real(1e-6)));
        EXPECT_EQ(fromBytes(toBytes(world)).stateHash(), world.stateHash());
    }
}

} // namespace
} // namespace kodo
