// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace destructoooor {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;
using Ids = std::vector<BodyId>;

inline constexpr Real kStepSeconds = Real(1) / 60;

/// A scene of the sandbox: a question, what one expects to see, and a judge of it.
struct Scene {
    std::string_view group;
    std::string_view name;
    std::string_view question;
    std::string_view expectation;
    /// Fills a World that has gravity and settings; returns the bodies that holds() looks at.
    Ids (*build)(kodo::World& world);
    Real seconds; // after which holds() is true, if nothing was touched
    bool (*holds)(const kodo::World& world, const Ids& ids);

    Vec2 gravity{0, -10};                                 // m/s^2
    kodo::Aabb view{{-13, Real(-1.5)}, {13, Real(14.5)}}; // m, what the window shows at first
    kodo::StepSettings settings = kodo::balanced();
    /// Called before each step with its number, from 0 on; may be null.
    void (*act)(kodo::World& world, const Ids& ids, std::uint64_t tick) = nullptr;
};

/// All scenes, group by group.
std::span<const Scene> catalogue();

/// A World with a scene in it.
struct Staged {
    kodo::World world;
    Ids ids;
};
Staged stage(const Scene& scene, const kodo::StepSettings& settings);
inline Staged stage(const Scene& scene) {
    return stage(scene, scene.settings);
}

// The scenes of each file, in the order of the catalogue.
std::span<const Scene> stackingScenes();  // stacking, mass ratio
std::span<const Scene> surfaceScenes();   // friction, restitution
std::span<const Scene> jointScenes();     // joints
std::span<const Scene> machineScenes();   // machines, vehicles, characters
std::span<const Scene> geometryScenes();  // continuous collision, compounds, ground
std::span<const Scene> fieldScenes();     // sensors and filters, fields, water
std::span<const Scene> principleScenes(); // chaos, rollback, thesis

} // namespace destructoooor
