// SPDX-License-Identifier: MIT
// Compiled with -fno-rtti: the virtual table of Lift names no type.
#include "no_rtti_field.hpp"

namespace kodo {
namespace {

class Lift final : public ForceField {
public:
    FieldForce at(const BodyView& body, Real) const override { return {{0, body.mass()}}; }
};

} // namespace

std::shared_ptr<const ForceField> fieldWithoutRtti() {
    return std::make_shared<Lift>();
}

std::shared_ptr<const ForceField> gravityWithoutRtti() {
    return std::make_shared<Gravity>(Vec2{0, 1});
}

} // namespace kodo
