// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

/// The lower mode of two bodies.
inline ContinuousMode modeOf(const Bodies& bodies, std::uint32_t a, std::uint32_t b) {
    return bodies.changes.continuousModes ? std::min(bodies.record[a].rules.continuousMode,
                                                     bodies.record[b].rules.continuousMode)
                                          : ContinuousMode::All;
}
/// True if that mode lets continuous collision check the pair.
inline bool areChecked(const Bodies& bodies, std::uint32_t a, std::uint32_t b) {
    const ContinuousMode mode = modeOf(bodies, a, b);
    return mode == ContinuousMode::All ||
           (mode == ContinuousMode::Static && (bodies.locked(a) || bodies.locked(b)));
}

} // namespace KODO_PRECISION
} // namespace kodo
