// SPDX-License-Identifier: MIT
#pragma once

namespace support {

/// Is memory, or are threads, watched by a sanitizer? That makes everything several times as dear.
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

/// So many random cases; under a sanitizer a tenth.
constexpr int draws(int whole) {
    return kSanitized ? whole / 10 : whole;
}

} // namespace support
