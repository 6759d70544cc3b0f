// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace bench {

/// Number of calls of operator new so far, in any program that links this. Direct calls of malloc,
/// as in Box2D, are not counted.
std::uint64_t allocationCount();

/// Bytes allocated by operator new and not freed, by the usable size of the blocks.
std::size_t liveBytes();

/// Bytes allocated by malloc and not freed, by any caller. 0 if the C library provides no count.
std::size_t heapBytes();

} // namespace bench
