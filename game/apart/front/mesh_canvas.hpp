// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

#include <kodo_draw/camera.hpp>
#include <kodo_draw/mesh.hpp>

#include <string_view>
#include <vector>

namespace apart {

/// Canvas that collects the triangles of a picture in one Mesh, to need few draw calls. A derived
/// class draws the mesh, and has the letters.
class MeshCanvas : public Canvas {
public:
    explicit MeshCanvas(kodo_draw::Size pixels);

    /// Size of the picture, from the next begin() on.
    void setSize(kodo_draw::Size pixels) { pixels_ = pixels; }
    /// Camera of the last picture, without shake.
    const kodo_draw::Camera& camera() const { return steady_; }
    /// Camera of what is drawn next, with shake and zoom.
    const kodo_draw::Camera& drawingCamera() const { return camera_; }

    void begin(const Aabb& shown, Vec2 shake) override;
    Aabb visible() const override;
    void zoom(Vec2 focus, Real scale) override;
    void setGlow(bool on) override;
    void setDisjoint(bool on) override { mesh().setMiddlesFirst(on); }
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

protected:
    ~MeshCanvas() override = default;

    virtual kodo_draw::Mesh& mesh() = 0;
    /// Advance width (pixels) of one line of text in Plain or Bold.
    virtual float textWidth(Typeface face, std::string_view utf8, unsigned heightPixels) = 0;
    /// Adds one line of text to the mesh; `start` lies on the base line.
    virtual void addText(Typeface face, std::string_view utf8, unsigned heightPixels,
                         kodo_draw::Pixel start, kodo_draw::Rgba color) = 0;

private:
    std::span<const kodo_draw::Pixel> toPixels(std::span<const Vec2> corners);
    std::span<const kodo_draw::Rgba> toRgba(std::span<const Color> colors);
    bool display(std::string_view text, Vec2 place, const TextStyle& style);

    kodo_draw::Size pixels_;
    kodo_draw::Camera steady_;
    kodo_draw::Camera shaken_;              // with shake
    kodo_draw::Camera camera_;              // with shake and zoom
    std::vector<kodo_draw::Pixel> corners_; // reused, to avoid allocations
    std::vector<kodo_draw::Rgba> colors_;
    std::vector<float> widths_;
};

} // namespace apart
