// SPDX-License-Identifier: MIT
#include <apart/core/level_file.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/screens/help_scenes.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace apart {

namespace {

using kodo::Vec2;

constexpr Real kInside = Real(6.55);          // m, from the middle to the walls
constexpr Real kReach = kInside - Real(2.05); // m, of the middle of the paddle
constexpr Real kMeet = kPaddleY + Real(0.7);  // m, height at which the paddle meets a ball
constexpr std::uint32_t kServeTick = 40;

// The ball is slower than in the game, so that an eye can follow six scenes.
constexpr std::string_view kRoom = R"(format = 1
title = "Help"
idea = "A scene of the help page."
ball-speed = 7500
lives = 9
[[ledge]]
x = 0
y = 8100
width = 13900
height = 1000
[[ledge]]
x = -6750
y = 3900
width = 400
height = 8200
count = 2
step = [13500, 0]
)";

/// Where something that flies straight arrives at the height of the paddle; the walls reflect it.
struct Landing {
    Real x = 0;       // m
    Real seconds = 0; // from now
};

std::optional<Landing> landingOf(Vec2 place, Vec2 velocity, Real radius) {
    if (velocity.y >= 0 || place.y < kMeet) {
        return std::nullopt;
    }
    const Real seconds = (place.y - kMeet) / -velocity.y;
    const Real wall = kInside - radius;
    Real x = place.x + seconds * velocity.x;
    x = x > wall ? 2 * wall - x : x < -wall ? -2 * wall - x : x;
    return Landing{x, seconds};
}

/// The ball that arrives first.
std::optional<Landing> nextBall(const Game& game) {
    std::optional<Landing> first;
    for (const Ball& ball : game.balls()) {
        const kodo::BodyView body = game.world()[ball.body];
        const std::optional<Landing> own = landingOf(body.position(), body.velocity(), kBallRadius);
        if (own && (!first || own->seconds < first->seconds)) {
            first = own;
        }
    }
    return first;
}

Input movedTo(const Game& game, Real x) {
    Input input;
    input.target = static_cast<std::int16_t>(std::lround(1000 * std::clamp(x, -kReach, kReach)));
    input.launch = game.serving() && game.ticks() >= kServeTick;
    return input;
}

Real paddleX(const Game& game) {
    return game.world()[game.paddle()].position().x;
}

/// Meets the ball `aim` (m) beside the middle of the dome; a positive one sends it to the right.
Input meet(const Game& game, Real aim) {
    const std::optional<Landing> ball = nextBall(game);
    return movedTo(game, ball ? ball->x - aim : paddleX(game));
}

/// Towards the middle of the room.
Real inwards(const Game& game) {
    const std::optional<Landing> ball = nextBall(game);
    return ball && ball->x > 0 ? Real(-0.5) : Real(0.5);
}

/// The paddle waits far from the ball, and pulls it.
Input pullScript(const Game& game) {
    const std::optional<Landing> ball = nextBall(game);
    Input input = meet(game, inwards(game));
    if (ball && ball->seconds > Real(0.12)) {
        input = movedTo(game, ball->x > 0 ? ball->x - 4 : ball->x + 4);
        input.force = Force::Pull;
    }
    return input;
}

/// Pushes what has just left the paddle.
Input pushScript(const Game& game) {
    Input input = meet(game, inwards(game));
    input.force = !game.serving() && !nextBall(game) ? Force::Push : Force::None;
    return input;
}

/// Pulls until the meter is empty, waits until a third of it is full, and pulls again.
Input meterScript(const Game& game) {
    Input input = meet(game, inwards(game));
    const Real least = game.force() == Force::Pull ? Real(0) : Real(0.33);
    input.force = !game.serving() && game.meter() > least ? Force::Pull : Force::None;
    return input;
}

/// Catches parts that do no harm, if the ball leaves time for it.
Input moodsScript(const Game& game) {
    const std::optional<Landing> ball = nextBall(game);
    for (const Part& part : game.parts()) {
        const kodo::BodyView body = game.world()[part.body];
        const std::optional<Landing> own = landingOf(body.position(), body.velocity(), kBallRadius);
        if (own && moodOf(part.power) != Mood::Bad &&
            (!ball || own->seconds < ball->seconds - Real(0.25))) {
            return movedTo(game, own->x);
        }
    }
    return meet(game, inwards(game));
}

