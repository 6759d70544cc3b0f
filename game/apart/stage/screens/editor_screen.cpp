// SPDX-License-Identifier: MIT
#include <apart/core/editor/level_writer.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/screens/editor_screen.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace apart {

namespace {

constexpr std::uint32_t kTrialTicks = 60; // of one trial in a frame; a tick takes 0.04 ms or more
constexpr int kRestFrames = 20;           // of the pointer, until the fall is forecast
constexpr std::int32_t kTurnStep = 15000; // 1/1000 degree
constexpr double kAskSeconds = 4;         // in which a second escape leaves
constexpr const char* kUnsaved = "Not saved. Once more to leave all the same.";
constexpr Real kWidth = layout::kPanelRight - layout::kPanelLeft; // m, of the buttons

std::int32_t thousandths(Real metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1000));
}

/// Buttons in rows from a height on. Returns the next height.
Real addRow(std::vector<EditorButton>& all, std::vector<EditorButton> row, Real top, Real height) {
    const Real step = kWidth / static_cast<Real>(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        const Real left = layout::kPanelLeft + step * static_cast<Real>(i);
        row[i].place = {{left, top - height}, {left + step - Real(0.12), top}};
        all.push_back(std::move(row[i]));
    }
    return top - height - Real(0.12);
}

std::vector<EditorButton> makeButtons() {
    using Act = EditorAct;
    std::vector<EditorButton> all;
    constexpr Real kHigh = Real(0.68);
    Real top = Real(15.2);
    top = addRow(all, {{Act::Select, {}, "select  A"}, {Act::Ledge, {}, "ledge  L"}}, top, kHigh);
    top = addRow(all, {{Act::Rope, {}, "rope  R"}, {Act::Pin, {}, "pin  P"}}, top, kHigh);
    top -= Real(0.3);
    std::vector<EditorButton> row;
    for (std::size_t i = 0; i < kStuffNames.size(); ++i) {
        row.push_back({Act::Stuff, {}, std::to_string(i + 1), i});
    }
    top = addRow(all, std::move(row), top, Real(0.8));
    row = {};
    for (const Support hold : {Support::Standing, Support::Mounted, Support::Moving}) {
        const auto value = static_cast<std::size_t>(hold);
        row.push_back({Act::Hold, {}, std::string(kSupportNames[value]), value});
    }
    top = addRow(all, std::move(row), top, kHigh);
    for (std::size_t first = 0; first < kFormNames.size(); first += 4) {
        row = {};
        for (std::size_t i = first; i < first + 4; ++i) {
            row.push_back({Act::Shape, {}, "", i});
        }
        const bool last = first + 4 > kFormNames.size();
        top = addRow(all, std::move(row), top, Real(0.8));
        if (last) {
            all.pop_back(); // eleven shapes
        }
    }
    top -= Real(0.3);
    top = addRow(all, {{Act::Undo, {}, "undo  Z"}, {Act::Redo, {}, "redo  Y"}}, top, kHigh);
    top = addRow(all, {{Act::Mirror, {}, "mirror  M"}, {Act::Flip, {}, "flip  F"}}, top, kHigh);
    top = addRow(all, {{Act::Turn, {}, "turn  E"}, {Act::Remove, {}, "remove  X"}}, top, kHigh);
    top -= Real(0.3);
    top = addRow(all, {{Act::Map, {}, "serves  H"}, {Act::Try, {}, "try here  T"}}, top, kHigh);
    addRow(all, {{Act::Save, {}, "save  S"}, {Act::Leave, {}, "leave  esc"}}, top, kHigh);
    return all;
}

/// The key of an act, or kNoKey.
int keyOf(const EditorButton& button) {
    if (button.act == EditorAct::Stuff) {
        return keyNamed(button.label).value_or(kNoKey);
    }
    const std::size_t space = button.label.rfind(' ');
    const bool letter = space != std::string::npos && space + 2 == button.label.size();
    return letter ? keyNamed(button.label.substr(space + 1)).value_or(kNoKey) : kNoKey;
}

} // namespace

