// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/aabb.hpp>

#include <SFML/Graphics/Rect.hpp>
#include <SFML/System/Vector2.hpp>

namespace kodo_sfml {

/// Shows a rectangle of the world whole, undistorted and in the middle of a picture; what is left
/// of the picture lies to both sides of it. World: metres, y up. Picture: pixels, y down.
class Camera {
public:
    /// A rectangle or a picture without area is shown at 1 pixel a metre.
    Camera(kodo::Aabb shown, sf::Vector2u picturePixels);

    sf::Vector2f toPixels(kodo::Vec2 point) const;
    kodo::Vec2 toWorld(sf::Vector2f pixel) const;
    /// How long a length in metres is in the picture.
    float toPixels(kodo::Real length) const { return scale_ * length; }
    /// Where the shown rectangle lies in the picture.
    sf::FloatRect frame() const;
    kodo::Aabb shown() const { return shown_; }

private:
    kodo::Aabb shown_;
    float scale_ = 1; // pixels a metre
    sf::Vector2f middle_;
};

} // namespace kodo_sfml
