// SPDX-License-Identifier: MIT
// The keys of the editor, also while they are held.
#include <apart/core/editor/size_edit.hpp>
#include <apart/stage/screens/editor_screen.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

bool repeats(int key) {
    constexpr std::array<std::string_view, 10> kNames = {"W", "Q",    "K",    "J",     "Z",
                                                         "Y", "left", "down", "right", "up"};
    return std::any_of(kNames.begin(), kNames.end(),
                       [&](std::string_view name) { return key == keyNamed(name); });
}

} // namespace

void EditorScreen::takeKey(int key, double now) {
    const auto is = [&](const char* name) { return key == keyNamed(name); };
    const EditStep way = is("left")    ? EditStep{-kSnapGrid, 0}
                         : is("right") ? EditStep{kSnapGrid, 0}
                         : is("up")    ? EditStep{0, kSnapGrid}
                         : is("down")  ? EditStep{0, -kSnapGrid}
                                       : EditStep{};
    if (way != EditStep{} && !hand_.chosen.empty()) {
        nudge(way, now);
    }
    if (is("enter") && !outline_.corners.empty()) {
        finishGround(now);
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
        resize(larger, now);
    }
    const std::vector<EditorButton>& all = buttons();
    const auto found = std::find_if(all.begin(), all.end(), [&](const EditorButton& button) {
        return keyOf(button) == key || (button.act == EditorAct::Remove && is("delete"));
    });
    if (found != all.end() && key != kNoKey) {
        act(*found, now);
    }
}

/// `key`: the one that is held.
void EditorScreen::repeat(int key, double now) {
    constexpr double kEvery = 1.0 / 12; // s
    if (key != hand_.repeated) {
        hand_.repeated = kNoKey;
    }
    if (hand_.repeated != kNoKey && repeats(key) && now >= hand_.repeatAt) {
        hand_.repeatAt = std::max(hand_.repeatAt + kEvery, now); // a stall is not made up for
        hand_.repeats = true;
        takeKey(key, now);
        hand_.repeats = false;
    }
}

/// One part alone keeps the contacts of its edges.
void EditorScreen::resize(EditStep larger, double now) {
    const Level& level = *document_.level();
    if (hand_.chosen.size() != 1 || hand_.free) {
        return change(resized(level, hand_.chosen, larger), now);
    }
    Level after = resizedToContact(level, hand_.chosen[0], larger);
    const bool stuck = after == level && resized(level, hand_.chosen, larger) != level;
    change(std::move(after), now);
    if (stuck) {
        say("Both of its sides touch something. With shift it grows all the same.", now);
    }
}

} // namespace apart
