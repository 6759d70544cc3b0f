// SPDX-License-Identifier: MIT
#include <apart/core/game.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <utility>

namespace apart {

namespace {

void landAll(GameState& game) {
    for (Block& block : game.blocks) {
        land(game, block);
    }
}

void conclude(GameState& game) {
    if (game.result != Result::Playing) {
        return;
    }
    if (game.counts.blocksLeft == 0) {
        if (game.tick - game.buildings.collapse.lastTick <= kLastFallTicks && game.falls()) {
            return; // no ball is needed any more
        }
        landAll(game);
        endCollapse(game);
        game.result = Result::Won;
        const bool earned = game.counts.bestBlow > 0; // what falls by itself pays nothing
        const Cleared won{.lives = earned ? game.counts.lives * kLifePoints : 0,
                          .prize = game.counts.prize(),
                          .spared = earned && game.keeps() ? kSparedPoints : 0};
        game.counts.score += won.lives + won.prize + won.spared;
        game.events.emplace_back(won);
    } else if (game.balls.empty() && !game.counts.isDown()) {
        --game.counts.lives;
        game.counts.combo = 0; // a combo ends with the last ball
        game.events.emplace_back(LifeLost{game.counts.lives});
        if (game.counts.lives == 0) {
            landAll(game);
            game.result = Result::Lost;
            game.events.emplace_back(Lost{game.counts.score});
            return;
        }
        letGoOfParts(game);
        while (!game.powers.effects.empty()) {
            endPower(game, game.powers.effects.size() - 1);
        }
        refreshPowers(game);
        newPaddle(game);
        newServe(game);
    }
}

} // namespace

Game::Game(const Level& level, std::uint32_t seed, Mode mode)
    : Game(std::make_shared<const Level>(level), seed, mode) {}

Game::Game(std::shared_ptr<const Level> level, std::uint32_t seed, Mode mode) {
    state_.counts.lives = level->lives;
    state_.origin.level = std::move(level);
    state_.origin.seed = seed;
    state_.origin.mode = mode;
    buildScene(state_);
    newPaddle(state_);
    newServe(state_);
}

void Game::tick(const Input& input) {
    state_.events.clear();
    ++state_.tick;
    if (input.aim) {
        aimServe(state_, *input.aim);
    }
    if (input.launch && result() == Result::Playing) {
        serving() ? serve(state_) : leap(state_);
    }
    endOldPowers(state_);
    useForce(state_, input);
    applyForces(state_);
    steer(state_, input);
    driveBoss(state_);
    fireParts(state_);
    state_.world.step(kTickSeconds);
    judge(state_);
    govern(state_);
    watchBuildings(state_);
    watchWaters(state_);
    watchProgress(state_);
    removeGone(state_);
    state_.counts.watchBlow();
    conclude(state_);
}

} // namespace apart
