// SPDX-License-Identifier: MIT
// The picture of the editor: the level, what is chosen, what the trials found, and the buttons.
#include <apart/core/field.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/painters/backdrop.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/editor_screen.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Color kStandsColor{120, 214, 140};
constexpr Color kMovesColor{255, 120, 96};
constexpr double kNoticeSeconds = 6;

std::vector<std::vector<Vec2>> cornersOf(const PlacedShape& placed) {
    std::vector<std::vector<Vec2>> all;
    for (const kodo::Polygon& polygon : polygonsOf(placed.shape)) {
        std::vector<Vec2> corners;
        for (const Vec2 corner : polygon.corners) {
            corners.push_back(placed.frame * corner);
        }
        all.push_back(std::move(corners));
    }
    return all;
}

std::array<Vec2, 4> rectangleOf(const Aabb& box) {
    return {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
}

void paintShape(Canvas& canvas, const PlacedShape& placed, Color fill, Color rim) {
    for (const std::vector<Vec2>& corners : cornersOf(placed)) {
        canvas.polygon(corners, fill);
        canvas.outline(corners, Real(0.06), rim);
    }
}

void paintPart(Canvas& canvas, const Level& level, LevelPart part, Color color) {
    if (part.of == LevelPart::Of::Block) {
        return paintShape(canvas, placedShapeOf(level.freeBlocks[part.index]), faded(color, 0.3f),
                          color);
    }
    if (hasOutline(level, part)) {
        const ObstructionDef& ground = level.obstructions[part.index];
        for (const kodo::Polygon& piece : polygonsOf(solidOf(ground))) {
            canvas.polygon(piece.corners, faded(color, 0.2f));
        }
        return canvas.outline(outlineOf(ground), Real(0.06), color);
    }
    const std::array<Vec2, 4> corners = rectangleOf(boundsOf(level, part));
    canvas.polygon(corners, faded(color, 0.2f));
    canvas.outline(corners, Real(0.06), color);
}

void paintButton(Canvas& canvas, const EditorButton& button, bool on, bool under) {
    const std::array<Vec2, 4> frame = rectangleOf(button.place);
    canvas.polygon(frame, on ? faded(palette::kAccent, 0.24f) : Color{255, 255, 255, 16});
    if (on || under) {
        canvas.outline(frame, Real(0.05), on ? palette::kAccent : palette::kQuiet);
    }
    const Vec2 middle = button.place.center();
    const Vec2 size = button.place.extent();
    if (button.act == EditorAct::Shape) {
        FreeBlock block = usualBlock(static_cast<Form>(button.value));
        const PlacedShape placed = placedShapeOf(block);
        const Aabb bounds = boundsOf(placed);
        const Real scale = std::min(Real(0.8) * size.x / bounds.extent().x,
                                    Real(0.7) * size.y / bounds.extent().y);
        for (std::vector<Vec2>& corners : cornersOf(placed)) {
            for (Vec2& corner : corners) {
                corner = middle + scale * (corner - bounds.center());
            }
            canvas.polygon(corners, on ? palette::kAccent : palette::kQuiet);
        }
        if (block.form == Form::Wheel) {
            canvas.ring(middle, Real(0.15), Real(0.06), palette::kInk);
        }
        return;
    }
    Color color = on ? palette::kAccent : palette::kText;
    const bool turf = button.act == EditorAct::Turf;
    if (turf || button.act == EditorAct::Stuff) {
        const Real inner = Real(0.08);
        const Color stuff = turf ? palette::kTurf[button.value]
                                 : canvas.palette().of(static_cast<Stuff>(button.value));
        canvas.polygon(rectangleOf(button.place.grown(-inner)), stuff);
        color = palette::kInk;
    }
    const bool small = turf || button.act == EditorAct::Hold;
    canvas.text(button.label, {middle.x, middle.y - Real(0.14)},
                {small ? Real(0.3) : Real(0.42), color, Typeface::Plain, Align::Middle,
                 size.x - (turf ? Real(0.22) : Real(0.12))});
}

/// An arrow down to a place.
void paintArrow(Canvas& canvas, Vec2 tip, Color color) {
    canvas.line(tip + Vec2{0, Real(1.3)}, tip, Real(0.12), color);
    canvas.line(tip + Vec2{Real(-0.35), Real(0.45)}, tip, Real(0.12), color);
    canvas.line(tip + Vec2{Real(0.35), Real(0.45)}, tip, Real(0.12), color);
}

std::string titleOf(const EditDocument& document) {
    return shortened(document.level()->title, 24) + (document.isSaved() ? "" : " *");
}

} // namespace

