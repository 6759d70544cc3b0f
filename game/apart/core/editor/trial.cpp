// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/editor/trial.hpp>
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <utility>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr std::uint32_t kSettled = kTouchTicks + 1; // the game knows by then what carries what
constexpr std::uint32_t kFallTicks = 6 * kTicksPerSecond;

/// Whether something came down by itself in the last tick: a mount gave way after a long wait, or
/// the rest of a building that is down.
bool comesDownByItself(const Game& game) {
    const auto waited = [](const Event& event) {
        const auto* let = std::get_if<LetGo>(&event);
        return let != nullptr && (let->why == LetGo::Why::Fatigue || let->why == LetGo::Why::Torn);
    };
    return game.counts().isDown() ||
           std::any_of(game.events().begin(), game.events().end(), waited);
}

/// The nearest place above in which a ball touches neither block nor obstruction, below the top;
/// the same place if there is none.
Vec2 freeAbove(const kodo::World& world, Vec2 place) {
    const auto solid =
        static_cast<std::uint16_t>(flagsOf(Role::Block) | flagsOf(Role::Obstruction));
    for (Vec2 free = place; free.y < kFieldHeight - kBallRadius; free.y += kBallRadius) {
        if (overlap(world, kodo::Circle{kBallRadius}, {free, {}}, {kodo::kMatchAny, solid})
                .empty()) {
            return free;
        }
    }
    return place;
}

} // namespace

void Trial::dropBall(Game& game, Vec2 place) {
    constexpr Real kReach = kFieldWidth / 2 - kPaddleHalfWidth - 2 * kBallRadius;
    GameState& state = game.state_;
    place = freeAbove(state.world, place);
    kodo::BodyRef paddle = state.world[state.paddle.body];
    paddle.setPosition({std::clamp(place.x, -kReach, kReach), paddle.position().y});
    for (Ball& ball : state.balls) {
        ball.riding = false;
        ball.hollow = false;
        ball.heading = {0, -1};
        kodo::BodyRef body = state.world[ball.body];
        body.setType(kodo::BodyType::Dynamic);
        body.setPosition(place);
        body.setVelocity(state.ballSpeed() * ball.heading);
    }
    state.counts.hit(state.tick);
}

void Trial::strike(Game& game, std::uint32_t key, Vec2 point) {
    GameState& state = game.state_;
    const auto found = std::find_if(state.blocks.begin(), state.blocks.end(),
                                    [&](const Block& block) { return block.key == key; });
    if (found == state.blocks.end() || state.balls.empty()) {
        return;
    }
    const Real mass = std::as_const(state.world)[state.balls.front().body].mass();
    const Vec2 impulse{0, 2 * mass * state.ballSpeed()};
    if (found->kind.breakable()) {
        breakBlock(state, static_cast<std::size_t>(found - state.blocks.begin()), point, impulse);
    } else {
        state.world[found->body].applyImpulse(impulse, point);
    }
}

FallForecast::FallForecast(std::shared_ptr<const Level> level, std::size_t block, Vec2 point)
    : game_(std::move(level), 1), block_(block), point_(point) {
    for (const FreeBlock& free : game_.level().freeBlocks) {
        poses_.push_back(placedShapeOf(free).frame);
    }
}

bool FallForecast::done() const {
    return game_.ticks() >= kSettled + kFallTicks;
}

void FallForecast::advance(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks && !done(); ++i) {
        if (game_.ticks() == kSettled) {
            Trial::strike(game_, keyOfFree(block_), point_);
        }
        game_.tick({});
        look();
    }
}

void FallForecast::look() {
    std::vector<bool> stands(poses_.size());
    for (const Block& block : game_.blocks()) {
        const std::uint32_t first = keyOfFree(0);
        if (block.key >= first) {
            const std::size_t index = block.key - first;
            poses_[index] = game_.world()[block.body].transform();
            stands[index] = block.support != Support::Fallen;
        }
    }
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        const auto found = std::find_if(fallen_.begin(), fallen_.end(),
                                        [&](const Fallen& fallen) { return fallen.block == i; });
        if (found != fallen_.end()) {
            found->pose = poses_[i];
        } else if (!stands[i]) {
            fallen_.push_back({i, poses_[i]});
        }
    }
}

ServeMap::ServeMap(std::shared_ptr<const Level> level)
    : start_(std::move(level), 1), game_(start_) {
    for (const Block& block : start_.blocks()) {
        keys_.push_back(block.key);
    }
    cleared_.resize(keys_.size());
    begin();
}

void ServeMap::begin() {
    constexpr std::uint32_t kStride = 83; // no factor of kServes: early serves go everywhere
    const std::uint32_t place = served_ * kStride % kServes;
    const int aim = kMostAim * (2 * static_cast<int>(place) + 1 - static_cast<int>(kServes)) /
                    static_cast<int>(kServes);
    gone_.assign(keys_.size(), false);
    game_ = start_;
    game_.tick({.launch = true, .aim = static_cast<std::int16_t>(aim)});
}

void ServeMap::advance(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks && !done(); ++i) {
        game_.tick(bot(game_));
        const bool byItself = comesDownByItself(game_);
        if (!byItself) {
            look();
        }
        const bool over = byItself || game_.result() != Result::Playing || game_.serving() ||
                          game_.ticks() >= kSeconds * kTicksPerSecond;
        if (over) {
            finish();
        }
    }
}

void ServeMap::look() {
    gone_.assign(keys_.size(), true);
    for (const Block& block : game_.blocks()) {
        const auto found = std::lower_bound(keys_.begin(), keys_.end(), block.key);
        gone_[static_cast<std::size_t>(found - keys_.begin())] = block.support == Support::Fallen;
    }
}

void ServeMap::finish() {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        cleared_[i] += gone_[i] ? 1 : 0;
    }
    ++served_;
    if (!done()) {
        begin();
    }
}

double ServeMap::clearedBy(std::size_t block) const {
    return served_ == 0 ? 0 : static_cast<double>(cleared_[block]) / served_;
}

} // namespace apart
