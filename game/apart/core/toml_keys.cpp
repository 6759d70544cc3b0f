// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr std::size_t kLongestText = 160; // bytes of title or idea

} // namespace

void TomlKeys::fail(int line, std::string reason) {
    if (!problem_) {
        problem_ = FileProblem{file_, line, std::move(reason)};
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
