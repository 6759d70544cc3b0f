// SPDX-License-Identifier: MIT
#include <apart/sfml/inspector.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <cstdio>

namespace apart {

void Inspector::measure(double frameSeconds, double gameSeconds) {
    constexpr double kShare = 0.05; // of a new value
    frame_ += kShare * (frameSeconds - frame_);
    game_ += kShare * (gameSeconds - game_);
}

void Inspector::draw(SfmlCanvas& canvas, const Game& game) const {
    if (!on_) {
        return;
    }
    const std::size_t vertices = canvas.picture().vertexCount();
    kodo_sfml::paintWorld(canvas.painter(), canvas.camera(), game.world(),
                          {true, true, true, true, 0.05f});
    char line[160];
    std::snprintf(line, sizeof line,
                  "%.0f frames/s   game %.2f ms a frame   %zu bodies   %zu contacts   %zu vertices",
                  1 / frame_, 1000 * game_, game.world().bodyCount(),
                  game.world().collisions().size(), vertices);
    const Vec2 corner = canvas.visible().lower + Vec2{Real(0.3), Real(0.3)};
    canvas.text(line, corner, {Real(0.42), {140, 255, 160, 255}, Typeface::Plain, Align::Left});
}

} // namespace apart
