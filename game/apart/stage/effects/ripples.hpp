// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <vector>

namespace apart {

/// Waves on the surfaces of the waters of a level: columns coupled by springs. A picture only.
class Ripples {
public:
    /// Call after each tick of the game.
    void tick(const Game& game);
    /// A body strikes the surface; `speed` in m/s, upwards.
    void strike(const Game& game, kodo::Vec2 point, kodo::Real speed, kodo::Real mass);
    /// Height (m) above the still surface.
    kodo::Real heightAt(std::size_t water, kodo::Real x) const;

private:
    struct Column {
        kodo::Real height = 0; // m, above the still surface
        kodo::Real speed = 0;  // m/s
    };
    struct Surface {
        kodo::Real left = 0; // m, of the first column
        std::vector<Column> columns;
    };
    void fit(const Game& game);

    std::vector<Surface> surfaces_; // by water
};

} // namespace apart
