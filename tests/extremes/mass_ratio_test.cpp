// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

StepSettings wakeful() {
    StepSettings settings;
    settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
    return settings;
}

StepSettings withShocks() {
    StepSettings settings = thesis2006();
    settings.contactPasses = 4;
    settings.shockPasses = 4;
    settings.leaveOut = static_cast<std::uint8_t>(Feature::Resting);
    return settings;
}

/// A unit box on the floor and one on it that is so many times as heavy, after five seconds.
struct Load {
    World world;
    BodyId light;
    BodyId heavy;

    Load(Real ratio, const StepSettings& settings)
        : world({.gravity = support::kEarth, .settings = settings}) {
        support::addFloor(world);
        BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1);
        def.density = ratio > Real(1e6) ? Real(1e6) / ratio : 1;
        light = world.add(def);
        def.position.y = Real(1.5);
        def.density *= ratio;
        heavy = world.add(def);
        support::run(world, 300);
    }
    /// The share of the light box's size that is lost.
    Real crush() const { return Real(1.5) - world[heavy].position().y; }
    Real fastest() const {
        return std::max(length(world[light].velocity()), length(world[heavy].velocity()));
    }
};

// Up to 1:50 the light box keeps its size to 1 % under the default settings.
TEST(MassRatio, AFiftyTimesHeavierBlockDoesNotCrushALightOne) {
    for (const Real ratio : {Real(1), Real(10), Real(50)}) {
        SCOPED_TRACE(ratio);
        const Load load(ratio, wakeful());
        EXPECT_LT(load.crush(), Real(0.01));
        EXPECT_LT(load.fastest(), Real(0.05)); // it bounces by a millimetre
    }
}

// W5: with shock propagation up to 1:1000 and beyond: the light one counts as ground.
TEST(MassRatio, WithShockPropagationAThousandTimesIsNoMore) {
    for (const Real ratio : {Real(1e3), Real(1e6)}) {
        SCOPED_TRACE(ratio);
        const Load load(ratio, withShocks());
        EXPECT_LT(load.crush(), Real(0.01));
        EXPECT_LT(load.fastest(), Real(0.01));
    }
}

// Up to 1:1e9 whatever happens is bounded: nothing leaves, nothing is lost under the floor (the
// heavy one lies on it at 0.5 at the lowest, but for 5 cm), and after 5 s nothing moves at 1 m/s.
TEST(MassRatio, UpToABillionItIsBounded) {
    for (const StepSettings& settings : {wakeful(), withShocks()}) {
        for (const Real ratio : {Real(1e3), Real(1e6), Real(1e9)}) {
            SCOPED_TRACE(ratio);
            const Load load(ratio, settings);
            EXPECT_GT(load.world[load.heavy].position().y, Real(0.45));
            EXPECT_LT(load.world[load.heavy].position().y, Real(1.6));
            EXPECT_GT(load.world[load.light].position().y, Real(0.4));
            EXPECT_LT(load.fastest(), 1);
            EXPECT_TRUE(load.world.frozenBodies().empty());
        }
    }
}

/// The length (m) of a hanging chain of ten links of 0.25 m, with little inertia, that ends in a
/// ball of so many times the mass of a link, after ten seconds. Without load it is 2.5 m.
Real chainLength(Real ratio) {
    World world({.gravity = support::kEarth, .settings = wakeful()});
    BodyId last = world.add({.shape = Circle{Real(0.1)}, .flags = kLocked});
    for (int i = 1; i <= 10; ++i) {
        BodyDef def = support::ballDef({0, Real(-0.25) * static_cast<Real>(i)}, Real(0.1));
        def.density = i == 10 ? ratio : 1;
        const BodyId link = world.add(def);
        world.add(Pin{.ends = {last, link, {0, Real(-0.125)}, {0, Real(0.125)}}});
        last = link;
    }
    support::run(world, 600);
    return length(world[last].position());
}

TEST(MassRatio, AChainStretchesByOnePercentAtMostUnderTenTimesItsLink) {
    EXPECT_TRUE(support::near(chainLength(1), 2.5L, Real(0.025)));
    EXPECT_TRUE(support::near(chainLength(10), 2.5L, Real(0.025)));
}

} // namespace
} // namespace kodo
