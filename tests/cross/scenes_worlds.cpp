// SPDX-License-Identifier: MIT
// What a world does beside forces: sleep, queries, lines as ground, belts, order of events, rates
// of steps, crowds.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cross_scene.hpp"

namespace crosscheck {
namespace {

using scenes::Vec2;

const char* const kYesOrNo = "1 is yes, 0 is no";
const char* const kSkin = "the skin of Box2D, 1 cm";

CrossScene sleepers() {
    CrossScene scene{"SleepersWakeAtTheTouchOfAnotherBody",
                     "A ball falls for 4 s onto one of two boxes that sleep",
                     "Bodies at rest sleep; the one that is hit wakes, the other sleeps on.",
                     "",
                     {"sleepers", scenes::kDown, {scenes::ground(20)}}};
    scene.def.sleep = true;
    scene.def.bodies.push_back(scenes::box(1, 1, {-3, 0.5}));
    scene.def.bodies.push_back(scenes::box(1, 1, {3, 0.5}));
    scene.def.bodies.push_back(scenes::ball(0.25, {-3, 1.25 + 80})); // 10 t^2 / 2
    scene.drawn = {1, 2};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 3);
        const double one = engine.isAsleep(1) ? 1 : 0;
        const double other = engine.isAsleep(2) ? 1 : 0;
        const double speed = sizeOf(engine.state(1).velocity);
        run(engine, 1.1);
        return {one, other, speed, engine.isAsleep(1) ? 1.0 : 0.0, engine.isAsleep(2) ? 1.0 : 0.0};
    };
    figure(scene, "left box sleeps after 3 s", "").exact(1, 0, kYesOrNo);
    figure(scene, "right box sleeps after 3 s", "").exact(1, 0, kYesOrNo);
    figure(scene, "speed of a sleeper", "m/s").exact(0, 0, "it stands still");
    figure(scene, "left box sleeps after the hit", "").exact(0, 0, kYesOrNo);
    figure(scene, "right box sleeps after the hit", "").exact(1, 0, kYesOrNo);
    return scene;
}

CrossScene queried() {
    CrossScene scene{
        "RaysAndBoxesFindWhatIsThere",
        "Rays and boxes ask for a disc, a turned square and a triangle",
        "A ray meets a disc where |m + t d| = r, and a square where it crosses its side. A "
        "box that meets the bounds of the disc, but not the disc, does not find it.",
        "The shapes of Box2D are inset by their skin.",
        {"queried", {}, {}}};
    scene.def.bodies = {scenes::ball(1, {0, 0}), scenes::box(1, 1, {4, 0}),
                        scenes::ball(0.2, {9, 9})};
    scene.def.bodies[1].rotation = scenes::slope(1, 1);
    scenes::BodyDef triangle;
    triangle.parts = {scenes::Polygon{{{-1, 0}, {1, 0}, {0, 2}}}};
    triangle.position = {-4, 0};
    scene.def.bodies.push_back(triangle);
    for (const std::size_t body : {0u, 1u, 3u}) {
        scene.def.bodies[body].locked = true;
    }
    scene.drawn = {0, 1, 3};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        engine.step(kDt);
        const auto fraction = [&](Vec2 from, Vec2 to) {
            const auto found = engine.rayCast(from, to);
            return found ? found->fraction : -1;
        };
        const auto first = engine.rayCast({10, 0.25}, {-10, 0.25});
        const auto count = [&](Vec2 low, Vec2 high) {
            return static_cast<double>(engine.overlap(low, high).size());
        };
        return {fraction({0.6, 5}, {0.6, -5}),
                fraction({4, 5}, {4, -5}),
                fraction({-4.5, 5}, {-4.5, -5}),
                fraction({0, 1.2}, {10, 1.2}),
                first ? static_cast<double>(first->body) : -1,
                count({0.8, 0.8}, {0.95, 0.95}),
                count({0.6, 0.6}, {0.95, 0.95}),
                count({-6, -2}, {6, 3})};
    };
    figure(scene, "ray to the disc", "").exact(0.42, 1e-6, "rounding");
    figure(scene, "ray to the corner of the square", "")
        .exact(0.5 - std::sqrt(0.5) / 10, 1e-6, "rounding")
        .box2d(2e-3, kSkin);
    figure(scene, "ray to the side of the triangle", "")
        .exact(0.4, 1e-6, "rounding")
        .box2d(4e-3, "the skin, 1 cm, on a steep side");
    figure(scene, "ray that passes", "").exact(-1, 0, "-1: no hit");
    figure(scene, "first body on a ray", "").exact(1, 0, "its number");
    figure(scene, "found in the corner of the bounds", "").exact(0, 0, "a number of bodies");
    figure(scene, "found at the edge of the disc", "").exact(1, 0, "a number of bodies");
    figure(scene, "found by a box around all but one", "").exact(3, 0, "a number of bodies");
    return scene;
}

