// SPDX-License-Identifier: MIT
#include "cross_scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace crosscheck {

double Engine::impulse(std::size_t a, std::size_t b) const {
    double sum = 0;
    for (const Touch& one : touches()) {
        sum += one.a == std::min(a, b) && one.b == std::max(a, b) ? one.impulse : 0;
    }
    return sum;
}

bool Engine::touching(std::size_t a, std::size_t b) const {
    const std::vector<Touch> all = touches();
    return std::any_of(all.begin(), all.end(), [&](const Touch& one) {
        return one.a == std::min(a, b) && one.b == std::max(a, b);
    });
}

FigureAdder::FigureAdder(CrossScene& scene, std::string what, std::string unit) : scene_(scene) {
    Figure figure;
    figure.what = std::move(what);
    figure.unit = std::move(unit);
    scene_.figures.push_back(figure);
}

Figure& FigureAdder::last() {
    return scene_.figures.back();
}

FigureAdder& FigureAdder::set(Rule rule, double value, double tolerance,
                              const std::string& reason) {
    last().rule = rule;
    last().exact = value;
    last().tolerance = tolerance;
    last().reason = reason;
    return *this;
}

FigureAdder& FigureAdder::exact(double value, double tolerance, const std::string& reason) {
    return set(Rule::Exact, value, tolerance, reason);
}
FigureAdder& FigureAdder::kodoExact(double value, double tolerance, const std::string& reason) {
    return set(Rule::KodoExact, value, tolerance, reason);
}
FigureAdder& FigureAdder::agree(double tolerance, const std::string& reason) {
    return set(Rule::Agree, 0, tolerance, reason);
}
FigureAdder& FigureAdder::atMost(double value, const std::string& reason) {
    return set(Rule::AtMost, value, 0, reason);
}
FigureAdder& FigureAdder::propagation(double tolerance, const std::string& reason) {
    last().propagation = Wider{tolerance, reason};
    return *this;
}

const std::vector<CrossScene>& sceneBook() {
    static const std::vector<CrossScene> book = [] {
        std::vector<CrossScene> all;
        for (const auto& chapter : {impactScenes, dropScenes, slideScenes, pileScenes, jointScenes,
                                    loadScenes, filterScenes, moverScenes, fractureScenes}) {
            std::vector<CrossScene> some = chapter();
            std::move(some.begin(), some.end(), std::back_inserter(all));
        }
        return all;
    }();
    return book;
}

namespace {

/// Plays a scene in another engine and keeps what happened.
class Recorder final : public Engine {
public:
    Recorder(const CrossScene& scene, Engine& engine) : scene_(scene), engine_(engine) { note(); }

    Played played;

    void step(double dt) override {
        engine_.step(dt);
        time_ += dt;
        note();
        std::set<std::pair<std::size_t, std::size_t>> now;
        for (const Touch& one : engine_.touches()) {
            if (one.impulse > 0) {
                now.insert({one.a, one.b});
            }
        }
        for (const auto& pair : now) {
            if (!pairs_.contains(pair) && played.impacts.size() < 6) {
                played.impacts.push_back(
                    {time_, pair.first, pair.second, engine_.impulse(pair.first, pair.second)});
            }
        }
        pairs_ = std::move(now);
    }
    void join(const Link& link) override { engine_.join(link); }
    void split(std::size_t body, std::size_t part) override { engine_.split(body, part); }
    State state(std::size_t body) const override { return engine_.state(body); }
    std::vector<Touch> touches() const override { return engine_.touches(); }
    scenes::Vec2 jointForce(std::size_t joint) const override { return engine_.jointForce(joint); }

private:
    void note() {
        for (const std::size_t body : scene_.drawn) {
            const State now = engine_.state(body);
            played.tracks[body].push_back({time_, now.position, now.angle});
        }
    }

    const CrossScene& scene_;
    Engine& engine_;
    double time_ = 0;
    std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

} // namespace

Played play(const CrossScene& scene, Engine& engine) {
    Recorder recorder(scene, engine);
    recorder.played.values = scene.measure(recorder);
    return recorder.played;
}

double toleranceOf(const Figure& figure, Solver solver) {
    return solver == Solver::Propagation && figure.propagation ? figure.propagation->tolerance
                                                               : figure.tolerance;
}

bool holds(const Figure& figure, Solver solver, double kodo, double box2d) {
    const double tolerance = toleranceOf(figure, solver);
    const auto near = [&](double value, double right, double most) {
        return std::abs(value - right) <= most;
    };
    const bool judged = tolerance >= 0;
    switch (figure.rule) {
    case Rule::Exact:
        return (!judged || near(kodo, figure.exact, tolerance)) &&
               near(box2d, figure.exact, figure.tolerance);
    case Rule::KodoExact:
        return !judged || near(kodo, figure.exact, tolerance);
    case Rule::Agree:
        return !judged || near(kodo, box2d, tolerance);
    case Rule::AtMost:
        return !judged || kodo <= figure.exact + tolerance;
    case Rule::Show:
        break;
    }
    return true;
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

double meanForce(Engine& engine, std::size_t a, std::size_t b) {
    double sum = 0;
    for (int i = 0; i < 60; ++i) {
        engine.step(kDt);
        sum += engine.impulse(a, b);
    }
    return sum; // N s during one second
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
