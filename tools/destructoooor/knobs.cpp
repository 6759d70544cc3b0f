// SPDX-License-Identifier: MIT
#include "knobs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace destructoooor {

using kodo::Real;
using kodo::StepSettings;

namespace {

/// A knob for one number of the settings.
template <typename T>
Knob settingsKnob(std::string label, T StepSettings::*number, double low, double high,
                  double stride) {
    return {
        .label = std::move(label),
        .low = low,
        .high = high,
        .stride = stride,
        .value =
            [number](const Sandbox& box) { return static_cast<double>(box.settings().*number); },
        .set =
            [number](Sandbox& box, double value) {
                StepSettings settings = box.settings();
                settings.*number = static_cast<T>(value);
                box.setSettings(settings);
            }};
}

Knob featureKnob(std::string label, kodo::Feature feature) {
    return {.label = std::move(label),
            .value = [feature](const Sandbox& box) { return box.settings().has(feature) ? 1 : 0; },
            .set =
                [feature](Sandbox& box, double value) {
                    StepSettings settings = box.settings();
                    const auto bit = static_cast<unsigned>(feature);
                    const unsigned others = settings.leaveOut & ~bit;
                    settings.leaveOut =
                        static_cast<std::uint8_t>(value > 0 ? others : others | bit);
                    box.setSettings(settings);
                },
            .words = {"off", "on"}};
}

Knob strategyKnob() {
    return {.label = "solver",
            .value =
                [](const Sandbox& box) {
                    return box.settings().strategy == kodo::Strategy::Propagation ? 0 : 1;
                },
            .set =
                [](Sandbox& box, double value) {
                    StepSettings settings = box.settings();
                    settings.strategy =
                        value > 0 ? kodo::Strategy::SoftStep : kodo::Strategy::Propagation;
                    box.setSettings(settings);
                },
            .words = {"propagation", "soft step"}};
}

} // namespace

std::vector<Knob> makeKnobs() {
    return {
        strategyKnob(),
        settingsKnob("substeps", &StepSettings::substeps, 1, 16, 1),
        settingsKnob("collision iterations", &StepSettings::impactPasses, 0, 40, 1),
        settingsKnob("rest iterations", &StepSettings::contactPasses, 1, 60, 1),
        settingsKnob("shock propagation", &StepSettings::shockPasses, 0, 10, 1),
        settingsKnob("contact stiffness, Hz", &StepSettings::contactHertz, 5, 240, 5),
        settingsKnob("contact damping", &StepSettings::contactDamping, 0.5, 20, 0.5),
        settingsKnob("push speed, m/s", &StepSettings::pushSpeed, 0.5, 10, 0.5),
        settingsKnob("steps until rest", &StepSettings::restSteps, 1, 120, 1),
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
        featureKnob("resting", kodo::Feature::Resting),
        featureKnob("rotation", kodo::Feature::Rotation),
        featureKnob("sweep", kodo::Feature::Sweep),
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
