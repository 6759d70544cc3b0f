// SPDX-License-Identifier: MIT
#include <apart/sfml/inspector.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <kodo_sfml/world_painter.hpp>

#include <fmt/format.h>

#include <array>
#include <string>

namespace apart {

void Inspector::measure(double frameSeconds, double gameSeconds) {
    constexpr double kShare = 0.05; // weight of a new value
    frame_ += kShare * (frameSeconds - frame_);
    game_ += kShare * (gameSeconds - game_);
}

void Inspector::draw(SfmlCanvas& canvas, const ShownGame& shown) const {
    if (!on_) {
        return;
    }
    const std::size_t vertices = canvas.picture().vertexCount();
    const Game& game = shown.game;
    canvas.zoom(shown.closeup.focus, shown.closeup.scale);
    kodo_sfml::WorldPainter picture(canvas.painter(), canvas.drawingCamera());
    kodo::draw(game.world(), picture,
               {.contacts = true, .impulses = true, .bounds = true, .metresPerImpulse = 0.05f});
    canvas.zoom({}, 1);
    const Ledger& ledger = game.ledger();
    const std::array<std::string, 4> lines = {
        fmt::format("{:.0f} frames/s   game {:.2f} ms a frame   {} vertices", 1 / frame_,
                    1000 * game_, vertices),
        fmt::format("{} bodies   {} contacts", game.world().bodyCount(),
                    game.world().collisions().size()),
        fmt::format("work, J:   servo {:.0f}   field {:.0f}   breaks {:.0f}   kicks {:.0f}",
                    ledger.servoWork, ledger.fieldWork, ledger.breakWork, ledger.kickWork),
        fmt::format("impulse, N s:   field {:.0f}, {:.0f}   mounts {:.0f}, {:.0f}",
                    ledger.fieldImpulseX, ledger.fieldImpulseY, ledger.mountImpulseX,
                    ledger.mountImpulseY)};
    // Inside the field, because the panel beside it shows the score.
    Vec2 corner{layout::kLeft + Real(0.3), layout::kTop - Real(0.6)};
    for (const std::string& line : lines) {
        canvas.text(line, corner, {Real(0.42), {140, 255, 160, 255}});
        corner.y -= Real(0.55);
    }
}

} // namespace apart
