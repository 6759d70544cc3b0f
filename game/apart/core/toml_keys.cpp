// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>

#include <algorithm>
#include <array>
#include <iterator>

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

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

bool TomlKeys::isSimilar(std::string_view written, std::string_view meant) {
    const std::size_t most = std::clamp<std::size_t>(meant.size() / 2, 1, 2);
    if (written.size() > meant.size() + most) {
        return false;
    }
    std::vector<std::size_t> row(meant.size() + 1); // edit distances from the start of `written`
    for (std::size_t j = 0; j < row.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < meant.size(); ++j) {
            const std::size_t same = lower(written[i]) == lower(meant[j]) ? 0 : 1;
            const std::size_t best = std::min({diagonal + same, row[j] + 1, row[j + 1] + 1});
            diagonal = std::exchange(row[j + 1], best);
        }
    }
    return row.back() <= most;
}

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
    faults_.emplace(line, std::move(reason));
}

void TomlKeys::failAt(const std::vector<int>& lines, std::string reason) {
    for (std::size_t i = 1; i < lines.size(); ++i) {
        reason += (i > 1 ? ", line " : "; also in line ") + std::to_string(lines[i]);
    }
    fail(lines.front(), std::move(reason));
}

std::optional<FileProblem> TomlKeys::problem() const {
    if (faults_.empty()) {
        return std::nullopt;
    }
    FileProblem problem{file_, faults_.begin()->first, faults_.begin()->second};
    const std::size_t told = std::min(faults_.size(), kMostFaults);
    problem.more.assign(std::next(faults_.begin()),
                        std::next(faults_.begin(), static_cast<std::ptrdiff_t>(told)));
    if (faults_.size() > told) {
        problem.more.emplace_back(0, "and " + std::to_string(faults_.size() - told) + " more");
    }
    return problem;
}

void TomlKeys::onlyKeys(const toml::table& table, std::initializer_list<std::string_view> known,
                        const std::string& prefix) {
    for (const auto& [key, node] : table) {
        if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
            fail(static_cast<int>(key.source().begin.line),
                 "unknown key " + prefix + std::string(key.str()));
            unknown_.emplace_back(&table, std::string(key.str()));
        }
    }
}

bool TomlKeys::isMisspelled(const toml::table& table, const std::string& key) const {
    return std::any_of(unknown_.begin(), unknown_.end(), [&](const auto& other) {
        return other.first == &table && isSimilar(other.second, key);
    });
}

void TomlKeys::missing(const toml::table& table, const std::string& key,
                       const std::string& prefix) {
    if (!isMisspelled(table, key)) {
        fail(lineOf(table),
             prefix.empty() ? "the key " + key + " is missing" : prefix + key + " is missing");
    }
}

std::int32_t TomlKeys::number(const toml::table& table, const std::string& key,
                              const Range& range) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (!range.otherwise) {
            missing(table, key);
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

TomlKeys::Pair TomlKeys::pair(const toml::table& table, const std::string& key, std::int32_t most,
                              std::optional<Pair> otherwise) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (!otherwise) {
            missing(table, key);
        }
        return otherwise.value_or(Pair{});
    }
    const toml::array* list = node->as_array();
    std::array<std::int32_t, 2> numbers{};
    bool good = list != nullptr && list->size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const auto* value = list->get(i)->as_integer();
        good = value != nullptr && value->get() >= -most && value->get() <= most;
        numbers[i] = good ? static_cast<std::int32_t>(value->get()) : 0;
    }
    if (!good) {
        fail(lineOf(*node), key + " must be two whole numbers from -" + std::to_string(most) +
                                " to " + std::to_string(most));
    }
    return {numbers[0], numbers[1]};
}

std::string TomlKeys::text(const toml::table& table, const std::string& key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        missing(table, key);
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
            return {};
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

std::string basicString(std::string_view text) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            result += '\\';
        }
        if (code < 0x20 || code == 0x7f) {
            result += "\\u00";
            result += kHex[code / 16];
            result += kHex[code % 16];
        } else {
            result += letter;
        }
    }
    return result + '"';
}

} // namespace apart
