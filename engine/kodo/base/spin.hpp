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

/// Spins until ready(), but no more than that: who then still has to wait should sleep. To be woken
/// takes about as long.
template <typename Ready>
void spinUntil(Ready ready) {
    for (int spins = 0; spins < kManySpins && !ready(); ++spins) {
        pauseSpin(spins);
    }
}

} // namespace kodo
