// SPDX-License-Identifier: MIT
#pragma once

#include <SFML/Graphics/BlendMode.hpp>
#include <SFML/Graphics/Color.hpp>
#include <SFML/Graphics/Font.hpp>
#include <SFML/Graphics/Rect.hpp>
#include <SFML/Graphics/RenderTarget.hpp>
#include <SFML/Graphics/Texture.hpp>
#include <SFML/Graphics/Vertex.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace kodo_sfml {

enum class Blend { Over, Add, Replace };

/// Collects one picture as triangles, in the order of painting, and draws them in as few calls as
/// textures and blending allow. All positions and lengths are pixels, y down.
///
/// Edges are smooth: they fade over one pixel. That looks the same everywhere, and without a
/// graphics card it costs far less than several samples a pixel.
class Painter {
public:
    void clear();
    void draw(sf::RenderTarget& target) const;

    /// Of everything added from here on.
    void setBlend(Blend blend) { blend_ = blend; }

    /// Sharp edges; colours of the upper left, upper right, lower right and lower left corner.
    void rectangle(sf::FloatRect where, std::span<const sf::Color, 4> colors);
    /// Convex, in either direction; one colour, or one a corner.
    void polygon(std::span<const sf::Vector2f> corners, sf::Color color);
    void polygon(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);
    /// Convex, with sharp edges: for what is faint, or laid side by side.
    void facet(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);
    /// A convex polygon with a rim along the inside of its edges, whose colour lies over the others
    /// and fades into them: half as many triangles as polygon() and outline() need for that.
    void rimmed(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors,
                float width, sf::Color rim);
    /// The edges of any polygon, mitred; half of the width lies inside.
    void outline(std::span<const sf::Vector2f> corners, float width, sf::Color color);
    void line(sf::Vector2f from, sf::Vector2f to, float width, sf::Color color);
    /// Shaded from the middle to the rim.
    void disc(sf::Vector2f center, float radius, sf::Color middle, sf::Color rim);
    void ring(sf::Vector2f center, float radius, float width, sf::Color color);
    /// A part (texels) of a texture on a rectangle. The texture must live until draw().
    void image(const sf::Texture& texture, sf::FloatRect part, sf::FloatRect where,
               sf::Color tint = sf::Color::White);
    /// UTF-8, one line, starting at `start` on the base line. The font must live until draw().
    void text(const sf::Font& font, std::string_view utf8, unsigned heightPixels,
              sf::Vector2f start, sf::Color color);

    std::size_t vertexCount() const { return vertices_.size(); }

private:
    /// Vertices that one call can draw.
    struct Run {
        std::size_t first;
        Blend blend;
        const sf::Texture* texture;
    };

    /// A stroke from one point to another: at each end a step to its side, half of it being inside.
    struct Band {
        sf::Vector2f from;
        sf::Vector2f fromSide; // as long as half the stroke is wide, times its mitre
        sf::Vector2f to;
        sf::Vector2f toSide;
        float halfWidth;
    };

    void use(const sf::Texture* texture, Blend blend);
    void triangle(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c);
    void quad(const sf::Vertex& a, const sf::Vertex& b, const sf::Vertex& c, const sf::Vertex& d);
    void band(const Band& band, sf::Color color);
    void fan(std::span<const sf::Vector2f> corners, std::span<const sf::Color> colors);

    std::vector<sf::Vertex> vertices_;
    std::vector<sf::Vector2f> sides_; // of the polygon in work
    std::vector<sf::Color> oneColor_; // repeated for each of its corners
    std::vector<Run> runs_;
    Blend blend_ = Blend::Over;
};

/// How far the pen moves over a line of text, in pixels. Loads the glyphs, so it needs a display.
float textWidth(const sf::Font& font, std::string_view utf8, unsigned heightPixels);

} // namespace kodo_sfml
