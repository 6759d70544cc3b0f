// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// Called with the text of the failed condition and its location. It may throw, as in tests. If it
/// returns, the program is aborted.
using AssertHandler = void (*)(const char* condition, const char* file, int line);

/// Replaces the handler of KODO_ASSERT and returns the previous one. nullptr restores the default,
/// which prints to stderr.
AssertHandler setAssertHandler(AssertHandler handler);

[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);

} // namespace KODO_PRECISION
} // namespace kodo

/// Checks an internal invariant, which fails only if the engine has a bug. Invalid user input
/// throws an exception with a message instead.
#ifdef KODO_ENABLE_ASSERTS
#define KODO_ASSERT(condition)                                                                     \
    ((condition) ? static_cast<void>(0) : ::kodo::assertionFailed(#condition, __FILE__, __LINE__))
#else
#define KODO_ASSERT(condition) static_cast<void>(0)
#endif
