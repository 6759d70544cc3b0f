// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <kodo/kodo.hpp>

namespace apart {

/// The bare paddle: a dome on a foot that narrows downwards, so that a ball caught at its side is
/// pushed down and out. The origin lies in the middle of its widest line.
kodo::Polygon paddleShape();

/// Height of the dome above that line at a distance from its middle (m); 0 beyond the rim.
kodo::Real domeHeight(kodo::Real x);

/// Speed of the paddle (m/s) after one tick at the wheel. The motor's force limits how fast it may
/// change and the motor's energy how large it may be, so mass makes it slow.
kodo::Real drivenSpeed(const Input& input, kodo::Real x, kodo::Real speed, kodo::Real mass);

} // namespace apart
