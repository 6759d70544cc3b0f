// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace kodo {

/// Waits for some tens of nanoseconds, after so many such spins in a row. Who has waited long gives
/// the core up, for there may be more threads than cores.
inline void pauseSpin(int spins) {
    constexpr int kLong = 2000; // spins
    if (spins >= kLong) {
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