bool EditorScreen::isOn(const EditorButton& button) const {
    const bool block = tool_.tool == EditorTool::Block;
    switch (button.act) {
    case EditorAct::Select:
        return tool_.tool == EditorTool::Select;
    case EditorAct::Ledge:
        return tool_.tool == EditorTool::Ledge;
    case EditorAct::Rope:
        return tool_.tool == EditorTool::Rope;
    case EditorAct::Pin:
        return tool_.tool == EditorTool::Pin;
    case EditorAct::Ground:
        return tool_.tool == EditorTool::Ground;
    case EditorAct::Turf: {
        const ObstructionDef* ground = chosenGround();
        return ground != nullptr ? ground->turf == static_cast<Turf>(button.value)
                                 : tool_.tool == EditorTool::Ground &&
                                       tool_.turf == static_cast<Turf>(button.value);
    }
    case EditorAct::Stuff:
        return block && tool_.stuff == static_cast<Stuff>(button.value);
    case EditorAct::Hold:
        return block && tool_.hold == static_cast<Support>(button.value);
    case EditorAct::Shape:
        return block && tool_.form == static_cast<Form>(button.value);
    case EditorAct::Map:
        return trials_.map.has_value();
    default:
        return false;
    }
}

void EditorScreen::drawLamp(Canvas& canvas) const {
    const StandingTrial& standing = *trials_.standing;
    const auto& moved = standing.first();
    const Color color = moved ? kMovesColor : standing.done() ? kStandsColor : palette::kAccent;
    const Vec2 place{layout::kPanelLeft + Real(0.3), Real(15.85)};
    canvas.disc(place, Real(0.26), lighter(color, 0.4f), color);
    canvas.ring(place, Real(0.34), Real(0.06), darker(color, 0.4f));
    const std::string text = moved ? fmt::format("moves after {:.1f} s",
                                                 static_cast<double>(moved->tick) / kTicksPerSecond)
                             : standing.done()
                                 ? "it stands"
                                 : fmt::format("standing for {:.0f} s", 60 * standing.share());
    canvas.text(text, {layout::kPanelLeft + Real(0.8), Real(15.7)},
                {Real(0.46), color, Typeface::Bold, Align::Left, Real(3.7)});
    if (moved) {
        paintArrow(canvas, moved->block.home.position + Vec2{0, Real(0.3)}, kMovesColor);
    }
}

void EditorScreen::drawPanel(Canvas& canvas) const {
    canvas.text(titleOf(document_), {layout::kPanelLeft, Real(17.3)},
                {Real(0.6), palette::kText, Typeface::Bold, Align::Left, Real(4.5)});
    const Level& level = *document_.level();
    canvas.text(fmt::format("{}, {}",
                            countText(static_cast<std::int64_t>(level.freeBlocks.size() +
                                                                level.cells.size()),
                                      "block"),
                            countText(static_cast<std::int64_t>(level.links.size()), "joint")),
                {layout::kPanelLeft, Real(16.65)},
                {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Left, Real(4.5)});
    drawLamp(canvas);
    for (const EditorButton& button : buttons()) {
        paintButton(canvas, button, isOn(button), button.place.contains(hand_.pointer));
    }
    if (trials_.map) {
        canvas.text(fmt::format("{} of {} serves", trials_.map->served(), ServeMap::kServes),
                    {layout::kPanelLeft, Real(0.35)},
                    {Real(0.42), palette::kText, Typeface::Plain, Align::Left, Real(4.5)});
        const Aabb bar{{layout::kPanelLeft, Real(0.05)}, {layout::kPanelRight, Real(0.17)}};
        const Vec2 end{bar.lower.x + static_cast<Real>(trials_.map->share()) * bar.extent().x,
                       bar.upper.y};
        canvas.rectangle(bar, {255, 255, 255, 40}, {255, 255, 255, 40});
        canvas.rectangle({bar.lower, end}, palette::kAccent, palette::kAccent);
    }
}

/// What the next press or release would do.
void EditorScreen::drawHand(Canvas& canvas) const {
    const Level& level = *document_.level();
    const bool inside = layout::kField.contains(hand_.pointer);
    const EditStep way = step();
    for (const LevelPart part : hand_.chosen) {
        paintPart(canvas, level, part, palette::kAccent);
    }
    if (way != EditStep{} && hand_.drags && tool_.tool == EditorTool::Select) {
        const Level after = moved(level, hand_.chosen, way);
        for (const LevelPart part : hand_.chosen) {
            paintPart(canvas, after, part, palette::kText);
        }
    }
    if (tool_.tool == EditorTool::Block && inside) {
        FreeBlock block = blockInHand();
        block.x += way.x;
        block.y += way.y;
        const Color color = canvas.palette().of(tool_.stuff);
        paintShape(canvas, placedShapeOf(block), faded(color, 0.6f), palette::kText);
    }
    if (hand_.pressed && !hand_.drags && !outline_.drags && tool_.tool == EditorTool::Select) {
        const Aabb box =
            unite(Aabb{*hand_.pressed, *hand_.pressed}, Aabb{hand_.pointer, hand_.pointer});
        canvas.outline(rectangleOf(box), Real(0.05), palette::kAccent);
    }
    const Vec2 from = hand_.pressed.value_or(hand_.pointer);
    if (tool_.tool == EditorTool::Ledge && inside) {
        const Vec2 half = hand_.pressed ? Vec2{} : Vec2{2, 0};
        canvas.line(from - half, Vec2{hand_.pointer.x, from.y} + half, Real(0.4),
                    faded(palette::kText, 0.5f));
    }
    if (tool_.tool == EditorTool::Rope && hand_.pressed) {
        canvas.line(from, hand_.pointer, Real(0.06), palette::kAccent);
    }
    if (tool_.tool == EditorTool::Pin || tool_.tool == EditorTool::Rope) {
        canvas.ring(hand_.pointer, Real(0.18), Real(0.06), palette::kAccent);
    }
}

