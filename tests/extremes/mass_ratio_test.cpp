// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

StepSettings withoutSleep() {
    StepSettings settings;
    settings.leaveOut = Feature::Sleep;
    return settings;
}

StepSettings withShocks() {
    StepSettings settings = thesis2006();
    settings.propagation().contactPasses = 4;
    settings.propagation().shockPasses = 4;
    settings.leaveOut = Feature::Sleep;
    return settings;
}

/// A unit box on the floor under a box of `ratio` times its mass, after 5 s.
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
    /// Compression of the light box, as share of its size.
    Real crush() const { return Real(1.5) - world[heavy].position().y; }
    Real fastest() const {
        return std::max(length(world[light].velocity()), length(world[heavy].velocity()));
    }
};

// Up to 1:1000, compression stays below 1 % with the default settings.
TEST(MassRatio, AThousandTimesHeavierBlockDoesNotCrushALightOne) {
    for (const Real ratio : {Real(1), Real(10), Real(50), Real(87), Real(88), Real(90), Real(100),
                             Real(300), Real(400), Real(1000)}) {
        SCOPED_TRACE(ratio);
        const Load load(ratio, withoutSleep());
        EXPECT_LT(load.crush(), Real(0.01));
        EXPECT_LT(load.fastest(), Real(0.05)); // it bounces by a millimetre
    }
}

// W5: shock propagation treats the light box as ground, so the ratio does not matter.
TEST(MassRatio, ShockPropagationCarriesAMillionTimesHeavierBlock) {
    for (const Real ratio : {Real(1e3), Real(1e6)}) {
        SCOPED_TRACE(ratio);
        const Load load(ratio, withShocks());
        EXPECT_LT(load.crush(), Real(0.01));
        EXPECT_LT(load.fastest(), Real(0.01));
    }
}

/// Ten unit boxes on the floor under a box of `ratio` times the mass of one.
struct Tower {
    World world{{.gravity = support::kEarth, .settings = withoutSleep()}};
    BodyId floor = support::addFloor(world);
    std::vector<BodyId> boxes = support::addStack(world, 10);
    BodyId heavy;

    explicit Tower(Real ratio) {
        BodyDef def = support::boxDef({0, Real(10.5)}, 1, 1);
        def.density = ratio;
        heavy = world.add(def);
    }
    /// Compression of the ten light boxes, as share of their height.
    Real crush() const { return (Real(10.5) - world[heavy].position().y) / 10; }
};

// Each contact may yield by 8.5 mm (0.9 %), between two light boxes by twice that. A buckling tower
// would move sideways without stopping.
TEST(MassRatio, ATowerCarriesThreeThousandTimesTheWeightOfABox) {
    for (const Real ratio :
         {Real(100), Real(200), Real(300), Real(500), Real(1000), Real(2000), Real(3000)}) {
        SCOPED_TRACE(ratio);
        Tower tower(ratio);
        support::run(tower.world, 600);
        EXPECT_LT(tower.crush(), Real(0.02));
        for (const BodyId id : tower.world.bodies()) {
            EXPECT_LT(std::abs(tower.world[id].position().x), Real(0.1));
            EXPECT_LT(length(tower.world[id].velocity()), Real(0.05));
        }
    }
}

// Substep refinement applies to heavy loads only. Up to 1:87 a contact is visited ten times, twice
// in each of five substeps. The impact of a heavy body that no force presses on is not refined
// either.
TEST(MassRatio, OnlyHeavyLoadsRefineTheSubsteps) {
    const auto visitsByContact = [](const World& world) {
        return stepStats(world).contacts / world.collisions().size();
    };
    for (const auto& [ratio, visits] : {std::pair(Real(87), 10u), std::pair(Real(88), 20u),
                                        std::pair(Real(1000), 40u), std::pair(Real(3000), 80u)}) {
        Tower tower(ratio);
        support::run(tower.world, 60);
        EXPECT_EQ(visitsByContact(tower.world), visits) << ratio;
        EXPECT_EQ(stepStats(tower.world).mostParts, visits / 10) << ratio;
        EXPECT_EQ(stepStats(tower.world).refinedBodies, visits > 10 ? 11u : 0u) << ratio;
    }
    World space;
    BodyDef def = support::ballDef({}, 1);
    space.add(def);
    def.position = {Real(1.9), 0};
    def.density = 1000;
    space.add(def);
    space.step(support::kDt);
    ASSERT_EQ(space.collisions().size(), 1u);
    EXPECT_LE(stepStats(space).contacts, 20u);
    EXPECT_EQ(stepStats(space).mostParts, 1u);
}

