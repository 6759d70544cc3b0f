// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <memory>

namespace kodo {
inline namespace KODO_PRECISION {

/// Provides threads to a step. The engine starts none of its own: use a ThreadPool, or wrap the
/// thread pool of the game in this interface.
///
/// Each thread of the step takes parts of its loops as they come. A step does not wait for a thread
/// that has not begun: late or missing threads make it slower, never wrong. The result has the same
/// bits with any number of them. A thread stays for the whole step and spins where there is no
/// work.
class KODO_API Executor {
public:
    virtual ~Executor();
    /// Number of threads that may help the stepping one, >= 0.
    virtual int helpers() const = 0;
    /// Has task(data) called once on each of at most helpers() threads, and returns at once. A call
    /// by begin() itself, on the stepping thread, returns at once and helps nothing.
    virtual void begin(void (*task)(void*), void* data) = 0;
    /// Returns when no call of the task runs any more and none will be made.
    virtual void end() = 0;
};

/// Threads that wait for work: spinning for a moment, then asleep. One pool can serve many Worlds,
/// one step at a time: a step that finds it in use throws std::logic_error and changes nothing.
class KODO_API ThreadPool final : public Executor {
public:
    /// Starts 0 to kMaxHelpers threads. Throws BadDefinition for another number, std::system_error
    /// if the system gives no more threads.
    explicit ThreadPool(int helpers);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool() override;

    static constexpr int kMaxHelpers = 255;

    int helpers() const override;
    void begin(void (*task)(void*), void* data) override;
    void end() override;

private:
    class Threads;
    std::unique_ptr<Threads> threads_;
};

} // namespace KODO_PRECISION
} // namespace kodo
