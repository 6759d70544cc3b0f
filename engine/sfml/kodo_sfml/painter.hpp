// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_sfml/edge_texture.hpp>

#include <SFML/Graphics/BlendMode.hpp>
#include <SFML/Graphics/Color.hpp>
#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/Rect.hpp>
#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/Graphics/Vertex.hpp>

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace kodo_sfml {

enum class Blend { Over, Add, Replace };

/// Collects the triangles of one picture in painting order. Draws them in one call for each run of
/// equal texture and blending. All positions and lengths are pixels, y down.
///
/// Edges are antialiased: they fade over one pixel, by the opacity of one small texture. The result
/// does not depend on the graphics hardware. In software rendering this is much cheaper than
/// multisampling.
class Painter {
public:
    void clear();
    void draw(sf::RenderTarget& target) const;

    /// Blending of all shapes added afterwards.
    void setBlend(Blend blend) { blend_ = blend; }

    /// From now on, the opaque middles of rimmed() shapes are drawn before everything else, until
    /// false is given. For shapes that do not overlap: much cheaper in software rendering, which
    /// then reads neither the picture nor a texture for them.
    void setMiddlesFirst(bool on);

    /// Without antialiasing; colours of the upper left, upper right, lower right and lower left
    /// corner.
    void rectangle(sf::FloatRect where, std::span<const sf::Color, 4> colors);
    /// A convex polygon of either orientation; one colour, or one per corner.
    void polygon(std::span<const sf::Vector2f> corners, sf::Color color);
    void polygon(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);
    /// A convex polygon without antialiasing, for faint areas and adjacent polygons.
    void facet(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);
    /// A convex polygon with an inner rim. The rim colour is blended over `colors` and fades
    /// inwards. Needs half the triangles of polygon() and outline().
    void rimmed(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors,
                float width, sf::Color rim);
    /// The mitred edges of any simple polygon; half of the width lies inside.
    void outline(std::span<const sf::Vector2f> corners, float width, sf::Color color);
    void line(sf::Vector2f from, sf::Vector2f to, float width, sf::Color color);
    /// A stroke through all points: its segments share their ends, so that a translucent one has no
    /// gaps or overlaps at bends of up to 90 degrees. One width and colour for each point.
    void ribbon(std::span<const sf::Vector2f> points, std::span<const float> widths,
                std::span<const sf::Color> colors);
    /// A disc with a gradient from `middle` to `rim`. A transparent rim needs no fade.
    void disc(sf::Vector2f center, float radius, sf::Color middle, sf::Color rim);
    void ring(sf::Vector2f center, float radius, float width, sf::Color color);
    /// Draws a part (texels) of a texture into a rectangle. The texture must live until draw().
    void image(const sf::Texture& texture, sf::FloatRect part, sf::FloatRect where,
               sf::Color tint = sf::Color::White);
    /// One line of UTF-8 text; `start` lies on the base line. The font must live until draw().
    void text(const sf::Font& font, std::string_view utf8, unsigned heightPixels,
              sf::Vector2f start, sf::Color color);

    std::size_t vertexCount() const { return vertices_.size(); }
    /// Corners of the triangles, three by three. Those of shapes and strokes have texels of
    /// edgeImage(), and colours that are premultiplied by their opacity.
    std::span<const sf::Vertex> vertices() const { return vertices_; }

private:
    enum class Fill { Plain, Edges, Image };
    /// Vertices that one call draws.
    struct Run {
        std::size_t first;
        Blend blend;
        Fill fill;
        const sf::Texture* texture; // of Image
    };

    /// One end of a stroke.
    struct Knot {
        sf::Vector2f place;
        sf::Vector2f side; // for a half width of 1; its length is the mitre
        float halfWidth;
        sf::Color color;
    };

    void use(Fill fill, Blend blend, const sf::Texture* texture = nullptr);
    void useAnyFill();
    sf::Color blended(sf::Color color) const;
    sf::Vertex opaque(sf::Vector2f place, sf::Color color) const;
    /// A vertex of a filled shape, this many pixels inside the outer border of its fade.
    sf::Vertex inside(sf::Vector2f place, sf::Color color, float pixels) const;
    void middle(std::span<const sf::Vertex> corners);
    void triangle(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c);
    void quad(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c, const sf::Vertex& d);
    void band(const Knot& from, const Knot& to);
    void strip(const Knot& from, const Knot& to);
    void fan(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);

    std::vector<sf::Vertex> vertices_;
    std::vector<sf::Vertex> middles_;      // of the shapes since setMiddlesFirst(true)
    std::vector<sf::Vertex> innerCorners_; // scratch
    std::size_t firstVertex_ = 0;          // at setMiddlesFirst(true), and the first run after it
    std::size_t firstRun_ = 0;
    bool middlesFirst_ = false;
    std::vector<sf::Vector2f> sides_; // scratch: see outwards()
    std::vector<sf::Color> oneColor_; // scratch: one colour, repeated per corner
    std::vector<Run> runs_;
    mutable std::unique_ptr<sf::Texture> edges_; // made by the first draw(), which has a display
    Blend blend_ = Blend::Over;
};

/// Advance width of one line of text, in pixels. Loads the glyphs, so it needs a display.
float textWidth(const sf::Font& font, std::string_view utf8, unsigned heightPixels);

} // namespace kodo_sfml
