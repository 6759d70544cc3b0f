// SPDX-License-Identifier: MIT
#pragma once

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

/// Number of random cases: `whole` in float, half of it in double, a tenth under a sanitizer.
constexpr int draws(int whole) {
    return whole / (kSanitized ? 10 : kDouble ? 2 : 1);
}

/// All values in float; the first one in double and under a sanitizer.
template <typename T>
std::vector<T> variants(std::initializer_list<T> values) {
    return kSanitized || kDouble ? std::vector<T>{*values.begin()} : std::vector<T>(values);
}

/// Number of random poses for each pair of kinds of shapes in tests/collide. The environment
/// variable RANDOM_POSES sets it, as 10000 for a thorough run; each seed is fixed.
inline int poses() {
    static const char* const wanted = std::getenv("RANDOM_POSES");
    return wanted == nullptr ? (kSanitized ? 300 : draws(2000)) : std::atoi(wanted);
}

} // namespace support
