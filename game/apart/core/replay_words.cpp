// SPDX-License-Identifier: MIT
#include <apart/core/replay.hpp>
#include <apart/core/replay_words.hpp>

#include <algorithm>

namespace apart {

Words wordsOf(std::string_view line) {
    Words words;
    line = line.substr(0, line.find('#'));
    const std::string_view blanks = " \t\r";
    for (std::size_t start = line.find_first_not_of(blanks); start != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, start), line.size());
        words.push_back(line.substr(start, end - start));
        start = line.find_first_not_of(blanks, end);
    }
    return words;
}

std::optional<std::size_t> indexOf(std::string_view word, std::span<const std::string_view> names) {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - names.begin());
}

std::string quoted(std::string_view word) {
    std::string text = "'";
    for (const char c : word.substr(0, 40)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    return text + "'";
}

std::optional<std::uint32_t> tickOf(std::string_view word) {
    const std::optional<std::int64_t> value = toNumber(word);
    if (!value || *value < 0 || *value > kLongestReplay) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(*value);
}

std::string tickReason(std::string_view word) {
    return quoted(word) + " is not a tick: a whole number from 0 to " +
           std::to_string(kLongestReplay);
}

} // namespace apart
