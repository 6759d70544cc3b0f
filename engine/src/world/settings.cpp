// SPDX-License-Identifier: MIT
#include <kodo/settings.hpp>
#include <kodo/world.hpp>

#include "base/checks.hpp"
#include "base/state_stream.hpp"

#include <string>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Upper bounds, far above any use and far below an overflow of their products.
constexpr Real kMaxHertz = Real(1e9);
constexpr Real kMaxDamping = Real(1e6);
constexpr Real kMaxPush = Real(1e7);
constexpr Real kLeastGap = Real(1e-4);
constexpr Real kMostGap = Real(1e4);

std::optional<Problem> checkCount(const char* field, int value, int low, int high) {
    if (value < low || value > high) {
        return Problem{field, "must be from " + std::to_string(low) + " to " +
                                  std::to_string(high) + ", but is " + std::to_string(value)};
    }
    return std::nullopt;
}

/// Fields that both solvers have.
template <typename Settings>
std::optional<Problem> checkCommon(const Settings& settings) {
    return firstOf({checkCount("settings.substeps", settings.substeps, 1, 64),
                    checkCount("settings.impactPasses", settings.impactPasses, 0, 1000),
                    checkPositive("settings.jointHertz", settings.jointHertz, kMaxHertz),
                    checkPositive("settings.jointDamping", settings.jointDamping, kMaxDamping),
                    checkPositive("settings.pushSpeed", settings.pushSpeed, kMaxPush)});
}

std::optional<Problem> checkSolver(const SoftSettings& settings) {
    return firstOf({checkCommon(settings),
                    checkPositive("settings.contactHertz", settings.contactHertz, kMaxHertz),
                    checkPositive("settings.contactDamping", settings.contactDamping, kMaxDamping),
                    checkRange("settings.jointGap", settings.jointGap, kLeastGap, kMostGap)});
}

std::optional<Problem> checkSolver(const PropagationSettings& settings) {
    return firstOf({checkCommon(settings),
                    checkCount("settings.contactPasses", settings.contactPasses, 1, 1000),
                    checkCount("settings.shockPasses", settings.shockPasses, 0, 1000)});
}

} // namespace

SoftSettings& StepSettings::soft() {
    return const_cast<SoftSettings&>(std::as_const(*this).soft());
}
const SoftSettings& StepSettings::soft() const {
    if (const auto* const settings = std::get_if<SoftSettings>(&solver)) {
        return *settings;
    }
    throw BadDefinition({"settings.solver", "is PropagationSettings: use propagation()"});
}
PropagationSettings& StepSettings::propagation() {
    return const_cast<PropagationSettings&>(std::as_const(*this).propagation());
}
const PropagationSettings& StepSettings::propagation() const {
    if (const auto* const settings = std::get_if<PropagationSettings>(&solver)) {
        return *settings;
    }
    throw BadDefinition({"settings.solver", "is SoftSettings: use soft()"});
}

std::optional<Problem> check(const StepSettings& settings) {
    return firstOf(
        {std::visit([](const auto& solver) { return checkSolver(solver); }, settings.solver),
         checkCount("settings.sleepSteps", settings.sleepSteps, 1, 1000000)});
}

void visitState(StateStream& stream, StepSettings& settings) {
    auto& [solver, sleepSteps, leaveOut] = settings;
    stream(solver, sleepSteps, leaveOut.bits);
    require(check(settings));
}

/// All tolerances follow from the length unit. It follows exactly from any of them, since their
/// ratios are powers of two.
void visitState(StateStream& stream, Tolerances& tolerances) {
    auto& [slop, margin, grown] = tolerances;
    Real unit = slop * Tolerances::kSlopsPerUnit;
    stream(unit);
    require(check(WorldDef{{}, unit, {}}));
    if (stream.reads()) {
        tolerances = Tolerances::forUnit(unit);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