void EditorScreen::drawTrials(Canvas& canvas, double now) const {
    const Level& level = *document_.level();
    if (trials_.map) { // from blue over violet to red
        const auto paint = [&](const PlacedShape& placed, std::size_t index) {
            const auto share = static_cast<float>(trials_.map->clearedBy(index));
            const Color color = mix({60, 110, 255}, {255, 50, 40}, share);
            paintShape(canvas, placed, faded(color, 0.75f), color);
            canvas.text(fmt::format("{:.0f}", 100 * share),
                        boundsOf(placed).center() - Vec2{0, Real(0.12)},
                        {Real(0.36), palette::kText, Typeface::Bold, Align::Middle, Real(0.7)});
        };
        for (std::size_t i = 0; i < level.cells.size(); ++i) {
            paint({kodo::Box{kCellWidth, kCellHeight}, {centerOf(level.cells[i]), {}}}, i);
        }
        for (std::size_t i = 0; i < level.freeBlocks.size(); ++i) {
            paint(placedShapeOf(level.freeBlocks[i]), level.cells.size() + i);
        }
    }
    if (!trials_.forecast) {
        return;
    }
    const float pulse = 0.35f + 0.1f * static_cast<float>(std::sin(4 * now));
    for (const FallForecast::Fallen& fallen : trials_.forecast->fallen()) {
        const PlacedShape home = placedShapeOf(level.freeBlocks[fallen.block]);
        for (const std::vector<Vec2>& corners : cornersOf(home)) {
            canvas.outline(corners, Real(0.08), kMovesColor);
        }
        if (fallen.block != trials_.forecast->struck()) {
            paintShape(canvas, {home.shape, fallen.pose}, faded(kMovesColor, pulse),
                       faded(kMovesColor, 0.7f));
        }
    }
}

/// What the forecast found, as a sentence for the line below the field, where no block stands.
std::string EditorScreen::forecastText() const {
    const auto count = static_cast<std::int64_t>(trials_.forecast->fallen().size());
    if (count > 0) {
        return countText(count, "block") + " cleared by a hit here";
    }
    return trials_.forecast->done() ? "nothing comes down" : "...";
}

/// What the tool does, for the same line.
std::string_view EditorScreen::hint() const {
    switch (tool_.tool) {
    case EditorTool::Select:
        return chosenGround() != nullptr
                   ? "drag a corner, or the middle of an edge   click a corner, X: remove it   "
                     "shift: no snapping"
                   : "drag: move   shift: no snapping   drag beside: choose several   "
                     "arrows: 50 mm   rest on a block: its fall";
    case EditorTool::Block:
        return "click: place   shift: no snapping   E: turn   F: flip   A: select";
    case EditorTool::Ledge:
        return "click or drag: a ledge   shift: no snapping   A: select";
    case EditorTool::Rope:
        return "drag from the field or a block to a block   shift: no snapping   A: select";
    case EditorTool::Pin:
        return "click where two blocks meet, or a block and the field   shift: no snapping   "
               "A: select";
    case EditorTool::Ground:
        break;
    }
    return outline_.corners.empty()
               ? "click: the corners of ground, one after the other   shift: no snapping   "
                 "A: select"
               : "click: next corner   the first one, enter: done   Z: one back   escape: drop it";
}

void EditorScreen::draw(Canvas& canvas, double now) const {
    paintBackdrop(canvas, document_.level()->theme, now);
    constexpr Real kGrown = 300; // ticks, after which blocks are at full size; nothing moves
    play_->draw(canvas, kGrown, layout::kShown, false);
    drawTrials(canvas, now);
    drawHand(canvas);
    drawGround(canvas);
    drawPanel(canvas);
    const bool news = !notice_.empty() && now - noticeAt_ < kNoticeSeconds;
    const bool foretold = !news && trials_.forecast;
    const Color color = news ? palette::kAccent : foretold ? palette::kText : palette::kQuiet;
    const std::string line = news ? notice_ : foretold ? forecastText() : std::string(hint());
    canvas.text(
        line, {0, Real(0.25)},
        {Real(0.46), color, foretold ? Typeface::Bold : Typeface::Plain, Align::Middle, Real(23)});
}

} // namespace apart
