// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/color.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <kodo/math.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace apart {

using kodo::Aabb;
using kodo::Real;
using kodo::Vec2;

/// Display is the face of titles and large numbers: letters of cut stones (letterforms.hpp). A text
/// with signs that it lacks is drawn in Bold.
enum class Typeface : std::uint8_t { Plain, Bold, Display };
enum class Align : std::uint8_t { Left, Middle, Right };

struct TextStyle {
    Real height = Real(0.5); // m, from ascender to descender
    Color color{};
    Typeface face = Typeface::Plain;
    Align align = Align::Left;
    Real room = 0; // m; a wider text is made smaller. 0: any width
};

/// Drawing surface. Positions and lengths are metres of the field, y up. Later drawing covers
/// earlier drawing.
class Canvas {
public:
    virtual ~Canvas() = default;

    /// Begins a picture that shows at least this rectangle, with equal scales in x and y. `shake`
    /// offsets the whole picture (m).
    virtual void begin(const Aabb& shown, Vec2 shake) = 0;
    /// The visible rectangle. It exceeds the one passed to begin() if the window's aspect ratio
    /// differs.
    virtual Aabb visible() const = 0;
    /// Enlarges what is drawn next about a point that stays in place. 1: as begun.
    virtual void zoom(Vec2 focus, Real scale) = 0;
    /// While on, colours are added to the picture (additive blending).
    virtual void setGlow(bool on) = 0;
    /// While on, the middles of rimmed() shapes may be drawn before everything else, which is
    /// cheaper. For shapes that hardly overlap.
    virtual void setDisjoint(bool) {}

    /// Rectangle without antialiasing, for adjoining areas. Colours of the lower and upper edge.
    virtual void rectangle(const Aabb& box, Color below, Color above) = 0;
    /// Convex polygon, with one colour or one per corner.
    virtual void polygon(std::span<const Vec2> corners, Color color) = 0;
    virtual void polygon(std::span<const Vec2> corners, std::span<const Color> colors) = 0;
    /// Convex polygon without antialiasing, for faint or adjoining areas: the cheapest primitive.
    virtual void facet(std::span<const Vec2> corners, std::span<const Color> colors) = 0;
    /// Convex polygon with a rim along the inside of its edges. The rim fades into the corner
    /// colours.
    virtual void rimmed(std::span<const Vec2> corners, std::span<const Color> colors, Real width,
                        Color rim) = 0;
    /// The edges of a polygon. Half of the width lies inside.
    virtual void outline(std::span<const Vec2> corners, Real width, Color color) = 0;
    virtual void line(Vec2 from, Vec2 to, Real width, Color color) = 0;
    /// A stroke through all points, without gaps or overlaps at its bends. Widths (m) and colours:
    /// one for each point.
    virtual void ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                        std::span<const Color> colors) = 0;
    virtual void disc(Vec2 center, Real radius, Color middle, Color rim) = 0;
    virtual void ring(Vec2 center, Real radius, Real width, Color color) = 0;
    /// One line of UTF-8 text. `place` is the start, centre or end of its base line.
    virtual void text(std::string_view utf8, Vec2 place, const TextStyle& style) = 0;

    /// A stroke of one width and colour through all points.
    void ribbon(std::span<const Vec2> points, Real width, Color color);

    /// Colours of stuffs and powers.
    const Palette& palette() const { return *palette_; }
    void setPalette(Vision vision) { palette_ = &paletteOf(vision); }
    /// Factor on the height of all texts in Plain and Bold.
    Real textScale() const { return textScale_; }
    void setTextScale(Real scale) { textScale_ = scale; }

private:
    const Palette* palette_ = &paletteOf(Vision::Usual);
    Real textScale_ = 1;
};

} // namespace apart
