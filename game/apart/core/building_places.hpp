// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/building.hpp>
#include <apart/core/toml_keys.hpp>

#include <span>
#include <string>
#include <vector>

namespace apart {

/// Bounds of 1/1000 m, both included.
struct PlaceRange {
    std::int32_t low = 0;
    std::int32_t high = 0;
};

/// Checks the places of the copies of a table: blocks lie within the field, and at most 20 of them
/// at one place.
class BuildingPlaces {
public:
    explicit BuildingPlaces(TomlKeys& keys) : keys_(keys) {}

    /// The blocks of a table, of at most the field in size. Faults are named once for each of x and
    /// y.
    void add(const toml::table& table, std::span<const FreeBlock> copies);
    /// After all blocks.
    void checkCrowds();

    /// A fault unless the value of copy `number` from 1 is in range. `key` is a key of the table;
    /// `also` ends the sentence.
    bool check(const toml::table& table, const std::string& key, std::int32_t value,
               const PlaceRange& range, const std::string& name, const std::string& also = "");

private:
    struct Middle {
        kodo::Vec2 place;
        kodo::Real size = 0; // m, the smaller one of width and height
        int line = 0;        // of its table
    };

    TomlKeys& keys_;
    std::vector<Middle> middles_;
};

} // namespace apart
