// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <kodo_draw/values.hpp>

namespace kodo_draw {

/// Maps a rectangle of the world to the centre of a picture, as large as fits, with equal scales.
/// World: metres, y up. Picture: pixels, y down.
class Camera {
public:
    /// If the rectangle or the picture has no area, the scale is 1 pixel per metre.
    Camera(kodo::Aabb shown, Size picturePixels);

    Pixel toPixels(kodo::Vec2 point) const;
    kodo::Vec2 toWorld(Pixel pixel) const;
    /// A length in metres as a length in pixels.
    float toPixels(kodo::Real length) const { return scale_ * length; }
    /// The shown rectangle in pixels.
    Rect frame() const;
    kodo::Aabb shown() const { return shown_; }
    /// All that the picture shows: the rectangle, and what lies beside it.
    kodo::Aabb picture() const;

private:
    kodo::Aabb shown_;
    float scale_ = 1; // pixels per metre
    Pixel middle_;
};

} // namespace kodo_draw
