// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/toml_keys.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// The legend of a level file, beyond Level::kinds. What could not be read is known, so that no
/// other fault follows from it.
struct Legend {
    /// Keys of a kind of block that could not be read.
    struct Doubt {
        bool stuff = false;
        bool support = false; // the key hold
        bool core = false;
    };
    /// Letter of the grid for an obstruction.
    struct Sign {
        char letter = '?';
        ObstructionDef def;
    };

    std::vector<Doubt> doubts; // by index into Level::kinds
    std::vector<Sign> signs;
    std::string unread;   // letters whose entries could not be read
    bool complete = true; // false: the legend as a whole could not be read

    bool isUnread(std::string_view letter) const {
        return !complete || unread.find(letter) != std::string::npos;
    }
};

/// Reads the tables [legend.X] into Level::kinds and the rest of the legend.
Legend readLegend(TomlKeys& keys, const toml::table& root, Level& level);

} // namespace apart
