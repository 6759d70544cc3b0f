// SPDX-License-Identifier: MIT
// D2: force fields with numbers that no World can use.
#include <support/scenes.hpp>

#include <memory>
#include <string>

namespace kodo {
namespace {

using support::kInf;
using support::kNan;

constexpr Attractor::Law kInverse = Attractor::Law::InverseSquare;

struct BadField {
    std::string names; // the field of the Problem
    std::shared_ptr<const ForceField> field;
};

std::vector<BadField> badFields() {
    const auto water = [](Real density, Real drag) { return Buoyancy::Fluid{density, drag}; };
    return {
        {"field.acceleration", std::make_shared<Gravity>(Vec2{0, kNan})},
        {"field.acceleration", std::make_shared<Gravity>(Vec2{kInf, 0})},
        {"field.acceleration", std::make_shared<Gravity>(Vec2{0, -2 * kMaxSpeed})},
        {"field.linear", std::make_shared<Drag>(DragLaw{-1, 0})},
        {"field.linear", std::make_shared<Drag>(DragLaw{kNan, 0})},
        {"field.quadratic", std::make_shared<Drag>(DragLaw{0, -Real(0.1)})},
        {"field.quadratic", std::make_shared<Drag>(DragLaw{0, kInf})},
        {"field.air", std::make_shared<Drag>(DragLaw{1, 0}, Vec2{kNan, 0})},
        {"field.linear", std::make_shared<Wind>(DragLaw{-1, 0}, Vec2{})},
        {"field.air", std::make_shared<Wind>(DragLaw{1, 0}, Vec2{0, kInf})},
        {"field.region", std::make_shared<Wind>(DragLaw{1, 0}, Vec2{}, Aabb{{1, 0}, {0, 1}})},
        {"field.region", std::make_shared<Wind>(DragLaw{1, 0}, Vec2{}, Aabb{{kNan, 0}, {0, 1}})},
        {"field.center", std::make_shared<Attractor>(kInverse, Vec2{kNan, 0}, Real(1))},
        {"field.strength", std::make_shared<Attractor>(kInverse, Vec2{}, kInf)},
        {"field.softening", std::make_shared<Attractor>(kInverse, Vec2{}, Real(1), Real(-1))},
        {"field.density", std::make_shared<Buoyancy>(water(-1, 0), Vec2{}, Vec2{0, -10})},
        {"field.drag", std::make_shared<Buoyancy>(water(1, kNan), Vec2{}, Vec2{0, -10})},
        {"field.surface", std::make_shared<Buoyancy>(water(1, 0), Vec2{0, kNan}, Vec2{0, -10})},
        {"field.gravity", std::make_shared<Buoyancy>(water(1, 0), Vec2{}, Vec2{})},
        {"field.gravity", std::make_shared<Buoyancy>(water(1, 0), Vec2{}, Vec2{0, kInf})},
    };
}

template <typename Call>
void expectRefused(const BadField& bad, Call call) {
    try {
        call();
        ADD_FAILURE() << bad.names << " is accepted";
    } catch (const BadDefinition& error) {
        EXPECT_EQ(error.problem().field, bad.names) << error.what();
    }
}

TEST(BadField, IsRefusedByNameAndChangesNothing) {
    World world({.gravity = support::kEarth});
    world.add(support::ballDef({}, 1));
    const auto before = world.fields().size();
    const std::uint64_t hash = world.stateHash();
    for (const BadField& bad : badFields()) {
        expectRefused(bad, [&] { world.addField({bad.field}); });
        expectRefused(bad, [&] { world.setFields({world.fields()[0], {bad.field}}); });
    }
    EXPECT_EQ(world.fields().size(), before);
    EXPECT_EQ(world.stateHash(), hash);
}

} // namespace
} // namespace kodo
