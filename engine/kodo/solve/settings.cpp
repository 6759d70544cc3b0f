// SPDX-License-Identifier: MIT
#include <kodo/solve/settings.hpp>

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

// Far beyond any use, and far from where their products overflow.
constexpr Real kMostHertz = Real(1e9);
constexpr Real kMostDamping = Real(1e6);
constexpr Real kMostPush = Real(1e7);
constexpr unsigned kAllFeatures = 127;

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
    if (auto problem = checkPositive("settings.contactHertz", settings.contactHertz, kMostHertz)) {
        return problem;
    }
    if (auto problem =
            checkPositive("settings.contactDamping", settings.contactDamping, kMostDamping)) {
        return problem;
    }
    if (auto problem = checkPositive("settings.jointHertz", settings.jointHertz, kMostHertz)) {
        return problem;
    }
    if (auto problem =
            checkPositive("settings.jointDamping", settings.jointDamping, kMostDamping)) {
        return problem;
    }
    if ((settings.leaveOut & ~kAllFeatures) != 0) {
        return Problem{"settings.leaveOut", "must be a set of Feature"};
    }
    return checkPositive("settings.pushSpeed", settings.pushSpeed, kMostPush);
}

} // namespace kodo::inline KODO_PRECISION
