// SPDX-License-Identifier: MIT
#include <kodo_draw/camera.hpp>

#include <algorithm>

namespace kodo_draw {

Camera::Camera(kodo::Aabb shown, Size picturePixels)
    : shown_(shown),
      middle_{0.5f * static_cast<float>(picturePixels.x),
              0.5f * static_cast<float>(picturePixels.y)} {
    const kodo::Vec2 extent = shown.extent();
    if (extent.x > 0 && extent.y > 0 && picturePixels.x > 0 && picturePixels.y > 0) {
        scale_ = std::min(2 * middle_.x / extent.x, 2 * middle_.y / extent.y);
    }
}

Pixel Camera::toPixels(kodo::Vec2 point) const {
    const kodo::Vec2 arm = point - shown_.center();
    return {middle_.x + scale_ * arm.x, middle_.y - scale_ * arm.y};
}

kodo::Vec2 Camera::toWorld(Pixel pixel) const {
    const kodo::Vec2 arm{pixel.x - middle_.x, middle_.y - pixel.y};
    return shown_.center() + arm / scale_;
}

kodo::Aabb Camera::picture() const {
    return {toWorld({0, 2 * middle_.y}), toWorld({2 * middle_.x, 0})};
}

Rect Camera::frame() const {
    const kodo::Vec2 size = scale_ * shown_.extent();
    return {middle_.x - 0.5f * size.x, middle_.y - 0.5f * size.y, size.x, size.y};
}

} // namespace kodo_draw
