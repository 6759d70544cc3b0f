// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

namespace kodo::inline KODO_PRECISION {

/// Called with the broken condition and its place. It may throw (tests do); if it returns, the
/// program is aborted.
using AssertHandler = void (*)(const char* condition, const char* file, int line);

/// Replaces the handler of KODO_ASSERT and returns the one before; nullptr restores the default,
/// which prints to stderr.
AssertHandler setAssertHandler(AssertHandler handler);

[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);

} // namespace kodo::inline KODO_PRECISION

/// Checks what cannot be false unless the engine itself is wrong. What a user can get wrong is
/// refused with a sentence at the World's door instead.
#ifdef KODO_ENABLE_ASSERTS
#define KODO_ASSERT(condition)                                                                     \
    ((condition) ? static_cast<void>(0) : ::kodo::assertionFailed(#condition, __FILE__, __LINE__))
#else
#define KODO_ASSERT(condition) static_cast<void>(0)
#endif
