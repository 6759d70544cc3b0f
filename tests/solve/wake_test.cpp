// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/sleeping.hpp>

#include <algorithm>
#include <memory>
#include <ostream>

namespace kodo {
namespace {

using support::kSolvers;
using support::settingsOf;
using support::Solver;

using support::addFloor;
using support::addStack;
using support::ballDef;
using support::boxDef;
using support::isAsleep;
using support::kDt;
using support::run;
using support::slippery;

/// Five boxes on a kinematic table and five more far away on the floor, all asleep. A weight hangs
/// on a revolute joint nearby, asleep in the air without contact.
struct Quiet {
    World world{{.gravity = support::kEarth}};
    BodyId floor;
    BodyId table;
    std::vector<BodyId> stack; // on the table
    std::vector<BodyId> other; // on the floor
    BodyId weight;
    JointId pin;

    Quiet() {
        floor = addFloor(world);
        BodyDef top = boxDef({0, 2}, 6, 1);
        top.type = BodyType::Kinematic;
        table = world.add(top);
        for (int i = 0; i < 5; ++i) {
            stack.push_back(world.add(boxDef({0, 3 + static_cast<Real>(i)}, 1, 1)));
        }
        other = addStack(world, 5, 20);
        weight = world.add(ballDef({0, 20}, Real(0.25)));
        pin = world.add(RevoluteJoint{
            .ends = {.a = table, .b = weight, .anchorA = {0, 19}, .anchorB = {0, 1}}});
        run(world, 600);
    }
};

const Quiet& quiet() {
    static const Quiet scene;
    return scene;
}

TEST(Wake, TheInitialSceneIsAsleep) {
    EXPECT_EQ(support::countAsleep(quiet().world), 11u);
}

struct Cause {
    const char* name;
    void (*act)(Quiet&);
};

void PrintTo(const Cause& cause, std::ostream* out) {
    *out << cause.name;
}

const Cause kCauses[] = {
    {"Force",
     [](Quiet& q) {
         q.world[q.stack[0]].applyForce({1, 0});
     }},
    {"ForceAtAPoint",
     [](Quiet& q) {
         q.world[q.stack[4]].applyForce({1, 0}, {0, 7});
     }},
    {"Torque", [](Quiet& q) { q.world[q.stack[2]].applyTorque(Real(0.1)); }},
    {"Impulse",
     [](Quiet& q) {
         q.world[q.stack[2]].applyImpulse({Real(0.1), 0});
     }},
    {"ForceOnAll",
     [](Quiet& q) {
         q.world.applyForceToAll({0, 1});
     }},
    {"TorqueOnAll", [](Quiet& q) { q.world.applyTorqueToAll(1); }},
    {"Velocity",
     [](Quiet& q) {
         q.world[q.stack[1]].setVelocity({0, 0});
     }},
    {"AngularVelocity", [](Quiet& q) { q.world[q.stack[1]].setAngularVelocity(0); }},
    {"MoveTo",
     [](Quiet& q) {
         q.world[q.stack[1]].moveTo({0, 4}, kDt);
     }},
    {"Position",
     [](Quiet& q) {
         q.world[q.stack[4]].setPosition({0, 9});
     }},
    {"Rotation",
     [](Quiet& q) {
         q.world[q.stack[4]].setRotation({0, 1});
     }},
    {"Flags", [](Quiet& q) { q.world[q.stack[4]].setFlags(1); }},
    {"Required", [](Quiet& q) { q.world[q.stack[4]].setRequired(1); }},
    {"Material", [](Quiet& q) { q.world[q.stack[4]].setMaterial(slippery()); }},
    {"Mass", [](Quiet& q) { q.world[q.stack[4]].setMass(3); }},
    {"MassFromDensity", [](Quiet& q) { q.world[q.stack[4]].setMassFromDensity(); }},
    {"CopyOfABody", [](Quiet& q) { q.world[q.stack[4]].copyFrom(q.world[q.weight]); }},
    {"ByHand", [](Quiet& q) { q.world[q.stack[4]].wake(); }},
    {"ByHandOfTheLowest", [](Quiet& q) { q.world[q.stack[0]].wake(); }},
    {"TableByHand", [](Quiet& q) { q.world[q.table].wake(); }},
    {"WeldOfAPart",
     [](Quiet& q) {
         q.world.weld(q.stack[3], Box{1, 1, {1, 0}}, Material{}, Real(1));
     }},
    {"WeldOfABody", [](Quiet& q) { q.world.weld(q.stack[3], q.stack[4]); }},
    {"WeldOfAFreeBody",
     [](Quiet& q) {
         q.world.weld(q.stack[3], q.world.add(ballDef({1, 6}, Real(0.2))));
     }},
    {"WeldIntoTheTable", [](Quiet& q) { q.world.weld(q.table, q.stack[0]); }},
    {"Removal", [](Quiet& q) { q.world.remove(q.stack[0]); }},
    {"TableRemoved", [](Quiet& q) { q.world.remove(q.table); }},
    {"TableTeleported",
     [](Quiet& q) {
         q.world[q.table].setPosition({100, 2});
     }},
    {"TableMoves",
     [](Quiet& q) {
         q.world[q.table].setVelocity({1, 0});
     }},
    {"TableTurns", [](Quiet& q) { q.world[q.table].setAngularVelocity(1); }},
    {"TableSinks",
     [](Quiet& q) {
         q.world[q.table].moveTo({0, 1}, kDt);
     }},
    {"TableSlippery", [](Quiet& q) { q.world[q.table].setMaterial(slippery()); }},
    {"TableDisabled", [](Quiet& q) { q.world[q.table].setFlags(kDisabled); }},
    {"TableUnlocked", [](Quiet& q) { q.world[q.table].setType(BodyType::Dynamic); }},
    {"TableGetsAPart",
     [](Quiet& q) {
         q.world.weld(q.table, Circle{1, {5, 0}}, Material{}, Real(1));
     }},
    {"FieldAdded",
     [](Quiet& q) {
         q.world.addField({std::make_shared<Gravity>(Vec2{1, 0})});
     }},
    {"FieldsRemoved", [](Quiet& q) { q.world.setFields({}); }},
    {"JointAdded",
     [](Quiet& q) {
         q.world.add(
             DistanceJoint{.ends = {.a = q.stack[4], .b = q.weight}, .limits = Range{0, 1000}});
     }},
    {"SleepLeftOut",
     [](Quiet& q) {
         StepSettings settings = q.world.settings();
         settings.leaveOut = Feature::Sleep;
         q.world.setSettings(settings);
     }},
    {"Touch",
     [](Quiet& q) {
         BodyDef ball = ballDef({0, Real(7.8)}, Real(0.3));
         ball.velocity = {0, -1};
         q.world.add(ball);
         q.world.step(kDt);
     }},
};

class WakeCause : public testing::TestWithParam<Cause> {};

std::string nameOf(const testing::TestParamInfo<Cause>& info) {
    return info.param.name;
}

// O3, O4: a change of one box, or of its support, wakes the whole pile in the next step.
TEST_P(WakeCause, WakesTheWholePile) {
    Quiet scene = quiet();
    GetParam().act(scene);
    scene.world.step(kDt);
    for (const BodyId id : scene.stack) {
        EXPECT_TRUE(!scene.world.contains(id) || !isAsleep(scene.world, id)) << id.index;
    }
}

INSTANTIATE_TEST_SUITE_P(Wake, WakeCause, testing::ValuesIn(kCauses), nameOf);

// O4: no other body wakes, such as the pile far away.
TEST(Wake, DoesNotSpreadToBodiesThatDoNotTouch) {
    Quiet scene = quiet();
    scene.world.remove(scene.stack[0]);
    scene.world[scene.weight].applyImpulse({1, 0});
    run(scene.world, 10);
    for (const BodyId id : scene.other) {
        EXPECT_TRUE(isAsleep(scene.world, id));
    }
    EXPECT_EQ(stepStats(scene.world).bodies, 5u); // four boxes and the weight
}

// O4: when a box of a sleeping stack is removed, all boxes above it wake and come down by one box.
TEST(Wake, RemovingABoxLetsAllAboveItComeDown) {
    for (std::size_t pulled = 0; pulled < 5; ++pulled) {
        Quiet scene = quiet();
        scene.world.remove(scene.stack[pulled]);
        scene.world.step(kDt);
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_TRUE(i == pulled || !isAsleep(scene.world, scene.stack[i])) << i;
        }
        run(scene.world, 900);
        for (std::size_t i = 0; i < 5; ++i) {
            if (i != pulled) {
                const Real storey = static_cast<Real>(i) - (i > pulled ? 1 : 0);
                const BodyView box = scene.world[scene.stack[i]];
                EXPECT_TRUE(isAsleep(scene.world, scene.stack[i]));
                // Each of up to four contacts may yield by the slop; the impact may shift them a
                // little.
                EXPECT_TRUE(support::near(box.position().y, 3 + storey, Real(0.02)));
                EXPECT_TRUE(support::near(box.position().x, 0, Real(0.25)));
            }
        }
    }
}

// O4: a joint connects like a contact: a hanging body wakes when its support moves, is removed or
// is changed.
TEST(Wake, AChangeOfASupportWakesAHangingBody) {
    const Cause causes[] = {
        {"the joint is removed", [](Quiet& q) { q.world.remove(q.pin); }},
        {"the joint is changed", [](Quiet& q) { q.world.setJoint(q.pin, q.world.joint(q.pin)); }},
        {"the table moves",
         [](Quiet& q) {
             q.world[q.table].setVelocity({1, 0});
         }},
        {"the table is removed", [](Quiet& q) { q.world.remove(q.table); }},
        {"the table is teleported",
         [](Quiet& q) {
             q.world[q.table].setPosition({1, 2});
         }},
        {"the table is rotated",
         [](Quiet& q) {
             q.world[q.table].setRotation(Rot{0, 1});
         }},
    };
    for (const Cause& cause : causes) {
        Quiet scene = quiet();
        cause.act(scene);
        scene.world.step(kDt);
        EXPECT_FALSE(isAsleep(scene.world, scene.weight)) << cause.name;
    }
}

// X6: wake() wakes a pile without changing it: it falls asleep again where it was. Other piles
// stay asleep.
TEST(Wake, ByHandChangesNoPose) {
    Quiet scene = quiet();
    scene.world[scene.stack[2]].wake();
    EXPECT_EQ(support::countAsleep(scene.world), 6u); // the other pile and the weight
    run(scene.world, 60);
    EXPECT_EQ(support::countAsleep(scene.world), 11u);
    for (const BodyId id : scene.stack) {
        const Vec2 moved = scene.world[id].position() - quiet().world[id].position();
        EXPECT_LT(length(moved), scene.world.tolerances().slop / 4);
    }
}

// X6: of a support it wakes all that leans on it or hangs on it, at once.
TEST(Wake, OfASupportByHandWakesWhatLeansOnIt) {
    Quiet scene = quiet();
    scene.world[scene.table].wake();
    EXPECT_EQ(support::countAsleep(scene.world), 5u);
    EXPECT_FALSE(isAsleep(scene.world, scene.weight));
    scene.world[scene.floor].wake();
    EXPECT_EQ(support::countAsleep(scene.world), 0u);
}

// X6: of an awake body it restarts the count of calm steps, so that it does not fall asleep.
TEST(Wake, ByHandInEachStepKeepsAPileAwake) {
    Quiet scene = quiet();
    for (int step = 0; step < 100; ++step) {
        scene.world[scene.stack[4]].wake();
        scene.world.step(kDt);
        ASSERT_EQ(support::countAsleep(scene.world), 6u);
    }
}

// O3: a sleeping body wakes in the step in which it is touched, not earlier.
TEST(Wake, HappensInTheStepOfTheTouch) {
    Quiet scene = quiet();
    const BodyId ball = scene.world.add(ballDef({0, 12}, Real(0.3)));
    const BodyId top = scene.stack[4];
    for (int step = 0; step < 120 && isAsleep(scene.world, top); ++step) {
        EXPECT_EQ(support::recordOf(scene.world, top, ball), nullptr);
        scene.world.step(kDt);
    }
    EXPECT_FALSE(isAsleep(scene.world, scene.stack[0]));
    EXPECT_NE(support::recordOf(scene.world, top, ball), nullptr);
    EXPECT_TRUE(support::near(scene.world[ball].position().y, Real(7.8), Real(0.02)));
}

// O3: a pile that wakes without a force falls asleep again, and has moved by no more than its
// contacts yield.
TEST(Wake, WithoutForcesEndsInTheSamePoses) {
    Quiet scene = quiet();
    for (int again = 0; again < 10; ++again) {
        scene.world[scene.stack[2]].setVelocity({});
        run(scene.world, 60);
        ASSERT_EQ(support::countAsleep(scene.world), 11u);
    }
    for (const BodyId id : scene.stack) {
        const Vec2 moved = scene.world[id].position() - quiet().world[id].position();
        EXPECT_LT(length(moved), scene.world.tolerances().slop / 4);
    }
}

// A sleeping island keeps its contacts: after it wakes, their records continue with Persist.
TEST(Wake, ContactsPersistAcrossSleep) {
    Quiet scene = quiet();
    EXPECT_TRUE(scene.world.collisions().empty());
    scene.world[scene.stack[2]].setVelocity({});
    scene.world.step(kDt);
    int seen = 0;
    for (const CollisionRecord& record : scene.world.collisions()) {
        EXPECT_EQ(record.phase, TouchPhase::Persist);
        ++seen;
    }
    EXPECT_EQ(seen, 5);
}

// The record of a body that a touch wakes contains the impulses of this step only, not those of the
// step before it fell asleep. The box weighs 10 N, and the ball laid on it 0.02 N.
TEST(Wake, ATouchDoesNotRecordImpulsesFromBeforeSleep) {
    for (const Solver strategy : kSolvers) {
        SCOPED_TRACE(static_cast<int>(strategy));
        StepSettings settings = settingsOf(strategy);
        World world({.gravity = support::kEarth, .settings = settings});
        const BodyId floor = addFloor(world);
        const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
        run(world, 120);
        ASSERT_TRUE(isAsleep(world, box));
        BodyDef ball = ballDef({0, Real(1.025)}, Real(0.025));
        world.add(ball);
        world.step(kDt);
        ASSERT_FALSE(isAsleep(world, box));
        const CollisionRecord* record = support::recordOf(world, floor, box);
        ASSERT_NE(record, nullptr);
        EXPECT_LT(record->totalImpulse, Real(1.1) * 10 * kDt);
        EXPECT_LE(record->maxImpulse, record->totalImpulse);
    }
}

// Contacts with a table that starts to move persist too.
TEST(Wake, ContactsWithATableThatStartsToMovePersist) {
    Quiet scene = quiet();
    scene.world[scene.table].setVelocity({Real(0.1), 0});
    scene.world.step(kDt);
    const CollisionRecord* record = support::recordOf(scene.world, scene.table, scene.stack[0]);
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->phase, TouchPhase::Persist);
}

