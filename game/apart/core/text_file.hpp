// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace apart {

/// What is wrong with a file from outside, and where.
struct FileProblem {
    std::string file;
    int line = 0; // from 1; 0: the file as a whole
    std::string reason;

    /// "levels/arch.toml:12: the reason".
    std::string text() const;
};

/// The value, or why there is none.
template <typename T>
using Read = std::variant<T, FileProblem>;

/// The bytes of a file of at most `limit` bytes.
Read<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit);

/// Writes to a new file beside it and then renames it over the old one, so that a failure leaves
/// the old one as it was.
std::optional<FileProblem> writeTextFile(const std::filesystem::path& path, std::string_view text);

/// FNV-1a with 64 bits; finds damage, not forgery.
std::uint64_t digestOf(std::string_view bytes);

// Numbers as text, independent of locale. Reading wants the whole of the text.
std::optional<std::int64_t> toNumber(std::string_view text);
std::optional<std::uint64_t> fromHex(std::string_view text); // 16 digits, lower case
std::string toHex(std::uint64_t value);

/// What is wrong with a seed, as a sentence; empty when it is a whole number from 0 to 4294967295.
std::string wrongSeed(const std::string& text);

} // namespace apart
