// SPDX-License-Identifier: MIT
#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/editor/level_writer.hpp>
#include <apart/core/level_file.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace apart {

namespace {

constexpr std::size_t kMostSteps = 500; // of the history

/// The order in which the reader finds cells and obstructions.
void sortAsRead(Level& level) {
    std::stable_sort(level.cells.begin(), level.cells.end(), [](const Cell& a, const Cell& b) {
        return std::tie(a.row, a.column) < std::tie(b.row, b.column);
    });
    const auto rank = [](const ObstructionDef& def) {
        const int kind = def.kind == ObstructionKind::Ledge    ? 1
                         : def.kind == ObstructionKind::Ground ? 2
                                                               : 0;
        return std::tuple(kind, kind == 0 ? -def.y : 0, kind == 0 ? def.x : 0);
    };
    std::stable_sort(level.obstructions.begin(), level.obstructions.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

} // namespace

EditDocument::EditDocument(Level level)
    : history_{std::make_shared<const Level>(std::move(level))}, saved_(history_[0]) {}

std::string EditDocument::apply(Level changed, bool joins) {
    sortAsRead(changed);
    Read<Level> read = parseLevel(toToml(changed), changed.name, "");
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return problem->reason;
    }
    if (std::get<Level>(read) != changed) {
        return "two parts are in one cell of the grid";
    }
    if (changed == *level()) {
        return "";
    }
    history_.resize(joins && canUndo() ? now_ : now_ + 1);
    history_.push_back(std::make_shared<const Level>(std::move(changed)));
    if (history_.size() > kMostSteps) {
        history_.erase(history_.begin());
    }
    now_ = history_.size() - 1;
    return "";
}

void EditDocument::undo() {
    now_ -= canUndo() ? 1 : 0;
}

void EditDocument::redo() {
    now_ += canRedo() ? 1 : 0;
}

Level newLevel(const std::string& name) {
    Level level;
    level.name = name;
    level.title = name;
    level.idea = "A level of my own.";
    level = withLedge(std::move(level), {0, kodo::Real(6)}, 8000);
    return withBlock(std::move(level), standingKind(Stuff::Brick),
                     {.x = 0, .y = 6600, .width = 1600, .height = 800});
}

} // namespace apart
