// SPDX-License-Identifier: MIT
// Uses kodo::sfml without a window.
#include <kodo_draw/camera.hpp>

int main() {
    const kodo_draw::Camera camera(kodo::Aabb{{0, 0}, {2, 1}}, kodo_draw::Size{200, 100});
    const kodo_draw::Pixel corner = camera.toPixels(kodo::Vec2{0, 1});
    return corner == kodo_draw::Pixel{0, 0} ? 0 : 1;
}
