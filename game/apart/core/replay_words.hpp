// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// The words of a line of a replay, without its comment.
using Words = std::vector<std::string_view>;
Words wordsOf(std::string_view line);

/// Index of the word among the names.
std::optional<std::size_t> indexOf(std::string_view word, std::span<const std::string_view> names);

/// For a message: at most 40 printable characters of the word.
std::string quoted(std::string_view word);

/// Empty unless the word is a whole number from 0 to kLongestReplay.
std::optional<std::uint32_t> tickOf(std::string_view word);
/// Why a word is no tick.
std::string tickReason(std::string_view word);

} // namespace apart