CrossScene cast() {
    CrossScene scene{
        "DiscsAndBoxesAreCastToWhatTheyMeet",
        "Discs and a box are cast at a disc, a turned square and a triangle",
        "A disc meets a disc where the distance of both centres is the sum of the radii, and a "
        "side "
        "where its centre is a radius before it. A cast that starts in overlap ends there.",
        "The casts of Box2D 2.4.1 end within its slop.",
        {"cast", {}, {}}};
    scenes::BodyDef triangle;
    triangle.parts = {scenes::Polygon{{{-1, 0}, {1, 0}, {0, 2}}}};
    triangle.position = {-4, 0};
    scene.def.bodies = {scenes::ball(1, {0, 0}), scenes::box(1, 1, {4, 0}),
                        scenes::ball(0.2, {9, 9}), triangle};
    scene.def.bodies[1].rotation = scenes::slope(1, 1);
    for (const std::size_t body : {0u, 1u, 3u}) {
        scene.def.bodies[body].locked = true;
    }
    scene.drawn = {0, 1, 3};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        engine.step(kDt);
        const auto fraction = [&](const scenes::Part& shape, Vec2 from, Vec2 to) {
            const auto found = engine.shapeCast(shape, from, to);
            return found ? found->fraction : -1;
        };
        const scenes::Circle disc{0.5};
        const scenes::Box box{1, 1};
        const auto first = engine.shapeCast(box, {10, 0}, {-10, 0});
        return {fraction(disc, {0.9, 5}, {0.9, -5}),
                fraction(disc, {-3.5, 5}, {-3.5, -5}),
                fraction(box, {4, 5}, {4, -5}),
                fraction(disc, {1.6, 5}, {1.6, -5}),
                first ? static_cast<double>(first->body) : -1,
                first ? first->fraction : -1,
                fraction(disc, {0.5, 0.5}, {5, 5})};
    };
    const char* const slop = "it stops within its slop of 5 mm and its skin of 1 cm, of 10 m";
    const double corner =
        std::sqrt(0.5) + 0.5; // m, from the middle of the square to that of the box
    figure(scene, "disc to the disc", "").exact(0.38, 1e-6, "rounding").box2d(2e-3, slop);
    figure(scene, "disc to the side of the triangle", "")
        .exact((4 - std::sqrt(5.0) / 2) / 10, 1e-6, "rounding")
        .box2d(4e-3, "the same, on a steep side");
    figure(scene, "box to the corner of the square", "")
        .exact((5 - corner) / 10, 1e-6, "rounding")
        .box2d(4e-3, slop);
    figure(scene, "disc that passes", "").exact(-1, 0, "-1: no hit");
    figure(scene, "first body in the way of a box", "").exact(1, 0, "its number");
    figure(scene, "box to this body", "")
        .exact((6 - corner) / 20, 1e-6, "rounding")
        .box2d(2e-3, slop);
    figure(scene, "disc that starts in overlap", "").kodoExact(0, 0, "it does not move");
    return scene;
}

CrossScene chained() {
    CrossScene scene{"BoxSlidesOverAChainWithoutFeelingItsJoints",
                     "A box slides at 4 m/s over a line of 40 segments",
                     "It stops after v^2 / (2 mu g), as on one surface, and never rises or tilts.",
                     "Euler in Box2D errs by v dt / 2, and its line has a skin.",
                     {"chained", scenes::kDown, {}}};
    std::vector<Vec2> points;
    for (int i = 0; i <= 40; ++i) {
        points.push_back({-5 + 0.25 * i, 0});
    }
    scene.def.chains = {{points}};
    scene.def.bodies = {scenes::box(1, 0.5, {-4, 0.25})};
    scene.def.bodies[0].velocity = {4, 0};
    scene.drawn = {0};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        double highest = 0;
        double tilt = 0;
        for (int i = 0; i < 120; ++i) {
            engine.step(kDt);
            const State box = engine.state(0);
            highest = std::max(highest, box.position.y);
            tilt = std::max(tilt, std::abs(box.angle));
        }
        const State end = engine.state(0);
        return {end.position.x + 4, end.velocity.x, highest, tilt};
    };
    figure(scene, "distance", "m")
        .exact(16.0 / 12, 0.01, "a sixth of v dt")
        .thesis(0.04, "Euler: half of v dt")
        .box2d(0.05, "Euler: half of v dt, and settling onto the skin");
    figure(scene, "speed at the end", "m/s").exact(0, 1e-4, "it rests");
    figure(scene, "highest", "m").exact(0.25, 1e-3, "1 mm").box2d(0.011, kSkin);
    figure(scene, "most tilt", "rad").exact(0, 2e-3, "2 mm over the width").box2d(0.01, kSkin);
    return scene;
}

