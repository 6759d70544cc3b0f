// SPDX-License-Identifier: MIT
#include <kodo/executor.hpp>

#include "base/checks.hpp"
#include "base/spin.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

class ThreadPool::Threads {
public:
    explicit Threads(int helpers) {
        threads_.reserve(static_cast<std::size_t>(helpers));
        try {
            for (int i = 0; i < helpers; ++i) {
                threads_.emplace_back([this] { work(); });
            }
        } catch (...) { // the system gives no more threads
            close();
            throw;
        }
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() { close(); }

    int count() const { return static_cast<int>(threads_.size()); }
    void begin(void (*task)(void*), void* data);
    void end();

private:
    void work();
    void close();

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable begun_;
    std::condition_variable idle_;
    void (*task_)(void*) = nullptr; // nullptr: none, or it has ended
    void* data_ = nullptr;
    // Written under the mutex, read without it by spinning threads.
    std::atomic<std::uint64_t> round_{0}; // number of tasks so far
    std::atomic<int> working_{0};
    std::atomic<bool> closing_{false};
};

void ThreadPool::Threads::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

void ThreadPool::Threads::begin(void (*task)(void*), void* data) {
    {
        const std::lock_guard lock(mutex_);
        if (task_ != nullptr) {
            throw std::logic_error("ThreadPool: another step uses the pool; it serves one step at "
                                   "a time");
        }
        task_ = task;
        data_ = data;
        ++round_;
    }
    begun_.notify_all();
}

void ThreadPool::Threads::end() {
    std::unique_lock lock(mutex_);
    task_ = nullptr;
    lock.unlock();
    spinUntil([&] { return working_ == 0; }); // a helper normally finishes at once
    lock.lock();
    idle_.wait(lock, [&] { return working_ == 0; });
}

void ThreadPool::Threads::work() {
    std::uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        lock.unlock();
        spinUntil([&] { return closing_ || round_ != seen; }); // the next step may follow at once
        lock.lock();
        begun_.wait(lock, [&] { return closing_ || round_ != seen; });
        if (closing_) {
            return;
        }
        seen = round_;
        if (task_ == nullptr) {
            continue; // the task ended before this thread began
        }
        ++working_;
        void (*const task)(void*) = task_;
        void* const data = data_;
        lock.unlock();
        task(data);
        lock.lock();
        if (--working_ == 0) {
            idle_.notify_all();
        }
    }
}

ThreadPool::ThreadPool(int helpers) {
    if (helpers < 0 || helpers > kMaxHelpers) {
        refuse(Problem{"helpers", "must be from 0 to " + std::to_string(kMaxHelpers) + ", but is " +
                                      std::to_string(helpers)});
    }
    threads_ = std::make_unique<Threads>(helpers);
}

ThreadPool::~ThreadPool() = default;

int ThreadPool::helpers() const {
    return threads_->count();
}

void ThreadPool::begin(void (*task)(void*), void* data) {
    threads_->begin(task, data);
}

void ThreadPool::end() {
    threads_->end();
}

} // namespace KODO_PRECISION
} // namespace kodo
