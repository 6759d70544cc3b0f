// SPDX-License-Identifier: MIT
#include <apart/core/absent_bot.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/flight.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr Real kRimMargin = Real(0.4);    // m; unused border of the dome
constexpr Real kCatchHeight = 7;          // m; higher parts are ignored
constexpr Real kSpareSeconds = Real(0.5); // to return from a caught part to the ball
constexpr Real kFarSeconds = 20;          // later arrivals are not predicted
constexpr std::uint32_t kAimTicks = 600;  // then it picks another target
constexpr int kBentSteps = 90;            // of the prediction of bent paths
constexpr Real kPullHeight = 8;           // m; lower balls are not pulled
constexpr Real kPullSpare = 1;            // s; if a ball arrives earlier, no block is torn
constexpr std::uint32_t kWhimTicks = 30;  // duration of a random choice of Erratic
constexpr int kAttempts = 3;              // to find a block in sight
constexpr Real kTriedSeconds = 3;         // without damage; then luck may help
constexpr int kShots = 8;                 // tested on each side of the paddle's middle
constexpr Real kLeapSeconds = Real(0.05); // before the ball arrives
constexpr Real kNudgeSeconds = Real(0.2); // likewise; until then it is away from the serve
constexpr Real kNudge = Real(0.7);        // m

Real meetingHeight(Real offset) {
    return kPaddleY + domeHeight(offset) + kBallRadius;
}

/// x (m) of a ball after reflections between the side walls.
Real mirrored(Real x) {
    const Real edge = kFieldWidth / 2 - kBallRadius;
    while (x < -edge || x > edge) {
        x = x < -edge ? -2 * edge - x : 2 * edge - x;
    }
    return x;
}

/// Heading after the reflections off the side walls on a way (m) along x.
Vec2 mirroredHeading(Vec2 heading, Real from, Real way) {
    const Real edge = kFieldWidth / 2 - kBallRadius;
    Real x = from + way;
    while (x < -edge || x > edge) {
        x = x < -edge ? -2 * edge - x : 2 * edge - x;
        heading.x = -heading.x;
    }
    return heading;
}

/// Simulates the ball alone between the walls, with the same force fields.
std::optional<Arrival> bentArrivalAt(const Game& game, const Ball& ball, Real height) {
    const kodo::BodyView now = game.world()[ball.body];
    LoneFlight flight(game, now.position(), ball.heading, now.velocity());
    for (int step = 1; step <= kBentSteps; ++step) {
        flight.step();
        if (flight.place().y <= height) {
            return Arrival{flight.place().x, static_cast<Real>(step) * LoneFlight::kStep};
        }
    }
    return std::nullopt;
}

std::optional<Arrival> arrivalAt(const Game& game, const Ball& ball, Real height) {
    const kodo::BodyView body = game.world()[ball.body];
    const Vec2 velocity = body.velocity();
    const Vec2 place = body.position();
    if (ball.riding || velocity.y >= 0 || place.y < kPaddleY) {
        return std::nullopt;
    }
    if (isBent(game)) {
        return bentArrivalAt(game, ball, height);
    }
    const Real seconds = std::max((height - place.y) / velocity.y, Real(0));
    if (seconds > kFarSeconds) {
        return std::nullopt;
    }
    return Arrival{mirrored(place.x + velocity.x * seconds), seconds};
}

bool isInSight(const Game& game, Vec2 from, kodo::BodyId body) {
    const Vec2 way = game.world()[body].position() - from;
    const std::optional<kodo::QueryHit> hit = game.state().ahead(from, way);
    return hit && hit->body == body;
}

