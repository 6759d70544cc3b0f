// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

namespace kodo::inline KODO_PRECISION {

/// Lends a World threads for the time of a step. The engine starts none of its own: ThreadPool is
/// one ready-made, and a game that has a pool already wraps it in this.
///
/// The helpers take pieces of the step's loops as they come, and nothing waits for one that has not
/// begun: so fewer threads than promised, late ones, or none at all make a step slower, but never
/// wrong, and its outcome has the same bits with any number of them. A helper that has come stays
/// for the whole step, and spins or yields where there is nothing to share.
class Executor {
public:
    virtual ~Executor() = default;
    /// Threads that may help the one that steps, >= 0.
    virtual int helpers() const = 0;
    /// Has task(data) called once on each of at most helpers() threads, and returns at once.
    virtual void begin(void (*task)(void*), void* data) = 0;
    /// Returns when no call that was begun is under way, and none will be made any more.
    virtual void end() = 0;
};

} // namespace kodo::inline KODO_PRECISION
