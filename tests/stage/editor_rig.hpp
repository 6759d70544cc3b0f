// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/own_levels.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "stage_rig.hpp"

namespace apart {

namespace fs = std::filesystem;

/// A stage whose editor writes into a folder of its own.
class EditorStage : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        fs::create_directories(folder_);
    }

    void start() {
        StageDef def = StageRig::twoLevels();
        def.edit = [levels = def.levels, this](const Level* level) {
            return editorOf(level, levels, folder_);
        };
        rig_ = std::make_unique<StageRig>(std::move(def));
        rig_->clickItem(Action::Levels);
        key("N");
    }

    void key(const char* name) {
        Signals signals;
        signals.presses = {{false, *keyNamed(name)}};
        rig_->frame(signals);
    }
    void mouse(Vec2 place, bool held, bool clicked) {
        Signals signals;
        signals.pointer = signals.pointerNow = place;
        signals.dragging = held;
        signals.shiftHeld = shift_;
        signals.clicked = clicked;
        rig_->frame(signals);
    }
    void drag(Vec2 from, Vec2 to) {
        mouse(from, true, true);
        mouse((from + to) / 2, true, false);
        mouse(to, true, false);
        mouse(to, false, false);
    }
    void click(Vec2 place) {
        mouse(place, true, true);
        mouse(place, false, false);
    }
    void button(EditorAct act, std::size_t value = 0) {
        for (const EditorButton& button : EditorScreen::buttons()) {
            if (button.act == act && button.value == value) {
                return click(button.place.center());
            }
        }
        FAIL() << "no such button";
    }
    const EditorScreen& editor() { return *rig_->stage.editor(); }
    const Level& level() { return *editor().document().level(); }

    std::unique_ptr<StageRig> rig_;
    bool shift_ = false; // held
};

} // namespace apart
