// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <atomic>

namespace kodo {
inline namespace KODO_PRECISION {

/// Refuses calls that user code makes within a step or a visiting query of the same World. A copy
/// of a World starts without either. `call` is the name as users write it: "World::remove".
class ChangeGuard {
public:
    ChangeGuard() = default;
    ChangeGuard(const ChangeGuard&) noexcept {}
    ChangeGuard& operator=(const ChangeGuard&) noexcept { return *this; }

    /// Throws std::logic_error if a change is not possible now.
    void requireChangeable(const char* call) const {
        if (inStep_ || visits_.load(std::memory_order_relaxed) != 0) {
            refuse(call);
        }
    }
    /// Throws std::logic_error within a step: the World is between two states.
    void requireWhole(const char* call) const {
        if (inStep_) {
            refuse(call);
        }
    }

    /// Lasts as long as a step.
    class Step {
    public:
        explicit Step(ChangeGuard& guard) : guard_(guard) { guard_.inStep_ = true; }
        ~Step() { guard_.inStep_ = false; }
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;

    private:
        ChangeGuard& guard_;
    };

    /// Lasts as long as a query that calls user code. Several threads may query one World.
    class Visit {
    public:
        explicit Visit(const ChangeGuard& guard) : guard_(guard) {
            guard_.visits_.fetch_add(1, std::memory_order_relaxed);
        }
        ~Visit() { guard_.visits_.fetch_sub(1, std::memory_order_relaxed); }
        Visit(const Visit&) = delete;
        Visit& operator=(const Visit&) = delete;

    private:
        const ChangeGuard& guard_;
    };

private:
    [[noreturn]] void refuse(const char* call) const;

    bool inStep_ = false;
    mutable std::atomic<int> visits_{0};
};

} // namespace KODO_PRECISION
} // namespace kodo
