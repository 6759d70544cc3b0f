// SPDX-License-Identifier: MIT
#pragma once

namespace support {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// So many random cases; under a sanitizer, which makes each several times as dear, a tenth.
constexpr int draws(int whole) {
    return kSanitized ? whole / 10 : whole;
}

} // namespace support
