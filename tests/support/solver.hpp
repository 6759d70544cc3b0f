// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

namespace support {

/// The two solvers, for tests that cover both.
enum class Solver { Soft, Propagation };
inline constexpr Solver kSolvers[] = {Solver::Soft, Solver::Propagation};

inline kodo::StepSettings settingsOf(Solver solver) {
    return solver == Solver::Propagation ? kodo::thesis2006() : kodo::StepSettings{};
}

/// Sets the substep count of the selected solver.
inline kodo::StepSettings withSubsteps(kodo::StepSettings settings, int substeps) {
    std::visit([&](auto& solver) { solver.substeps = substeps; }, settings.solver);
    return settings;
}

inline kodo::Real pushSpeedOf(const kodo::StepSettings& settings) {
    return std::visit([](const auto& solver) { return solver.pushSpeed; }, settings.solver);
}

} // namespace support
