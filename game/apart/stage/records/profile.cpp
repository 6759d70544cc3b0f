// SPDX-License-Identifier: MIT
#include <apart/stage/records/profile.hpp>

#include <algorithm>

namespace apart {

bool Profile::enter(Mode in, const std::string& level, Best game) {
    Best& known = best[static_cast<std::size_t>(in)][level];
    const bool beaten = known.score > 0 && game.score > known.score;
    known.score = std::max(known.score, game.score);
    known.cleared = known.cleared || game.cleared;
    known.unhurt = known.unhurt || game.unhurt;
    known.chain = known.chain || game.chain;
    known.fewHits = known.fewHits || game.fewHits;
    known.oneFall = known.oneFall || game.oneFall;
    known.kept = known.kept || game.kept;
    known.ways |= game.ways;
    known.unproved = std::max(known.unproved, game.unproved);
    return beaten;
}

void Profile::adopt(Mode in, const std::string& level, Best other) {
    if (other.score <= bestOf(in, level).unproved) {
        other.score = 0;
    }
    enter(in, level, other);
}

void Profile::correct(Mode in, const std::string& level, std::int32_t score) {
    Best& known = best[static_cast<std::size_t>(in)][level];
    if (known.score > score) {
        known.unproved = std::max(known.unproved, known.score);
    }
    known.score = score;
}

} // namespace apart
