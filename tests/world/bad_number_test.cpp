// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <functional>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

/// A World with motion and contacts, and one of its boxes.
struct Scene {
    World world{{.gravity = support::kEarth}};
    BodyId box;

    Scene() {
        support::addFloor(world);
        box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        world.add(support::ballDef({0, 3}, Real(0.5)));
        support::run(world, 20);
    }
};

/// Expects the call to be refused with the field named, without any change of state.
void expectRefused(const char* field, const std::function<void(Scene&)>& call) {
    SCOPED_TRACE(field);
    Scene scene;
    const std::uint64_t before = scene.world.stateHash();
    try {
        call(scene);
        ADD_FAILURE() << "not refused";
    } catch (const BadDefinition& bad) {
        EXPECT_EQ(bad.problem().field, field) << bad.what();
    }
    EXPECT_EQ(scene.world.stateHash(), before);
}

TEST(BadNumber, StepRefusesABadDt) {
    for (const Real dt : {kNan, kInf, -kInf, Real(-0.01), Real(0), Real(2), Real(1e-9)}) {
        expectRefused("dt", [dt](Scene& s) { s.world.step(dt); });
    }
}

TEST(BadNumber, StepAcceptsTheShortestAndTheLongestDt) {
    Scene scene;
    EXPECT_NO_THROW(scene.world.step(kMinTimeStep));
    EXPECT_NO_THROW(scene.world.step(kMaxTimeStep));
}

TEST(BadNumber, ARefusedStepKeepsTheRecords) {
    Scene scene;
    const std::size_t records = scene.world.collisions().size();
    ASSERT_GT(records, 0u);
    EXPECT_THROW(scene.world.step(kNan), BadDefinition);
    EXPECT_EQ(scene.world.collisions().size(), records);
}

TEST(BadNumber, SettersRefuseInvalidNumbers) {
    expectRefused("position", [](Scene& s) { s.world[s.box].setPosition({kNan, 0}); });
    expectRefused("position", [](Scene& s) {
        s.world[s.box].setPosition({0, 2 * kMaxCoordinate});
    });
    expectRefused("rotation", [](Scene& s) { s.world[s.box].setRotation({1, 1}); });
    expectRefused("rotation", [](Scene& s) { s.world[s.box].setRotation({kNan, 0}); });
    expectRefused("velocity", [](Scene& s) { s.world[s.box].setVelocity({0, kInf}); });
    expectRefused("velocity", [](Scene& s) { s.world[s.box].setVelocity({Real(1e8), 0}); });
    expectRefused("angularVelocity", [](Scene& s) { s.world[s.box].setAngularVelocity(kNan); });
    expectRefused("material.restitution",
                  [](Scene& s) { s.world[s.box].setMaterial(withFriction(Real(0.5), 3)); });
    expectRefused("material.kineticFriction",
                  [](Scene& s) { s.world[s.box].setMaterial(withFriction(-1)); });
}

TEST(BadNumber, MoveToRefusesInvalidNumbers) {
    expectRefused("position", [](Scene& s) { s.world[s.box].moveTo({kNan, 0}, support::kDt); });
    expectRefused("rotation", [](Scene& s) { s.world[s.box].moveTo({}, Rot{5, 0}, support::kDt); });
    expectRefused("dt", [](Scene& s) { s.world[s.box].moveTo({}, 0); });
    expectRefused("position", [](Scene& s) { s.world[s.box].moveTo({1000, 0}, Real(1e-6)); });
    expectRefused("rotation", [](Scene& s) {
        s.world[s.box].moveTo(s.world[s.box].position(), Rot{-1, 0}, kMinTimeStep);
    });
}

TEST(BadNumber, ForcesAndImpulsesRefuseInvalidNumbers) {
    expectRefused("force", [](Scene& s) { s.world[s.box].applyForce({kNan, 0}); });
    expectRefused("force", [](Scene& s) { s.world[s.box].applyForce({kInf, 0}, {}); });
    expectRefused("point", [](Scene& s) { s.world[s.box].applyForce({1, 0}, {kNan, 0}); });
    expectRefused("torque", [](Scene& s) { s.world[s.box].applyTorque(kInf); });
    expectRefused("impulse", [](Scene& s) { s.world[s.box].applyImpulse({kNan, 0}); });
    expectRefused("point", [](Scene& s) { s.world[s.box].applyImpulse({1, 0}, {0, kInf}); });
    expectRefused("velocity after the impulse", [](Scene& s) {
        s.world[s.box].applyImpulse({Real(1e9), 0});
    });
}

TEST(BadNumber, CloneAndWeldRefuseInvalidArguments) {
    expectRefused("position", [](Scene& s) { s.world.clone(s.box, {kNan, 0}); });
    expectRefused("part", [](Scene& s) { s.world.weld(s.box, s.box); });
}

struct BadWorld {
    const char* field;
    std::function<void(WorldDef&)> spoil;
};

const BadWorld kBadWorlds[] = {
    {"gravity", [](WorldDef& d) { d.gravity.x = kNan; }},
    {"gravity", [](WorldDef& d) { d.gravity.y = kInf; }},
    {"lengthUnit", [](WorldDef& d) { d.lengthUnit = 0; }},
    {"lengthUnit", [](WorldDef& d) { d.lengthUnit = -1; }},
    {"lengthUnit", [](WorldDef& d) { d.lengthUnit = kNan; }},
    {"settings.substeps", [](WorldDef& d) { d.settings.soft().substeps = 0; }},
    {"settings.substeps", [](WorldDef& d) { d.settings.soft().substeps = 65; }},
    {"settings.impactPasses", [](WorldDef& d) { d.settings.soft().impactPasses = -1; }},
    {"settings.contactHertz", [](WorldDef& d) { d.settings.soft().contactHertz = 0; }},
    {"settings.contactHertz", [](WorldDef& d) { d.settings.soft().contactHertz = kNan; }},
    {"settings.contactDamping", [](WorldDef& d) { d.settings.soft().contactDamping = -1; }},
    {"settings.jointGap", [](WorldDef& d) { d.settings.soft().jointGap = kInf; }},
    {"settings.pushSpeed", [](WorldDef& d) { d.settings.soft().pushSpeed = kInf; }},
};

TEST(BadNumber, AWorldRefusesABadDefinition) {
    for (const BadWorld& bad : kBadWorlds) {
        SCOPED_TRACE(bad.field);
        WorldDef def;
        bad.spoil(def);
        const auto problem = check(def);
        ASSERT_TRUE(problem.has_value());
        EXPECT_EQ(problem->field, bad.field);
        try {
            const World world(def);
            ADD_FAILURE() << "not refused";
        } catch (const BadDefinition& error) {
            EXPECT_EQ(error.problem().text(), problem->text());
        }
    }
}

TEST(BadNumber, SetSettingsRefusesAndKeepsTheOldSettings) {
    for (const BadWorld& bad : kBadWorlds) {
        WorldDef def;
        bad.spoil(def);
        if (check(def.settings).has_value()) {
            Scene scene;
            const StepSettings before = scene.world.settings();
            EXPECT_THROW(scene.world.setSettings(def.settings), BadDefinition);
            EXPECT_EQ(scene.world.settings(), before);
        }
    }
}

} // namespace
} // namespace kodo
