// SPDX-License-Identifier: MIT
#include <kodo/solve/settings.hpp>

#include <cmath>
#include <string>

namespace kodo::inline KODO_PRECISION {
namespace {

std::optional<Problem> checkCount(const char* field, int value, int low, int high) {
    if (value < low || value > high) {
        return Problem{field, "must be " + std::to_string(low) + " to " + std::to_string(high) +
                                  ", but is " + std::to_string(value)};
    }
    return std::nullopt;
}

std::optional<Problem> checkPositive(const char* field, Real value) {
    if (!(std::isfinite(value) && value > 0)) {
        return Problem{field, "must be finite and greater than 0, but is " + std::to_string(value)};
    }
    return std::nullopt;
}

} // namespace

std::optional<Problem> check(const StepSettings& settings) {
    if (settings.strategy != Strategy::SoftStep && settings.strategy != Strategy::Propagation) {
        return Problem{"settings.strategy", "must be one of the enumerators of Strategy"};
    }
    if (auto problem = checkCount("settings.substeps", settings.substeps, 1, 64)) {
        return problem;
    }
    if (auto problem = checkCount("settings.impactPasses", settings.impactPasses, 0, 1000)) {
        return problem;
    }
    if (auto problem = checkCount("settings.contactPasses", settings.contactPasses, 1, 1000)) {
        return problem;
    }
    if (auto problem = checkCount("settings.shockPasses", settings.shockPasses, 0, 1000)) {
        return problem;
    }
    if (auto problem = checkCount("settings.restSteps", settings.restSteps, 1, 1000000)) {
        return problem;
    }
    if (auto problem = checkPositive("settings.contactHertz", settings.contactHertz)) {
        return problem;
    }
    if (auto problem = checkPositive("settings.contactDamping", settings.contactDamping)) {
        return problem;
    }
    if (auto problem = checkPositive("settings.jointHertz", settings.jointHertz)) {
        return problem;
    }
    if (auto problem = checkPositive("settings.jointDamping", settings.jointDamping)) {
        return problem;
    }
    return checkPositive("settings.pushSpeed", settings.pushSpeed);
}

} // namespace kodo::inline KODO_PRECISION
