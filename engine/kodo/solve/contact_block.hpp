// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/math/softness.hpp>

#include <cstdint>

namespace kodo::inline KODO_PRECISION {

static_assert(sizeof(Motion) % sizeof(Real) == 0);
/// Where the Motion of a body begins, in Reals, so that the passes need not multiply.
constexpr std::uint32_t placeOfMotion(std::uint32_t body) {
    return body * static_cast<std::uint32_t>(sizeof(Motion) / sizeof(Real));
}
/// Whose Motion begins there.
constexpr std::uint32_t bodyOfPlace(std::uint32_t place) {
    return place / static_cast<std::uint32_t>(sizeof(Motion) / sizeof(Real));
}

/// Eight contacts as the passes of the solver see them, side by side. No two of them push the same
/// body, so they are solved at once. Everything is found before the passes, which only multiply and
/// add. Arms are fixed for the step: a separation follows the motion to first order in the turn.
/// A lane without a contact has neither normal nor masses nor impulses, so that it pushes nobody;
/// it lies between Bodies::spare() and itself.
struct alignas(64) ContactBlock {
    static constexpr int kContacts = 8;
    using Each = Real[kContacts];

    std::uint32_t a[kContacts]; // see placeOfMotion
    std::uint32_t b[kContacts];
    Each normalX;
    Each normalY;
    struct Point {
        Each leverA; // m, cross(armA, normal)
        Each leverB;
        Each mass;       // kg, effective, along the normal
        Each separation; // m, at the start of the step
        Each impulse;    // N s, of the substep
        Each largest;    // N s, in one substep
    };
    Point points[2];
    Each tangentLeverA; // m, of both points' mean, since they share one friction
    Each tangentLeverB;
    Each tangentMass; // kg
    Each friction;    // N s
    Each staticFriction;
    Each kineticFriction;
    Each pushSpeed; // m/s at most, to part the two
    Each total;     // N s, normal, over the step
};
static_assert(sizeof(ContactBlock) == 8 * (2 * 4 + 22 * sizeof(Real)));

/// The part of a block that only contacts with rolling resistance need.
struct RollingBlock {
    ContactBlock::Each lever;   // m; 0 without
    ContactBlock::Each mass;    // kg m^2
    ContactBlock::Each impulse; // N m s
};

/// Which parts of a block are in use.
struct BlockUse {
    std::int32_t rolling = -1; // place of its RollingBlock, if there is one
    bool twoPoints = false;    // or else each contact has one
    bool onLocked = false;   // all contacts have a side that cannot be pushed: twice the frequency
    std::uint8_t movesA = 0; // by lane: a can be pushed
    std::uint8_t movesB = 0;
};

/// What all contacts of a substep share.
struct PassSettings {
    Softness soft;
    Softness onLocked;
    Real invH;
    bool friction;
    Real kept; // 1, but 0 in the first substep: of what was summed up so far
};

/// One pass over `count` blocks, in an order. `motion` is that of the bodies.
struct ContactPassArguments {
    ContactBlock* blocks;
    RollingBlock* rolling;
    const BlockUse* use;
    const std::uint32_t* order;
    std::size_t count;
    Motion* motion;
    PassSettings settings;
    bool far = false; // blocks lie in a far cache, since there are so many
};

/// Carries the contacts of `count` blocks on to the start of a step, whose Motion still has the
/// moves of the last one.
struct CarryArguments {
    ContactBlock* blocks;
    Carried* carried; // by row
    const BlockUse* use;
    const std::uint32_t* order;
    std::size_t count;
    Motion* motion;       // by body; left as it is
    const Extent* extent; // by body
    bool far = false;     // as above
};

/// The passes, as made for one kind of machine. All kinds give the same bits.
struct ContactPasses {
    using Pass = void (*)(const ContactPassArguments&);
    using Carry = void (*)(const CarryArguments&);

    const char* name; // for tests
    Pass warmStart;   // pushes with the impulses so far
    Pass solve;       // pushes overlaps apart like stiff springs
    Pass settle;      // without that push, which takes its speed out again along the normal
    Pass relax;       // likewise, with friction, if wanted; sums up what was pushed
    Carry carry;

    static const ContactPasses& baseline();
    /// Nothing where neither the build nor the machine has it.
    static const ContactPasses* avx2();
    /// The fastest that runs here.
    static const ContactPasses& best();
};

} // namespace kodo::inline KODO_PRECISION
