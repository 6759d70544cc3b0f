// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>

#include <initializer_list>

namespace apart {

/// A level with glass blocks in the given columns of its third row; it has no name.
inline Level levelOfGlass(std::initializer_list<int> columns) {
    Level level;
    BlockKind glass;
    glass.letter = 'g';
    glass.stuff = Stuff::Glass;
    glass.pattern = Pattern::Shatter;
    glass.strength = 3000;
    level.kinds = {glass};
    for (const int column : columns) {
        level.cells.push_back({2, static_cast<std::uint8_t>(column), 0});
    }
    return level;
}

} // namespace apart
