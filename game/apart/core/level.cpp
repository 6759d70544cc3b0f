// SPDX-License-Identifier: MIT
#include <apart/core/level.hpp>
#include <kodo/base/hash.hpp>

namespace apart {

std::uint64_t digestOf(const Level& level) {
    kodo::StateHash hash;
    hash.add(level.ballSpeed);
    hash.add(level.lives);
    hash.add(static_cast<std::uint64_t>(level.cells.size()));
    for (const Cell& cell : level.cells) {
        const BlockKind& kind = level.kinds[cell.kind];
        hash.add(cell.row);
        hash.add(cell.column);
        hash.add(static_cast<std::uint8_t>(kind.stuff));
        hash.add(static_cast<std::uint8_t>(kind.power));
        hash.add(static_cast<std::uint8_t>(kind.pattern));
        hash.add(kind.strength);
    }
    return hash.value();
}

} // namespace apart
