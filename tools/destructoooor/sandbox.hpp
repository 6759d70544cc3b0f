// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace destructoooor {

enum class Scene : std::uint8_t { Ground, Tower, Pyramid, Pit };
inline constexpr std::array<std::string_view, 4> kSceneNames = {"Ground", "Tower", "Pyramid",
                                                                "Pit"};

/// What can be dropped.
enum class Primitive : std::uint8_t { Box, Circle, Polygon, Plank };
inline constexpr std::array<std::string_view, 4> kPrimitiveNames = {"box", "circle", "polygon",
                                                                    "plank"};

inline constexpr kodo::Real kStepSeconds = kodo::Real(1) / 60;

/// What the solver leaves to be desired, as numbers.
struct Measures {
    kodo::Real deepest = 0; // m; the worst overlap of the last step
    kodo::Real highest = 0; // m; top of the highest body, the ground lying at 0
    kodo::Real fastest = 0; // m/s
    std::size_t bodies = 0;
    std::size_t resting = 0;
    std::size_t contacts = 0;
    std::size_t visits = 0; // of contacts by the solver: its cost, free of any clock
};

/// The world of the demo, without a window: four scenes into which things are dropped while every
/// number of the integration can be changed [Thesis06, Appendix A].
class Sandbox {
public:
    Sandbox();

    /// The scene anew, with the settings as they are.
    void restart(Scene scene);
    Scene scene() const { return scene_; }

    void drop(Primitive what, kodo::Vec2 place, kodo::Real size);
    /// Pushes everything near the place away from it.
    void burst(kodo::Vec2 place);
    void step();

    const kodo::World& world() const { return world_; }
    const kodo::StepSettings& settings() const { return settings_; }
    void setSettings(const kodo::StepSettings& settings);
    kodo::Real gravity() const { return gravity_; } // m/s^2, downwards
    void setGravity(kodo::Real gravity);
    kodo::Real friction() const { return friction_; } // of everything
    kodo::Real restitution() const { return restitution_; }
    void setMaterial(kodo::Real friction, kodo::Real restitution);

    Measures measures() const;

private:
    void takeOutLost();

    Scene scene_ = Scene::Ground;
    kodo::World world_;
    kodo::StepSettings settings_;
    kodo::Real gravity_ = 10;
    kodo::Real friction_ = kodo::Real(0.6);
    kodo::Real restitution_ = 0;
    std::uint64_t drops_ = 0; // so that no two polygons are alike
};

} // namespace destructoooor
