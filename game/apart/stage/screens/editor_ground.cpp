// SPDX-License-Identifier: MIT
// The editor's tool for ground, and the outline of the chosen one.
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/screens/editor_screen.hpp>

#include <algorithm>
#include <utility>

namespace apart {

namespace {

Vec2 metresOf(GroundPoint point) {
    return {static_cast<Real>(point.x) / 1000, static_cast<Real>(point.y) / 1000};
}

} // namespace

const ObstructionDef* EditorScreen::chosenGround() const {
    const bool one = hand_.chosen.size() == 1 && hasOutline(*document_.level(), hand_.chosen[0]);
    return one ? &document_.level()->obstructions[hand_.chosen[0].index] : nullptr;
}

GroundPoint EditorScreen::corner() const {
    return cornerAt(*document_.level(), hand_.pointer, hand_.free, hand_.chosen);
}

bool EditorScreen::closes() const {
    constexpr Real kNear = Real(0.25); // m
    const std::vector<GroundPoint>& corners = outline_.corners;
    return corners.size() >= 3 && (length(metresOf(corners.front()) - hand_.pointer) < kNear ||
                                   corners.back() == corner());
}

/// A press on the outline of the chosen ground takes a corner, or the middle of an edge.
bool EditorScreen::pressGrip() {
    outline_.grip.reset();
    const bool shown = tool_.tool == EditorTool::Select || tool_.tool == EditorTool::Ground;
    const ObstructionDef* ground = shown ? chosenGround() : nullptr;
    outline_.grip = ground == nullptr ? std::nullopt : gripAt(*ground, hand_.pointer);
    outline_.drags = outline_.grip.has_value();
    return outline_.drags;
}

/// `from`: m, of the press.
void EditorScreen::releaseGrip(Vec2 from, double now) {
    constexpr Real kStill = Real(0.08); // m; less is a click, which chooses a corner
    outline_.drags = false;
    const ObstructionDef* ground = chosenGround();
    if (ground == nullptr) { // a key has changed the level meanwhile
        return outline_.grip.reset();
    }
    if (length(hand_.pointer - from) > kStill) {
        return putCorner(*outline_.grip, corner(), now);
    }
    if (outline_.grip->edge) {
        outline_.grip.reset();
    }
}

/// The corner is chosen from then on, wherever the outline has it.
void EditorScreen::putCorner(GroundGrip grip, GroundPoint to, double now) {
    change(withCorner(*document_.level(), hand_.chosen[0].index, grip, to), now);
    const std::vector<GroundPoint>& points = chosenGround()->points;
    const auto found = std::find(points.begin(), points.end(), to);
    outline_.grip.reset();
    if (found != points.end()) {
        outline_.grip = GroundGrip{static_cast<std::size_t>(found - points.begin())};
    }
}

void EditorScreen::addCorner(double now) {
    if (closes()) {
        return finishGround(now);
    }
    hand_.chosen.clear();
    const GroundPoint at = corner();
    if (outline_.corners.empty() || outline_.corners.back() != at) {
        outline_.corners.push_back(at);
    }
}

void EditorScreen::finishGround(double now) {
    if (outline_.corners.size() < 3) {
        return say("Ground has three corners or more.", now);
    }
    const std::shared_ptr<const Level> before = document_.level();
    change(withGround(*before, outline_.corners, tool_.turf), now);
    if (document_.level() != before) { // ground comes last in a level
        outline_ = {};
        hand_.chosen = {{LevelPart::Of::Obstruction, document_.level()->obstructions.size() - 1}};
    }
}

/// Of the chosen ground, or of the next one.
void EditorScreen::setTurf(Turf turf, double now) {
    tool_.turf = turf;
    const Level& level = *document_.level();
    const auto isGround = [&](LevelPart part) { return hasOutline(level, part); };
    if (std::any_of(hand_.chosen.begin(), hand_.chosen.end(), isGround)) {
        return change(withTurf(level, hand_.chosen, turf), now);
    }
    if (tool_.tool != EditorTool::Ground) {
        setTool(EditorTool::Ground);
    }
}

void EditorScreen::drawGround(Canvas& canvas) const {
    const Color faint = faded(palette::kAccent, 0.5f);
    const auto line = [&](Vec2 from, Vec2 to, Color color) {
        canvas.line(from, to, Real(0.06), color);
    };
    const Vec2 at = metresOf(corner());
    if (tool_.tool == EditorTool::Ground) {
        constexpr Real kLowest = static_cast<Real>(kLowestCorner) / 1000;
        canvas.line({layout::kLeft, kLowest}, {layout::kRight, kLowest}, Real(0.04),
                    faded(palette::kQuiet, 0.6f));
        const std::vector<GroundPoint>& corners = outline_.corners;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            line(metresOf(corners[i]), metresOf(corners[i + 1]), palette::kAccent);
        }
        if (!corners.empty()) {
            const Vec2 first = metresOf(corners.front());
            line(metresOf(corners.back()), closes() ? first : at, faint);
            line(closes() ? first : at, first, faded(faint, 0.5f));
            canvas.ring(first, closes() ? Real(0.3) : Real(0.2), Real(0.06), palette::kAccent);
        }
        for (const GroundPoint corner : corners) {
            canvas.disc(metresOf(corner), Real(0.1), palette::kAccent, palette::kAccent);
        }
        if (layout::kField.grown(1).contains(hand_.pointer)) {
            canvas.ring(at, Real(0.14), Real(0.05), palette::kText);
        }
    }
    const ObstructionDef* ground = chosenGround();
    if (ground == nullptr || !outline_.corners.empty()) {
        return;
    }
    for (std::size_t i = 0; i < ground->points.size(); ++i) {
        const GroundGrip corner{i};
        const bool taken = outline_.grip == corner;
        canvas.disc(gripPlace(*ground, corner), taken ? Real(0.2) : Real(0.14),
                    taken ? palette::kText : palette::kAccent, palette::kAccent);
        canvas.ring(gripPlace(*ground, {i, true}), Real(0.1), Real(0.06), palette::kAccent);
    }
    if (outline_.drags) { // the edges as they will be
        const std::size_t from = outline_.grip->corner;
        const std::size_t count = ground->points.size();
        const std::size_t before = outline_.grip->edge ? from : (from + count - 1) % count;
        line(metresOf(ground->points[before]), at, palette::kText);
        line(at, metresOf(ground->points[(from + 1) % count]), palette::kText);
    }
}

} // namespace apart
