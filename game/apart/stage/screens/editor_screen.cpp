// SPDX-License-Identifier: MIT
#include <apart/core/editor/level_writer.hpp>
#include <apart/core/editor/size_edit.hpp>
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
constexpr double kStaySeconds = 0.2;      // of the pointer at a place to try from
constexpr double kRepeatAfter = 0.3;      // s, of a key that is held
constexpr double kAskSeconds = 4;         // in which a second escape leaves
constexpr const char* kUnsaved = "Not saved. Once more to leave all the same.";

std::int32_t thousandths(Real metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1000));
}

} // namespace

EditorScreen::EditorScreen(EditorStart start, const Settings& settings)
    : start_(std::move(start)), settings_(settings), document_(start_.level) {
    changed();
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
    const Level wanted = level;
    const bool joins = hand_.repeats && before == hand_.made;
    if (const std::string problem = document_.apply(std::move(level), joins); !problem.empty()) {
        return say("That is no level: " + problem + ".", now);
    }
    notice_.clear();
    if (document_.level() != before) {
        hand_.chosen = followed(std::move(hand_.chosen), wanted, *document_.level());
        hand_.made = document_.level();
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
    const auto placed = [&](const kodo::Aabb& bounds, const LevelParts& own, EditStep way) {
        return hand_.free ? way : snapped(*document_.level(), bounds, own, way);
    };
    const Level& level = *document_.level();
    if (tool_.tool == EditorTool::Block) {
        const kodo::Aabb bounds = boundsOf(placedShapeOf(blockInHand()));
        return placed(bounds, {}, stepOf(hand_.pointer - bounds.center()));
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
    return still ? EditStep{} : placed(bounds, hand_.chosen, way);
}

void EditorScreen::press() {
    hand_.pressed = hand_.pointer;
    hand_.drags = false;
    if (pressGrip() || tool_.tool != EditorTool::Select) {
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
    if (outline_.drags) {
        return releaseGrip(from, now);
    }
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
        const std::int32_t grid = hand_.free ? 1 : kSnapGrid;
        const std::int32_t across = std::abs(thousandths(to.x - from.x)) / grid * grid;
        const bool drawn = across >= 400;
        const Real middle = drawn ? (from.x + to.x) / 2 : to.x;
        const auto onGrid = [step = static_cast<Real>(grid)](Real place) {
            return std::round(place * 1000 / step) * step / 1000;
        };
        const std::int32_t width = drawn ? across : kUsual;
        return change(withLedge(level, {onGrid(middle), onGrid(from.y)}, width), now);
    }
    case EditorTool::Rope:
    case EditorTool::Pin: {
        const bool rope = tool_.tool == EditorTool::Rope;
        std::optional<Level> linked = rope ? withRope(level, from, to, hand_.free)
                                           : withPin(level, to, hand_.chosen, hand_.free);
        if (!linked) {
            return say(rope ? "One end of a rope is at a block that is not mounted."
                            : "A pin is at a block that is not mounted.",
                       now);
        }
        return change(std::move(*linked), now);
    }
    case EditorTool::Ground:
        return addCorner(now);
    }
}

/// What is drawn of an outline is dropped.
void EditorScreen::setTool(EditorTool tool) {
    tool_.tool = tool;
    outline_ = {};
}

/// Or takes back the latest corner of an outline.
void EditorScreen::undo(bool again) {
    outline_.grip.reset();
    if (!again && !outline_.corners.empty()) {
        return outline_.corners.pop_back();
    }
    again ? document_.redo() : document_.undo();
    notice_.clear();
    hand_.chosen.clear();
    changed();
}

void EditorScreen::remove(double now) {
    if (!outline_.corners.empty()) {
        return outline_.corners.pop_back();
    }
    if (chosenGround() != nullptr && outline_.grip) {
        const std::size_t corner = outline_.grip->corner;
        outline_.grip.reset();
        return change(withoutCorner(*document_.level(), hand_.chosen[0].index, corner), now);
    }
    change(without(*document_.level(), hand_.chosen), now);
    hand_.chosen.clear();
}

void EditorScreen::nudge(EditStep step, double now) {
    if (const ObstructionDef* ground = chosenGround(); ground != nullptr && outline_.grip) {
        const GroundPoint from = ground->points[outline_.grip->corner];
        return putCorner(*outline_.grip, {from.x + step.x, from.y + step.y}, now);
    }
    change(moved(*document_.level(), hand_.chosen, step), now);
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
        return setTool(EditorTool::Select);
    case EditorAct::Ledge:
        return setTool(EditorTool::Ledge);
    case EditorAct::Rope:
        return setTool(EditorTool::Rope);
    case EditorAct::Pin:
        return setTool(EditorTool::Pin);
    case EditorAct::Ground:
        hand_.chosen.clear();
        return setTool(EditorTool::Ground);
    case EditorAct::Turf:
        return setTurf(static_cast<Turf>(button.value), now);
    case EditorAct::Stuff:
        tool_.stuff = static_cast<Stuff>(button.value);
        return setTool(EditorTool::Block);
    case EditorAct::Hold:
        tool_.hold = static_cast<Support>(button.value);
        return setTool(EditorTool::Block);
    case EditorAct::Shape:
        tool_.form = static_cast<Form>(button.value);
        tool_.larger = {};
        return setTool(EditorTool::Block);
    case EditorAct::Undo:
    case EditorAct::Redo:
        return undo(button.act == EditorAct::Redo);
    case EditorAct::Mirror:
        return change(withMirrorImages(level, chosen), now);
    case EditorAct::Flip:
        tool_.flip = placing != tool_.flip;
        return placing ? void() : change(flipped(level, chosen), now);
    case EditorAct::Turn:
        tool_.turn = placing ? (tool_.turn + kTurnStep) % 360000 : tool_.turn;
        return placing ? void() : change(turned(level, chosen, kTurnStep), now);
    case EditorAct::Remove:
        return remove(now);
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

EditorScreen::Wish EditorScreen::take(const Signals& signals, double now) {
    if (signals.pointer || signals.clicked) {
        hand_.rests = hand_.pointer == signals.pointerNow ? hand_.rests : 0;
        hand_.movedAt = hand_.pointer == signals.pointerNow ? hand_.movedAt : now;
        hand_.pointer = signals.pointerNow;
    }
    const bool stays = signals.clicked || now - hand_.movedAt >= kStaySeconds;
    if (stays && layout::kField.contains(hand_.pointer)) {
        hand_.field = hand_.pointer;
    }
    hand_.free = signals.shiftHeld;
    for (const Command command : signals.commands) {
        if (command == Command::Back && !outline_.corners.empty()) {
            outline_ = {};
            return Wish::None;
        }
        if (command == Command::Back) {
            return leave(now);
        }
    }
    for (const Press press : signals.presses) {
        if (!press.pad && press.code == keyNamed("T")) {
            return Wish::Try;
        }
        if (!press.pad) {
            hand_.made.reset();
            takeKey(press.code, now);
            hand_.repeated = press.code;
            hand_.repeatAt = now + kRepeatAfter;
        }
    }
    repeat(signals.keyHeld, now);
    if (signals.clicked) {
        for (const EditorButton& button : buttons()) {
            if (button.place.contains(hand_.pointer)) {
                act(button, now);
                return button.act == EditorAct::Try     ? Wish::Try
                       : button.act == EditorAct::Leave ? leave(now)
                                                        : Wish::None;
            }
        }
        const bool walls = tool_.tool == EditorTool::Ground || chosenGround() != nullptr;
        if (layout::kField.grown(walls ? 1 : 0).contains(hand_.pointer)) {
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
    const Vec2 from = layout::kField.contains(hand_.pointer) ? hand_.pointer : hand_.field;
    const Vec2 place{std::clamp(from.x, layout::kLeft + 1, layout::kRight - 1),
                     std::clamp(from.y, Real(3), layout::kTop - 1)};
    play->dropBall(place);
    return play;
}

} // namespace apart
