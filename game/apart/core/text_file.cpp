// SPDX-License-Identifier: MIT
#include <apart/core/text_file.hpp>
#include <kodo/state_hash.hpp>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <system_error>

#ifndef _WIN32
#include <sys/stat.h>

#include <fcntl.h>
#include <unistd.h>
#endif

namespace apart {

namespace {

/// Reads at most `limit` + 1 bytes of a regular file into `bytes`, none of a longer one. Returns
/// the reason why it cannot be read, or "".
#ifdef _WIN32
std::string readBytes(const std::filesystem::path& path, std::size_t limit, std::string& bytes) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > limit) {
        bytes.resize(error ? 0 : limit + 1);
        return error ? "cannot be read" : "";
    }
    std::ifstream stream(path, std::ios::binary);
    bytes.resize(static_cast<std::size_t>(size));
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return stream.is_open() && !stream.bad() ? "" : "cannot be read";
}
#else
/// A file descriptor that is closed at the end of its scope.
struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    ~Descriptor() {
        if (number >= 0) {
            close(number);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number;
};

std::string readBytes(const std::filesystem::path& path, std::size_t limit, std::string& bytes) {
    // Without O_NONBLOCK, opening a pipe that has replaced the file meanwhile would wait for ever.
    const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat about {};
    if (file.number < 0 || fstat(file.number, &about) != 0) {
        return "cannot be read";
    }
    if (!S_ISREG(about.st_mode)) {
        return "is a pipe, a device or a socket, not a file";
    }
    if (about.st_size > 0 && static_cast<std::uintmax_t>(about.st_size) > limit) {
        bytes.resize(limit + 1);
        return "";
    }
    constexpr std::size_t kChunk = 65536; // files of /proc are regular, but report no size
    for (std::size_t had = 0; had <= limit; had = bytes.size()) {
        bytes.resize(std::min(had + kChunk, limit + 1));
        const ssize_t count = read(file.number, bytes.data() + had, bytes.size() - had);
        bytes.resize(had + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count <= 0) {
            return count < 0 ? "cannot be read" : "";
        }
    }
    return "";
}
#endif

/// A decoded character: its code point and length in bytes.
struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0; // 0: not UTF-8
};

Character decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) {
        return {first, 1};
    }
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (first < 0xc2 || first > 0xf4 || text.size() < length) {
        return {};
    }
    std::uint32_t code = first & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return {};
        }
        code = code << 6 | (byte(i) & 0x3fu);
    }
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[length] || code > 0x10ffff || surrogate ? Character{}
                                                                 : Character{code, length};
}

/// True for characters that command a terminal, or change the order of the text around them.
bool isCommand(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x61c || code == 0x200e ||
           code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

} // namespace

std::string notAFile(std::filesystem::file_status status) {
    if (!std::filesystem::exists(status)) {
        return "there is no such file";
    }
    if (std::filesystem::is_directory(status)) {
        return "is a folder, not a file";
    }
    return std::filesystem::is_regular_file(status) ? ""
                                                    : "is a pipe, a device or a socket, not a file";
}

std::string printable(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const auto [code, length] = decode(text);
        if (length == 0 || isCommand(code)) {
            shown += '?';
        } else {
            shown += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return shown;
}

std::vector<std::uint32_t> codePoints(std::string_view utf8) {
    std::vector<std::uint32_t> codes;
    while (!utf8.empty()) {
        const auto [code, length] = decode(utf8);
        if (length > 0) {
            codes.push_back(code);
        }
        utf8.remove_prefix(std::max<std::size_t>(1, length));
    }
    return codes;
}

std::string FileProblem::text() const {
    std::string text = file;
    if (line > 0) {
        text += ':';
        text += std::to_string(line);
    }
    text += ": ";
    return printable(text += reason);
}

std::vector<std::string> FileProblem::texts() const {
    std::vector<std::string> all = {text()};
    for (const auto& [otherLine, otherReason] : more) {
        all.push_back(FileProblem{file, otherLine, otherReason}.text());
    }
    return all;
}

Read<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit) {
    const auto wrong = [&](std::string reason) {
        return FileProblem{path.string(), 0, std::move(reason)};
    };
    std::error_code error;
    std::string reason = notAFile(std::filesystem::status(path, error));
    std::string bytes;
    if (reason.empty()) {
        reason = readBytes(path, limit, bytes);
    }
    if (!reason.empty()) {
        return wrong(std::move(reason));
    }
    if (bytes.size() > limit) {
        return wrong("is longer than " + std::to_string(limit) + " bytes");
    }
    return bytes;
}

std::uint64_t digestOf(std::string_view bytes) {
    kodo::StateHash hash;
    for (const char byte : bytes) {
        hash.add(static_cast<std::uint8_t>(byte));
    }
    return hash.value();
}

std::optional<std::int64_t> toNumber(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::uint64_t> fromHex(std::string_view text) {
    std::uint64_t value = 0;
    for (const char digit : text) {
        const bool decimal = digit >= '0' && digit <= '9';
        if (text.size() != 16 || (!decimal && (digit < 'a' || digit > 'f'))) {
            return std::nullopt;
        }
        value = value << 4 | static_cast<std::uint64_t>(decimal ? digit - '0' : digit - 'a' + 10);
    }
    return text.empty() ? std::nullopt : std::optional(value);
}

std::string toHex(std::uint64_t value) {
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) {
        text[i] = "0123456789abcdef"[value & 15];
    }
    return text;
}

std::string wrongSeed(const std::string& text) {
    const std::optional<std::int64_t> number = toNumber(text);
    if (number && *number >= 0 && *number <= std::numeric_limits<std::uint32_t>::max()) {
        return {};
    }
    std::string sentence = "a seed is a whole number from 0 to 4294967295, not '";
    sentence += text;
    return sentence += '\'';
}

} // namespace apart
