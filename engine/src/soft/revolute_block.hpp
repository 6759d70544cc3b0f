// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "math/softness.hpp"

#include <cstddef>
#include <cstdint>

namespace kodo {
inline namespace KODO_PRECISION {

/// Eight revolute joints as a structure of arrays. No two of them move the same body, so SIMD lanes
/// solve them at once. In an empty lane both bodies are Bodies::spare(), and arms and masses are
/// zero.
struct alignas(64) RevoluteBlock {
    static constexpr int kJoints = 8;
    using Each = Real[kJoints];
    struct Both {
        Each x;
        Each y;
    };

    std::uint32_t a[kJoints]; // see velocityOffset
    std::uint32_t b[kJoints];
    Both startA; // m, from a's centre of mass to its anchor at the start of the step
    Both startB;
    Both between;  // m, from a's centre of mass to b's at the start of the step
    Each mass;     // 1/kg, sum of both bodies
    Each inertiaA; // 1/(kg m^2)
    Each inertiaB;
    Both armA; // m, to anchor b, at the last rotate(), like the members down to torqueB
    Both armB;
    Both gap;    // m, anchor b minus anchor a
    Each massXX; // kg, K^-1, see PointConstraint::stopping
    Each massXY;
    Each massYY;
    Each torqueA; // N m s, change of arm x impulse by the rotation; 0 once it is applied
    Each torqueB;
    Both impulse; // N s, of the substep
    Both total;   // N s, over the step
};

/// Motors and limits of the joints of a RevoluteBlock. Joints without a motor have no torque, those
/// without limits have limits of kFarAngle. Impulses act on b, in N m s.
struct alignas(64) RevoluteAngles {
    using Each = RevoluteBlock::Each;
    static constexpr Real kFarAngle = Real(1e6); // rad

    Each start;  // rad, angle of b relative to a minus the reference, at the start of the step
    Each angle;  // rad, at the last rotate()
    Each lower;  // rad
    Each upper;  // rad
    Each speed;  // rad/s, of the motor
    Each torque; // N m, >= 0; the largest of the motor
    Each motor;  // impulse, of the substep
    Each below;  // impulse of the lower limit, >= 0, of the substep
    Each above;  // impulse of the upper limit, >= 0, against the direction of the others
    Each total;  // impulse, over the step
};

struct RevoluteUse {
    static constexpr std::uint32_t kNoAngles = ~std::uint32_t{};

    std::uint8_t movesA = 0; // lane mask: body a is not locked
    std::uint8_t movesB = 0;
    std::uint32_t angles = kNoAngles; // index of the motors and limits of the block
};

/// One pass over `count` blocks in order. `motion` is indexed by body.
struct RevolutePassArguments {
    RevoluteBlock* blocks;
    const RevoluteUse* use;
    RevoluteAngles* angles;
    std::size_t count;
    BodyVelocity* motion;
    Real h; // s, of a substep
    Softness soft;
};

/// The passes compiled for one instruction set. All instruction sets give bit-identical results.
struct RevolutePasses {
    using Pass = void (*)(const RevolutePassArguments&);

    const char* name; // for tests
    Pass rotate;      // updates arms, gaps, masses and angles after displacements
    Pass warmStart;   // applies the accumulated impulses
    Pass solve;       // biased: closes gaps and restores limits as soft constraints
    Pass relax;       // without bias; adds up the impulses of the step

    static const RevolutePasses& baseline();
    /// nullptr if the build or the machine lacks AVX2.
    static const RevolutePasses* avx2();
    /// The fastest passes that the machine supports.
    static const RevolutePasses& best();
};

} // namespace KODO_PRECISION
} // namespace kodo
