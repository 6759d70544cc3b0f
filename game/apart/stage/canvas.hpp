// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/color.hpp>
#include <kodo/math/aabb.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace apart {

using kodo::Aabb;
using kodo::Real;
using kodo::Vec2;

enum class Typeface : std::uint8_t { Plain, Bold };
enum class Align : std::uint8_t { Left, Middle, Right };

struct TextStyle {
    Real height = Real(0.5); // m, from the top of the letters to the bottom of the g
    Color color{};
    Typeface face = Typeface::Plain;
    Align align = Align::Left;
};

/// What the game is drawn on. Places and lengths are metres of the field, y up; what is drawn later
/// covers what was drawn before.
class Canvas {
public:
    virtual ~Canvas() = default;

    /// Begins a picture that shows at least this rectangle, undistorted; `shake` moves all of it.
    virtual void begin(const Aabb& shown, Vec2 shake) = 0;
    /// All that is visible: more than what begin() asked for when the window has another shape.
    virtual Aabb visible() const = 0;
    /// While on, colours are added to what is there instead of covering it.
    virtual void setGlow(bool on) = 0;

    /// A rectangle with sharp edges, for what is laid side by side; its colours below and above.
    virtual void rectangle(const Aabb& box, Color below, Color above) = 0;
    /// Convex; one colour, or one a corner.
    virtual void polygon(std::span<const Vec2> corners, Color color) = 0;
    virtual void polygon(std::span<const Vec2> corners, std::span<const Color> colors) = 0;
    /// Convex, with sharp edges, for what is faint or laid side by side: it costs the least.
    virtual void facet(std::span<const Vec2> corners, std::span<const Color> colors) = 0;
    /// Convex, with a rim along the inside of its edges that fades into the colours of the corners.
    virtual void rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                        Color rim) = 0;
    /// The edges of a polygon; half of the width lies inside.
    virtual void outline(std::span<const Vec2> corners, Real width, Color color) = 0;
    virtual void line(Vec2 from, Vec2 to, Real width, Color color) = 0;
    virtual void disc(Vec2 center, Real radius, Color middle, Color rim) = 0;
    virtual void ring(Vec2 center, Real radius, Real width, Color color) = 0;
    /// One line of UTF-8 whose base line starts, is centred or ends at a place.
    virtual void text(std::string_view utf8, Vec2 place, const TextStyle& style) = 0;
};

} // namespace apart
