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
constexpr unsigned kAllFeatures = 127;

/// Checks fields in order and keeps the first problem.
class Checks {
public:
    void count(const char* field, int value, int low, int high) {
        if (!problem_ && (value < low || value > high)) {
            problem_ =
                Problem{field, "must be from " + std::to_string(low) + " to " +
                                   std::to_string(high) + ", but is " + std::to_string(value)};
        }
    }
    void positive(const char* field, Real value, Real most) {
        if (!problem_) {
            problem_ = checkPositive(field, value, most);
        }
    }
    /// Fields that both solvers have.
    template <typename Settings>
    void common(const Settings& settings) {
        count("settings.substeps", settings.substeps, 1, 64);
        count("settings.impactPasses", settings.impactPasses, 0, 1000);
        positive("settings.jointHertz", settings.jointHertz, kMaxHertz);
        positive("settings.jointDamping", settings.jointDamping, kMaxDamping);
        positive("settings.pushSpeed", settings.pushSpeed, kMaxPush);
    }
    void operator()(const SoftSettings& settings) {
        common(settings);
        positive("settings.contactHertz", settings.contactHertz, kMaxHertz);
        positive("settings.contactDamping", settings.contactDamping, kMaxDamping);
    }
    void operator()(const PropagationSettings& settings) {
        common(settings);
        count("settings.contactPasses", settings.contactPasses, 1, 1000);
        count("settings.shockPasses", settings.shockPasses, 0, 1000);
    }
    std::optional<Problem> first() const { return problem_; }

private:
    std::optional<Problem> problem_;
};

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
    Checks checks;
    std::visit([&](const auto& solver) { checks(solver); }, settings.solver);
    checks.count("settings.sleepSteps", settings.sleepSteps, 1, 1000000);
    if (!checks.first() && (settings.leaveOut.bits & ~kAllFeatures) != 0) {
        return Problem{"settings.leaveOut", "must be a set of Feature"};
    }
    return checks.first();
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