// Between the step in which it fell asleep and the next one, the list of awake bodies has it still:
// its acceleration must be found again.
TEST(Wake, ABodyThatWakesBeforeTheNextStepFalls) {
    World world({.gravity = support::kEarth});
    const BodyId floor = addFloor(world);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    ASSERT_LT(support::stepsUntilAsleep(world, box, 200), 200);
    world.remove(floor);
    run(world, 60);
    EXPECT_LT(world[box].position().y, Real(-4)); // 5 m in a second
}

// One calm body among many that are not: its island is followed along contacts and joints. A
// neighbour that is not calm keeps it awake, also beyond another calm body.
TEST(Wake, AFewCalmBodiesSleepUnlessANeighbourMoves) {
    for (const bool moves : {false, true}) {
        World world({.gravity = support::kEarth});
        addFloor(world);
        BodyDef def = boxDef({0, Real(0.5)}, 1, 1);
        const BodyId lower = world.add(def);
        def.position = {0, Real(1.5)};
        const BodyId middle = world.add(def);
        def.position = {0, Real(2.5)};
        def.flags = moves ? kNeverSleep : 0;
        world.add(def);
        for (int i = 0; i < 40; ++i) { // they never come to rest
            BodyDef ball = ballDef({10 + 3 * static_cast<Real>(i), 2}, Real(0.5));
            ball.shape = Circle{Real(0.5)};
            ball.material.restitution = 1;
            ball.flags = kNeverSleep;
            world.add(ball);
        }
        run(world, 200);
        EXPECT_EQ(isAsleep(world, lower), !moves);
        EXPECT_EQ(isAsleep(world, middle), !moves);
    }
}

