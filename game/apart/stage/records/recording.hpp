// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/controls.hpp>
#include <apart/stage/sound/speaker.hpp>

#include <deque>
#include <string>
#include <vector>

namespace apart {

/// One drawn primitive.
struct Stroke {
    enum class Kind : std::uint8_t {
        Rectangle,
        Polygon,
        Outline,
        Line,
        Ribbon,
        Disc,
        Ring,
        Text
    } kind;
    Vec2 place;    // first corner, centre or base line
    Color color;   // of the first corner or the centre
    Real size = 0; // radius, width or letter height
    std::string text{};
    TextStyle style{};    // of a text
    Vec2 enlargedPlace{}; // of a text: its place in the picture, after the zoom
};

/// A canvas without a screen, for tests. It records the primitives of the last picture.
class RecordingCanvas : public Canvas {
public:
    void begin(const Aabb& shown, Vec2 shake) override;
    Aabb visible() const override { return shown_; }
    /// Size of the window (pixels) from the next begin() on; without one, the picture has the shape
    /// of what it must show.
    void setWindow(Vec2 pixels) { window_ = pixels; }
    void zoom(Vec2 focus, Real scale) override;
    void setGlow(bool) override {}
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

    const std::vector<Stroke>& strokes() const { return strokes_; }
    Vec2 shake() const { return shake_; }
    /// The largest zoom of the picture.
    Real mostZoom() const { return mostZoom_; }
    bool says(std::string_view text) const;

private:
    Aabb shown_{};
    Vec2 window_; // pixels
    Vec2 shake_;
    Vec2 focus_;
    Real zoom_ = 1;
    Real mostZoom_ = 1;
    std::vector<Stroke> strokes_;
};

class RecordingSpeaker : public Speaker {
public:
    void play(const Note& note) override { notes.push_back(note); }
    void follow(const SoundScene& now) override { scene = now; }
    std::vector<Note> notes;
    SoundScene scene;
};

/// Replays a script, one Signals per poll, then empty input.
class ScriptedControls : public Controls {
public:
    Signals poll() override;
    void capture(bool on) override { captured = on; }
    std::deque<Signals> script;
    bool captured = false;
};

} // namespace apart
