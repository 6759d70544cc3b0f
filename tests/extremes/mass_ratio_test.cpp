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

// Up to 1:1000 the light box keeps its size to 1 % under the default settings.
TEST(MassRatio, AThousandTimesHeavierBlockDoesNotCrushALightOne) {
    for (const Real ratio : {Real(1), Real(10), Real(50), Real(87), Real(88), Real(90), Real(100),
                             Real(300), Real(400), Real(1000)}) {
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

/// Ten unit boxes on the floor and one on them that is so many times as heavy.
struct Tower {
    World world{{.gravity = support::kEarth, .settings = wakeful()}};
    BodyId floor = support::addFloor(world);
    std::vector<BodyId> boxes = support::addStack(world, 10);
    BodyId heavy;

    explicit Tower(Real ratio) {
        BodyDef def = support::boxDef({0, Real(10.5)}, 1, 1);
        def.density = ratio;
        heavy = world.add(def);
    }
    /// The share of its height that the light part has lost.
    Real crush() const { return (Real(10.5) - world[heavy].position().y) / 10; }
};

// Each contact may give by 8.5 mm, which is 0.9 %, and twice that between two light ones; a tower
// that buckles moves aside, and does not stop.
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

// The finer substeps are for such loads alone: up to 1:87 a contact is looked at ten times, twice
// in each of five substeps. What is lighter than that costs as before, and so does a blow of
// something heavy that no force presses on.
TEST(MassRatio, OnlySuchLoadsRefineTheStep) {
    const auto visitsByContact = [](const World& world) {
        return world.contactVisits() / world.collisions().size();
    };
    for (const auto& [ratio, visits] : {std::pair(Real(87), 10u), std::pair(Real(88), 20u),
                                        std::pair(Real(1000), 40u), std::pair(Real(3000), 80u)}) {
        Tower tower(ratio);
        support::run(tower.world, 60);
        EXPECT_EQ(visitsByContact(tower.world), visits) << ratio;
    }
    World space;
    BodyDef def = support::ballDef({}, 1);
    space.add(def);
    def.position = {Real(1.9), 0};
    def.density = 1000;
    space.add(def);
    space.step(support::kDt);
    ASSERT_EQ(space.collisions().size(), 1u);
    EXPECT_LE(space.contactVisits(), 20u);
}

// Records and what contacts keep are as of whole substeps: the floor carries all the weight, each
// of two points half of it in each of five substeps; and a World that was read from bytes goes on
// bit by bit, also when the load is taken off, and the step is coarse again.
TEST(MassRatio, ARefinedStepReportsAndKeepsWhatAWholeOneWould) {
    Tower tower(1000);
    support::run(tower.world, 600);
    const CollisionRecord* record =
        support::recordOf(tower.world, tower.floor, tower.boxes.front());
    ASSERT_NE(record, nullptr);
    const long double weight = 1010 * 10 / 60.0L; // N s in a step
    EXPECT_TRUE(support::nearShare(record->totalImpulse, weight, 0.02L));
    EXPECT_TRUE(support::nearShare(record->maxImpulse, weight / 10, 0.1L));
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
    EXPECT_EQ(tower.world.contactVisits(), 10 * tower.world.collisions().size());
}

// Up to 1:1e9 whatever happens is bounded: nothing leaves, nothing is lost under the floor (the
// heavy one lies on it at 0.5 at the lowest, but for 5 cm), and after 5 s nothing moves at 1 m/s.
TEST(MassRatio, UpToABillionItIsBounded) {
    for (const StepSettings& settings : {wakeful(), withShocks()}) {
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

// Pins that form no loop are solved at once, so the load hardly matters: to a millimetre.
TEST(MassRatio, AChainDoesNotStretchUnderTenThousandTimesItsLink) {
    for (const Real ratio : {Real(1), Real(10), Real(100), Real(1e3), Real(1e4)}) {
        SCOPED_TRACE(ratio);
        EXPECT_TRUE(support::near(chainLength(ratio), 2.5L, Real(1e-3)));
    }
}

} // namespace
} // namespace kodo
