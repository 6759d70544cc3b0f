// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/math/softness.hpp>

#include <cstddef>
#include <cstdint>

namespace kodo::inline KODO_PRECISION {

/// Eight pins as the passes of the solver see them, side by side. No two of them push the same
/// body, so they are solved at once. A lane without a pin lies between Bodies::spare() and itself,
/// and has neither arms nor masses.
struct alignas(64) PinBlock {
    static constexpr int kPins = 8;
    using Each = Real[kPins];
    struct Both {
        Each x;
        Each y;
    };

    std::uint32_t a[kPins]; // see placeOfMotion
    std::uint32_t b[kPins];
    Both startA; // m, from a's centre of mass to its anchor at the start of the step
    Both startB;
    Both between;  // m, from a's centre of mass to b's at the start of the step
    Each mass;     // 1/kg, of both bodies together
    Each inertiaA; // 1/(kg m^2)
    Each inertiaB;
    Both armA; // m, as of the last pass of turn, like all down to the masses
    Both armB;
    Both gap;    // m, anchor b minus anchor a
    Each massXX; // kg, K^-1, see PointConstraint::stopping
    Each massXY;
    Each massYY;
    Both impulse; // N s, of the substep
    Both total;   // N s, over the step
};

/// By lane: a, or b, can be pushed.
struct PinUse {
    std::uint8_t movesA = 0;
    std::uint8_t movesB = 0;
};

/// One pass over `count` blocks in their order. `motion` is that of the bodies.
struct PinPassArguments {
    PinBlock* blocks;
    const PinUse* use;
    std::size_t count;
    Motion* motion;
    Real h; // s, of a substep
    Softness soft;
};

/// The passes, as made for one kind of machine. All kinds give the same bits.
struct PinPasses {
    using Pass = void (*)(const PinPassArguments&);

    const char* name; // for tests
    Pass turn;        // finds arms, gaps and masses where the bodies are by now
    Pass warmStart;   // pushes with the impulses so far
    Pass solve;       // closes gaps like stiff springs
    Pass relax;       // takes the speed of that out again; sums up what was pushed

    static const PinPasses& baseline();
    /// Nothing where neither the build nor the machine has it.
    static const PinPasses* avx2();
    /// The fastest that runs here.
    static const PinPasses& best();
};

} // namespace kodo::inline KODO_PRECISION
