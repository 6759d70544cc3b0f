// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>

#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace apart {

/// Parses a TOML text. Keys of more than 16 names are refused: each name is a table within the one
/// before, and the parser recurs for each.
Read<toml::table> parseToml(std::string_view text, const std::string& file);

/// A basic string of TOML, in quotes.
std::string basicString(std::string_view text);

/// Reads keys of TOML tables and keeps all faults with their lines.
class TomlKeys {
public:
    explicit TomlKeys(std::string file) : file_(std::move(file)) {}

    struct Range {
        std::int32_t low = 0;
        std::int32_t high = 0;
        std::optional<std::int32_t> otherwise{}; // default; without it the key is required
    };

    struct Pair {
        std::int32_t first = 0;
        std::int32_t second = 0;
    };

    static int lineOf(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

    void fail(int line, std::string reason);
    /// A fault at several lines: the first one, with the others in its text.
    void failAt(const std::vector<int>& lines, std::string reason);
    std::size_t faults() const { return faults_.size(); } // so far
    /// The first kMostFaults faults by line, then the number of the others. nullopt: there are
    /// none.
    std::optional<FileProblem> problem() const;
    static constexpr std::size_t kMostFaults = 20;

    /// True if a key is a misspelling of another one: at most two letters are inserted, removed or
    /// exchanged, in a key of less than four one. Capitals do not count.
    static bool isSimilar(std::string_view written, std::string_view meant);
    /// True if an unknown key of the table is a misspelling of this key.
    bool isMisspelled(const toml::table& table, const std::string& key) const;
    /// A required key is absent: a fault unless it is misspelled.
    void missing(const toml::table& table, const std::string& key, const std::string& prefix = "");
    void onlyKeys(const toml::table& table, std::initializer_list<std::string_view> known,
                  const std::string& prefix);
    std::int32_t number(const toml::table& table, const std::string& key, const Range& range);
    /// Two whole numbers from -most to most.
    Pair pair(const toml::table& table, const std::string& key, std::int32_t most,
              std::optional<Pair> otherwise);
    std::string text(const toml::table& table, const std::string& key); // empty after a fault
    bool flag(const toml::table& table, const std::string& key);        // false unless given
    /// Index of the key's text among the names; nullopt if the key is absent or invalid.
    std::optional<std::size_t> choice(const toml::table& table, const std::string& key,
                                      std::span<const std::string_view> names);
    /// The same as an enumerator, or `otherwise`.
    template <typename Enum>
    Enum choice(const toml::table& table, const std::string& key,
                std::span<const std::string_view> names, Enum otherwise) {
        return static_cast<Enum>(
            choice(table, key, names).value_or(static_cast<std::size_t>(otherwise)));
    }

private:
    std::string file_;
    std::set<std::pair<int, std::string>> faults_;                    // by line
    std::vector<std::pair<const toml::table*, std::string>> unknown_; // keys
};

} // namespace apart
