// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kodo {
inline namespace KODO_PRECISION {

/// A colour with its opacity; 255 is opaque.
struct DrawColor {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;
};

/// How a figure looks.
struct DrawStyle {
    DrawColor line{};
    DrawColor fill{0, 0, 0, 0}; // of circles and polygons; opacity 0: hollow
    Real width = Real(1.5);     // pixels, of lines
};

/// Selects what draw() draws of a World.
struct DrawOptions {
    bool shapes = true;    // all parts, and a line from the centre of mass that shows the rotation
    bool joints = true;    // each with thin lines from the centres of its dynamic bodies
    bool contacts = false; // of the last step: points with their normals
    bool impulses = false; // of the last step: arrows along the normals
    bool bounds = false;   // axis-aligned, of bodies
    bool velocities = false;            // arrows, of moving bodies
    bool centers = false;               // centres of mass of dynamic bodies, as crosses
    bool labels = false;                // see DebugDraw::label()
    Real metresPerImpulse = Real(0.1);  // m/(N s); length of these arrows
    Real secondsOfVelocity = Real(0.1); // s; a velocity arrow leads to where a body is then
    /// The colours of awake dynamic bodies tell their islands, by contacts of the last step and
    /// joints. Otherwise they tell ids.
    bool islands = false;
};

/// A picture that draw() fills. A renderer implements the first six functions; the others are made
/// of these. Points and lengths are in the world (m, y up). Figures come in painting order.
class KODO_API DebugDraw {
public:
    virtual ~DebugDraw();

    /// What the picture shows (m, world). Bodies outside of it are left out.
    virtual Aabb view() const = 0;
    /// Size of a pixel (m): marks of joints, points and arrows have a fixed size in pixels.
    virtual Real pixel() const = 0;

    virtual void line(Vec2 from, Vec2 to, const DrawStyle& style) = 0;
    virtual void circle(Vec2 center, Real radius, const DrawStyle& style) = 0;
    /// Convex, corners counter-clockwise.
    virtual void polygon(std::span<const Vec2> corners, const DrawStyle& style) = 0;
    /// One line of UTF-8, centred at a point, in the colour of lines.
    virtual void text(Vec2 middle, std::string_view utf8, const DrawStyle& style) = 0;

    /// All points within a radius (m, > 0) of a convex polygon, or of a line with two corners.
    virtual void rounded(std::span<const Vec2> corners, Real radius, const DrawStyle& style);
    /// What lies behind the line through a point of the surface.
    virtual void halfPlane(Vec2 surface, Vec2 normal, const DrawStyle& style);
    virtual void point(Vec2 place, const DrawStyle& style);
    virtual void arrow(Vec2 from, Vec2 to, const DrawStyle& style);
    virtual void spring(Vec2 from, Vec2 to, const DrawStyle& style);

    /// Called before the figures of a body, which have this style. May change it.
    virtual void begin(const BodyView& /*body*/, DrawStyle& /*style*/) {}
    /// What DrawOptions::labels writes at the centre of mass: "3" for a body with the index 3.
    virtual std::string label(const BodyView& body) { return std::to_string(body.id().index); }
};

/// Draws a World: bodies in the order of ids, then joints, then what the last step did.
///
/// Each dynamic body has a colour of its own. Static bodies are grey, kinematic ones violet, frozen
/// ones red. Sleeping ones are faint, sensors hollow, disabled ones and those outside the region
/// nearly clear. With contacts, impulses or islands, World::collisions() is read, whose rules hold.
KODO_API void draw(const World& world, DebugDraw& target, const DrawOptions& options = {});

/// Draws one shape at a pose, such as that of a cast. The front of a one-sided segment has a short
/// line.
KODO_API void draw(const ConvexShape& shape, const Transform& pose, DebugDraw& target,
                   const DrawStyle& style);

/// Bounds (m, world) of all bodies with a margin, to be shown. A plane counts as a point of its
/// surface. Of a World without bodies, a square of two length units.
KODO_API Aabb viewOf(const World& world);

/// A picture as SVG, a text that each browser shows. The same World gives the same text on every
/// machine.
class KODO_API SvgDraw final : public DebugDraw {
public:
    /// Throws BadDefinition for a view without area, and for a width (pixels) beyond 16 to 16384.
    explicit SvgDraw(const Aabb& view, int width = 640, DrawColor background = {24, 28, 36});

    Aabb view() const override { return view_; }
    Real pixel() const override { return 1 / scale_; }
    void line(Vec2 from, Vec2 to, const DrawStyle& style) override;
    void circle(Vec2 center, Real radius, const DrawStyle& style) override;
    void polygon(std::span<const Vec2> corners, const DrawStyle& style) override;
    void text(Vec2 middle, std::string_view utf8, const DrawStyle& style) override;

    /// The whole document, of what has been drawn so far.
    std::string document() const { return figures_ + "</g>\n</svg>\n"; }

private:
    std::string place(Vec2 point) const;
    void figure(const std::string& tag, std::span<const Vec2> corners, const DrawStyle& style);
    void use(const DrawStyle& style);

    Aabb view_;
    Real scale_; // pixels per metre
    std::string figures_;
    std::string group_; // tag of the last group
};

/// A World as SVG, 640 pixels wide. Without a view (m, world), viewOf() is taken.
KODO_API std::string svg(const World& world, const DrawOptions& options = {},
                         const std::optional<Aabb>& view = std::nullopt);

} // namespace KODO_PRECISION
} // namespace kodo
