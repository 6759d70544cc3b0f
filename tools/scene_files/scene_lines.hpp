// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene_keys.hpp"

// Values as TOML.
namespace scene_files {
inline namespace KODO_PRECISION {

/// The shortest digits that give the same bits.
inline std::string textOf(kodo::Real value) {
    return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}
inline std::string textOf(kodo::Vec2 value) {
    return "[" + textOf(value.x) + ", " + textOf(value.y) + "]";
}
inline std::string textOf(const std::vector<kodo::Vec2>& points) {
    std::string all;
    for (const kodo::Vec2 point : points) {
        all += (all.empty() ? "" : ", ") + textOf(point);
    }
    return "[" + all + "]";
}
inline std::string inQuotes(std::string_view words) {
    std::string made = "\"";
    for (const char c : words) {
        made += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return made + "\"";
}
inline std::string categoryList(kodo::Flags flags) {
    std::string all;
    for (unsigned number = 0; number < kCategories; ++number) {
        if ((flags & kodo::category(number)) != 0) {
            all += (all.empty() ? "" : ", ") + std::to_string(number);
        }
    }
    if ((flags & kodo::kDefaultCategory) != 0) {
        all += all.empty() ? "\"default\"" : ", \"default\"";
    }
    return "[" + all + "]";
}

/// Lines of a table, or the content of a table in one line.
class Lines {
public:
    explicit Lines(const char* between) : between_(between) {}

    void add(std::string_view key, const std::string& value) {
        made_ += (made_.empty() ? "" : between_) + std::string(key) + " = " + value;
    }
    void flag(std::string_view key, bool set) {
        if (set) {
            add(key, "true");
        }
    }
    /// A number other than that of a value-initialised definition.
    template <typename Def, typename Value>
    void take(const char* key, const Def& def, Value Def::*member) {
        static const Def kUsual{};
        if (def.*member == kUsual.*member && !(isZero(def.*member))) {
            return;
        }
        write(key, def.*member, kUsual.*member);
    }
    const std::string& made() const { return made_; }

private:
    static bool isZero(kodo::Real value) { return value == 0 && std::signbit(value); }
    template <typename Value>
    static bool isZero(const Value&) {
        return false;
    }
    static bool isZero(kodo::Vec2 value) { return isZero(value.x) || isZero(value.y); }

    void write(const char* key, kodo::Real value, kodo::Real) { add(key, textOf(value)); }
    void write(const char* key, int value, int) { add(key, std::to_string(value)); }
    void write(const char* key, bool value, bool) { flag(key, value); }
    void write(const char* key, kodo::Vec2 value, kodo::Vec2) { add(key, textOf(value)); }
    void write(const char* key, const std::optional<kodo::Vec2>& value,
               const std::optional<kodo::Vec2>&) {
        add(key, textOf(*value));
    }
    void write(const char* key, const std::optional<kodo::Range>& value,
               const std::optional<kodo::Range>&) {
        add(key, textOf(kodo::Vec2{value->lower, value->upper}));
    }

    const char* between_;
    std::string made_;
};

/// Match mode, what it compares with, and group.
void writeMatch(Lines& lines, const kodo::CollisionFilter& filter);
/// A body as a table.
std::string bodyText(const kodo::BodyView& body, const std::string& name);

} // namespace KODO_PRECISION
} // namespace scene_files
