// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr Real kRimMargin = Real(0.4);    // m; it does not aim with the very rim of the dome
constexpr Real kCatchHeight = 7;          // m; parts above are not waited for
constexpr Real kSpareSeconds = Real(0.5); // from a caught part back to the ball
constexpr Real kFarSeconds = 20;          // what flies so flat may do anything until then
constexpr std::uint32_t kAimTicks = 600;  // then it aims at another block, whatever happened

Real meetingHeight(Real offset) {
    return kPaddleY + domeHeight(offset) + kBallRadius;
}

/// x after bouncing between the side walls.
Real mirrored(Real x) {
    const Real edge = kFieldWidth / 2 - kBallRadius;
    while (x < -edge || x > edge) {
        x = x < -edge ? -2 * edge - x : 2 * edge - x;
    }
    return x;
}

/// Sign that the side walls have given to the way along x.
Vec2 mirroredHeading(Vec2 heading, Real from, Real way) {
    const Real edge = kFieldWidth / 2 - kBallRadius;
    Real x = from + way;
    while (x < -edge || x > edge) {
        x = x < -edge ? -2 * edge - x : 2 * edge - x;
        heading.x = -heading.x;
    }
    return heading;
}

std::optional<Arrival> arrivalAt(const Game& game, const Ball& ball, Real height) {
    const kodo::BodyView body = game.world()[ball.body];
    const Vec2 velocity = body.velocity();
    const Vec2 place = body.position();
    if (ball.riding || velocity.y >= 0 || place.y < kPaddleY) {
        return std::nullopt;
    }
    const Real seconds = std::max((height - place.y) / velocity.y, Real(0));
    if (seconds > kFarSeconds) {
        return std::nullopt;
    }
    return Arrival{mirrored(place.x + velocity.x * seconds), seconds};
}

/// Where to send the ball, the same for a while: straight to a breakable block or to its image in a
/// side wall, and now and then somewhere at the top, since what is behind steel wants luck.
std::optional<Vec2> aim(const Game& game) {
    std::vector<kodo::BodyId> wanted;
    for (const Block& block : game.blocks()) {
        if (block.kind.breakable()) {
            wanted.push_back(block.body);
        }
    }
    if (wanted.empty()) {
        return std::nullopt;
    }
    const std::uint64_t moment =
        mixKeys(static_cast<std::uint64_t>(game.blocksLeft()), game.ticks() / kAimTicks);
    Generator chance(mixKeys(game.seed(), moment));
    const kodo::BodyId chosen = wanted[chance.below(static_cast<std::uint32_t>(wanted.size()))];
    const Vec2 goal = game.world()[chosen].position();
    const Real between = kFieldWidth - 2 * kBallRadius;
    switch (chance.below(8)) {
    case 0:
        return Vec2{between - goal.x, goal.y};
    case 1:
        return Vec2{-between - goal.x, goal.y};
    case 2:
        return Vec2{chance.between(-kFieldWidth / 2, kFieldWidth / 2), kFieldHeight};
    default:
        return goal;
    }
}

/// How far from the paddle's middle the ball should meet it, so that it leaves towards `goal`.
Real offsetFor(Vec2 goal, Vec2 meeting, Vec2 heading) {
    const Vec2 normal = normalize(normalize(goal - meeting) - heading);
    const Real most = kPaddleHalfWidth - kRimMargin;
    return std::clamp((kDomeRadius + kBallRadius) * normal.x, -most, most);
}

/// Anywhere on the dome, the same for a while.
Real someOffset(const Game& game) {
    Generator chance(mixKeys(game.seed(), game.ticks() / kAimTicks, 7));
    return chance.between(kRimMargin - kPaddleHalfWidth, kPaddleHalfWidth - kRimMargin);
}

/// Where the paddle's middle should be when the ball comes, to aim.
Real placeFor(const Game& game, const Ball& ball, const Arrival& arrival) {
    const std::optional<Vec2> goal = aim(game);
    if (!goal) {
        return arrival.x;
    }
    const kodo::BodyView body = game.world()[ball.body];
    const Vec2 heading =
        mirroredHeading(ball.heading, body.position().x, body.velocity().x * arrival.seconds);
    const Real offset = offsetFor(*goal, {arrival.x, meetingHeight(0)}, heading);
    const std::optional<Arrival> refined = arrivalAt(game, ball, meetingHeight(offset));
    return (refined ? refined->x : arrival.x) - offset;
}

/// Where to be for a part that can be caught before the ball comes.
std::optional<Real> partToCatch(const Game& game, Real secondsLeft) {
    for (const Part& part : game.parts()) {
        const kodo::BodyView body = game.world()[part.body];
        const Vec2 place = body.center();
        if (part.state != PartState::Loose || place.y > kCatchHeight || place.y < kPaddleY) {
            continue;
        }
        // y + vy t - g t^2 / 2 = paddle
        const Real vy = body.velocity().y;
        const Real drop = place.y - meetingHeight(0);
        const Real root = std::sqrt(std::max(vy * vy + 2 * kGravity * drop, Real(0)));
        const Real seconds = (vy + root) / kGravity;
        if (seconds + kSpareSeconds < secondsLeft) {
            return mirrored(place.x + body.velocity().x * seconds);
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Arrival> arrivalOf(const Game& game, const Ball& ball) {
    return arrivalAt(game, ball, meetingHeight(0));
}

Input bot(const Game& game, BotKind kind) {
    const Ball* next = nullptr;
    Arrival first{0, 2}; // nothing comes within two seconds
    Real place = 0;
    for (const Ball& ball : game.balls()) {
        const std::optional<Arrival> arrival = arrivalOf(game, ball);
        if (arrival && (next == nullptr || arrival->seconds < first.seconds)) {
            next = &ball;
            first = *arrival;
        }
    }
    if (next != nullptr) {
        place = kind == BotKind::Good     ? placeFor(game, *next, first)
                : kind == BotKind::Random ? first.x - someOffset(game)
                                          : first.x;
    } else if (!game.balls().empty() && !game.serving()) {
        place = game.world()[game.balls()[0].body].position().x / 2; // half way, to be near
    }
    if (kind == BotKind::Good) {
        place = partToCatch(game, first.seconds).value_or(place);
    }
    const Real most = kFieldWidth / 2;
    Input input;
    input.target = static_cast<std::int16_t>(std::clamp(place, -most, most) * 1000);
    input.launch = game.serving();
    return input;
}

} // namespace apart
