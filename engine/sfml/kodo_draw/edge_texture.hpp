// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_draw/values.hpp>

#include <vector>

namespace kodo_draw {

// Edges of shapes fade over one pixel by the opacity of a small texture. Without it each edge
// needs a quad of its own, and software rendering takes most of its time for the number of
// triangles. Row 0 is a ramp: opacity against the distance from the outer border. Each other row
// is the profile across a stroke of one width.

constexpr float kFade = 0.5f; // pixels; an edge fades over this distance on both sides
constexpr float kThin = 1;    // pixels; a stroke of smaller half width has no opaque core

/// Texel of a point that is this many pixels inside the outer border of a shape.
Pixel rampTexel(float pixels);
/// Texel of a point without a fade.
Pixel opaqueTexel();

/// The profile of a stroke from border to border.
struct StrokeProfile {
    float halfPixels;          // half width with the fade, of the quad to draw
    Pixel left, middle, right; // texels; middle and right are equal distances from left
    float opacity;             // factor; a stroke thinner than a pixel is fainter instead
    bool halves;               // too wide for a row: one quad from each border to the middle
};
StrokeProfile strokeProfile(float halfWidth);

/// Opacity, 0..1, of the texture; texels outside it are those of its border.
float opacityAt(Pixel texel);
/// Width and height of the texture (texels).
Size edgeTextureSize();
/// Opacities of the texture, row by row from the top: a texel is white, premultiplied by its own.
std::vector<std::uint8_t> edgeOpacities();

} // namespace kodo_draw
