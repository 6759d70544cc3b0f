// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/records.hpp>

namespace apart {

// Column of the description, m.
inline constexpr Real kAboutLeft = Real(4.7);
inline constexpr Real kAboutRight = Real(14.6);

/// The level that is chosen on the map.
struct AboutLook {
    const Level& level;
    std::size_t number; // in the list, from 1
    const Stop& stop;
    const Records& records;
    Vec2 pointer;   // m; names the honour below it
    double seconds; // of animations
};

/// Paints title, idea, preview, best scores and honours of a level. One that is closed says what
/// opens it instead of its idea.
void paintAbout(Canvas& canvas, const AboutLook& look);

} // namespace apart
