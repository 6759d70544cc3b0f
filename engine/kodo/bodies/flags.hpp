// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cstdint>

namespace kodo::inline KODO_PRECISION {

/// Flags of a body. The low 16 bits belong to the user and say what the body *is*; the engine
/// compares them and gives them no meaning. The high 16 bits are the engine's.
using Flags = std::uint32_t;

inline constexpr Flags kUserFlags = 0x0000ffff;
inline constexpr Flags kLockMove = 1u << 16;   // infinite mass: moves only as its velocity is set
inline constexpr Flags kLockRotate = 1u << 17; // infinite inertia: turns only as it is told to
inline constexpr Flags kLocked = kLockMove | kLockRotate;
inline constexpr Flags kDisabled = 1u << 18;  // collides with nothing; the thesis has its opposite
inline constexpr Flags kResting = 1u << 19;   // set by the step: sleeps until something wakes it
inline constexpr Flags kNeverRest = 1u << 20; // may not be put to rest
inline constexpr Flags kColliding = 1u << 21; // set by the step: touched something in it
inline constexpr Flags kSensor = 1u << 22;    // is noticed, but neither pushes nor is pushed
inline constexpr Flags kFrozen = 1u << 23;    // set by the step: see World::frozenBodies
inline constexpr Flags kOutside = 1u << 24;   // set by the step: see World::setRegion
/// Those that only the engine sets.
inline constexpr Flags kStatusFlags = kResting | kColliding | kFrozen | kOutside;

/// How a body compares `required` with the user flags of what it meets. None of the three: it
/// meets everything.
inline constexpr Flags kMatchAny = 1u << 28;   // one of the required flags is there
inline constexpr Flags kMatchAll = 1u << 29;   // all of them are there
inline constexpr Flags kMatchEqual = 1u << 30; // they are there and no others
inline constexpr Flags kMatchModes = kMatchAny | kMatchAll | kMatchEqual;

/// Which bodies meet [Thesis06, 4.1.6].
struct CollisionFilter {
    Flags flags = 0;
    std::uint16_t required = 0;
};

/// Would a body with this filter meet one with those user flags? "Any" and "all" of no flags is
/// never true, so a body that requires nothing in these modes meets nothing.
constexpr bool accepts(CollisionFilter filter, Flags other) {
    const Flags required = filter.required;
    const Flags present = other & kUserFlags;
    switch (filter.flags & kMatchModes) {
    case kMatchAny:
        return (present & required) != 0;
    case kMatchAll:
        return required != 0 && (present & required) == required;
    case kMatchEqual:
        return present == required;
    default:
        return true;
    }
}

/// Symmetric: both must accept the other, so the order of two bodies never decides, as it could in
/// the thesis.
constexpr bool shouldCollide(CollisionFilter a, CollisionFilter b) {
    return ((a.flags | b.flags) & kDisabled) == 0 && accepts(a, b.flags) && accepts(b, a.flags);
}

} // namespace kodo::inline KODO_PRECISION
