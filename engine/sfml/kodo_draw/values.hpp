// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace kodo_draw {

/// A place or a vector of the picture: pixels, y down. Of a texture: texels.
struct Pixel {
    float x = 0;
    float y = 0;

    friend constexpr Pixel operator+(Pixel a, Pixel b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Pixel operator-(Pixel a, Pixel b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Pixel operator*(float s, Pixel v) { return {s * v.x, s * v.y}; }
    friend constexpr Pixel operator/(Pixel v, float s) { return {v.x / s, v.y / s}; }
    friend constexpr bool operator==(Pixel, Pixel) = default;
};

/// Size of a picture (pixels).
struct Size {
    unsigned x = 0;
    unsigned y = 0;

    friend constexpr bool operator==(Size, Size) = default;
};

/// A rectangle of the picture (pixels).
struct Rect {
    float left = 0;
    float top = 0;
    float width = 0;
    float height = 0;

    constexpr bool contains(Pixel p) const {
        return p.x >= left && p.x < left + width && p.y >= top && p.y < top + height;
    }
};

/// A colour with its opacity; 255 is opaque.
struct Rgba {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Rgba, Rgba) = default;
};

} // namespace kodo_draw
