// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/run.hpp>

#include <string>
#include <string_view>

namespace apart {

/// A run in few bytes: its inputs by differences, and few of its state hashes (kLinkHash), coded by
/// BitCoder. The first byte, kPackedMark, begins no replay and no data of raw deflate.
std::string packed(const ReplayRun& run);
Read<ReplayRun> unpacked(std::string_view bytes, const std::string& file);
inline constexpr char kPackedMark = 0x07;
inline constexpr std::uint32_t kLinkHash = 1200; // ticks

/// "#replay=..." behind the address of a page of the game: packed() as base64 for URLs.
std::string linkOf(const ReplayRun& run);
/// True if the text has such a fragment.
bool isLink(std::string_view text);
Read<ReplayRun> runOfLink(std::string_view link);

} // namespace apart
