// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/step_stats.hpp>

#include "base/worker_team.hpp"
#include "contacts/contact_set.hpp"
#include "joints/joint_set.hpp"

#include <variant>

namespace kodo {
inline namespace KODO_PRECISION {

/// What the solvers and continuous collision use of a step.
struct StepInput {
    Bodies& bodies;
    ContactSet& contactSet;
    JointSet& joints;
    const StepSettings& settings;
    const Tolerances& tolerances;
    Real dt; // s
    WorkerTeam& team;
    std::uint64_t count; // steps of the World so far; numbers the passes of the thesis's solver
    StepStats& work;     // what the solver did

    template <typename Solver>
    const Solver& solver() const {
        return std::get<Solver>(settings.solver);
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
