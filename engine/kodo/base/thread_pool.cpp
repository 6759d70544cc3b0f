// SPDX-License-Identifier: MIT
#include <kodo/base/problem.hpp>
#include <kodo/base/spin.hpp>
#include <kodo/base/thread_pool.hpp>

namespace kodo::inline KODO_PRECISION {

ThreadPool::ThreadPool(int helpers) {
    if (helpers < 0 || helpers > kMost) {
        refuse(Problem{"helpers", "must be 0 to " + std::to_string(kMost) + ", but is " +
                                      std::to_string(helpers)});
    }
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

ThreadPool::~ThreadPool() {
    close();
}

void ThreadPool::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

void ThreadPool::begin(void (*task)(void*), void* data) {
    {
        const std::lock_guard lock(mutex_);
        task_ = task;
        data_ = data;
        ++round_;
    }
    begun_.notify_all();
}

void ThreadPool::end() {
    std::unique_lock lock(mutex_);
    task_ = nullptr;
    lock.unlock();
    spinUntil([&] { return working_ == 0; }); // a helper leaves at once
    lock.lock();
    idle_.wait(lock, [&] { return working_ == 0; });
}

void ThreadPool::work() {
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
            continue; // it came when all was done
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

} // namespace kodo::inline KODO_PRECISION
