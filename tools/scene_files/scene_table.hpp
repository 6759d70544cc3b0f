// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/toml_keys.hpp>
#include <kodo/kodo.hpp>

#include <array>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace scene_files {
inline namespace KODO_PRECISION {

/// "shape.linearDamping" as the key that it comes from: linear_damping.
std::string keyOf(const std::string& field);

/// One table. Each key that is asked for counts as used.
class Table {
public:
    Table(apart::TomlKeys& keys, const toml::table& table) : keys_(&keys), table_(&table) {}

    apart::TomlKeys& keys() { return *keys_; }
    /// Tells keys that are none of these.
    void onlyKeys(std::initializer_list<std::string_view> known, const std::string& prefix);
    int line() const { return apart::TomlKeys::lineOf(*table_); }
    /// The line of a key, or of the table.
    int line(const std::string& key) const {
        const toml::node* node = table_->get(key);
        return node != nullptr ? apart::TomlKeys::lineOf(*node) : line();
    }
    bool has(const std::string& key) const { return table_->contains(key); }
    const toml::node* get(const std::string& key) {
        used_.insert(key);
        return table_->get(key);
    }
    void need(const std::string& key) {
        if (!has(key)) {
            keys_->missing(*table_, key);
        }
    }
    void fail(const std::string& key, const std::string& reason) {
        keys_->fail(line(key), key + " " + reason);
    }
    /// What kodo::check() says, at the key that it names.
    void fail(const kodo::Problem& problem);

    std::optional<double> number(const std::string& key) {
        const toml::node* node = get(key);
        return node != nullptr ? number(*node, key) : std::nullopt;
    }
    std::optional<double> number(const toml::node& node, const std::string& key);
    double number(const std::string& key, double low, double high, double otherwise);
    std::optional<kodo::Vec2> pair(const std::string& key) {
        const toml::node* node = get(key);
        return node != nullptr ? pair(*node, key) : std::nullopt;
    }
    std::optional<kodo::Vec2> pair(const toml::node& node, const std::string& key);
    std::optional<std::vector<kodo::Vec2>> points(const std::string& key);
    std::optional<kodo::Flags> categories(const std::string& key);
    bool flag(const std::string& key) {
        used_.insert(key);
        return keys_->flag(*table_, key);
    }
    std::string text(const std::string& key) {
        used_.insert(key);
        return keys_->text(*table_, key);
    }
    template <std::size_t count>
    std::optional<std::size_t> choice(const std::string& key,
                                      const std::array<std::string_view, count>& names) {
        used_.insert(key);
        return keys_->choice(*table_, key, names);
    }

    template <typename Def>
    void take(const char* key, Def& def, kodo::Real Def::*member) {
        if (const std::optional<double> value = number(key)) {
            def.*member = static_cast<kodo::Real>(*value);
        }
    }
    template <typename Def>
    void take(const char* key, Def& def, int Def::*member) {
        def.*member = static_cast<int>(number(key, 0, 1e6, def.*member));
    }
    template <typename Def>
    void take(const char* key, Def& def, bool Def::*member) {
        def.*member = flag(key);
    }
    template <typename Def>
    void take(const char* key, Def& def, kodo::Vec2 Def::*member) {
        def.*member = pair(key).value_or(def.*member);
    }
    template <typename Def>
    void take(const char* key, Def& def, std::optional<kodo::Vec2> Def::*member) {
        def.*member = pair(key);
    }
    template <typename Def>
    void take(const char* key, Def& def, std::optional<kodo::Range> Def::*member) {
        if (const std::optional<kodo::Vec2> both = pair(key)) {
            def.*member = kodo::Range{both->x, both->y};
        }
    }

    /// Keys that nothing has asked for.
    void noOther(const std::string& where);
    /// These ones have no use.
    void noUse(std::initializer_list<const char*> unwanted, const std::string& where);

private:
    apart::TomlKeys* keys_;
    const toml::table* table_;
    std::set<std::string> used_;
};

/// Calls take(table) for each [[key]].
template <typename Take>
void eachOf(apart::TomlKeys& keys, const toml::node* node, const std::string& key, Take take) {
    if (node == nullptr) {
        return;
    }
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty() || !list->is_homogeneous(toml::node_type::table)) {
        keys.fail(apart::TomlKeys::lineOf(*node), key + " must be written as [[" + key + "]]");
        return;
    }
    for (const toml::node& one : *list) {
        take(*one.as_table());
    }
}

} // namespace KODO_PRECISION
} // namespace scene_files
