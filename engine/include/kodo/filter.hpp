// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/error.hpp>

#include <cstdint>

namespace kodo {
inline namespace KODO_PRECISION {

/// Flags of a body. Bits 16 to 31 have a meaning for the engine. The other 48 are categories: they
/// belong to the user, and filters compare them.
using Flags = std::uint64_t;

inline constexpr Flags kUserFlags = 0xffff'ffff'0000'ffff;
/// The categories by number, 0 to 47: bits 0 to 15, then 32 to 63. Throws BadDefinition for others.
constexpr Flags category(unsigned number) {
    return number < 48 ? Flags{1} << (number < 16 ? number : number + 16)
                       : throw BadDefinition({"category", "must be from 0 to 47"});
}
inline constexpr Flags kLockMove = 1u << 16;   // motion lock: infinite mass
inline constexpr Flags kLockRotate = 1u << 17; // motion lock: infinite moment of inertia
inline constexpr Flags kDisabled = 1u << 18;   // collides with nothing, no query finds it
inline constexpr Flags kAsleep = 1u << 19;     // status
inline constexpr Flags kNeverSleep = 1u << 20; // the body keeps its island awake
inline constexpr Flags kColliding = 1u << 21;  // status: touched something in the last step
inline constexpr Flags kSensor = 1u << 22;     // detects overlap, without any response
inline constexpr Flags kFrozen = 1u << 23;     // status: see World::frozenBodies()
inline constexpr Flags kOutside = 1u << 24;    // status: outside the region, see World::setRegion()
// Bit 31 is reserved. Definitions and setters refuse it, kNoSensors and, as a flag,
// kDefaultCategory.
/// Set by the engine alone; setters ignore them.
inline constexpr Flags kStatusFlags = kAsleep | kColliding | kFrozen | kOutside;

// How a body compares `required` with the user flags of another. Without one of these it collides
// with all.
inline constexpr Flags kMatchNone = 1u << 27;  // none of the required flags is set
inline constexpr Flags kMatchAny = 1u << 28;   // at least one of the required flags is set
inline constexpr Flags kMatchAll = 1u << 29;   // all of them are set
inline constexpr Flags kMatchEqual = 1u << 30; // exactly these are set
inline constexpr Flags kMatchModes = kMatchNone | kMatchAny | kMatchAll | kMatchEqual;
/// Of queries alone: parts that are sensors are left out.
inline constexpr Flags kNoSensors = 1u << 25;
/// Of `required` alone: the category of bodies that name none.
inline constexpr Flags kDefaultCategory = 1u << 26;
/// The categories of a body with these flags: its user flags, or kDefaultCategory without them.
constexpr Flags categoriesOf(Flags flags) {
    return (flags & kUserFlags) != 0 ? flags & kUserFlags : kDefaultCategory;
}

/// Decides which bodies collide, or which ones a query or a field concerns [Thesis06, 4.1.6].
struct CollisionFilter {
    /// At most one of kMatchModes. Of a body also its user flags; queries, fields and forces on all
    /// bodies refuse these. Of a query also kNoSensors.
    Flags flags = 0;
    Flags required = 0; // categories that the mode compares with those of the other
    /// Comes before the mode: bodies of one group collide if it is > 0, and do not if it is < 0. 0
    /// is no group.
    std::int32_t group = 0;
};

/// True if a filter lets a body with the flags `other` through. kMatchAny and kMatchAll with
/// `required` 0 let nothing through; kMatchEqual then names kDefaultCategory.
constexpr bool accepts(CollisionFilter filter, Flags other) {
    const Flags required = filter.required;
    const Flags present = categoriesOf(other);
    switch (filter.flags & kMatchModes) {
    case kMatchNone:
        return (present & required) == 0;
    case kMatchAny:
        return (present & required) != 0;
    case kMatchAll:
        return required != 0 && (present & required) == required;
    case kMatchEqual:
        return present == (required != 0 ? required : kDefaultCategory);
    default:
        return true;
    }
}

/// The same with groups.
constexpr bool accepts(CollisionFilter filter, CollisionFilter other) {
    return filter.group != 0 && filter.group == other.group ? filter.group > 0
                                                            : accepts(filter, other.flags);
}

/// True if both filters accept the other body. It is symmetric, which the thesis's test is not.
constexpr bool shouldCollide(CollisionFilter a, CollisionFilter b) {
    return ((a.flags | b.flags) & kDisabled) == 0 && accepts(a, b) && accepts(b, a);
}

} // namespace KODO_PRECISION
} // namespace kodo
