// SPDX-License-Identifier: MIT
#include <apart/core/building_places.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Aabb;
using kodo::Real;
using kodo::Vec2;

namespace {

constexpr std::ptrdiff_t kMostAtOnePlace = 20;

std::int32_t rounded(Real value) {
    return static_cast<std::int32_t>(std::lround(value * 1000));
}

/// Places of a block whose bounds are given, so that it is between two walls.
PlaceRange rangeOf(std::int32_t place, Real lower, Real upper, PlaceRange walls) {
    return {place + walls.low - rounded(lower), place + walls.high - rounded(upper)};
}

} // namespace

bool BuildingPlaces::check(const toml::table& table, const std::string& key, std::int32_t value,
                           const PlaceRange& range, const std::string& name,
                           const std::string& also) {
    if (value >= range.low && value <= range.high) {
        return true;
    }
    const toml::node* node = table.get(key);
    keys_.fail(TomlKeys::lineOf(node == nullptr ? table : *node),
               name + " is " + std::to_string(value) + ", but must be from " +
                   std::to_string(range.low) + " to " + std::to_string(range.high) + also);
    return false;
}

void BuildingPlaces::add(const toml::table& table, std::span<const FreeBlock> copies) {
    constexpr PlaceRange kAcross{-static_cast<std::int32_t>(kFieldWidth * 500),
                                 static_cast<std::int32_t>(kFieldWidth * 500)};
    constexpr PlaceRange kUp{0, static_cast<std::int32_t>(kFieldHeight * 1000)};
    const std::string also = ": the whole block lies within the field";
    bool goodX = true;
    bool goodY = true;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        const FreeBlock& block = copies[i];
        const std::string of = copies.size() == 1 ? "" : " of copy " + std::to_string(i + 1);
        const PlacedShape placed = placedShapeOf(block);
        const Aabb bounds = boundsOf(placed);
        const Vec2 size = bounds.extent();
        const PlaceRange across = rangeOf(block.x, bounds.lower.x, bounds.upper.x, kAcross);
        const PlaceRange up = rangeOf(block.y, bounds.lower.y, bounds.upper.y, kUp);
        if (across.low > across.high || up.low > up.high) {
            keys_.fail(TomlKeys::lineOf(table), "the block is larger than the field");
            return;
        }
        goodX = goodX && check(table, "x", block.x, across, "x" + of, also);
        goodY = goodY && check(table, "y", block.y, up, "y" + of, also);
        middles_.push_back(
            {placed.frame.position, std::min(size.x, size.y), TomlKeys::lineOf(table)});
    }
}

void BuildingPlaces::checkCrowds() {
    for (auto middle = middles_.begin(); middle != middles_.end(); ++middle) {
        const std::ptrdiff_t before = std::count_if(middles_.begin(), middle, [&](const auto& b) {
            return length(b.place - middle->place) < std::min(b.size, middle->size) / 4;
        });
        if (before == kMostAtOnePlace) { // named once for each place
            keys_.fail(middle->line, "more than " + std::to_string(kMostAtOnePlace) +
                                         " blocks have their middles at one place");
        }
    }
}

} // namespace apart
