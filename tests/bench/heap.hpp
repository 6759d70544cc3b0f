// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace bench {

/// How often operator new has been called so far. A program that links this has it counted. What
/// calls malloc itself, as Box2D does, is not seen.
std::uint64_t allocationCount();

/// Bytes that operator new has given out and not got back, by the size that malloc really gave.
std::size_t liveBytes();

/// Bytes that malloc has given out and not got back, whoever called it; 0 where the C library does
/// not tell.
std::size_t heapBytes();

} // namespace bench