CrossScene belt() {
    CrossScene scene{"BeltCarriesABoxAtItsSpeed",
                     "A belt at 2 m/s carries a box that is laid on it",
                     "mu = 0.5: the box reaches 2 m/s after 0.4 s and lags 0.4 m behind.",
                     "Euler in Box2D errs by v dt / 2.",
                     {"belt", scenes::kDown, {}}};
    scene.def.bodies = {scenes::box(20, 1, {0, -0.5}, {0.5, 0, 2}),
                        scenes::box(1, 0.5, {-3, 0.25}, {0.5, 0})};
    scene.def.bodies[0].locked = true;
    scene.drawn = {1};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 0.2);
        const double half = engine.state(1).velocity.x;
        run(engine, 1.8);
        const State box = engine.state(1);
        return {half, box.velocity.x, 4 - (box.position.x + 3), box.angle};
    };
    figure(scene, "box after 0.2 s", "m/s")
        .exact(1, 0.02, "2 %: a quarter of a step of friction, 0.083 m/s")
        .thesis(0.1, "one step of friction")
        .box2d(0.1, "one step of friction");
    figure(scene, "box after 2 s", "m/s").exact(2, 1e-4, "it sticks");
    figure(scene, "lag", "m")
        .exact(0.4, 0.01, "a third of v dt")
        .thesis(0.05, "v dt = 33 mm, and settling")
        .box2d(0.05, "v dt = 33 mm, and settling");
    figure(scene, "tilt", "rad").exact(0, 2e-3, "2 mm over the width");
    return scene;
}

CrossScene ordered() {
    CrossScene scene{
        "BallsInARowAreHitInTheirOrder",
        "A ball at 5 m/s passes its speed along a row of four with gaps of 0.5 m",
        "Equal masses, e = 1: hit k is at 0.1 k s, and each ball stands still after it.",
        "",
        {"ordered", {}, {}}};
    for (int i = 0; i < 5; ++i) {
        scene.def.bodies.push_back(scenes::ball(0.25, {1.0 * i, 0}, {0, 1}));
    }
    scene.def.bodies[0].velocity = {5, 0};
    scene.drawn = {0, 1, 2, 3, 4};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        std::vector<double> times(4, -1);
        std::vector<std::size_t> order;
        for (int i = 1; i <= 60; ++i) {
            engine.step(kDt);
            for (std::size_t k = 0; k < 4; ++k) {
                if (times[k] < 0 && engine.impulse(k, k + 1) > 0) {
                    times[k] = i * kDt;
                    order.push_back(k);
                }
            }
        }
        double slowest = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            slowest = std::max(slowest, sizeOf(engine.state(k).velocity));
        }
        return {times[0], times[3], std::is_sorted(order.begin(), order.end()) ? 1.0 : 0.0,
                engine.state(4).velocity.x, slowest};
    };
    figure(scene, "first hit", "s").exact(0.1, 2 * kDt, "two steps");
    figure(scene, "fourth hit", "s")
        .exact(0.4, 2 * kDt, "two steps")
        .thesis(5 * kDt, "a step for each hit")
        .box2d(5 * kDt, "a step for each hit");
    figure(scene, "hits in order", "").exact(1, 0, kYesOrNo);
    figure(scene, "speed of the last", "m/s").exact(5, 1e-4, "rounding");
    figure(scene, "largest speed of the others", "m/s").exact(0, 1e-4, "rounding");
    return scene;
}

CrossScene slideAt(int rate, const std::string& name) {
    const double dt = 1.0 / rate;
    CrossScene scene{name,
                     "A box slides to rest in steps of 1/" + std::to_string(rate) + " s",
                     "Distance v^2 / (2 mu g), time v / (mu g), at each rate of steps.",
                     "Euler in Box2D errs by v dt / 2.",
                     {"slide", scenes::kDown, {scenes::ground(20)}}};
    scene.def.bodies.push_back(scenes::box(1, 0.5, {-5, 0.25}));
    scene.def.bodies[1].velocity = {6, 0};
    scene.drawn = {1};
    scene.measure = [dt](Engine& engine) -> std::vector<double> {
        double stop = 0;
        for (int i = 1; i * dt <= 2; ++i) {
            engine.step(dt);
            stop = engine.state(1).velocity.x > 0.01 ? i * dt : stop;
        }
        return {engine.state(1).position.x + 5, stop, engine.state(1).position.y};
    };
    figure(scene, "distance", "m")
        .exact(3, 0.15 * 6 * dt, "a seventh of v dt")
        .thesis(0.6 * 6 * dt, "Euler: half of v dt, and a step of settling")
        .box2d(0.6 * 6 * dt, "Euler: half of v dt, and a step of settling");
    figure(scene, "time", "s").exact(1, 2 * dt, "two steps");
    figure(scene, "height", "m").exact(0.25, 1e-3, "1 mm").box2d(0.006, "Box2D's slop is 5 mm");
    return scene;
}

