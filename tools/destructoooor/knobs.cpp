// SPDX-License-Identifier: MIT
#include "knobs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <variant>

namespace destructoooor {

using kodo::Real;
using kodo::StepSettings;

namespace {

/// A knob for one value of the settings. find(settings) returns a pointer to it, or nullptr if the
/// present solver has no such value.
template <typename Find>
Knob settingsKnob(std::string label, Find find, double low, double high, double stride) {
    return {.label = std::move(label),
            .low = low,
            .high = high,
            .stride = stride,
            .value =
                [find, low](const Sandbox& box) {
                    StepSettings settings = box.settings();
                    const auto* const number = find(settings);
                    return number != nullptr ? static_cast<double>(*number) : low;
                },
            .set =
                [find](Sandbox& box, double value) {
                    StepSettings settings = box.settings();
                    if (auto* const number = find(settings)) {
                        *number = static_cast<std::remove_reference_t<decltype(*number)>>(value);
                        box.setSettings(settings);
                    }
                }};
}

/// Finds a value that both solvers have.
template <auto soft, auto propagation>
auto* ofBoth(StepSettings& settings) {
    auto* const own = std::get_if<kodo::SoftSettings>(&settings.solver);
    return own != nullptr ? &(own->*soft) : &(settings.propagation().*propagation);
}
/// Finds a value of one solver; nullptr with the other one.
template <typename Solver, auto member>
auto* ofOne(StepSettings& settings) {
    auto* const own = std::get_if<Solver>(&settings.solver);
    return own != nullptr ? &(own->*member) : nullptr;
}

Knob featureKnob(std::string label, kodo::Feature feature) {
    return {.label = std::move(label),
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

Knob solverKnob() {
    return {.label = "solver",
            .value =
                [](const Sandbox& box) {
                    return std::holds_alternative<kodo::SoftSettings>(box.settings().solver) ? 1
                                                                                             : 0;
                },
            .set =
                [](Sandbox& box, double value) {
                    StepSettings settings = box.settings();
                    settings.solver = value > 0 ? decltype(settings.solver)(kodo::SoftSettings{})
                                                : kodo::PropagationSettings{};
                    box.setSettings(settings);
                },
            .words = {"propagation", "soft"}};
}

} // namespace

std::vector<Knob> makeKnobs() {
    using Soft = kodo::SoftSettings;
    using Propagation = kodo::PropagationSettings;
    return {
        solverKnob(),
        settingsKnob("substeps", ofBoth<&Soft::substeps, &Propagation::substeps>, 1, 16, 1),
        settingsKnob("collision iterations",
                     ofBoth<&Soft::impactPasses, &Propagation::impactPasses>, 0, 40, 1),
        settingsKnob("rest iterations", ofOne<Propagation, &Propagation::contactPasses>, 1, 60, 1),
        settingsKnob("shock propagation", ofOne<Propagation, &Propagation::shockPasses>, 0, 10, 1),
        settingsKnob("contact stiffness, Hz", ofOne<Soft, &Soft::contactHertz>, 5, 240, 5),
        settingsKnob("contact damping", ofOne<Soft, &Soft::contactDamping>, 0.5, 20, 0.5),
        settingsKnob("push speed, m/s", ofBoth<&Soft::pushSpeed, &Propagation::pushSpeed>, 0.5, 10,
                     0.5),
        settingsKnob(
            "steps until sleep", [](StepSettings& settings) { return &settings.sleepSteps; }, 1,
            120, 1),
        {.label = "gravity, m/s2",
         .low = 0,
         .high = 40,
         .stride = 1,
         .value = [](const Sandbox& box) { return static_cast<double>(box.gravity()); },
         .set = [](Sandbox& box, double value) { box.setGravity(static_cast<Real>(value)); }},
        {.label = "friction",
         .low = 0,
         .high = 1,
         .stride = 0.05,
         .value = [](const Sandbox& box) { return static_cast<double>(box.friction()); },
         .set = [](Sandbox& box,
                   double value) { box.setMaterial(static_cast<Real>(value), box.restitution()); }},
        {.label = "restitution",
         .low = 0,
         .high = 1,
         .stride = 0.05,
         .value = [](const Sandbox& box) { return static_cast<double>(box.restitution()); },
         .set = [](Sandbox& box,
                   double value) { box.setMaterial(box.friction(), static_cast<Real>(value)); }},
        featureKnob("sleep", kodo::Feature::Sleep),
        featureKnob("rotation", kodo::Feature::Rotation),
        featureKnob("continuous collision", kodo::Feature::ContinuousCollision),
    };
}

double snapped(const Knob& knob, double value) {
    const double steps = std::round((value - knob.low) / knob.stride);
    return std::clamp(knob.low + steps * knob.stride, knob.low, knob.high);
}

std::string valueText(const Knob& knob, const Sandbox& sandbox) {
    const double value = knob.value(sandbox);
    if (!knob.words.empty()) {
        return knob.words[static_cast<std::size_t>(value - knob.low)];
    }
    char text[32];
    std::snprintf(text, sizeof text, knob.stride < 1 ? "%.2f" : "%.0f", value);
    return text;
}

} // namespace destructoooor
