// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/inset_canvas.hpp>

#include <algorithm>
#include <array>

namespace apart {

InsetCanvas::InsetCanvas(Canvas& page, const Aabb& region, const Aabb& box, Vision vision)
    : page_(page),
      region_(region),
      scale_(std::min(box.extent().x / region.extent().x, box.extent().y / region.extent().y)),
      center_(region.center()),
      middle_(box.center()) {
    setPalette(vision);
    setTextScale(page.textScale());
}

/// Moves points to the page. False if all are outside the region.
bool InsetCanvas::moved(std::span<const Vec2> corners) {
    if (corners.empty() || !overlap(kodo::aabbOf(corners), region_)) {
        return false;
    }
    corners_.clear();
    for (const Vec2 corner : corners) {
        corners_.push_back(at(corner));
    }
    return true;
}

bool InsetCanvas::shows(Vec2 center, Real radius) const {
    return region_.grown(radius).contains(center);
}

void InsetCanvas::rectangle(const Aabb& box, Color below, Color above) {
    const Aabb cut{
        {std::max(box.lower.x, region_.lower.x), std::max(box.lower.y, region_.lower.y)},
        {std::min(box.upper.x, region_.upper.x), std::min(box.upper.y, region_.upper.y)}};
    if (cut.lower.x < cut.upper.x && cut.lower.y < cut.upper.y) {
        page_.rectangle({at(cut.lower), at(cut.upper)}, below, above);
    }
}

void InsetCanvas::polygon(std::span<const Vec2> corners, Color color) {
    if (moved(corners)) {
        page_.polygon(corners_, color);
    }
}

void InsetCanvas::polygon(std::span<const Vec2> corners, std::span<const Color> colors) {
    if (moved(corners)) {
        page_.polygon(corners_, colors);
    }
}

void InsetCanvas::facet(std::span<const Vec2> corners, std::span<const Color> colors) {
    if (moved(corners)) {
        page_.facet(corners_, colors);
    }
}

void InsetCanvas::rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                         Color rim) {
    if (moved(corners)) {
        page_.rimmed(corners_, colors, scale_ * width, rim);
    }
}

void InsetCanvas::outline(std::span<const Vec2> corners, Real width, Color color) {
    if (moved(corners)) {
        page_.outline(corners_, scale_ * width, color);
    }
}

void InsetCanvas::line(Vec2 from, Vec2 to, Real width, Color color) {
    if (moved(std::array{from, to})) {
        page_.line(corners_[0], corners_[1], scale_ * width, color);
    }
}

void InsetCanvas::ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                         std::span<const Color> colors) {
    if (moved(points)) {
        widths_.clear();
        for (const Real width : widths) {
            widths_.push_back(scale_ * width);
        }
        page_.ribbon(corners_, widths_, colors);
    }
}

void InsetCanvas::disc(Vec2 center, Real radius, Color middle, Color rim) {
    if (shows(center, radius)) {
        page_.disc(at(center), scale_ * radius, middle, rim);
    }
}

void InsetCanvas::ring(Vec2 center, Real radius, Real width, Color color) {
    if (shows(center, radius)) {
        page_.ring(at(center), scale_ * radius, scale_ * width, color);
    }
}

void InsetCanvas::text(std::string_view utf8, Vec2 place, const TextStyle& style) {
    if (shows(place, 0)) {
        TextStyle scaled = style;
        scaled.height *= scale_;
        scaled.room *= scale_;
        page_.text(utf8, at(place), scaled);
    }
}

} // namespace apart
