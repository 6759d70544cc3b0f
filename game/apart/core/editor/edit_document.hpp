// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace apart {

/// A level that is being edited, with its history. It is always one that the game can read.
class EditDocument {
public:
    explicit EditDocument(Level level);

    const std::shared_ptr<const Level>& level() const { return history_[now_]; }
    /// Takes a changed level. Returns "", or why it is no level: the first error that the reader
    /// of level files finds. It is then left out. `joins`: undo takes it back with the last step.
    std::string apply(Level changed, bool joins = false);
    bool canUndo() const { return now_ > 0; }
    bool canRedo() const { return now_ + 1 < history_.size(); }
    void undo();
    void redo();
    const std::shared_ptr<const Level>& saved() const { return saved_; } // as it was last
    bool isSaved() const { return level() == saved_; }
    void markSaved() { saved_ = level(); }

private:
    std::vector<std::shared_ptr<const Level>> history_; // by time, at least one
    std::size_t now_ = 0;
    std::shared_ptr<const Level> saved_;
};

/// A level to begin with: a ledge with a block on it.
Level newLevel(const std::string& name);

} // namespace apart
