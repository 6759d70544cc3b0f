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

/// Shapes that can be dropped.
enum class Primitive : std::uint8_t { Box, Circle, Polygon, Plank };
inline constexpr std::array<std::string_view, 4> kPrimitiveNames = {"box", "circle", "polygon",
                                                                    "plank"};

inline constexpr kodo::Real kStepSeconds = kodo::Real(1) / 60;

/// Quality and cost of the last step.
struct Measures {
    kodo::Real maxOverlap = 0; // m, largest overlap
    kodo::Real highest = 0;    // m, top of the highest body; the ground is at 0
    kodo::Real fastest = 0;    // m/s
    std::size_t bodies = 0;    // dynamic ones
    std::size_t asleep = 0;    // sleeping ones
    std::size_t contacts = 0;
    std::size_t visits = 0; // of contacts by the solver: cost without a clock
};

/// The world of the demo, without a window: four scenes for dropped bodies. Every parameter of the
/// simulation can change between steps [Thesis06, Appendix A].
class Sandbox {
public:
    Sandbox();

    /// Rebuilds a scene with the present settings.
    void restart(Scene scene);
    Scene scene() const { return scene_; }

    void drop(Primitive what, kodo::Vec2 place, kodo::Real size);
    /// Applies impulses away from the place to all dynamic bodies near it.
    void burst(kodo::Vec2 place);
    void step();

    const kodo::World& world() const { return world_; }
    const kodo::StepSettings& settings() const { return settings_; }
    void setSettings(const kodo::StepSettings& settings);
    kodo::Real gravity() const { return gravity_; } // m/s^2, downwards
    void setGravity(kodo::Real gravity);
    kodo::Real friction() const { return friction_; } // of all bodies
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
    std::uint64_t drops_ = 0; // seed of the next random polygon
};

} // namespace destructoooor
