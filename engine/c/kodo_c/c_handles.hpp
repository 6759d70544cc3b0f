// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/executor.hpp>
#include <kodo_c/c_guard.hpp>

#include <atomic>
#include <stdexcept>

/// A World behind the opaque pointer of C.
struct kodo_World {
    kodo::World world;
    /// Calls that run code of the user, or that step the World with others: it must not be
    /// destroyed meanwhile.
    mutable std::atomic<int> users{0};
};

struct kodo_ThreadPool {
    kodo::ThreadPool pool;
};

namespace kodo_c {

inline kodo::World& worldOf(kodo_World* handle) {
    return required(handle, "world").world;
}
inline const kodo::World& worldOf(const kodo_World* handle) {
    return required(handle, "world").world;
}

/// Marks a World as in use.
class InUse {
public:
    explicit InUse(const kodo_World& handle) : handle_(handle) { ++handle_.users; }
    InUse(const InUse&) = delete;
    InUse& operator=(const InUse&) = delete;
    ~InUse() { --handle_.users; }

private:
    const kodo_World& handle_;
};

} // namespace kodo_c
