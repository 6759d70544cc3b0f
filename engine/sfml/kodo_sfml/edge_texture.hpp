// SPDX-License-Identifier: MIT
#pragma once

#include <SFML/Graphics/Image.hpp>
#include <SFML/System/Vector2.hpp>

namespace kodo_sfml {

// Edges of shapes fade over one pixel by the opacity of a small texture. Without it each edge
// needs a quad of its own, and software rendering takes most of its time for the number of
// triangles. Row 0 is a ramp: opacity against the distance from the outer border. Each other row
// is the profile across a stroke of one width.

constexpr float kFade = 0.5f; // pixels; an edge fades over this distance on both sides
constexpr float kThin = 1;    // pixels; a stroke of smaller half width has no opaque core

/// Texel of a point that is this many pixels inside the outer border of a shape.
sf::Vector2f rampTexel(float pixels);
/// Texel of a point without a fade.
sf::Vector2f opaqueTexel();

/// The profile of a stroke from border to border.
struct StrokeProfile {
    float halfPixels;                 // half width with the fade, of the quad to draw
    sf::Vector2f left, middle, right; // texels; middle and right are equal distances from left
    float opacity;                    // factor; a stroke thinner than a pixel is fainter instead
    bool halves;                      // too wide for a row: one quad from each border to the middle
};
StrokeProfile strokeProfile(float halfWidth);

/// Opacity, 0..1, of the texture; texels outside it are those of its border.
float opacityAt(sf::Vector2f texel);
/// The texture, with premultiplied colours.
sf::Image edgeImage();

} // namespace kodo_sfml
