// SPDX-License-Identifier: MIT
// Parts of the step that are left out (4.2.2.1): what they cost, and that nothing else changes.
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <algorithm>
#include <ctime>

#include "experiment.hpp"

namespace thesis {

namespace {

using kodo::Feature;
using kodo::Real;
using kodo::World;

struct Part {
    const char* name;
    Feature feature;
};

constexpr Part kParts[] = {
    {"Friction", Feature::Friction},       {"RollingResistance", Feature::RollingResistance},
    {"Restitution", Feature::Restitution}, {"ContinuousCollision", Feature::ContinuousCollision},
    {"Records", Feature::Records},         {"Sleep", Feature::Sleep},
    {"Rotation", Feature::Rotation}};

/// Boxes that do not need the feature: frictionless, slow, without bounce, roll or turn, or never
/// calm. Restitution also applies the impulses of inelastic impacts: there they slide apart from
/// each other. Elsewhere they are poured on a heap.
World pileWithout(Feature feature, kodo::StepSettings settings, int count) {
    World world({.gravity = {0, -1}, .settings = settings});
    const bool smooth = feature == Feature::Friction || feature == Feature::Rotation;
    const bool dull = feature == Feature::Restitution || feature == Feature::ContinuousCollision;
    kodo::Material material = kodo::withFriction(smooth ? 0 : Real(0.5), dull ? 0 : Real(0.3));
    if (!smooth && feature != Feature::RollingResistance) {
        material.rollingResistance = Real(0.01);
    }
    support::addFloor(world, material);
    support::RandomNumbers random(7);
    for (int i = 0; i < count; ++i) {
        kodo::BodyDef def = support::boxDef({}, Real(0.6), Real(0.6), material);
        def.flags = feature == Feature::Rotation ? kodo::kLockRotate : 0;
        def.flags |= feature == Feature::Sleep ? kodo::kNeverSleep : 0;
        def.position = {Real(i % 10) - 5, Real(0.6) + Real(0.9) * Real(i / 10)};
        if (feature == Feature::Restitution) {
            def.position = {2 * Real(i), Real(0.3)};
            def.velocity = {Real(0.1) * Real(i % 10), 0};
        } else if (feature != Feature::Rotation) {
            def.rotation = random.rotation();
        }
        world.add(def);
    }
    return world;
}

/// s of CPU time, of some steps.
double secondsOf(World& world, int steps) {
    const std::clock_t start = std::clock();
    for (int i = 0; i < steps; ++i) {
        world.step(support::kDt);
        (void)world.begunCollisions(); // a game reads them, where there are any
    }
    return static_cast<double>(std::clock() - start + 1) / CLOCKS_PER_SEC; // never 0
}

/// The median of ratios of times, and the largest difference (m) of a body's place.
struct Comparison {
    double ratio = 0;
    double apart = 0;
};

Comparison compare(const Part& part, const Profile& profile, Extent extent) {
    kodo::StepSettings with = profile.settings;
    with.leaveOut = {};
    kodo::StepSettings without = with;
    without.leaveOut = part.feature;
    std::vector<double> ratios;
    Comparison result;
    for (int round = 0; round < extent.of(5, 1); ++round) {
        World all = pileWithout(part.feature, with, extent.of(120, 24));
        World less = pileWithout(part.feature, without, extent.of(120, 24));
        const int steps = extent.of(240, 90);
        const double base = secondsOf(all, steps);
        ratios.push_back(secondsOf(less, steps) / base);
        const std::vector<kodo::BodyId> ours = all.bodies();
        const std::vector<kodo::BodyId> theirs = less.bodies();
        for (std::size_t i = 0; i < ours.size(); ++i) {
            const kodo::Vec2 way = all[ours[i]].position() - less[theirs[i]].position();
            result.apart = std::max(result.apart, static_cast<double>(length(way)));
        }
    }
    std::sort(ratios.begin(), ratios.end());
    result.ratio = ratios[ratios.size() / 2];
    return result;
}

} // namespace

void addLeaveOut(std::vector<Experiment>& book, Extent extent) {
    Experiment one{"leaveout"};
    for (const Profile& profile : profiles()) {
        for (const Part& part : kParts) {
            const Comparison result = compare(part, profile, extent);
            const std::string setting = std::string(profile.name) + ", without " + part.name;
            one.add("largest change of a place, where the part has nothing to do", setting,
                    result.apart, "m")
                .atMost(0, "a part that has nothing to do changes no bit of a place");
            one.add("CPU time, as a share of that of the whole step", setting, result.ratio);
        }
    }
    book.push_back(one);
}

} // namespace thesis
