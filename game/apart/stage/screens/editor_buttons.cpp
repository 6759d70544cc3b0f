// SPDX-License-Identifier: MIT
// The buttons beside the field of the editor.
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/screens/editor_screen.hpp>

#include <utility>

namespace apart {

namespace {

constexpr Real kWidth = layout::kPanelRight - layout::kPanelLeft; // m, of the buttons

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
    top = addRow(all, {{Act::Ground, {}, "ground  G"}}, top, kHigh);
    std::vector<EditorButton> row;
    for (std::size_t i = 0; i < kTurfNames.size(); ++i) {
        row.push_back({Act::Turf, {}, std::string(kTurfNames[i]), i});
    }
    top = addRow(all, std::move(row), top, kHigh);
    top -= Real(0.3);
    row = {};
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

} // namespace

int keyOf(const EditorButton& button) {
    if (button.act == EditorAct::Stuff) {
        return keyNamed(button.label).value_or(kNoKey);
    }
    const std::size_t space = button.label.rfind(' ');
    const bool letter = space != std::string::npos && space + 2 == button.label.size();
    return letter ? keyNamed(button.label.substr(space + 1)).value_or(kNoKey) : kNoKey;
}

const std::vector<EditorButton>& EditorScreen::buttons() {
    static const std::vector<EditorButton> all = makeButtons();
    return all;
}

} // namespace apart