/// A stack asleep on the floor, and a wall beside it that does not touch it.
struct Beside {
    World world{{.gravity = support::kEarth}};
    std::vector<BodyId> stack;
    BodyId wall;

    Beside(Solver solver, BodyType type, Real gap)
        : world({.gravity = support::kEarth, .settings = settingsOf(solver)}) {
        addFloor(world);
        stack = addStack(world, 3, 0);
        BodyDef def = boxDef({1 + gap, Real(1.5)}, 1, 2);
        def.type = type;
        wall = world.add(def);
        run(world, 300);
    }
    bool sleeps() const {
        return std::all_of(stack.begin(), stack.end(),
                           [&](BodyId id) { return isAsleep(world, id); });
    }
};

// O4: a body that is only near changes nothing for a sleeper, until it comes.
TEST(Wake, IsNotCausedByABodyThatIsOnlyNear) {
    void (*const changes[])(World&, BodyId) = {
        [](World& world, BodyId wall) { world.remove(wall); },
        [](World& world, BodyId wall) {
            world[wall].setPosition({9, 5});
        },
        [](World& world, BodyId wall) { world[wall].setFlags(kDisabled); },
        [](World& world, BodyId wall) { world[wall].setMaterial(slippery()); },
        [](World& world, BodyId wall) {
            world.weld(wall, Circle{Real(0.1), {Real(0.4), 0}}, Material{}, Real(1));
        },
        [](World& world, BodyId wall) { world[wall].wake(); },
    };
    for (const Solver solver : kSolvers) {
        for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
            for (const Real gap : {Real(0.006), Real(0.015), Real(0.03)}) {
                for (const auto change : changes) {
                    Beside scene(solver, type, gap);
                    ASSERT_TRUE(scene.sleeps());
                    change(scene.world, scene.wall);
                    run(scene.world, 10);
                    ASSERT_TRUE(scene.sleeps()) << "gap " << gap;
                    if (scene.world.contains(scene.wall)) {
                        scene.world[scene.wall].setFlags(0);
                        scene.world[scene.wall].setPosition({Real(0.9), Real(1.5)});
                        run(scene.world, 2);
                        ASSERT_FALSE(scene.sleeps()) << "gap " << gap;
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
