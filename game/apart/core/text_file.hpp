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

/// Reason not to read or replace what stands at a path; empty if it is a regular file. A pipe or a
/// device might never end.
std::string notAFile(std::filesystem::file_status status);

/// Writes a temporary file beside `path`, brings it to the disk and then renames it, so that a
/// failure keeps the old file. Its name is its own, so that two programs may save at once. Mode and
/// owner stay, and a symbolic link does: its target is written. A file with several names (hard
/// links) is written in place. A file without write permission is refused, and so is a pipe or a
/// device, which the renamed file would replace.
std::optional<FileProblem> writeTextFile(const std::filesystem::path& path, std::string_view text);

/// While one lives and is held, no other one is, in any process: around reading a file, merging
/// and writing it. It ends with its process. Not on Windows, where each is held.
class FolderLock {
public:
    /// Tries each 5 ms, so often at most.
    explicit FolderLock(const std::filesystem::path& folder, int attempts = 1000);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Also true where the file system has no locks.
    bool held() const { return held_; }

private:
    int folder_ = -1;
    bool held_ = true;
};

/// 64-bit FNV-1a; detects damage, not forgery.
std::uint64_t digestOf(std::string_view bytes);

// Numbers as text, independent of locale. The whole text must be a number.
std::optional<std::int64_t> toNumber(std::string_view text);
std::optional<std::uint64_t> fromHex(std::string_view text); // 16 digits, lower case
std::string toHex(std::uint64_t value);

/// Why a seed is invalid, as a sentence; empty if it is an integer from 0 to 4294967295.
std::string wrongSeed(const std::string& text);

} // namespace apart
