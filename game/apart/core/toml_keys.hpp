// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>

#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace apart {

/// Parses a TOML text. Keys of more than 16 names are refused: each name is a table within the one
/// before, and the parser recurs for each.
Read<toml::table> parseToml(std::string_view text, const std::string& file);

/// Reads keys of TOML tables and keeps the first problem with its line.
class TomlKeys {
public:
    explicit TomlKeys(std::string file) : file_(std::move(file)) {}

    struct Range {
        std::int32_t low = 0;
        std::int32_t high = 0;
        std::optional<std::int32_t> otherwise{}; // default; without it the key is required
    };

    static int lineOf(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

    void fail(int line, std::string reason);
    const std::optional<FileProblem>& problem() const { return problem_; }

    void onlyKeys(const toml::table& table, std::initializer_list<std::string_view> known,
                  const std::string& prefix);
    std::int32_t number(const toml::table& table, const std::string& key, const Range& range);
    std::string text(const toml::table& table, const std::string& key);
    bool flag(const toml::table& table, const std::string& key); // false unless given
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
    std::optional<FileProblem> problem_;
};

} // namespace apart
