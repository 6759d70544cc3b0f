// SPDX-License-Identifier: MIT
#include "scene_table.hpp"

#include <algorithm>
#include <cmath>

#include "scene_keys.hpp"

namespace scene_files {
inline namespace KODO_PRECISION {

using apart::TomlKeys;
using kodo::Flags;
using kodo::Real;
using kodo::Vec2;

namespace {
constexpr double kLargestNumber = 1e12; // kodo::check() has the limits of each key
} // namespace

std::string keyOf(const std::string& field) {
    std::string key;
    for (const char c : field.substr(field.rfind('.') + 1)) {
        if (c == '[') {
            break;
        }
        const bool capital = c >= 'A' && c <= 'Z';
        key += capital ? std::string{'_', static_cast<char>(c - 'A' + 'a')} : std::string{c};
    }
    return key == "angular_velocity" ? "spin" : key == "corners" ? "polygon" : key;
}

std::optional<double> Table::number(const toml::node& node, const std::string& key) {
    const std::optional<double> value =
        node.is_number() ? node.value<double>() : std::optional<double>();
    if (!value || !(std::abs(*value) <= kLargestNumber)) {
        keys_->fail(TomlKeys::lineOf(node), key + " must be a number");
        return std::nullopt;
    }
    return value;
}

double Table::number(const std::string& key, double low, double high, double otherwise) {
    const toml::node* node = get(key);
    if (node == nullptr) {
        return otherwise;
    }
    const double value = node->is_number() ? node->value<double>().value_or(low - 1) : low - 1;
    if (!(value >= low && value <= high)) {
        const auto shortly = [](double limit) {
            std::string digits = std::to_string(limit);
            digits.erase(digits.find_last_not_of('0') + 1);
            return digits.back() == '.' ? digits.substr(0, digits.size() - 1) : digits;
        };
        fail(key, "must be a number from " + shortly(low) + " to " + shortly(high));
        return otherwise;
    }
    return value;
}

std::optional<Vec2> Table::pair(const toml::node& node, const std::string& key) {
    const toml::array* list = node.as_array();
    if (list != nullptr && list->size() == 2 && list->get(0)->is_number() &&
        list->get(1)->is_number()) {
        const std::optional<double> x = number(*list->get(0), key);
        const std::optional<double> y = number(*list->get(1), key);
        return x && y ? std::optional(Vec2{static_cast<Real>(*x), static_cast<Real>(*y)})
                      : std::nullopt;
    }
    keys_->fail(TomlKeys::lineOf(node), key + " must be two numbers, as [1, 2]");
    return std::nullopt;
}

std::optional<std::vector<Vec2>> Table::points(const std::string& key) {
    const toml::node* node = get(key);
    const toml::array* list = node != nullptr ? node->as_array() : nullptr;
    if (node == nullptr) {
        return std::nullopt;
    }
    if (list == nullptr || list->size() < 2) {
        fail(key, "must be a list of points, as [[0, 0], [1, 0], [0, 1]]");
        return std::nullopt;
    }
    std::vector<Vec2> all;
    for (const toml::node& one : *list) {
        all.push_back(pair(one, "a point of " + key).value_or(Vec2{}));
    }
    return all;
}

std::optional<Flags> Table::categories(const std::string& key) {
    const toml::node* node = get(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    Flags all = 0;
    const toml::array* list = node->as_array();
    bool good = list != nullptr;
    for (std::size_t i = 0; good && i < list->size(); ++i) {
        const auto* name = list->get(i)->as_string();
        if (key == "with" && name != nullptr && name->get() == "default") {
            all |= kodo::kDefaultCategory;
            continue;
        }
        const auto* number = list->get(i)->as_integer();
        good = number != nullptr && number->get() >= 0 && number->get() < kCategories;
        all |= good ? kodo::category(static_cast<unsigned>(number->get())) : 0;
    }
    if (!good) {
        const char* const more = key == "with" ? ", and \"default\" for bodies without one" : "";
        fail(key, std::string("must be a list of whole numbers from 0 to 47, as [0, 3]") + more);
    }
    return all;
}

void Table::onlyKeys(std::initializer_list<std::string_view> known, const std::string& prefix) {
    keys_->onlyKeys(*table_, known, prefix);
    for (const auto& [key, node] : *table_) {
        if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
            used_.insert(std::string(key.str())); // told
        }
    }
}

void Table::noOther(const std::string& where) {
    for (const auto& [key, node] : *table_) {
        if (!used_.contains(std::string(key.str()))) {
            keys_->fail(TomlKeys::lineOf(node), std::string(key.str()) + " has no use in " + where);
        }
    }
}

void Table::noUse(std::initializer_list<const char*> unwanted, const std::string& where) {
    for (const char* key : unwanted) {
        if (has(key)) {
            fail(key, "has no use in " + where);
        }
    }
}

void Table::fail(const kodo::Problem& problem) {
    const std::string key = keyOf(problem.field);
    keys_->fail(line(key), key + " " + problem.reason);
}

} // namespace KODO_PRECISION
} // namespace scene_files
