// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/executor.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Threads that wait until a World has work for them: for a moment awake, then asleep. One pool may
/// serve many Worlds, but only one step at a time.
class ThreadPool final : public Executor {
public:
    /// Starts `helpers` threads, 0 to kMost; throws BadDefinition for another number, and
    /// std::system_error if the system gives no more threads.
    explicit ThreadPool(int helpers);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool() override;

    static constexpr int kMost = 255;

    int helpers() const override { return static_cast<int>(threads_.size()); }
    void begin(void (*task)(void*), void* data) override;
    void end() override;

private:
    void work();
    void close();

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable begun_;
    std::condition_variable idle_;
    void (*task_)(void*) = nullptr; // nullptr: none, or it has ended
    void* data_ = nullptr;
    // Changed under the mutex, and read without it by who spins.
    std::atomic<std::uint64_t> round_{0}; // how often there was a task
    std::atomic<int> working_{0};
    std::atomic<bool> closing_{false};
};

} // namespace kodo::inline KODO_PRECISION
