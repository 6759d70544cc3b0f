// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace kodo {

/// Spins in a row after which the core is given up, for there may be more threads than cores.
constexpr int kManySpins = 2000;

/// Waits a moment, after so many spins in a row: on x86 some tens of nanoseconds.
inline void pauseSpin(int spins) {
    if (spins >= kManySpins) {
        std::this_thread::yield();
        return;
    }
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/// Spins until ready(), but so many times at most. False if it is not by then.
template <typename Ready>
bool spinUntil(int most, Ready ready) {
    for (int spins = 0; !ready(); ++spins) {
        if (spins == most) {
            return false;
        }
        pauseSpin(spins);
    }
    return true;
}

} // namespace kodo
