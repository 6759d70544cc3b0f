// SPDX-License-Identifier: MIT
#include <apart/stage/play/play.hpp>

namespace apart {

void Play::tick(const Input& input, Speaker& speaker) {
    poses_.remember(game_.world());
    soundCues_.weigh(game_);
    game_.tick(input);
    juice_.tick(game_);
    soundCues_.play(game_.events(), game_.ticks(), share(juice_.settings().sound), speaker);
}

void Play::draw(Canvas& canvas, Real share, const Aabb& shown, bool words) const {
    paintField(canvas, {game_, juice_, poses_, share, shown, words});
}

} // namespace apart
