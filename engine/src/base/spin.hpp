// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace kodo {

/// Consecutive spins before the core is yielded: there may be more threads than cores.
constexpr int kManySpins = 2000;

/// Pauses after this many consecutive spins; on x86 some tens of nanoseconds.
inline void pauseSpin(int spins) {
    if (spins >= kManySpins) {
        std::this_thread::yield();
        return;
    }
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/// Spins until ready(), at most kManySpins times. After that a thread should sleep: waking it takes
/// about as long as these spins.
template <typename Ready>
void spinUntil(Ready ready) {
    for (int spins = 0; spins < kManySpins && !ready(); ++spins) {
        pauseSpin(spins);
    }
}

} // namespace kodo
