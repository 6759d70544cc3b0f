// SPDX-License-Identifier: MIT
#include <apart/core/text_file.hpp>
#include <kodo/state_hash.hpp>

#include <charconv>
#include <fstream>
#include <limits>
#include <system_error>

namespace apart {

std::string FileProblem::text() const {
    std::string text = file;
    if (line > 0) {
        text += ':';
        text += std::to_string(line);
    }
    text += ": ";
    return text += reason;
}

Read<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit) {
    const auto wrong = [&](std::string reason) {
        return FileProblem{path.string(), 0, std::move(reason)};
    };
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return wrong("there is no such file");
    }
    if (std::filesystem::is_directory(status)) {
        return wrong("is a folder, not a file");
    }
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(limit + 1, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream.is_open() || stream.bad()) {
        return wrong("cannot be read");
    }
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > limit) {
        return wrong("is longer than " + std::to_string(limit) + " bytes");
    }
    return bytes;
}

std::optional<FileProblem> writeTextFile(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path fresh = path;
    fresh += ".new";
    {
        std::ofstream stream(fresh, std::ios::binary | std::ios::trunc);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.flush();
        if (!stream) {
            std::error_code ignored;
            std::filesystem::remove(fresh, ignored);
            return FileProblem{path.string(), 0, "cannot be written"};
        }
    }
    std::error_code error;
    std::filesystem::rename(fresh, path, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(fresh, ignored);
        return FileProblem{path.string(), 0, "cannot be written: " + error.message()};
    }
    return std::nullopt;
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
