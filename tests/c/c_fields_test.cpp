// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <stdexcept>

#include "c_world.hpp"

namespace {

using namespace c_test;

TEST(CFields, EachKindOfTheEngineIsThatOfCpp) {
    const CWorld world(kodo_Real(0));
    kodo::World other;
    std::array<kodo_Field, 6> fields{kodo_field(KODO_GRAVITY),   kodo_field(KODO_DRAG),
                                     kodo_field(KODO_WIND),      kodo_field(KODO_WIND),
                                     kodo_field(KODO_ATTRACTOR), kodo_field(KODO_BUOYANCY)};
    fields[0].gravity.acceleration = kodo_vec2(1, -9);
    fields[1].drag = {{1, 2}, {3, 4}};
    fields[2].wind = {{1, 2}, {3, 4}, true, {{-5, -6}, {7, 8}}};
    fields[3].wind = {{1, 2}, {3, 4}, false, {}};
    fields[4].attractor = {KODO_LINEAR, {1, 2}, 3, 4};
    fields[5].buoyancy = {1, 2, {3, 4}, {0, -10}};
    fields[5].which = {KODO_MATCH_ANY, 6, 0};
    EXPECT_OK(kodo_setFields(world, fields.data(), fields.size()));
    other.setFields(
        {{std::make_shared<kodo::Gravity>(kodo::Vec2{1, -9}), {}},
         {std::make_shared<kodo::Drag>(kodo::DragLaw{1, 2}, kodo::Vec2{3, 4}), {}},
         {std::make_shared<kodo::Wind>(kodo::DragLaw{1, 2}, kodo::Vec2{3, 4},
                                       kodo::Aabb{{-5, -6}, {7, 8}}),
          {}},
         {std::make_shared<kodo::Wind>(kodo::DragLaw{1, 2}, kodo::Vec2{3, 4}), {}},
         {std::make_shared<kodo::Attractor>(kodo::Attractor::Law::Linear, kodo::Vec2{1, 2},
                                            kodo::Real(3), kodo::Real(4)),
          {}},
         {std::make_shared<kodo::Buoyancy>(kodo::Buoyancy::Fluid{1, 2}, kodo::Vec2{3, 4},
                                           kodo::Vec2{0, -10}),
          {kodo::kMatchAny, 6}}});
    EXPECT_EQ(other.stateHash(), world.hash());

    std::array<kodo_Field, 6> read{};
    std::size_t count = 0;
    EXPECT_OK(kodo_fields(world, read.data(), read.size(), &count));
    ASSERT_EQ(6u, count);
    const CWorld again(kodo_Real(0));
    for (const kodo_Field& field : read) {
        EXPECT_OK(kodo_addField(again, &field));
    }
    EXPECT_EQ(world.hash(), again.hash());
}

/// Context of a field of the user: pulls to the left, and counts.
struct Pull {
    int calls = 0;
    int ends = 0;
    kodo_BodyState last{};

    static void at(void* context, const kodo_FieldBody* body, kodo_Real, kodo_FieldForce* force) {
        ++static_cast<Pull*>(context)->calls;
        force->force.x = -2 * body->mass - body->velocity.x;
        force->torque = body->inertia;
        force->drag = 1;
        force->spinDrag = kodo_Real(0.5);
    }
    static void end(void* context) { ++static_cast<Pull*>(context)->ends; }

