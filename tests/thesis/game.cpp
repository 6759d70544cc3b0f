// SPDX-License-Identifier: MIT
// aPart (appendix A): parts that are caught, blocks that become balls, a ball that never halts.
#include <game/game_access.hpp>

#include <algorithm>
#include <cmath>

#include "experiment.hpp"

namespace thesis {

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;

std::string drawn(const Game& game) {
    return kodo::svg(game.world(), {}, kodo::Aabb{{-9, -1}, {9, kFieldHeight + 1}});
}

void weld(Experiment& one) {
    Game game = dropped("W");
    const auto part = static_cast<double>(game.world()[game.parts().front().body].mass());
    const auto before = static_cast<double>(game.world()[game.paddle()].mass());
    const auto inertia = static_cast<double>(game.world()[game.paddle()].inertia());
    one.pictures.push_back({"A part falls", drawn(game)});
    const bool caught = playUntil<Welded>(game, towards(kCatchX), 240).has_value();
    const kodo::BodyView paddle = game.world()[game.paddle()];
    one.add("a part that is caught is welded to the paddle", "rules of aPart", caught ? 1 : 0)
        .near(1, 0, "1: yes");
    one.add("shapes of the paddle after the weld", "Kodo", static_cast<double>(paddle.partCount()))
        .near(2, 0, "its dome and the part: one compound");
    one.add("mass of the paddle after the weld", "Kodo", static_cast<double>(paddle.mass()), "kg")
        .near(before + part, 1e-4 * (before + part), "the sum of both");
    one.add("moment of inertia over that before", "Kodo",
            static_cast<double>(paddle.inertia()) / inertia)
        .atLeast(1, "a part away from the centre adds to it");
    one.pictures.push_back({"The part is welded to the paddle", drawn(game)});
}

void launch(Experiment& one) {
    Game game = dropped("L");
    const int before = game.blocksLeft();
    const bool stuck = playUntil<Stuck>(game, towards(kCatchX), 240).has_value();
    const std::uint32_t start = game.ticks();
    const bool fired = playUntil<Launched>(game, towards(kCatchX), 240).has_value();
    one.add("time from the catch to the shot", "rules of aPart",
            stuck && fired ? static_cast<double>(game.ticks() - start) / 120 : 0, "s")
        .near(1, 1e-9, "it sticks for a second, 120 ticks");
    const Vec2 speed = game.world()[game.parts().front().body].velocity();
    one.add("direction of the shot, sideways over upwards", "Kodo",
            std::fabs(static_cast<double>(speed.x / speed.y)))
        .atMost(1e-3, "straight up");
    const bool spent = playUntil<Spent>(game, towards(kCatchX), 300).has_value();
    one.add("blocks above that it destroys", "Kodo", spent ? before - game.blocksLeft() : 0)
        .atLeast(2, "one of glass and one of brick lie above");
    one.pictures.push_back({"After the shot: a gap above the paddle", drawn(game)});
}

void split(Experiment& one) {
    Game game = dropped("S");
    one.add("balls after a block split", "rules of aPart", static_cast<double>(game.balls().size()))
        .atLeast(3, "the ball of the serve and two parts, at least");
    Input serve = towards(kCatchX);
    serve.launch = true;
    game.tick(serve);
    double slowest = 1e9;
    const int ticks = 40;
    for (int tick = 0; tick < ticks; ++tick) {
        game.tick(towards(kCatchX));
    }
    for (const Ball& ball : game.balls()) {
        slowest = std::min(slowest, static_cast<double>(length(game.world()[ball.body].velocity()) /
                                                        game.state().ballSpeed()));
    }
    one.add("speed of the slowest ball over that of the level", "rules of aPart", slowest)
        .atLeast(0.95, "a servo holds the speed; no gravity bends the path");
    one.pictures.push_back({"The block has become balls", drawn(game)});
}

void fracture(Experiment& one) {
    Game game(levelOf("ggg.wwww.bbb.ss\n" + emptyRows(3)), 1);
    const std::size_t whole = game.blocks().size();
    for (int i = 0; i < 6; ++i) {
        GameTestAccess::breakBlock(game, game.blocks().size() - 1, {0, 24});
    }
    one.add("blocks that break into pieces", "rules of aPart",
            static_cast<double>(whole - game.blocks().size()))
        .near(6, 0, "each of the six that are struck");
    one.add("pieces of six blocks", "rules of aPart", static_cast<double>(game.shards().size()))
        .atLeast(7, "more pieces than blocks");
    one.pictures.push_back({"Six blocks break in the patterns of their stuff", drawn(game)});
    for (int tick = 0; tick < 1200; ++tick) {
        game.tick({});
    }
    one.add("pieces left after 10 s", "rules of aPart", static_cast<double>(game.shards().size()))
        .atMost(0, "they fall off the screen");
}

} // namespace

void addGame(std::vector<Experiment>& book) {
    Experiment one{"apart"};
    weld(one);
    launch(one);
    split(one);
    fracture(one);
    book.push_back(one);
}

} // namespace thesis
