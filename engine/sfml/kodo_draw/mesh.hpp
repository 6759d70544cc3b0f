// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_draw/values.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace kodo_draw {

enum class Blend { Over, Add, Replace };

/// What the opacity of a vertex is multiplied by: nothing, the edge texture, or an image.
enum class Fill { Plain, Edges, Image };

/// Corner of a triangle. `texel` is a place in the edge texture, or in an image.
struct MeshVertex {
    Pixel place;
    Rgba color;
    Pixel texel;
};

/// Vertices that one call of a renderer draws: from `first` to that of the next run. Colours of
/// Plain and Edges are premultiplied by their opacity, those of Image are not.
struct MeshRun {
    std::size_t first;
    Blend blend; // of Plain and Edges: Over or Replace
    Fill fill;
    const void* image; // as given to Mesh::image()
};

/// Collects the triangles of one picture in painting order, in runs of equal texture and blending.
/// All positions and lengths are pixels, y down. It draws nothing: any renderer of triangles can.
///
/// Edges are antialiased: they fade over one pixel, by the opacity of one small texture. The result
/// does not depend on the graphics hardware. In software rendering this is much cheaper than
/// multisampling.
class Mesh {
public:
    void clear();

    /// Blending of all shapes added afterwards.
    void setBlend(Blend blend) { blend_ = blend; }

    /// From now on, the opaque middles of rimmed() shapes are drawn before everything else, until
    /// false is given. For shapes that do not overlap: much cheaper in software rendering, which
    /// then reads neither the picture nor a texture for them.
    void setMiddlesFirst(bool on);

    /// Without antialiasing; colours of the upper left, upper right, lower right and lower left
    /// corner.
    void rectangle(Rect where, std::span<const Rgba, 4> colors);
    /// A convex polygon of either orientation; one colour, or one per corner.
    void polygon(std::span<const Pixel> corners, Rgba color);
    void polygon(std::span<const Pixel> corners, std::span<const Rgba> colors);
    /// A convex polygon without antialiasing, for faint areas and adjacent polygons.
    void facet(std::span<const Pixel> corners, std::span<const Rgba> colors);
    /// A convex polygon with an inner rim. The rim colour is blended over `colors` and fades
    /// inwards. Needs half the triangles of polygon() and outline().
    void rimmed(std::span<const Pixel> corners, std::span<const Rgba> colors, float width,
                Rgba rim);
    /// The mitred edges of any simple polygon; half of the width lies inside.
    void outline(std::span<const Pixel> corners, float width, Rgba color);
    void line(Pixel from, Pixel to, float width, Rgba color);
    /// A stroke through all points: its segments share their ends, so that a translucent one has no
    /// gaps or overlaps at bends of up to 90 degrees. One width and colour for each point.
    void ribbon(std::span<const Pixel> points, std::span<const float> widths,
                std::span<const Rgba> colors);
    /// A disc with a gradient from `middle` to `rim`. A transparent rim needs no fade.
    void disc(Pixel center, float radius, Rgba middle, Rgba rim);
    void ring(Pixel center, float radius, float width, Rgba color);
    /// A part (texels) of an image in a rectangle. `texture` is a name that the renderer knows.
    void image(const void* texture, Rect part, Rect where, Rgba tint = {255, 255, 255});

    std::size_t vertexCount() const { return vertices_.size(); }
    /// Corners of the triangles, three by three.
    std::span<const MeshVertex> vertices() const { return vertices_; }
    std::span<const MeshRun> runs() const { return runs_; }

private:
    /// One end of a stroke.
    struct Knot {
        Pixel place;
        Pixel side; // for a half width of 1; its length is the mitre
        float halfWidth;
        Rgba color;
    };

    void use(Fill fill, Blend blend, const void* image = nullptr);
    void useAnyFill();
    Rgba blended(Rgba color) const;
    MeshVertex opaque(Pixel place, Rgba color) const;
    /// A vertex of a filled shape, this many pixels inside the outer border of its fade.
    MeshVertex inside(Pixel place, Rgba color, float pixels) const;
    void middle(std::span<const MeshVertex> corners);
    void triangle(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c);
    void quad(const MeshVertex& a, const MeshVertex& b, const MeshVertex& c, const MeshVertex& d);
    void band(const Knot& from, const Knot& to);
    void strip(const Knot& from, const Knot& to);
    void fan(std::span<const Pixel> corners, std::span<const Rgba> colors);

    std::vector<MeshVertex> vertices_;
    std::vector<MeshVertex> middles_;      // of the shapes since setMiddlesFirst(true)
    std::vector<MeshVertex> innerCorners_; // scratch
    std::size_t firstVertex_ = 0;          // at setMiddlesFirst(true), and the first run after it
    std::size_t firstRun_ = 0;
    bool middlesFirst_ = false;
    std::vector<Pixel> sides_;   // scratch: see outwards()
    std::vector<Rgba> oneColor_; // scratch: one colour, repeated per corner
    std::vector<MeshRun> runs_;
    Blend blend_ = Blend::Over;
};

} // namespace kodo_draw
