// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <gtest/gtest.h>

#include <string>

namespace field {
namespace {

using kodo::BodyId;
using kodo::BodyType;
using kodo::Real;
using kodo::Vec2;
using kodo::World;

inline constexpr Real kDt = Real(1) / 60; // s
inline constexpr kodo::Material kElastic{
    .staticFriction = 0, .kineticFriction = 0, .restitution = 1};

inline World underGravity() {
    return World({.gravity = {0, -10}});
}

inline void run(World& world, Real seconds) {
    for (Real t = 0; t < seconds - kDt / 2; t += kDt) {
        world.step(kDt);
    }
}

/// A static box of 40 by 2 m with its top at y = 0.
inline BodyId addGround(World& world, const kodo::Material& material = {}) {
    return world.add({.shape = kodo::Box{40, 2},
                      .position = {0, -1},
                      .material = material,
                      .type = BodyType::Static});
}

/// A unit box that has fallen asleep on the ground, or what lies there.
inline BodyId addSleepingBox(World& world, Vec2 position = {0, Real(0.5)}) {
    const BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = position});
    run(world, 3);
    return box;
}

/// A solver and a rate of steps.
struct Setting {
    kodo::StepSettings settings;
    Real dt = 0; // s
    bool thesis = false;

    World world(Vec2 gravity = {0, -10}) const {
        return World({.gravity = gravity, .settings = settings});
    }
    void run(World& world, Real seconds) const {
        for (Real t = 0; t < seconds - dt / 2; t += dt) {
            world.step(dt);
        }
    }
};

/// Runs a test in both solvers at 30, 60 and 240 Hz.
template <typename Test>
void inAllSettings(Test test) {
    for (const bool thesis : {false, true}) {
        for (const int rate : {30, 60, 240}) {
            SCOPED_TRACE((thesis ? "thesis, Hz: " : "soft, Hz: ") + std::to_string(rate));
            test(Setting{thesis ? kodo::thesis2006() : kodo::balanced(),
                         1 / static_cast<Real>(rate), thesis});
        }
    }
}

} // namespace
} // namespace field
