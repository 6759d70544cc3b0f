// SPDX-License-Identifier: MIT
#include <kodo/error.hpp>
#include <kodo/executor.hpp>
#include <kodo/step_stats.hpp>

#include <utility>

// Out-of-line destructors give each exception and interface one home, also across shared libraries.
namespace kodo {
inline namespace KODO_PRECISION {

BadDefinition::BadDefinition(Problem problem)
    : std::invalid_argument(problem.text()), problem_(std::move(problem)) {}
BadDefinition::~BadDefinition() = default;
BadBodyId::~BadBodyId() = default;
BadSnapshot::~BadSnapshot() = default;
Executor::~Executor() = default;
StageListener::~StageListener() = default;

} // namespace KODO_PRECISION
} // namespace kodo
