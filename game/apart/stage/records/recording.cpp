// SPDX-License-Identifier: MIT
#include <apart/stage/records/recording.hpp>

#include <algorithm>

namespace apart {

void RecordingCanvas::begin(const Aabb& shown, Vec2 shake) {
    shown_ = shown;
    if (window_.x > 0 && window_.y > 0) {
        const Vec2 extent = shown.extent();
        const Real scale = std::min(window_.x / extent.x, window_.y / extent.y);
        const Vec2 half = window_ / (2 * scale);
        shown_ = {shown.center() - half, shown.center() + half};
    }
    shake_ = shake;
    focus_ = {};
    zoom_ = 1;
    mostZoom_ = 1;
    strokes_.clear();
}

void RecordingCanvas::zoom(Vec2 focus, Real scale) {
    focus_ = focus;
    zoom_ = scale;
    mostZoom_ = std::max(mostZoom_, scale);
}

void RecordingCanvas::rectangle(const Aabb& box, Color below, Color) {
    strokes_.push_back({Stroke::Kind::Rectangle, box.lower, below});
}

void RecordingCanvas::polygon(std::span<const Vec2> corners, Color color) {
    strokes_.push_back({Stroke::Kind::Polygon, corners[0], color});
}

void RecordingCanvas::polygon(std::span<const Vec2> corners, std::span<const Color> colors) {
    strokes_.push_back({Stroke::Kind::Polygon, corners[0], colors[0]});
}

void RecordingCanvas::facet(std::span<const Vec2> corners, std::span<const Color> colors) {
    strokes_.push_back({Stroke::Kind::Polygon, corners[0], colors[0]});
}

void RecordingCanvas::rimmed(std::span<const Vec2> corners, std::span<const Color> colors,
                             Real width, Color) {
    strokes_.push_back({Stroke::Kind::Polygon, corners[0], colors[0], width});
}

void RecordingCanvas::outline(std::span<const Vec2> corners, Real width, Color color) {
    strokes_.push_back({Stroke::Kind::Outline, corners[0], color, width});
}

void RecordingCanvas::line(Vec2 from, Vec2, Real width, Color color) {
    strokes_.push_back({Stroke::Kind::Line, from, color, width});
}

void RecordingCanvas::ribbon(std::span<const Vec2> points, std::span<const Real> widths,
                             std::span<const Color> colors) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        strokes_.push_back({Stroke::Kind::Ribbon, points[i], colors[i], widths[i]});
    }
}

void RecordingCanvas::disc(Vec2 center, Real radius, Color middle, Color) {
    strokes_.push_back({Stroke::Kind::Disc, center, middle, radius});
}

void RecordingCanvas::ring(Vec2 center, Real radius, Real, Color color) {
    strokes_.push_back({Stroke::Kind::Ring, center, color, radius});
}

void RecordingCanvas::text(std::string_view utf8, Vec2 place, const TextStyle& style) {
    strokes_.push_back({Stroke::Kind::Text, place, style.color, style.height, std::string(utf8),
                        style, focus_ + zoom_ * (place - focus_)});
}

bool RecordingCanvas::says(std::string_view text) const {
    return std::any_of(strokes_.begin(), strokes_.end(), [&](const Stroke& stroke) {
        return stroke.text.find(text) != std::string::npos;
    });
}

Signals ScriptedControls::poll() {
    if (script.empty()) {
        return {};
    }
    Signals next = script.front();
    script.pop_front();
    return next;
}

} // namespace apart
