// SPDX-License-Identifier: MIT
#include <kodo/snapshot.hpp>
#include <support/scenes.hpp>

#include "bodies/no_rtti_field.hpp"

namespace kodo {
namespace {

// A field compiled without RTTI acts, and a snapshot takes it for one of the user's own.
TEST(FieldWithoutRtti, ActsAndIsOneOfTheUser) {
    World world;
    const BodyId ball = world.add({});
    const auto field = fieldWithoutRtti();
    world.addField({field});
    world.addField({gravityWithoutRtti()});
    support::run(world, 60);
    EXPECT_NEAR(world[ball].velocity().y, 2, 1e-4); // 60 steps of 1/60 s, rounded
    EXPECT_EQ(world.fields()[0].field->kind(), FieldKind::Own);
    EXPECT_EQ(world.fields()[1].field->kind(), FieldKind::Gravity);
    const World loaded = fromBytes(toBytes(world), {&field, 1});
    EXPECT_EQ(loaded.stateHash(), world.stateHash());
}

TEST(FieldKind, IsThatOfEachOwnField) {
    EXPECT_EQ(Gravity({}).kind(), FieldKind::Gravity);
    EXPECT_EQ(Drag({}).kind(), FieldKind::Drag);
    EXPECT_EQ(Wind({}, {}).kind(), FieldKind::Wind);
    EXPECT_EQ(Attractor(Attractor::Law::Linear, {}, 1).kind(), FieldKind::Attractor);
    EXPECT_EQ(Buoyancy({}, {}, {0, -1}).kind(), FieldKind::Buoyancy);
}

} // namespace
} // namespace kodo
