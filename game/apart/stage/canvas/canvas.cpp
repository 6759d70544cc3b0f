// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/canvas.hpp>

#include <vector>

namespace apart {

void Canvas::ribbon(std::span<const Vec2> points, Real width, Color color) {
    const std::vector<Real> widths(points.size(), width);
    const std::vector<Color> colors(points.size(), color);
    ribbon(points, widths, colors);
}

} // namespace apart
