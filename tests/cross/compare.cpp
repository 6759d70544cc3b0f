// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace crosscheck {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%14.7g", value);
    return text;
}

} // namespace

void Comparison::agree(const std::string& what, Both figure, double tolerance) {
    const bool good = std::abs(figure.kodo - figure.box2d) <= tolerance;
    rows_.push_back({what, std::nullopt, figure, tolerance, good});
}

void Comparison::witness(const std::string& what, double exact, Both figure, double tolerance) {
    const bool good =
        std::abs(figure.kodo - exact) <= tolerance && std::abs(figure.box2d - exact) <= tolerance;
    rows_.push_back({what, exact, figure, tolerance, good});
}

void Comparison::judge(const std::string& what, double exact, Both figure, double tolerance) {
    const bool good = std::abs(figure.kodo - exact) <= tolerance;
    rows_.push_back({what, exact, figure, tolerance, good});
    testing::Test::RecordProperty(what + ": error of Kodo", number(figure.kodo - exact));
    testing::Test::RecordProperty(what + ": error of Box2D", number(figure.box2d - exact));
}

void Comparison::show(const std::string& what, Both figure) {
    rows_.push_back({what, std::nullopt, figure, -1, true});
}

std::string Comparison::table() const {
    std::size_t width = 8;
    for (const Row& row : rows_) {
        width = std::max(width, row.what.size());
    }
    std::string text =
        std::string(width, ' ') + "           Kodo          Box2D    closed form      tolerance\n";
    for (const Row& row : rows_) {
        text += row.what + std::string(width - row.what.size(), ' ') + " " +
                number(row.figure.kodo) + " " + number(row.figure.box2d) + " " +
                (row.exact ? number(*row.exact) : std::string(14, ' ')) + " " +
                (row.tolerance >= 0 ? number(row.tolerance) : std::string(14, ' ')) +
                (row.good ? "\n" : "  DIFFERS\n");
    }
    return text;
}

testing::AssertionResult Comparison::holds() const {
    if (std::getenv("CROSS_TABLES") != nullptr) {
        std::cout << table();
    }
    const bool good =
        std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.good; });
    return (good ? testing::AssertionSuccess() : testing::AssertionFailure()) << "\n" << table();
}

std::vector<Both> inBoth(const scenes::SceneDef& scene,
                         const std::function<std::vector<double>(Engine&)>& measure,
                         double bounceThreshold) {
    const std::vector<double> kodo = measure(*makeKodo(scene));
    const std::vector<double> box2d = measure(*makeBox2d(scene, bounceThreshold));
    std::vector<Both> figures;
    for (std::size_t i = 0; i < kodo.size(); ++i) {
        figures.push_back({kodo[i], box2d.at(i)});
    }
    return figures;
}

void run(Engine& engine, double seconds, double dt) {
    for (long i = std::lround(seconds / dt); i > 0; --i) {
        engine.step(dt);
    }
}

Hit runToHit(Engine& engine, std::size_t a, std::size_t b, double mostSeconds, double dt) {
    Hit hit;
    for (int i = 1; i * dt <= mostSeconds; ++i) {
        engine.step(dt);
        hit.impulse = engine.impulse(a, b);
        if (hit.impulse > 0) {
            hit.time = i * dt;
            break;
        }
    }
    for (int i = 0; i < 2; ++i) {
        engine.step(dt);
        hit.impulse += engine.impulse(a, b);
    }
    return hit;
}

double runToRest(Engine& engine, std::size_t first, std::size_t last, double seconds,
                 double speed) {
    double since = 0;
    for (int i = 1; i * kDt <= seconds; ++i) {
        engine.step(kDt);
        for (std::size_t body = first; body <= last; ++body) {
            const State now = engine.state(body);
            if (dot(now.velocity, now.velocity) > speed * speed || std::abs(now.spin) > speed) {
                since = i * kDt;
            }
        }
    }
    return since > seconds - 2 * kDt ? -1 : since;
}

double energy(const Engine& engine, const scenes::SceneDef& scene) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].locked) {
            continue;
        }
        const Mass mass = massOf(scene.bodies[i]);
        const State now = engine.state(i);
        sum +=
            mass.mass * (dot(now.velocity, now.velocity) / 2 - dot(scene.gravity, now.position)) +
            mass.inertia * now.spin * now.spin / 2;
    }
    return sum;
}

} // namespace crosscheck
