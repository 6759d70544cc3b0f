// SPDX-License-Identifier: MIT
// Uses kodo::sfml without a window.
#include <kodo_sfml/camera.hpp>

int main() {
    const kodo_sfml::Camera camera(kodo::Aabb{{0, 0}, {2, 1}}, sf::Vector2u{200, 100});
    const sf::Vector2f corner = camera.toPixels(kodo::Vec2{0, 1});
    return corner == sf::Vector2f{0, 0} ? 0 : 1;
}
