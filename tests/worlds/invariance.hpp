// SPDX-License-Identifier: MIT
#pragma once

#include <worlds/ordinary.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>

/// Changes of a world that must not change its outcome. No figure is needed to judge that.
namespace worlds {

enum class Invariance {
    Boost,  // a velocity is added to all bodies; static ones become kinematic
    Mirror, // x becomes -x
    AtRest, // static bodies become kinematic ones without velocity
    Order,  // bodies and joints are added in the opposite order
    Length, // lengths and the length unit are four times as large: equal bits
    Mass,   // masses, forces and torques are eight times as large: equal bits
    Heavy,  // a kinematic body becomes a dynamic one of a million times the density
};
inline constexpr std::array kInvariances{Invariance::Boost, Invariance::Mirror, Invariance::AtRest,
                                         Invariance::Order, Invariance::Length, Invariance::Mass,
                                         Invariance::Heavy};
const char* nameOf(Invariance invariance);

/// The changed recipe, and how its motions correspond to those of the original.
struct Changed {
    Recipe recipe;
    Invariance invariance{};
    kodo::BasicVec2<double> boost{};   // m/s
    std::vector<std::size_t> places{}; // in the changed recipe, by index in the original

    /// The motion of a body of the original, from that of the changed world at a time (s).
    Motion original(const OrdinaryEngine& changed, std::size_t body, double time) const;
};
/// Nothing if the recipe has what the change would affect: air, a target that is fixed in the
/// world, parts whose masses scale differently.
std::optional<Changed> changed(const Recipe& recipe, Invariance invariance);

/// A recipe for invariances: for an even seed bodies in the way of one that moves by itself,
/// without gravity; for an odd one a random world, without air, events and sleep.
Recipe invarianceRecipe(std::uint64_t seed);

/// Bits are compared where the arithmetic allows it: for powers of two, and for bodies at rest.
bool isExact(Invariance invariance);
/// The first difference from the changed world.
std::optional<Finding> compare(const Recipe& recipe, const Changed& changed);
/// The first difference, in the first step that has one. Nothing where they agree, where the
/// change does not apply, and as soon as small differences grow so much that they tell nothing.
std::optional<Finding> judgeInvariance(const Recipe& recipe, Invariance invariance);
std::optional<Finding> judgeInvariance(const Recipe& recipe, const std::string& name);
/// Of all of them.
std::vector<Finding> judgeInvariances(const Recipe& recipe);

} // namespace worlds
