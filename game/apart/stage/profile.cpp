// SPDX-License-Identifier: MIT
#include <apart/stage/profile.hpp>

#include <algorithm>

namespace apart {

bool Profile::enter(Mode in, const std::string& level, Best game) {
    Best& known = best[static_cast<std::size_t>(in)][level];
    const bool beaten = known.score > 0 && game.score > known.score;
    known.score = std::max(known.score, game.score);
    known.cleared = known.cleared || game.cleared;
    known.unhurt = known.unhurt || game.unhurt;
    known.chain = known.chain || game.chain;
    return beaten;
}

} // namespace apart