EditorScreen::EditorScreen(EditorStart start, const Settings& settings)
    : start_(std::move(start)), settings_(settings), document_(start_.level) {
    changed();
}

const std::vector<EditorButton>& EditorScreen::buttons() {
    static const std::vector<EditorButton> all = makeButtons();
    return all;
}

void EditorScreen::say(std::string sentence, double now) {
    notice_ = std::move(sentence);
    noticeAt_ = now;
}

/// The level is another one.
void EditorScreen::changed() {
    const std::shared_ptr<const Level>& level = document_.level();
    play_ = std::make_unique<Play>(level, 1, Mode::Standard, settings_);
    trials_.standing = std::make_unique<StandingTrial>(level);
    trials_.forecast.reset();
    if (trials_.map) {
        trials_.map.emplace(level);
    }
}

void EditorScreen::change(Level level, double now) {
    const std::shared_ptr<const Level> before = document_.level();
    if (const std::string problem = document_.apply(std::move(level)); !problem.empty()) {
        return say("That is no level: " + problem + ".", now);
    }
    notice_.clear();
    if (document_.level() != before) {
        changed();
    }
}

FreeBlock EditorScreen::blockInHand() const {
    FreeBlock block = resized(usualBlock(tool_.form), tool_.larger);
    block.turn = tool_.turn;
    block.mirrored = tool_.flip;
    return block;
}

EditStep EditorScreen::step() const {
    const auto stepOf = [](Vec2 way) { return EditStep{thousandths(way.x), thousandths(way.y)}; };
    const Level& level = *document_.level();
    if (tool_.tool == EditorTool::Block) {
        const kodo::Aabb bounds = boundsOf(placedShapeOf(blockInHand()));
        return snapped(level, bounds, {}, stepOf(hand_.pointer - bounds.center()));
    }
    if (!hand_.drags || !hand_.pressed || hand_.chosen.empty()) {
        return {};
    }
    kodo::Aabb bounds = boundsOf(level, hand_.chosen[0]);
    for (const LevelPart part : hand_.chosen) {
        bounds = unite(bounds, boundsOf(level, part));
    }
    const EditStep way = stepOf(hand_.pointer - *hand_.pressed);
    constexpr std::int32_t kStill = 80; // 1/1000 m; less is a click
    const bool still = std::abs(way.x) < kStill && std::abs(way.y) < kStill;
    return still ? EditStep{} : snapped(level, bounds, hand_.chosen, way);
}

void EditorScreen::press() {
    hand_.pressed = hand_.pointer;
    hand_.drags = false;
    if (tool_.tool != EditorTool::Select) {
        return;
    }
    const std::optional<LevelPart> part = partAt(*document_.level(), hand_.pointer);
    const auto& chosen = hand_.chosen;
    if (part && std::find(chosen.begin(), chosen.end(), *part) == chosen.end()) {
        hand_.chosen = {*part};
    } else if (!part) {
        hand_.chosen.clear();
    }
    hand_.drags = part.has_value();
}

