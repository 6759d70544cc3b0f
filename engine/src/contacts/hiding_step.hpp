// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "contacts/contact.hpp"

#include <functional>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// What hides contacts of a step reads and writes: GhostCollisions, OneWayBodies.
struct HidingStep {
    const Bodies& bodies;
    std::span<Contact> contacts;
    std::span<ContactSummary> summaries;
    const Tolerances& tolerances;
    Real dt;                                    // s
    const std::function<void(Contact&)>& evict; // see SolverStorage
};

} // namespace KODO_PRECISION
} // namespace kodo
