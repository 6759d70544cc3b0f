// SPDX-License-Identifier: MIT
// The stage while a level is edited, or tried from the editor.
#include <apart/stage/stage.hpp>

#include <algorithm>

namespace apart {

void Stage::edit(EditorStart start) {
    if (screen_ == Screen::Title) {
        games_.demo(games_.level(), false); // behind the editor, if it is the first screen
    }
    editor_ = std::make_unique<EditorScreen>(std::move(start), records_.profile().audible());
    screen_ = Screen::Editor;
}

/// Input of the editor; or what ends a try, or begins it again. False: the tried game takes it.
bool Stage::takeEditor(const Signals& signals) {
    using Wish = EditorScreen::Wish;
    const Command command = signals.commands.empty() ? Command::Mute : signals.commands.front();
    const bool edits = screen_ == Screen::Editor;
    const Wish wish = edits                         ? editor_->take(signals, seconds_)
                      : command == Command::Restart ? Wish::Try
                                                    : Wish::None;
    if (wish == Wish::Try) {
        games_.beginTry(editor_->trialPlay());
        toGame();
        return true;
    }
    if (!edits) {
        const bool ends =
            command == Command::Back || command == Command::Pause || signals.focusLost;
        screen_ = ends ? Screen::Editor : screen_;
        return ends;
    }
    if (wish == Wish::None) {
        return true;
    }
    std::size_t shown = games_.level();
    if (editor_->wasSaved() && editor_->start().listed) { // it stands among the levels from now on
        const std::shared_ptr<const Level>& saved = editor_->document().saved();
        const auto found =
            std::find_if(def_.levels.begin(), def_.levels.end(),
                         [&](const auto& level) { return level->name == saved->name; });
        shown = static_cast<std::size_t>(found - def_.levels.begin());
        if (found == def_.levels.end()) {
            def_.levels.push_back(saved);
        } else {
            *found = saved;
        }
        records_.setLevel(saved);
        map_.setLevels(def_.levels);
    }
    editor_.reset();
    games_.choose(shown);
    toLevels();
    return true;
}

} // namespace apart