/// Target point, constant for kAimTicks: a breakable block or its mirror image in a side wall. One
/// time in eight it is a random point at the top, because blocks behind steel have no direct path.
std::optional<Vec2> aim(const Game& game, Vec2 meeting) {
    std::vector<kodo::BodyId> wanted;
    for (const Block& block : game.blocks()) {
        if (block.counts()) {
            wanted.push_back(block.body);
        }
    }
    if (wanted.empty()) {
        return std::nullopt;
    }
    const std::uint64_t moment =
        mixKeys(static_cast<std::uint64_t>(game.blocksLeft()), game.ticks() / kAimTicks);
    Generator chance(mixKeys(game.seed(), moment));
    const bool hidden = wanted.size() < game.blocks().size(); // steel may be in the way
    kodo::BodyId chosen;
    for (int attempt = 0; attempt < (hidden ? kAttempts : 1); ++attempt) {
        chosen = wanted[chance.below(static_cast<std::uint32_t>(wanted.size()))];
        if (!hidden || isInSight(game, meeting, chosen)) {
            break;
        }
    }
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

/// Offset (m) from the paddle's middle at which the ball leaves towards `goal`.
Real offsetFor(Vec2 goal, Vec2 meeting, Vec2 heading) {
    const Vec2 normal = normalize(normalize(goal - meeting) - heading);
    const Real most = kPaddleHalfWidth - kRimMargin;
    return std::clamp((kDomeRadius + kBallRadius) * normal.x, -most, most);
}

/// Offset (m) from the paddle's middle with the shortest path to a breakable block.
std::optional<Real> surestOffset(const Game& game, Real x, Vec2 heading) {
    const Real most = kPaddleHalfWidth - kRimMargin;
    std::optional<Real> best;
    Real shortest = 0;
    for (int shot = -kShots; shot <= kShots; ++shot) {
        const Real offset = most * static_cast<Real>(shot) / kShots;
        const Real lean = offset / (kDomeRadius + kBallRadius);
        const Vec2 normal{lean, std::sqrt(1 - lean * lean)};
        const Vec2 leaving = heading - 2 * dot(heading, normal) * normal;
        const std::optional<Real> way =
            game.state().wayToBlock({x, meetingHeight(offset)}, leaving);
        if (way && (!best || *way < shortest)) {
            best = offset;
            shortest = *way;
        }
    }
    return best;
}

/// Direction of the serve (Input::aim) with the shortest path to a breakable block.
std::optional<std::int16_t> surestServe(const Game& game) {
    const auto balls = game.balls();
    const auto riding =
        std::find_if(balls.begin(), balls.end(), [](const Ball& ball) { return ball.riding; });
    std::optional<std::int16_t> best;
    Real shortest = 0;
    for (int shot = -kShots; shot <= kShots && riding != balls.end(); ++shot) {
        const auto aim = static_cast<std::int16_t>(kMostAim * shot / (2 * kShots));
        const Vec2 heading = normalize(Vec2{static_cast<Real>(aim) / 1000, 1});
        const std::optional<Real> way =
            game.state().wayToBlock(game.world()[riding->body].position(), heading);
        if (way && (!best || *way < shortest)) {
            best = aim;
            shortest = *way;
        }
    }
    return best;
}

/// Random offset within -most..most (m), constant for kAimTicks.
Real someOffset(const Game& game, Real most) {
    Generator chance(mixKeys(game.seed(), game.ticks() / kAimTicks, 7));
    return chance.between(-most, most);
}

/// True in a quarter of the intervals of kAimTicks: then surestOffset() is not used, because moving
/// bodies or bent paths may give a hit that it does not predict.
bool wantsLuck(const Game& game) {
    Generator chance(mixKeys(game.seed(), game.ticks() / kAimTicks, 11));
    return chance.below(4) == 0;
}

/// x (m) of the paddle's middle that sends the ball to the target.
Real placeFor(const Game& game, const Ball& ball, const Arrival& arrival, BotKind kind) {
    const std::optional<Vec2> goal = aim(game, {arrival.x, meetingHeight(0)});
    if (!goal) {
        return arrival.x;
    }
    const kodo::BodyView body = game.world()[ball.body];
    const Vec2 heading =
        mirroredHeading(ball.heading, body.position().x, body.velocity().x * arrival.seconds);
    Real offset = offsetFor(*goal, {arrival.x, meetingHeight(0)}, heading);
    const bool tried = game.state().idleSeconds() > kTriedSeconds;
    if (!wantsLuck(game) || (kind == BotKind::Perfect && !tried)) {
        offset = surestOffset(game, arrival.x, heading).value_or(offset);
    }
    const std::optional<Arrival> refined = arrivalAt(game, ball, meetingHeight(offset));
    return (refined ? refined->x : arrival.x) - offset;
}

/// True if a part is worth catching: good powers, and Weld because it widens the paddle.
bool isWanted(Power power) {
    return moodOf(power) == Mood::Good || power == Power::Weld;
}

/// x (m) at which a part can be caught before the ball arrives.
std::optional<Real> partToCatch(const Game& game, Real secondsLeft) {
    for (const Part& part : game.parts()) {
        const kodo::BodyView body = game.world()[part.body];
        const Vec2 place = body.center();
        if (part.state != PartState::Loose || !isWanted(part.power) || place.y > kCatchHeight ||
            place.y < kPaddleY) {
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

/// The ball that arrives first, if one does within 2 s.
struct Meeting {
    const Ball* ball = nullptr; // nullptr: none
    Arrival arrival{0, 2};
};

Meeting firstMeeting(const Game& game, Real height) {
    Meeting first;
    for (const Ball& ball : game.balls()) {
        const std::optional<Arrival> arrival = arrivalAt(game, ball, height);
        if (arrival && (first.ball == nullptr || arrival->seconds < first.arrival.seconds)) {
            first = {&ball, *arrival};
        }
    }
    return first;
}

/// Force of Good when nothing was damaged for a while. It tears a block off while no ball arrives,
/// or pulls a high ball whose path does not hit a block.
Force forceFor(const Game& game) {
    if (game.state().patience() == Patience::Calm) {
        return Force::None;
    }
    const auto balls = game.balls();
    const bool safe = std::all_of(balls.begin(), balls.end(), [&](const Ball& ball) {
        const std::optional<Arrival> arrival = arrivalOf(game, ball);
        return !arrival || arrival->seconds > kPullSpare;
    });
    if (safe && game.state().nextToFall() != nullptr) {
        return Force::Pull;
    }
    for (const Ball& ball : game.balls()) {
        const Vec2 place = game.world()[ball.body].position();
        const bool high = place.y > kPullHeight;
        if (!ball.riding && high && !game.state().meetsBlock(place, kFarSight * ball.heading)) {
            return Force::Pull;
        }
    }
    return Force::None;
}

/// Skill of a bot that does not aim.
struct Hand {
    Real sight;  // m; higher balls are ignored
    Real error;  // m; largest distance from the ball to the paddle's middle
    Real errors; // share of the intervals of kAimTicks with that error, else half of it
};

Hand handOf(BotKind kind) {
    constexpr Real kBeside = kPaddleHalfWidth + kRimMargin / 2; // a miss
    switch (kind) {
    case BotKind::Clumsy:
        return {6, kBeside, 1};
    case BotKind::Novice:
        return {8, kBeside, Real(0.5)};
    default:
        return {kFieldHeight, kPaddleHalfWidth - kRimMargin, 1};
    }
}

/// A player with keys.
Input keyBot(const Game& game, const Hand& hand) {
    Input input;
    input.launch = game.serving();
    std::optional<Arrival> first;
    for (const Ball& ball : game.balls()) {
        const std::optional<Arrival> arrival = arrivalAt(game, ball, meetingHeight(0));
        const bool seen = game.world()[ball.body].position().y < hand.sight;
        if (seen && arrival && (!first || arrival->seconds < first->seconds)) {
            first = arrival;
        }
    }
    if (first) {
        Generator chance(mixKeys(game.seed(), game.ticks() / kAimTicks, 13));
        const Real error = chance.unit() < hand.errors ? hand.error : hand.error / 2;
        const Real goal = first->x + someOffset(game, error);
        const Real way = goal - game.world()[game.paddle()].position().x;
        const Real share = std::clamp(way / (kKeySpeed * kTickSeconds), Real(-1), Real(1));
        input.paddle = static_cast<std::int8_t>(share * 127);
    }
    return input;
}

Input erraticBot(const Game& game) {
    Generator chance(mixKeys(game.seed(), game.ticks() / kWhimTicks, 9));
    Input input = bot(game);
    switch (chance.below(4)) {
    case 0:
        input.target =
            static_cast<std::int16_t>(chance.between(-kFieldWidth / 2, kFieldWidth / 2) * 1000);
        break;
    case 1:
        input.target.reset();
        input.paddle = static_cast<std::int8_t>(static_cast<int>(chance.below(255)) - 127);
        break;
    default:
        break;
    }
    input.launch = chance.below(3) == 0;
    input.force = static_cast<Force>(chance.below(kForceNames.size()));
    return input;
}

} // namespace

std::optional<Arrival> arrivalOf(const Game& game, const Ball& ball) {
    return arrivalAt(game, ball, meetingHeight(0));
}

std::optional<Arrival> firstArrival(const Game& game, Real offset) {
    const Meeting next = firstMeeting(game, meetingHeight(offset));
    return next.ball != nullptr ? std::optional(next.arrival) : std::nullopt;
}

Input bot(const Game& game, BotKind kind) {
    const bool aims = kind == BotKind::Good || kind == BotKind::Perfect || kind == BotKind::Planner;
    if (kind == BotKind::Clumsy || kind == BotKind::Novice || kind == BotKind::Fair) {
        return keyBot(game, handOf(kind));
    }
    if (kind == BotKind::Absent) {
        return absentBot(game);
    }
    if (kind == BotKind::Erratic) {
        return erraticBot(game);
    }
    const auto [next, first] = firstMeeting(game, meetingHeight(0));
    Real place = 0;
    if (next != nullptr) {
        place = aims ? placeFor(game, *next, first, kind)
                : kind == BotKind::Random
                    ? first.x - someOffset(game, kPaddleHalfWidth - kRimMargin)
                    : first.x;
    } else if (!game.balls().empty() && !game.serving()) {
        place = game.world()[game.balls()[0].body].position().x / 2; // half of its x, to stay near
        const Block* tired =
            game.state().patience() == Patience::Calm ? nullptr : game.state().nextToFall();
        if (aims && tired != nullptr) {
            place = game.world()[tired->body].position().x; // there its pull is strongest
        }
    }
    Input input;
    input.launch = game.serving();
    if (aims) {
        place = partToCatch(game, first.seconds).value_or(place);
        input.force = forceFor(game);
        input.aim = surestServe(game);
        input.launch = input.launch || first.seconds < kLeapSeconds;
    }
    if (game.state().paddle.moved <= kMovedWay && first.seconds > kNudgeSeconds) {
        // Towards the middle: a hollow ball is filled by a paddle that has moved.
        place =
            game.state().paddle.servedFrom - std::copysign(kNudge, game.state().paddle.servedFrom);
    }
    const Real most = kFieldWidth / 2;
    input.target = static_cast<std::int16_t>(std::clamp(place, -most, most) * 1000);
    return input;
}

} // namespace apart
