// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/canvas.hpp>

/// Layout of the picture, in metres of the field.
namespace apart::layout {

inline constexpr Real kRight = kFieldWidth / 2;
inline constexpr Real kLeft = -kRight;
inline constexpr Real kTop = kFieldHeight;
inline constexpr Aabb kField{{kLeft, 0}, {kRight, kTop}};
/// For words of the game: not over the paddle.
inline constexpr Aabb kWords{{kLeft, Real(2.4)}, {kRight, kTop}};
inline constexpr Real kFrame = Real(0.45); // drawn thickness of the walls

/// The panel with score and lives, right of the field.
inline constexpr Real kPanelLeft = kRight + Real(1.25);
inline constexpr Real kPanelRight = kPanelLeft + Real(4.6);

/// The visible rectangle, with an aspect ratio of 16 to 10.
inline constexpr Aabb kShown{{kLeft - Real(0.85), Real(-0.35)},
                             {kPanelRight + Real(0.5), kTop + Real(0.85)}};
/// The title screen has no panel: same size, centred on the field.
inline constexpr Aabb kShownTitle{{Real(-0.5) * kShown.extent().x, kShown.lower.y},
                                  {Real(0.5) * kShown.extent().x, kShown.upper.y}};

inline constexpr unsigned kWindowWidth = 1280; // pixels
inline constexpr unsigned kWindowHeight = 800;

} // namespace apart::layout
