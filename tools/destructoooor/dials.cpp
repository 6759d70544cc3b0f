// SPDX-License-Identifier: MIT
#include "dials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>

namespace destructoooor {

using kodo::StepSettings;

namespace {

using Soft = kodo::SoftSettings;
using Propagation = kodo::PropagationSettings;

constexpr std::string_view kSolver = "Solver";
constexpr std::string_view kFeatures = "Features";
constexpr std::string_view kWorld = "World";

/// A dial for one number of the settings. find(settings) returns a pointer to it, or nullptr if the
/// present solver has no such number.
template <typename Find>
Dial settingsDial(Dial dial, Find find) {
    dial.group = kSolver;
    dial.value = [find, low = dial.low](const Sandbox& box) {
        StepSettings settings = box.settings();
        const auto* const number = find(settings);
        return number != nullptr ? static_cast<double>(*number) : low;
    };
    dial.set = [find](Sandbox& box, double value) {
        StepSettings settings = box.settings();
        if (auto* const number = find(settings)) {
            *number = static_cast<std::remove_reference_t<decltype(*number)>>(value);
            box.setSettings(settings);
        }
    };
    dial.shown = [find](const Sandbox& box) {
        StepSettings settings = box.settings();
        return find(settings) != nullptr;
    };
    return dial;
}

/// Finds a number that both solvers have.
template <auto soft, auto propagation>
auto* ofBoth(StepSettings& settings) {
    auto* const own = std::get_if<Soft>(&settings.solver);
    return own != nullptr ? &(own->*soft) : &(settings.propagation().*propagation);
}
/// Finds a number of one solver; nullptr with the other one.
template <typename Solver, auto member>
auto* ofOne(StepSettings& settings) {
    auto* const own = std::get_if<Solver>(&settings.solver);
    return own != nullptr ? &(own->*member) : nullptr;
}

Dial featureDial(std::string_view name, std::string_view what, std::string_view price,
                 kodo::Feature feature) {
    return {.group = kFeatures,
            .name = name,
            .what = what,
            .price = price,
            .value = [feature](const Sandbox& box) { return box.settings().has(feature) ? 1 : 0; },
            .set =
                [feature](Sandbox& box, double value) {
                    StepSettings settings = box.settings();
                    settings.leaveOut |= feature;
                    if (value > 0) {
                        settings.leaveOut.bits ^= kodo::Features(feature).bits;
                    }
                    box.setSettings(settings);
                },
            .words = {"off", "on"}};
}

Dial solverDial() {
    return {.group = kSolver,
            .name = "solver",
            .what =
                "soft: substeps of soft contacts. propagation: the solver of the thesis of 2006.",
            .price = "Compare times and overlap below.",
            .value =
                [](const Sandbox& box) {
                    return std::holds_alternative<Soft>(box.settings().solver) ? 0 : 1;
                },
            .set =
                [](Sandbox& box, double value) {
                    box.setSettings(value > 0 ? kodo::thesis2006() : kodo::balanced());
                },
            .words = {"soft", "propagation"}};
}

template <typename Get, typename Set>
Dial worldDial(Dial dial, Get get, Set set) {
    dial.group = kWorld;
    dial.value = [get](const Sandbox& box) { return static_cast<double>(get(box)); };
    dial.set = [set](Sandbox& box, double value) { set(box, static_cast<Real>(value)); };
    return dial;
}

std::vector<Dial> solverDials() {
    return {
        solverDial(),
        settingsDial(
            {.name = "substeps",
             .what = "Parts of a step. More: stiffer stacks and joints, larger mass ratios.",
             .price = "Visits of contacts are in proportion to it.",
             .low = 1,
             .high = 32},
            ofBoth<&Soft::substeps, &Propagation::substeps>),
        settingsDial({.name = "impactPasses",
                      .what = "Passes over impacts with restitution, through touching bodies.",
                      .price = "Only where bodies with restitution meet.",
                      .low = 0,
                      .high = 64},
                     ofBoth<&Soft::impactPasses, &Propagation::impactPasses>),
        settingsDial({.name = "contactPasses",
                      .what = "Passes over contacts. More: less overlap.",
                      .price = "Visits of contacts are in proportion to it.",
                      .low = 1,
                      .high = 60},
                     ofOne<Propagation, &Propagation::contactPasses>),
        settingsDial({.name = "shockPasses",
                      .what = "Passes level by level, from the ground up: carries any mass ratio.",
                      .price = "Each visits the contacts of all levels once more.",
                      .low = 0,
                      .high = 10},
                     ofOne<Propagation, &Propagation::shockPasses>),
        settingsDial({.name = "contactHertz",
                      .what = "Stiffness of contacts. Lower: softer piles, gentler pushing out.",
                      .low = 5,
                      .high = 240,
                      .stride = 5},
                     ofOne<Soft, &Soft::contactHertz>),
        settingsDial({.name = "contactDamping",
                      .what = "Damping ratio of contacts; 1 is critical.",
                      .low = 0.5,
                      .high = 20,
                      .stride = 0.5},
                     ofOne<Soft, &Soft::contactDamping>),
        settingsDial({.name = "jointHertz",
                      .what = "Stiffness of joints in loops.",
                      .low = 5,
                      .high = 240,
                      .stride = 5},
                     ofBoth<&Soft::jointHertz, &Propagation::jointHertz>),
        settingsDial({.name = "jointDamping",
                      .what = "Damping ratio of joints in loops.",
                      .low = 0.5,
                      .high = 10,
                      .stride = 0.5},
                     ofBoth<&Soft::jointDamping, &Propagation::jointDamping>),
        settingsDial({.name = "jointGap",
                      .what = "How far loaded joints may open, as a share of the smaller body.",
                      .price = "Smaller: loaded joints take more substeps, and more direct solves.",
                      .low = 0.01,
                      .high = 1,
                      .stride = 0.01},
                     ofOne<Soft, &Soft::jointGap>),
        settingsDial({.name = "pushSpeed",
                      .what = "Largest speed (m/s) that separates bodies in overlap.",
                      .low = 0.5,
                      .high = 10,
                      .stride = 0.5},
                     ofBoth<&Soft::pushSpeed, &Propagation::pushSpeed>),
        settingsDial({.name = "sleepSteps",
                      .what = "Calm steps in a row before an island falls asleep.",
                      .low = 1,
                      .high = 120},
                     [](StepSettings& settings) { return &settings.sleepSteps; }),
    };
}

std::vector<Dial> worldDials() {
    return {
        worldDial(
            {.name = "gravity", .what = "Gravity (m/s^2), downwards.", .low = -10, .high = 40},
            [](const Sandbox& box) { return box.gravity(); },
            [](Sandbox& box, Real value) { box.setGravity(value); }),
        worldDial(
            {.name = "wind",
             .what = "Speed of the air (m/s), to the right; it drags bodies.",
             .low = -20,
             .high = 20},
            [](const Sandbox& box) { return box.wind(); },
            [](Sandbox& box, Real value) { box.setWind(value); }),
        worldDial(
            {.name = "water",
             .what = "Height of the surface of water (m); its density is 2 kg/m^2.",
             .low = static_cast<double>(Sandbox::kNoWater),
             .high = 12,
             .stride = 0.5,
             .lowest = "none"},
            [](const Sandbox& box) { return box.waterLevel(); },
            [](Sandbox& box, Real value) { box.setWaterLevel(value); }),
        worldDial(
            {.name = "friction",
             .what = "Friction of all bodies, once this dial is moved.",
             .high = 1,
             .stride = 0.05},
            [](const Sandbox& box) { return box.friction(); },
            [](Sandbox& box, Real value) { box.setMaterial(value, box.restitution()); }),
        worldDial(
            {.name = "restitution",
             .what = "Restitution of all bodies, once this dial is moved.",
             .high = 1,
             .stride = 0.05},
            [](const Sandbox& box) { return box.restitution(); },
            [](Sandbox& box, Real value) { box.setMaterial(box.friction(), value); }),
    };
}

std::vector<Dial> featureDials() {
    using kodo::Feature;
    return {
        featureDial("Friction", "Without friction all surfaces are ice.", "", Feature::Friction),
        featureDial("Restitution", "Without restitution nothing bounces.",
                    "A tenth to a fifth of a step in a crowd.", Feature::Restitution),
        featureDial("RollingResistance",
                    "Rolling resistance brakes what rolls, where a material says so.", "",
                    Feature::RollingResistance),
        featureDial("Rotation", "Without rotation nothing turns.",
                    "About half of a step where bodies tumble.", Feature::Rotation),
        featureDial(
            "ContinuousCollision", "Without continuous collision fast bodies pass thin walls.",
            "Up to an eighth of a step where bodies are fast.", Feature::ContinuousCollision),
        featureDial("Sleep", "Sleep lets calm islands rest until something wakes them.", "",
                    Feature::Sleep),
    };
}

} // namespace

const std::vector<Dial>& dials() {
    static const std::vector<Dial> all = [] {
        std::vector<Dial> list;
        for (const auto make : {solverDials, worldDials, featureDials}) {
            const std::vector<Dial> part = make();
            list.insert(list.end(), part.begin(), part.end());
        }
        return list;
    }();
    return all;
}

std::span<const Profile> profiles() {
    static const std::array<Profile, 4> kProfiles = {{{"fast", kodo::fast()},
                                                      {"balanced", kodo::balanced()},
                                                      {"accurate", kodo::accurate()},
                                                      {"thesis2006", kodo::thesis2006()}}};
    return kProfiles;
}

double snapped(const Dial& dial, double value) {
    const double steps = std::round((value - dial.low) / dial.stride);
    return std::clamp(dial.low + steps * dial.stride, dial.low, dial.high);
}

} // namespace destructoooor
