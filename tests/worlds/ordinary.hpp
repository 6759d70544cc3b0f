// SPDX-License-Identifier: MIT
#pragma once

#include <worlds/recipe.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Ordinary scenes: what users build, with joints, usual rates and mass ratios up to 100. The same
/// judges look at each engine.
namespace worlds {

inline constexpr double kOrdinarySeconds = 30; // of each scene

/// The families of scenes, in the order of the table.
std::span<const char* const> ordinaryFamilies();
/// The family of a seed; neighbouring seeds have different ones.
std::size_t ordinaryFamily(std::uint64_t seed);
/// A scene of that family. `rests` is true where friction or limits stop all motion within 30 s.
/// Throws std::logic_error if bodies overlap that could collide: that is a fault of the scene.
Recipe ordinaryRecipe(std::uint64_t seed);

inline kodo::BasicVec2<double> toDouble(kodo::Vec2 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline kodo::BasicRot<double> toDouble(kodo::Rot q) {
    return {static_cast<double>(q.c), static_cast<double>(q.s)};
}

/// The motion of a body.
struct Motion {
    kodo::BasicVec2<double> position{}; // m, world: origin of the shape
    kodo::BasicRot<double> rotation{};
    kodo::BasicVec2<double> velocity{}; // m/s, of the centre of mass
    double spin = 0;                    // rad/s
};

/// A running scene.
class OrdinaryEngine {
public:
    OrdinaryEngine() = default;
    OrdinaryEngine(const OrdinaryEngine&) = delete;
    OrdinaryEngine& operator=(const OrdinaryEngine&) = delete;
    virtual ~OrdinaryEngine() = default;
    virtual void step() = 0;
    virtual Motion motion(std::size_t body) const = 0; // by index in the recipe
};

std::unique_ptr<OrdinaryEngine> ordinaryInKodo(const Recipe& recipe);
/// False if the build has no Box2D 3.
bool hasOrdinaryBox2d3();
std::unique_ptr<OrdinaryEngine> ordinaryInBox2d3(const Recipe& recipe);

/// What happened to a scene.
struct OrdinaryRun {
    std::vector<Finding> faults; // the first one of each judge
    double seconds = 0;          // processor time of the steps
};
OrdinaryRun runOrdinary(const Recipe& recipe, OrdinaryEngine& engine);

/// The judges, in the order of the table.
std::span<const char* const> ordinaryJudges();

/// The first fault of a judge in Kodo. Nothing for a recipe that is refused,
/// or whose bodies overlap at the start.
std::optional<Finding> judgeOrdinary(const Recipe& recipe, const std::string& judge);

/// Runs scenes and prints one line for each fault, and the table.
struct OrdinaryOptions {
    std::uint64_t seed = 1;
    std::uint64_t count = 1000;
    unsigned jobs = 1;
    std::string shrunkInto{}; // folder of the faulty scenes in Kodo, as small as possible; or none
};
/// True if no fault was found in Kodo.
bool reportOrdinary(const OrdinaryOptions& options);

} // namespace worlds