void EditorScreen::release(double now) {
    const Vec2 from = *hand_.pressed;
    const Vec2 to = hand_.pointer;
    const EditStep way = step(); // before the button counts as released
    hand_.pressed.reset();
    const Level& level = *document_.level();
    switch (tool_.tool) {
    case EditorTool::Select:
        if (hand_.drags) {
            change(moved(level, hand_.chosen, way), now);
        } else {
            hand_.chosen = partsIn(level, unite(Aabb{from, from}, Aabb{to, to}));
        }
        return;
    case EditorTool::Block: {
        FreeBlock block = blockInHand();
        block.x += way.x;
        block.y += way.y;
        return change(withBlock(level, standingKind(tool_.stuff, tool_.hold), block), now);
    }
    case EditorTool::Ledge: {
        constexpr std::int32_t kUsual = 4000; // 1/1000 m
        const std::int32_t across = std::abs(thousandths(to.x - from.x)) / kSnapGrid * kSnapGrid;
        const bool drawn = across >= 400;
        const Real middle = drawn ? (from.x + to.x) / 2 : to.x;
        const auto onGrid = [](Real place) {
            return std::round(place * 1000 / kSnapGrid) * kSnapGrid / 1000;
        };
        const std::int32_t width = drawn ? across : kUsual;
        return change(withLedge(level, {onGrid(middle), onGrid(from.y)}, width), now);
    }
    case EditorTool::Rope:
    case EditorTool::Pin: {
        const bool rope = tool_.tool == EditorTool::Rope;
        std::optional<Level> linked =
            rope ? withRope(level, from, to) : withPin(level, to, hand_.chosen);
        if (!linked) {
            return say(rope ? "One end of a rope is at a block that is not mounted."
                            : "A pin is at a block that is not mounted.",
                       now);
        }
        return change(std::move(*linked), now);
    }
    }
}

void EditorScreen::save(double now) {
    const std::string problem =
        start_.save ? start_.save(toToml(*document_.level())) : "There is no folder for levels.";
    if (problem.empty()) {
        document_.markSaved();
        ++saves_;
    }
    say(problem.empty() ? "Saved as " + start_.file : problem, now);
}

void EditorScreen::act(const EditorButton& button, double now) {
    const Level& level = *document_.level();
    const LevelParts& chosen = hand_.chosen;
    const bool placing = tool_.tool == EditorTool::Block;
    switch (button.act) {
    case EditorAct::Select:
        tool_.tool = EditorTool::Select;
        return;
    case EditorAct::Ledge:
        tool_.tool = EditorTool::Ledge;
        return;
    case EditorAct::Rope:
        tool_.tool = EditorTool::Rope;
        return;
    case EditorAct::Pin:
        tool_.tool = EditorTool::Pin;
        return;
    case EditorAct::Stuff:
        tool_.stuff = static_cast<Stuff>(button.value);
        tool_.tool = EditorTool::Block;
        return;
    case EditorAct::Hold:
        tool_.hold = static_cast<Support>(button.value);
        tool_.tool = EditorTool::Block;
        return;
    case EditorAct::Shape:
        tool_.form = static_cast<Form>(button.value);
        tool_.larger = {};
        tool_.tool = EditorTool::Block;
        return;
    case EditorAct::Undo:
    case EditorAct::Redo:
        button.act == EditorAct::Undo ? document_.undo() : document_.redo();
        hand_.chosen.clear();
        return changed();
    case EditorAct::Mirror:
        return change(withMirrorImages(level, chosen), now);
    case EditorAct::Flip:
        tool_.flip = placing != tool_.flip;
        return placing ? void() : change(flipped(level, chosen), now);
    case EditorAct::Turn:
        tool_.turn = placing ? (tool_.turn + kTurnStep) % 360000 : tool_.turn;
        return placing ? void() : change(turned(level, chosen, kTurnStep), now);
    case EditorAct::Remove:
        change(without(level, chosen), now);
        return hand_.chosen.clear();
    case EditorAct::Map:
        return trials_.map ? trials_.map.reset() : void(trials_.map.emplace(document_.level()));
    case EditorAct::Save:
        return save(now);
    case EditorAct::Try:
    case EditorAct::Leave:
        return; // of the stage
    }
}

EditorScreen::Wish EditorScreen::leave(double now) {
    const bool asked = notice_ == kUnsaved && now - noticeAt_ < kAskSeconds;
    if (document_.isSaved() || asked) {
        return Wish::Leave;
    }
    say(kUnsaved, now);
    return Wish::None;
}

