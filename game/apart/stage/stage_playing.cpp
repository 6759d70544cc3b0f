// SPDX-License-Identifier: MIT
// Effects of input while a game or a replay is on the screen.
#include <apart/stage/stage.hpp>

namespace apart {

void Stage::takePlaying(const Signals& signals) {
    const Game& game = session().game();
    const Real paddleX = game.world()[game.paddle()].position().x;
    inputMapper_.take(signals, paddleX,
                      static_cast<Real>(records_.profile().settings.mouse / 100.0));
    const bool over = game.result() != Result::Playing;
    const bool clickLaunches = game.serving() || game.state().secondsLeft(Power::Spring) > 0;
    const auto serve = game.serving() ? std::optional(game.serveHeading()) : std::nullopt;
    if (signals.clicked && clickLaunches) {
        inputMapper_.launch(signals, serve);
    }
    if (signals.clicked && over) {
        return finish();
    }
    for (const Command command : signals.commands) {
        switch (command) {
        case Command::Launch:
        case Command::Confirm:
            if (over) {
                return finish();
            }
            inputMapper_.launch(signals, serve);
            break;
        case Command::Back:
        case Command::Pause:
            return over ? finish()
                        : open(Screen::Paused, pauseMenu(watched_.list.leadsFrom(session())));
        case Command::Restart:
            if (mayEnd(Ending::Restart)) {
                if (over) {
                    finish();
                }
                games_.again();
                return toGame();
            }
            break;
        default:
            break;
        }
    }
    if (signals.focusLost && !over) {
        open(Screen::Paused, pauseMenu(watched_.list.leadsFrom(session())));
    }
}

void Stage::takeShow(const Signals& signals) {
    const auto seek = [&](std::int64_t tick) {
        games_.session().seek(tick, games_.theatre().show().pilot, records_.profile().settings);
    };
    if (const std::optional<std::int64_t> tick = games_.theatre().drag(signals)) {
        seek(*tick);
    }
    for (const Command command : signals.commands) {
        if (command == Command::Back) {
            return watched_.list.leadsFrom(session()) ? act({Action::Replays})
                                                      : open(Screen::Paused, pauseMenu(false));
        }
        const Theatre::Request request = games_.theatre().take(command, session().game().ticks());
        if (request.tick) {
            seek(*request.tick);
        }
        if (request.takeOver && session().game().result() == Result::Playing) {
            games_.session().takeOver();
            return open(Screen::Paused, pauseMenu(watched_.list.leadsFrom(session())));
        }
    }
}

} // namespace apart
