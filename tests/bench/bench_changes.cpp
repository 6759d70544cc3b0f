// SPDX-License-Identifier: MIT
// Loads of single events among many bodies: a fall, a push, removals, additions, and their reading.
#include <algorithm>
#include <memory>
#include <optional>

#include "bench_scenes.hpp"

namespace bench {
namespace {

using scenes::BodyDef;
using scenes::Dice;
using scenes::Vec2;

constexpr std::uint16_t kFloor = 1;    // categories
constexpr std::uint16_t kParticle = 2; // collides with the floor alone

/// Calls visit(i) for all numbers below `count` in random order.
template <typename Visit>
void inRandomOrder(std::size_t count, Dice& dice, Visit visit) {
    std::vector<std::size_t> left(count);
    for (std::size_t i = 0; i < count; ++i) {
        left[i] = i;
    }
    while (!left.empty()) {
        std::swap(left[dice.below(left.size())], left.back());
        visit(left.back());
        left.pop_back();
    }
}

/// A pyramid whose records are read after each step.
Scene readPyramid(const char* name, int size, double (Engine::*read)() const) {
    Scene scene = pyramid(size, 1);
    scene.def.name = name;
    scene.every = 1;
    scene.actIsTimed = true;
    const auto sum = std::make_shared<double>(0); // no compiler removes the reading
    scene.act = [=](Stage& stage, int) { *sum += (stage.engine().*read)(); };
    return scene;
}

} // namespace

/// Columns of four boxes sleep on shelves. Every 2 s, a ball falls on one of them; the one before
/// is removed.
Scene columns(int size, std::uint64_t seed) {
    constexpr int kHigh = 4; // boxes
    Scene scene;
    scene.def = {"columns", scenes::kDown, {}};
    const std::vector<Vec2> feet = addShelves(scene.def, size, {1.5, 8});
    for (const Vec2 foot : feet) {
        for (int i = 0; i < kHigh; ++i) {
            scene.def.bodies.push_back(scenes::box(1, 1, foot + Vec2{0, 0.5 + i}));
        }
    }
    scene.rest = true;
    scene.warmUp = 120;
    scene.every = 120;
    scene.actIsTimed = true;
    scene.worstStep = true;
    const auto last = std::make_shared<std::optional<std::size_t>>();
    const auto dice = std::make_shared<Dice>(seed);
    scene.act = [=](Stage& stage, int) {
        if (*last) {
            stage.remove(**last);
        }
        *last = stage.placeOfNext();
        BodyDef ball = scenes::ball(0.3, feet[dice->below(feet.size())] + Vec2{0, kHigh + 1.5});
        ball.velocity = {0, -3};
        stage.add(ball);
    };
    return scene;
}

/// One of the sleeping boxes hops in each step, by 12 mm.
Scene pushed(int size, std::uint64_t seed) {
    Scene scene = asleep(size, seed);
    scene.def.name = "pushed";
    scene.every = 1;
    scene.actIsTimed = true;
    const auto boxes = static_cast<std::size_t>(size);
    const std::size_t first = scene.def.bodies.size() - boxes;
    const auto dice = std::make_shared<Dice>(seed);
    scene.act = [=, warmUp = scene.warmUp](Stage& stage, int steps) {
        if (steps >= warmUp) {
            stage.engine().push(first + dice->below(boxes), {0, 0.5});
        }
    };
    return scene;
}

/// All boxes of columns of ten are removed between two steps, in random order. Only that is timed.
Scene removals(int size, std::uint64_t seed) {
    constexpr int kHigh = 10; // boxes
    Scene scene;
    scene.def = {"removals", scenes::kDown, {scenes::ground(1.1 * size / kHigh + 20)}};
    for (int i = 0; i < size; ++i) {
        const double x = 1.02 * (i / kHigh - 0.5 * (size / kHigh));
        scene.def.bodies.push_back(scenes::box(1, 1, {x, 0.5 + i % kHigh}));
    }
    scene.warmUp = 10;
    scene.every = 1;
    scene.stepIsTimed = false;
    scene.actIsTimed = true;
    scene.act = [=, warmUp = scene.warmUp](Stage& stage, int steps) {
        if (steps == warmUp + 1) {
            Dice dice(seed);
            inRandomOrder(static_cast<std::size_t>(size), dice,
                          [&](std::size_t i) { stage.remove(1 + i); });
        }
    };
    return scene;
}

/// Each particle lives for a second.
Scene particles(int size, std::uint64_t seed) {
    constexpr int kLife = 60; // steps
    Scene scene;
    scene.def = {"particles", scenes::kDown, {scenes::ground(100)}};
    scene.def.bodies[0].category = kFloor;
    scene.warmUp = kLife;
    scene.every = 1;
    scene.actIsTimed = true;
    const auto oldest = std::make_shared<std::size_t>(1);
    const auto dice = std::make_shared<Dice>(seed);
    scene.act = [=](Stage& stage, int) {
        for (int i = 0; i < std::max(1, size / kLife); ++i) {
            BodyDef body = scenes::ball(0.05, {dice->between(-20, 20), 0.5}, {0.6, 0.3});
            body.velocity = {dice->between(-3, 3), dice->between(0, 4)};
            body.category = kParticle;
            body.mask = kFloor;
            stage.add(body);
        }
        while (stage.placeOfNext() - *oldest > static_cast<std::size_t>(size)) {
            stage.remove((*oldest)++);
        }
    };
    return scene;
}

Scene events(int size, std::uint64_t) {
    Scene scene = readPyramid("events", size, &Engine::readEvents);
    scene.events = true;
    return scene;
}

Scene contacts(int size, std::uint64_t) {
    return readPyramid("contacts", size, &Engine::readContacts);
}

} // namespace bench
