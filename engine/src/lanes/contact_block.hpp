// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "math/softness.hpp"

#include <cstdint>
#include <limits>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

static_assert(sizeof(BodyVelocity) % sizeof(Real) == 0);
/// Offset of the BodyVelocity of a body in the array, in Reals, so that the passes need no
/// multiplication.
constexpr std::uint32_t velocityOffset(std::uint32_t body) {
    return body * static_cast<std::uint32_t>(sizeof(BodyVelocity) / sizeof(Real));
}
/// Inverse of velocityOffset().
constexpr std::uint32_t bodyOfPlace(std::uint32_t place) {
    return place / static_cast<std::uint32_t>(sizeof(BodyVelocity) / sizeof(Real));
}

/// Eight contacts as a structure of arrays. No two of them move the same body, so SIMD lanes solve
/// them at once. All coefficients are computed before the
/// passes, which only multiply and add.
///
/// Contact arms are fixed for the step: a separation follows deltaPosition exactly and deltaAngle
/// to first order. An empty lane has zero normal, masses and impulses, and both its bodies are
/// Bodies::spare().
struct alignas(64) ContactBlock {
    static constexpr int kContacts = 8;
    using Each = Real[kContacts];

    std::uint32_t a[kContacts]; // see velocityOffset
    std::uint32_t b[kContacts];
    Each normalX;
    Each normalY;
    struct Point {
        Each leverA; // m, cross(armA, normal)
        Each leverB;
        Each mass;       // kg, effective mass along the normal
        Each separation; // m, at the start of the step
        Each impulse;    // N s, of the substep
        Each largest;    // N s, largest impulse of a substep
    };
    Point points[2];
    Each relativeDisplacement; // m; these four are not used by the passes: see ContactNumbers
    Each approachSpeed;        // m/s
    Each impact[2];            // N s
    Each rolling;              // N m s, of the substep; see SurfaceBlock
    Each tangentLeverA;        // m, for the mean of both points, which share one friction impulse
    Each tangentLeverB;
    Each tangentMass;    // kg
    Each friction;       // N s
    Each staticFriction; // < 0, with its sign reversed: the contact slides
    Each kineticFriction;
    Each pushSpeed; // m/s, largest speed that separates an overlap
    Each total[2];  // N s, sums over the step: see ContactNumbers
};
static_assert(sizeof(ContactBlock) - 8 * (2 * 4 + 28 * sizeof(Real)) < 64);

/// Coefficients of the contacts of a block of which some have rolling resistance or a surface
/// speed.
struct SurfaceBlock {
    ContactBlock::Each rollingLever; // m; 0 without rolling resistance
    ContactBlock::Each rollingMass;  // kg m^2
    ContactBlock::Each speed;        // m/s, along perp(normal); see relativeSurfaceSpeed
};

/// Which data and lanes of a block are in use.
struct BlockUse {
    std::int32_t surface = -1; // index of its SurfaceBlock, or -1
    bool twoPoints = false;    // all contacts have two points, else all have one
    bool onLocked = false;     // all contacts have a body of infinite mass: doubled frequency
    std::uint8_t movesA = 0;   // lane mask: body a is not locked
    std::uint8_t movesB = 0;
    /// Some contact has a surface speed, or a static friction above the kinetic one.
    bool rareFriction = false;
};

/// Values shared by all contacts in a substep.
struct PassSettings {
    Softness soft;
    Softness onLocked;
    Real invH;
    bool friction;
    Real kept;          // factor of the sums so far: 0 in the first substep, else 1
    Real left = 1;      // substeps of the step that are left, with this one
    Real pushSpeed = 0; // m/s, of contacts that do not share it in a crowd
    /// m/s, separating speed above which such a contact carries nothing.
    Real thrown = std::numeric_limits<Real>::max();
};

/// One pass over `count` blocks in the order of `order`. `motion` is indexed by body.
struct ContactPassArguments {
    ContactBlock* blocks;
    SurfaceBlock* surfaces;
    const BlockUse* use;
    const std::uint32_t* order;
    std::size_t count;
    BodyVelocity* motion;
    PassSettings settings;
    bool far = false; // blocks exceed the near cache: prefetch
};

/// Advances the contacts of `count` blocks to the start of a step. `motion` still has the
/// displacements of the last step.
struct AdvanceArguments {
    ContactBlock* blocks;
    const BlockUse* use;
    const std::uint32_t* order;
    std::size_t count;
    BodyVelocity* motion; // by body; not modified
    const Extent* extent; // by body
    bool far = false;     // as in ContactPassArguments
};

/// The passes compiled for one instruction set. All instruction sets give bit-identical results.
struct ContactPasses {
    using Pass = void (*)(const ContactPassArguments&);
    using Advance = void (*)(const AdvanceArguments&);

    const char* name; // for tests
    Pass warmStart;   // applies the accumulated impulses
    Pass solve;       // biased: separates overlaps as soft contacts
    Pass relax;       // without bias, with friction if enabled; adds up the sums of the step
    Advance advance;

    static const ContactPasses& baseline();
    /// nullptr if the build or the machine lacks AVX2.
    static const ContactPasses* avx2();
    /// The fastest passes that the machine supports.
    static const ContactPasses& best();
};

} // namespace KODO_PRECISION
} // namespace kodo