// The counters tell who pays: of two towers, the one below the heavy box. They end with the load,
// in flight, and with the solver of the thesis, which divides no substep.
TEST(MassRatio, CountersOfAStepNameTheIslandThatIsRefined) {
    Tower tower(1000);
    for (int i = 0; i < 10; ++i) {
        tower.world.add(support::boxDef({20, Real(i) + Real(0.5)}, 1, 1));
    }
    support::run(tower.world, 60);
    EXPECT_EQ(stepStats(tower.world).mostParts, 4u);
    EXPECT_EQ(stepStats(tower.world).refinedBodies, 11u);
    World other = tower.world;
    other.setSettings(withShocks());
    other.step(support::kDt);
    EXPECT_EQ(stepStats(other).mostParts, 1u);
    EXPECT_EQ(stepStats(other).refinedBodies, 0u);
    EXPECT_GT(stepStats(other).contacts, 0u);
    tower.world[tower.heavy].setPosition({0, 100});
    support::run(tower.world, 2);
    EXPECT_EQ(stepStats(tower.world).mostParts, 1u);
    EXPECT_EQ(stepStats(tower.world).refinedBodies, 0u);
}

// Records and warm starts refer to whole substeps. The floor carries all the weight; each of five
// substeps carries a fifth of it. A restored World continues with the same
// bits, also when the load is removed and refinement ends.
TEST(MassRatio, ARefinedStepReportsImpulsesOfWholeSubsteps) {
    Tower tower(1000);
    support::run(tower.world, 600);
    const CollisionRecord* record =
        support::recordOf(tower.world, tower.floor, tower.boxes.front());
    ASSERT_NE(record, nullptr);
    const long double weight = 1010 * 10 / 60.0L; // N s in a step
    EXPECT_TRUE(support::nearShare(record->totalImpulse, weight, 0.02L));
    EXPECT_TRUE(support::nearShare(record->maxImpulse, weight / 5, 0.1L));
    World read = fromBytes(toBytes(tower.world));
    for (int step = 0; step < 60; ++step) {
        if (step == 20) {
            tower.world.remove(tower.heavy);
            read.remove(tower.heavy);
        }
        tower.world.step(support::kDt);
        read.step(support::kDt);
        ASSERT_EQ(read.stateHash(), tower.world.stateHash()) << step;
    }
    EXPECT_EQ(stepStats(tower.world).contacts, 10 * tower.world.collisions().size());
}

// Up to 1:1e9 the motion is bounded. The heavy box may at worst lie on the floor, at 0.5 m within 5
// cm. After 5 s all speeds are below 1 m/s.
TEST(MassRatio, MotionIsBoundedUpToABillion) {
    for (const StepSettings& settings : {withoutSleep(), withShocks()}) {
        for (const Real ratio : {Real(1e3), Real(1e4), Real(1e6), Real(1e9)}) {
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

/// m, length after 10 s of a hanging chain of ten links of 0.25 m with little inertia. The last
/// link has `ratio` times the mass of the others. The unloaded length is 2.5 m.
Real chainLength(Real ratio) {
    World world({.gravity = support::kEarth, .settings = withoutSleep()});
    BodyId last = world.add({.shape = Circle{Real(0.1)}, .type = BodyType::Static});
    for (int i = 1; i <= 10; ++i) {
        BodyDef def = support::ballDef({0, Real(-0.25) * static_cast<Real>(i)}, Real(0.1));
        def.density = i == 10 ? ratio : 1;
        const BodyId link = world.add(def);
        world.add(RevoluteJoint{.ends = {last, link, {0, Real(-0.125)}, {0, Real(0.125)}}});
        last = link;
    }
    support::run(world, 600);
    return length(world[last].position());
}

// Joints without loops are solved directly, so the load does not matter, within 1 mm.
TEST(MassRatio, AChainDoesNotStretchUnderTenThousandTimesItsLink) {
    for (const Real ratio : {Real(1), Real(10), Real(100), Real(1e3), Real(1e4)}) {
        SCOPED_TRACE(ratio);
        EXPECT_TRUE(support::near(chainLength(ratio), 2.5L, Real(1e-3)));
    }
}

} // namespace
} // namespace kodo
