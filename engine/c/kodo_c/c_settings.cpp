// SPDX-License-Identifier: MIT
#include <kodo_c/c_handles.hpp>
#include <kodo_c/c_values.hpp>

#include <limits>
#include <type_traits>
#include <variant>

namespace kodo_c {
namespace {

static_assert(std::is_same_v<decltype(kodo::StepSettings::solver),
                             std::variant<kodo::SoftSettings, kodo::PropagationSettings>>);

// The engine counts in int.
static_assert(std::numeric_limits<int>::max() == std::numeric_limits<std::int32_t>::max());

kodo::StepSettings settingsOf(kodo_Profile profile) {
    switch (profile) {
    case KODO_FAST:
        return kodo::fast();
    case KODO_BALANCED:
        return kodo::balanced();
    case KODO_ACCURATE:
        return kodo::accurate();
    case KODO_THESIS_2006:
        return kodo::thesis2006();
    default:
        requireKind(profile, KODO_THESIS_2006 + 1, "profile");
        return {};
    }
}

struct WriteSolver {
    kodo_Settings& settings;

    void operator()(const kodo::SoftSettings& solver) const {
        const auto& [substeps, impactPasses, contactHertz, contactDamping, jointHertz, jointDamping,
                     pushSpeed, jointGap] = solver;
        settings.soft = {substeps,   impactPasses, contactHertz, contactDamping,
                         jointHertz, jointDamping, pushSpeed,    jointGap};
    }
    void operator()(const kodo::PropagationSettings& solver) const {
        const auto& [substeps, impactPasses, contactPasses, shockPasses, jointHertz, jointDamping,
                     pushSpeed] = solver;
        settings.propagation = {substeps,   impactPasses, contactPasses, shockPasses,
                                jointHertz, jointDamping, pushSpeed};
    }
};

} // namespace

kodo::StepSettings fromC(const kodo_Settings& settings) {
    kodo::StepSettings made;
    requireKind(settings.solver, KODO_PROPAGATION + 1, "settings.solver");
    if (settings.solver == KODO_SOFT) {
        const kodo_SoftSettings& soft = settings.soft;
        made.solver = kodo::SoftSettings{soft.substeps,       soft.impactPasses, soft.contactHertz,
                                         soft.contactDamping, soft.jointHertz,   soft.jointDamping,
                                         soft.pushSpeed,      soft.jointGap};
    } else {
        const kodo_PropagationSettings& thesis = settings.propagation;
        made.solver = kodo::PropagationSettings{
            thesis.substeps,   thesis.impactPasses, thesis.contactPasses, thesis.shockPasses,
            thesis.jointHertz, thesis.jointDamping, thesis.pushSpeed};
    }
    made.sleepSteps = settings.sleepSteps;
    made.leaveOut.bits = settings.leaveOut;
    return made;
}

kodo_Settings toC(const kodo::StepSettings& settings) {
    const auto& [solver, sleepSteps, leaveOut] = settings;
    kodo_Settings made{};
    made.head = kodo_headOf(sizeof(kodo_Settings));
    made.solver = static_cast<kodo_SolverKind>(solver.index());
    std::visit(WriteSolver{made}, solver);
    made.sleepSteps = sleepSteps;
    made.leaveOut = leaveOut.bits;
    return made;
}

} // namespace kodo_c

using namespace kodo_c;

kodo_Status kodo_initSettings(kodo_Settings* settings, kodo_Head head, kodo_Profile profile) {
    return guarded([&] {
        initialise(settings, head, "kodo_Settings");
        settings->solver = -1; // refused, if the profile is
        *settings = toC(settingsOf(profile));
    });
}

kodo_Status kodo_worldSettings(const kodo_World* world, kodo_Settings* settings) {
    return guarded([&] { required(settings, "settings") = toC(worldOf(world).settings()); });
}

kodo_Status kodo_setSettings(kodo_World* world, const kodo_Settings* settings) {
    return guarded(
        [&] { worldOf(world).setSettings(fromC(checked(settings, "settings", "kodo_Settings"))); });
}