void EditorScreen::takeKey(int key, double now) {
    const auto is = [&](const char* name) { return key == keyNamed(name); };
    const EditStep nudge = is("left")    ? EditStep{-kSnapGrid, 0}
                           : is("right") ? EditStep{kSnapGrid, 0}
                           : is("up")    ? EditStep{0, kSnapGrid}
                           : is("down")  ? EditStep{0, -kSnapGrid}
                                         : EditStep{};
    if (nudge != EditStep{} && !hand_.chosen.empty()) {
        change(moved(*document_.level(), hand_.chosen, nudge), now);
    }
    constexpr std::int32_t kMore = 100; // 1/1000 m
    const EditStep larger = is("W")   ? EditStep{kMore, 0}
                            : is("Q") ? EditStep{-kMore, 0}
                            : is("K") ? EditStep{0, kMore}
                            : is("J") ? EditStep{0, -kMore}
                                      : EditStep{};
    if (larger != EditStep{} && tool_.tool == EditorTool::Block) {
        tool_.larger = {tool_.larger.x + larger.x, tool_.larger.y + larger.y};
    } else if (larger != EditStep{}) {
        change(resized(*document_.level(), hand_.chosen, larger), now);
    }
    const std::vector<EditorButton>& all = buttons();
    const auto found = std::find_if(all.begin(), all.end(), [&](const EditorButton& button) {
        return keyOf(button) == key || (button.act == EditorAct::Remove && is("delete"));
    });
    if (found != all.end() && key != kNoKey) {
        act(*found, now);
    }
}

EditorScreen::Wish EditorScreen::take(const Signals& signals, double now) {
    if (signals.pointer || signals.clicked) {
        hand_.rests = hand_.pointer == signals.pointerNow ? hand_.rests : 0;
        hand_.pointer = signals.pointerNow;
    }
    for (const Command command : signals.commands) {
        if (command == Command::Back) {
            return leave(now);
        }
    }
    for (const Press press : signals.presses) {
        if (!press.pad && press.code == keyNamed("T")) {
            return Wish::Try;
        }
        if (!press.pad) {
            takeKey(press.code, now);
        }
    }
    if (signals.clicked) {
        for (const EditorButton& button : buttons()) {
            if (button.place.contains(hand_.pointer)) {
                act(button, now);
                return button.act == EditorAct::Try     ? Wish::Try
                       : button.act == EditorAct::Leave ? leave(now)
                                                        : Wish::None;
            }
        }
        if (layout::kField.contains(hand_.pointer)) {
            press();
        }
    }
    if (hand_.pressed && !signals.dragging) {
        release(now);
    }
    return Wish::None;
}

void EditorScreen::advance() {
    const bool idle = tool_.tool == EditorTool::Select && !hand_.pressed;
    const std::optional<std::size_t> block =
        idle ? blockAt(*document_.level(), hand_.pointer) : std::nullopt;
    hand_.rests = block ? hand_.rests + 1 : 0;
    if (!block || (trials_.forecast && trials_.forecast->struck() != *block)) {
        trials_.forecast.reset();
    }
    if (block && !trials_.forecast && hand_.rests >= kRestFrames) {
        trials_.forecast.emplace(document_.level(), *block, hand_.pointer);
    }
    if (trials_.forecast && !trials_.forecast->done()) {
        return trials_.forecast->advance(kTrialTicks);
    }
    if (!trials_.standing->done() && !trials_.standing->first()) {
        return trials_.standing->advance(kTrialTicks);
    }
    if (trials_.map && !trials_.map->done()) {
        trials_.map->advance(kTrialTicks);
    }
}

std::unique_ptr<Play> EditorScreen::trialPlay() const {
    Level level = *document_.level();
    level.name += ".toml"; // no level has this name, so nothing is recorded
    auto play = std::make_unique<Play>(std::make_shared<const Level>(std::move(level)), 1,
                                       Mode::Standard, settings_);
    const Vec2 place{std::clamp(hand_.pointer.x, layout::kLeft + 1, layout::kRight - 1),
                     std::clamp(hand_.pointer.y, Real(3), layout::kTop - 1)};
    play->dropBall(place);
    return play;
}

} // namespace apart
