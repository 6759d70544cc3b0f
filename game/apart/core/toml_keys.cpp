// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr std::size_t kLongestText = 160; // bytes of title or idea

constexpr int kMostNames = 16; // of a dotted key

/// Index behind the quoted text that begins at `start`.
std::size_t behindQuoted(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const std::string three(3, quote);
    const bool multiline = text.substr(start, 3) == three;
    std::size_t i = start + (multiline ? 3 : 1);
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (multiline && text.substr(i, 3) == three) {
            return i + 3;
        } else if (!multiline && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        }
    }
    return text.size();
}

/// Line of the first key with too many names; 0 if there is none.
int lineOfLongKey(std::string_view text) {
    constexpr std::string_view kEndOfKey = "\n=,[]{}";
    int line = 1;
    int names = 1;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t next = i + 1;
        if (text[i] == '"' || text[i] == '\'') {
            next = behindQuoted(text, i);
        } else if (text[i] == '#') {
            next = std::min(text.find('\n', i), text.size());
        } else if (text[i] == '.') {
            if (++names > kMostNames) {
                return line;
            }
        } else if (kEndOfKey.find(text[i]) != std::string_view::npos) {
            names = 1;
        }
        line +=
            static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                        text.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
        i = next;
    }
    return 0;
}

} // namespace

Read<toml::table> parseToml(std::string_view text, const std::string& file) {
    if (const int line = lineOfLongKey(text)) {
        return FileProblem{file, line,
                           "a key has more than " + std::to_string(kMostNames) +
                               " names, separated by dots"};
    }
    try {
        return toml::table(toml::parse(text, file));
    } catch (const toml::parse_error& error) {
        return FileProblem{file, static_cast<int>(error.source().begin.line),
                           std::string(error.description())};
    }
}

void TomlKeys::fail(int line, std::string reason) {
    constexpr std::size_t kMost = 20;
    if (!problem_) {
        problem_ = FileProblem{file_, line, std::move(reason)};
        return;
    }
    const auto sameLine = [&](const auto& known) { return known.first == line; };
    const bool isListed = problem_->line == line || // the first error of a line may cause others
                          std::any_of(problem_->more.begin(), problem_->more.end(), sameLine);
    if (!isListed && problem_->more.size() < kMost) {
        problem_->more.emplace_back(line, std::move(reason));
    }
}

void TomlKeys::onlyKeys(const toml::table& table, std::initializer_list<std::string_view> known,
                        const std::string& prefix) {
    for (const auto& [key, node] : table) {
        if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
            fail(static_cast<int>(key.source().begin.line),
                 "unknown key " + prefix + std::string(key.str()));
        }
    }
}

std::int32_t TomlKeys::number(const toml::table& table, const std::string& key,
                              const Range& range) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (!range.otherwise) {
            fail(lineOf(table), "the key " + key + " is missing");
        }
        return range.otherwise.value_or(range.low);
    }
    const auto* value = node->as_integer();
    if (value == nullptr || value->get() < range.low || value->get() > range.high) {
        fail(lineOf(*node), key + " must be a whole number from " + std::to_string(range.low) +
                                " to " + std::to_string(range.high));
        return range.low;
    }
    return static_cast<std::int32_t>(value->get());
}

std::string TomlKeys::text(const toml::table& table, const std::string& key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        fail(lineOf(table), "the key " + key + " is missing");
        return {};
    }
    const auto* value = node->as_string();
    if (value == nullptr || value->get().empty() || value->get().size() > kLongestText) {
        fail(lineOf(*node),
             key + " must be a text of 1 to " + std::to_string(kLongestText) + " bytes");
        return {};
    }
    for (const char c : value->get()) {
        if (c >= 0 && c < ' ') {
            fail(lineOf(*node), key + " must be one line without control characters");
        }
    }
    return value->get();
}

bool TomlKeys::flag(const toml::table& table, const std::string& key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        return false;
    }
    const auto* value = node->as_boolean();
    if (value == nullptr) {
        fail(lineOf(*node), key + " must be true or false");
        return false;
    }
    return value->get();
}

std::optional<std::size_t> TomlKeys::choice(const toml::table& table, const std::string& key,
                                            std::span<const std::string_view> names) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::string value = node->value_or(std::string());
    const auto found = std::find(names.begin(), names.end(), value);
    if (found != names.end()) {
        return static_cast<std::size_t>(found - names.begin());
    }
    std::string list;
    for (const std::string_view name : names) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    fail(lineOf(*node), key + " must be one of " + list);
    return std::nullopt;
}

} // namespace apart