CrossScene bounceAt(int rate, const std::string& name) {
    const double dt = 1.0 / rate;
    CrossScene scene{name,
                     "An elastic ball bounces for 8 s in steps of 1/" + std::to_string(rate) + " s",
                     "It rises to 5 m after each bounce, whatever the rate of steps.",
                     "A fall of 1 s is a whole number of steps.",
                     {"bounce", scenes::kDown, {scenes::ground(20, {0, 1})}}};
    scene.def.bodies.push_back(scenes::ball(0.5, {0, 5.5}, {0, 1}));
    scene.drawn = {1};
    scene.measure = [dt](Engine& engine) -> std::vector<double> {
        double highest = 0;
        double last = 0;
        for (int i = 1; i * dt <= 8.05; ++i) {
            engine.step(dt);
            const double height = engine.state(1).position.y - 0.5;
            highest = std::max(highest, height);
            last = i * dt > 7 ? std::max(last, height) : last;
        }
        return {highest, last};
    };
    figure(scene, "highest of all", "m").exact(5, 1e-3, "1 mm");
    figure(scene, "peak after four bounces", "m").exact(5, 1e-3, "1 mm");
    return scene;
}

CrossScene crowd() {
    CrossScene scene{"FiveHundredBallsRestInABin",
                     "500 balls fall into a bin",
                     "All stay inside, and the floor carries their weight.",
                     "A pile that still settles presses with less force, or more.",
                     {"crowd", scenes::kDown, {}}};
    scene.def.bodies = {scenes::box(10, 1, {0, -0.5}, {0, 0}),
                        scenes::box(1, 14, {-5.5, 6}, {0, 0}),
                        scenes::box(1, 14, {5.5, 6}, {0, 0})};
    for (scenes::BodyDef& body : scene.def.bodies) {
        body.locked = true;
    }
    for (int i = 0; i < 500; ++i) { // odd rows are shifted, so that no column stands
        scene.def.bodies.push_back(scenes::ball(
            0.2, {-4.75 + 0.48 * (i % 20) + (i / 20 % 2 == 0 ? 0.0 : 0.2), 0.25 + 0.45 * (i / 20)},
            {0.5, 0}));
    }
    scene.drawn = {3, 253, 502};
    scene.measure = [](Engine& engine) -> std::vector<double> {
        run(engine, 3);
        double load = 0;
        for (int i = 0; i < 10; ++i) {
            engine.step(kDt);
            for (const Touch& one : engine.touches()) {
                load += one.a == 0 ? one.impulse : 0;
            }
        }
        double inside = 0;
        double fastest = 0;
        for (std::size_t i = 3; i < 503; ++i) {
            const State ball = engine.state(i);
            inside += std::abs(ball.position.x) < 5 && ball.position.y > 0 ? 1 : 0;
            fastest = std::max(fastest, sizeOf(ball.velocity));
        }
        return {inside, load / (10 * kDt), fastest};
    };
    const double weight = 500 * massOf(scene.def.bodies[3]).mass * 10;
    figure(scene, "balls inside", "").exact(500, 0, "none may leave");
    figure(scene, "force of the floor", "N")
        .exact(weight, 0.01 * weight, "1 %: the pile still settles")
        .withoutShock(0.1 * weight, "10 %: without shock passes the pile settles longer")
        .withShock(-1, kStatic)
        .box2d(0.1 * weight, "10 %: the pile settles longer");
    figure(scene, "largest speed", "m/s");
    return scene;
}

} // namespace

std::vector<CrossScene> worldScenes() {
    return {sleepers(),
            queried(),
            cast(),
            chained(),
            belt(),
            ordered(),
            slideAt(30, "BoxStopsAtTheExactDistanceAt30Hz"),
            slideAt(240, "BoxStopsAtTheExactDistanceAt240Hz"),
            bounceAt(30, "BallKeepsItsHeightAt30Hz"),
            bounceAt(240, "BallKeepsItsHeightAt240Hz"),
            crowd()};
}

} // namespace crosscheck
