// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <SFML/Graphics/Rect.hpp>
#include <SFML/System/Vector2.hpp>

namespace kodo_sfml {

/// Maps a rectangle of the world to the centre of a picture, as large as fits, with equal scales.
/// World: metres, y up. Picture: pixels, y down.
class Camera {
public:
    /// If the rectangle or the picture has no area, the scale is 1 pixel per metre.
    Camera(kodo::Aabb shown, sf::Vector2u picturePixels);

    sf::Vector2f toPixels(kodo::Vec2 point) const;
    kodo::Vec2 toWorld(sf::Vector2f pixel) const;
    /// A length in metres as a length in pixels.
    float toPixels(kodo::Real length) const { return scale_ * length; }
    /// The shown rectangle in pixels.
    sf::FloatRect frame() const;
    kodo::Aabb shown() const { return shown_; }

private:
    kodo::Aabb shown_;
    float scale_ = 1; // pixels per metre
    sf::Vector2f middle_;
};

} // namespace kodo_sfml
