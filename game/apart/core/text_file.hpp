// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace apart {

/// An error in a file, with its place.
struct FileProblem {
    std::string file;
    int line = 0; // from 1; 0: the file as a whole
    std::string reason;
    std::vector<std::pair<int, std::string>> more{}; // further errors: line and reason

    /// "levels/arch.toml:12: the reason", printable. Of the first error.
    std::string text() const;
    /// The text of each error.
    std::vector<std::string> texts() const;
};

/// The text for a terminal: every control character (C0, C1, DEL), bidirectional mark, line
/// separator and byte that is not UTF-8 becomes '?'.
std::string printable(std::string_view text);

/// The code points of a text; bytes that are not UTF-8 are left out.
std::vector<std::uint32_t> codePoints(std::string_view utf8);

/// A value, or the reason why it could not be read.
template <typename T>
using Read = std::variant<T, FileProblem>;

/// The bytes of a regular file of at most `limit` bytes. A pipe, a device, a folder or a longer
/// file is refused before any of it is read.
Read<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit);

/// Writes a temporary file beside `path`, brings it to the disk and then renames it, so that a
/// failure keeps the old file. Its name is its own, so that two programs may save at once. A
/// symbolic link stays: its target is written. A pipe or a device is refused, since the renamed
/// file would replace it.
std::optional<FileProblem> writeTextFile(const std::filesystem::path& path, std::string_view text);

/// 64-bit FNV-1a; detects damage, not forgery.
std::uint64_t digestOf(std::string_view bytes);

// Numbers as text, independent of locale. The whole text must be a number.
std::optional<std::int64_t> toNumber(std::string_view text);
std::optional<std::uint64_t> fromHex(std::string_view text); // 16 digits, lower case
std::string toHex(std::uint64_t value);

/// Why a seed is invalid, as a sentence; empty if it is an integer from 0 to 4294967295.
std::string wrongSeed(const std::string& text);

} // namespace apart