/// Sends the ball into the shaft between two walls.
Input comboScript(const Game& game) {
    return meet(game, nextBall(game) ? Real(0.08) * nextBall(game)->x : 0);
}

Input honoursScript(const Game& game) {
    if (game.serving()) {
        return movedTo(game, -3);
    }
    return meet(game, Real(0.4));
}

constexpr std::string_view kPullBlocks = R"([legend.g]
stuff = "glass"
[[block]]
kind = "g"
x = -4800
y = 6600
count = 7
step = [1600, 0]
[[block]]
kind = "g"
x = -4000
y = 5800
count = 6
step = [1600, 0]
)";

constexpr std::string_view kPushBlocks = R"([legend.w]
stuff = "glass"
[legend.b]
stuff = "glass"
hold = "standing"
[[block]]
kind = "w"
x = -3200
y = 6600
count = 5
step = [1600, 0]
[[ledge]]
x = -4400
y = 4000
width = 1800
height = 300
count = 2
step = [8800, 0]
[[block]]
kind = "b"
shape = "square"
x = -4400
y = 4550
rows = 3
row-step = [0, 800]
mirror = true
)";

constexpr std::string_view kMeterBlocks = R"([legend.g]
stuff = "glass"
[[block]]
kind = "g"
x = -4000
y = 6600
count = 6
step = [1600, 0]
)";

constexpr std::string_view kMoodBlocks = R"([legend.g]
stuff = "glass"
power = "heavy"
[legend.m]
stuff = "glass"
power = "weld"
[legend.b]
stuff = "glass"
power = "egg"
[[block]]
kind = "g"
x = -4000
y = 5600
count = 2
step = [4800, 0]
[[block]]
kind = "m"
x = -2400
y = 6400
count = 2
step = [4800, 0]
[[block]]
kind = "b"
x = -800
y = 5600
count = 2
step = [4800, 0]
)";

constexpr std::string_view kComboBlocks = R"([legend.g]
stuff = "glass"
[[block]]
kind = "g"
x = 1900
y = 3600
rows = 5
row-step = [0, 800]
mirror = true
[[block]]
kind = "g"
x = 3500
y = 6000
rows = 2
row-step = [0, 800]
mirror = true
)";

constexpr std::string_view kHonourBlocks = R"([legend.g]
stuff = "glass"
hold = "standing"
[legend.w]
stuff = "wood"
hold = "standing"
[legend.b]
stuff = "brick"
hold = "standing"
[[ledge]]
x = 2400
y = 2800
width = 1000
height = 400
[[block]]
kind = "g"
width = 800
height = 1400
x = 2400
y = 3700
[[block]]
kind = "w"
shape = "beam"
width = 3200
x = 2400
y = 4600
rows = 3
row-step = [0, 1200]
[[block]]
kind = "b"
shape = "square"
x = 1400
y = 5200
count = 3
step = [1000, 0]
rows = 2
row-step = [0, 1200]
)";

} // namespace

const std::array<HelpScene, kHelpTopics>& helpScenes() {
    static constexpr std::array<HelpScene, kHelpTopics> kScenes = {{
        {HelpTopic::Pull, kPullBlocks, 9, 1080, &pullScript},
        {HelpTopic::Push, kPushBlocks, 8, 1020, &pushScript},
        {HelpTopic::Meter, kMeterBlocks, 12, 1320, &meterScript},
        {HelpTopic::Moods, kMoodBlocks, 7, 1080, &moodsScript},
        {HelpTopic::Combo, kComboBlocks, 102, 840, &comboScript},
        {HelpTopic::Honours, kHonourBlocks, 27, 660, &honoursScript},
    }};
    return kScenes;
}

std::shared_ptr<const Level> levelOf(const HelpScene& scene) {
    const std::string text = std::string(kRoom) + std::string(scene.blocks);
    Read<Level> read = parseLevel(text, "help", "help");
    if (Level* level = std::get_if<Level>(&read)) {
        return std::make_shared<const Level>(std::move(*level));
    }
    throw std::logic_error("a scene of the help page has errors"); // a test reads them all
}

} // namespace apart
