// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

#include <vector>

namespace apart {

/// Draws a region of the field into a box of a page, with equal scales in x and y. Primitives that
/// lie outside the region are left out, and rectangles end at its edge. Others may cross the edge
/// of the box: the page covers that.
class InsetCanvas : public Canvas {
public:
    /// `region` (m of the field) is centred in `box` (m of the page) and fills it in one direction
    /// at least.
    InsetCanvas(Canvas& page, const Aabb& region, const Aabb& box, Vision vision);

    /// Where a point of the field is on the page.
    Vec2 at(Vec2 place) const { return middle_ + scale_ * (place - center_); }

    void begin(const Aabb&, Vec2) override {} // the page has begun
    Aabb visible() const override { return region_; }
    void zoom(Vec2, Real) override {} // a page has none
    void setGlow(bool on) override { page_.setGlow(on); }
    void rectangle(const Aabb& box, Color below, Color above) override;
    void polygon(std::span<const Vec2> corners, Color color) override;
    void polygon(std::span<const Vec2> corners, std::span<const Color> colors) override;
    void facet(std::span<const Vec2> corners, std::span<const Color> colors) override;
    void rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                Color rim) override;
    void outline(std::span<const Vec2> corners, Real width, Color color) override;
    void line(Vec2 from, Vec2 to, Real width, Color color) override;
    using Canvas::ribbon;
    void ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                std::span<const Color> colors) override;
    void disc(Vec2 center, Real radius, Color middle, Color rim) override;
    void ring(Vec2 center, Real radius, Real width, Color color) override;
    void text(std::string_view utf8, Vec2 place, const TextStyle& style) override;

private:
    bool moved(std::span<const Vec2> corners);
    bool shows(Vec2 center, Real radius) const;

    Canvas& page_;
    Aabb region_;
    Real scale_;
    Vec2 center_;               // of the region
    Vec2 middle_;               // of the box
    std::vector<Vec2> corners_; // on the page; reused, to avoid allocations
    std::vector<Real> widths_;
};

} // namespace apart