    kodo_Field field() {
        kodo_Field made = kodo_field(KODO_OWN_FIELD);
        made.own = {&Pull::at, &Pull::end, this, false};
        return made;
    }
};

/// The same field as a class of C++.
class CppPull final : public kodo::ForceField {
    kodo::FieldForce at(const kodo::BodyView& body, kodo::Real) const override {
        return {{-2 * body.mass() - body.velocity().x, 0}, body.inertia(), 1, kodo::Real(0.5)};
    }
};

TEST(CFields, AFieldOfTheUserMovesBodiesAsInCpp) {
    Pull pull;
    const CWorld world;
    world.add(bodyAt(0, 0));
    const kodo_Field field = pull.field();
    EXPECT_OK(kodo_addField(world, &field));
    world.step(30);
    kodo::World other = cppWorld();
    other.add({});
    other.addField({std::make_shared<CppPull>(), {}});
    for (int i = 0; i < 30; ++i) {
        other.step(kodo::Real(1) / 60);
    }
    EXPECT_EQ(30, pull.calls);
    EXPECT_EQ(other.stateHash(), world.hash());
}

TEST(CFields, TheContextEndsWithTheLastWorldThatHasTheField) {
    Pull pull;
    {
        const CWorld world;
        const kodo_Field field = pull.field();
        EXPECT_OK(kodo_addField(world, &field));
        const CWorld copy(world);
        EXPECT_OK(kodo_setFields(world, nullptr, 0));
        EXPECT_EQ(0, pull.ends);
    }
    EXPECT_EQ(1, pull.ends);
}

TEST(CFields, AFieldThatIsReadAndSetAgainIsTheSameField) {
    Pull pull;
    {
        const CWorld world;
        kodo_Field field = pull.field();
        EXPECT_OK(kodo_addField(world, &field));
        std::array<kodo_Field, 2> read{};
        std::size_t count = 0;
        EXPECT_OK(kodo_fields(world, read.data(), read.size(), &count));
        ASSERT_EQ(2u, count);
        EXPECT_EQ(&pull, read[1].own.context);
        EXPECT_OK(kodo_setFields(world, read.data(), read.size()));
        EXPECT_EQ(0, pull.ends);
    }
    EXPECT_EQ(1, pull.ends);
}

TEST(CFields, ARefusedFieldLeavesItsContextToTheCaller) {
    Pull pull;
    {
        const CWorld world;
        kodo_Field field = pull.field();
        field.which.required = 1; // without a match mode
        EXPECT_EQ(KODO_BAD_DEFINITION, kodo_addField(world, &field));
    }
    EXPECT_EQ(0, pull.ends);
}

TEST(CFields, AnExceptionOfAFieldIsReportedAndTheWorldGoesOn) {
    const CWorld world;
    const kodo_BodyId ball = world.add(bodyAt(0, 0));
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    bool throws = true;
    field.own.context = &throws;
    field.own.at = [](void* context, const kodo_FieldBody*, kodo_Real, kodo_FieldForce*) {
        if (*static_cast<bool*>(context)) {
            throw std::runtime_error("the field is out of order");
        }
    };
    EXPECT_OK(kodo_addField(world, &field));
    EXPECT_EQ(KODO_OTHER_ERROR, kodo_step(world, kodo_Real(1) / 60, nullptr));
    EXPECT_STREQ("the field is out of order", kodo_errorText());
    EXPECT_LT(world.state(ball).velocity.y, 0); // gravity acted
    throws = false;
    world.step();
}

TEST(CFields, AnExceptionAtTheEndOfAFieldStaysInside) {
    kodo_Field field = kodo_field(KODO_OWN_FIELD);
    field.own.at = [](void*, const kodo_FieldBody*, kodo_Real, kodo_FieldForce*) {};
    field.own.destroy = [](void*) { throw 1; };
    const CWorld world;
    EXPECT_OK(kodo_addField(world, &field));
    EXPECT_OK(kodo_setFields(world, nullptr, 0));
}

TEST(CFields, ForcesOnAllBodiesAreThoseOfCpp) {
    const CWorld world;
    world.add(bodyAt(0, 0));
    kodo::World other = cppWorld();
    other.add({});
    const kodo_Filter all{};
    EXPECT_OK(kodo_applyForceToAll(world, kodo_vec2(1, 2), nullptr));
    EXPECT_OK(kodo_applyTorqueToAll(world, 3, &all));
    other.applyForceToAll({1, 2});
    other.applyTorqueToAll(3);
    world.step();
    other.step(kodo::Real(1) / 60);
    EXPECT_EQ(other.stateHash(), world.hash());
}

} // namespace
