// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <vector>

namespace support {

/// True under an address or thread sanitizer, which slows tests down several times.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// True in the tests of kodo64, whose code is that of kodo: they run fewer cases.
#ifdef KODO_DOUBLE
inline constexpr bool kDouble = true;
#else
inline constexpr bool kDouble = false;
#endif

/// True with KODO_TESTS_FULL (tools/test --full).
#ifdef KODO_TESTS_FULL
inline constexpr bool kFull = true;
#else
inline constexpr bool kFull = false;
#endif

/// Number of random cases: `whole` in float, half of it in double, a tenth under a sanitizer.
constexpr int draws(int whole) {
    return whole / (kSanitized ? 10 : kDouble ? 2 : 1);
}

/// All values in a full run; each day the first two in float, the first one in double and under a
/// sanitizer. So the value that finds most comes first.
template <typename T>
std::vector<T> variants(std::initializer_list<T> values) {
    if (kFull && !kSanitized) {
        return values;
    }
    const std::size_t most = kSanitized || kDouble ? 1 : 2;
    return {values.begin(), values.begin() + std::min(most, values.size())};
}

/// Number of random poses for each pair of kinds of shapes in tests/collide: each day half of those
/// of a full run. The environment variable RANDOM_POSES sets it, as 10000 for a thorough run; each
/// seed is fixed.
inline int poses() {
    static const char* const wanted = std::getenv("RANDOM_POSES");
    return wanted == nullptr ? (kSanitized ? 300 : draws(kFull ? 2000 : 1000)) : std::atoi(wanted);
}

} // namespace support
