// SPDX-License-Identifier: MIT
#include "cross_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>
#include <set>
#include <sstream>
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
FigureAdder& FigureAdder::accurate(double tolerance, const std::string& reason) {
    last().accurate = Own{tolerance, reason};
    return *this;
}
FigureAdder& FigureAdder::thesis(double tolerance, const std::string& reason) {
    last().thesis = Own{tolerance, reason};
    return *this;
}
FigureAdder& FigureAdder::withShock(double tolerance, const std::string& reason) {
    last().withShock = Own{tolerance, reason};
    return *this;
}
FigureAdder& FigureAdder::withoutShock(double tolerance, const std::string& reason) {
    last().withoutShock = Own{tolerance, reason};
    return *this;
}
FigureAdder& FigureAdder::box2d(double tolerance, const std::string& reason) {
    last().box2d = Own{tolerance, reason};
    return *this;
}
FigureAdder& FigureAdder::box2d3(double tolerance, const std::string& reason) {
    last().box2d3 = Own{tolerance, reason};
    return *this;
}

namespace {

/// Lines "scene | figure | errors".
void readErrors(std::vector<CrossScene>& book) {
    std::ifstream file(CROSS_ERRORS);
    std::map<std::string, Errors> table;
    for (std::string line; std::getline(file, line);) {
        const std::size_t at = line.rfind(" | ");
        if (at == std::string::npos) {
            continue; // a comment
        }
        std::istringstream numbers(line.substr(at + 3));
        Errors& errors = table[line.substr(0, at)];
        for (double& error : errors) {
            numbers >> error;
        }
    }
    for (CrossScene& scene : book) {
        for (Figure& figure : scene.figures) {
            const auto found = table.find(scene.name + " | " + figure.what);
            if (found != table.end()) {
                figure.errors = found->second;
            }
        }
    }
}

} // namespace

const std::vector<CrossScene>& sceneBook() {
    static const std::vector<CrossScene> book = [] {
        std::vector<CrossScene> all;
        for (const auto& chapter :
             {impactScenes, dropScenes, slideScenes, pileScenes, jointScenes, loadScenes,
              filterScenes, moverScenes, fractureScenes, worldScenes, machineScenes}) {
            std::vector<CrossScene> some = chapter();
            std::move(some.begin(), some.end(), std::back_inserter(all));
        }
        readErrors(all);
        return all;
    }();
    return book;
}

namespace {

/// Plays a scene in another engine and keeps what happened.
class Recorder final : public Engine {
public:
    Recorder(const CrossScene& scene, Engine& engine)
        : scene_(scene), engine_(engine), bodies_(scene.def.bodies) {
        for (const scenes::BodyDef& body : bodies_) {
            centers_.push_back(massOf(body).center);
            parts_.push_back(std::vector<std::size_t>(body.parts.size()));
            std::iota(parts_.back().begin(), parts_.back().end(), std::size_t{0});
        }
        note();
    }

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
    void split(std::size_t body, std::size_t part) override {
        engine_.split(body, part);
        const auto at = static_cast<std::ptrdiff_t>(part);
        played.splits.push_back({played.times.size(), body, parts_[body][part]});
        scenes::BodyDef piece = bodies_[body];
        piece.parts = {piece.parts[part]};
        parts_[body].erase(parts_[body].begin() + at);
        bodies_[body].parts.erase(bodies_[body].parts.begin() + at);
        centers_[body] = massOf(bodies_[body]).center;
        centers_.push_back(massOf(piece).center);
        bodies_.push_back(std::move(piece));
        parts_.push_back({part});
    }
    State state(std::size_t body) const override { return engine_.state(body); }
    std::vector<Touch> touches() const override { return engine_.touches(); }
    scenes::Vec2 jointForce(std::size_t joint) const override { return engine_.jointForce(joint); }
    bool isBroken(std::size_t joint) const override { return engine_.isBroken(joint); }
    bool isAsleep(std::size_t body) const override { return engine_.isAsleep(body); }
    std::optional<RayFound> rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        return engine_.rayCast(from, to);
    }
    std::optional<RayFound> shapeCast(const scenes::Part& shape, scenes::Vec2 from,
                                      scenes::Vec2 to) const override {
        return engine_.shapeCast(shape, from, to);
    }
    std::vector<std::size_t> overlap(scenes::Vec2 low, scenes::Vec2 high) const override {
        return engine_.overlap(low, high);
    }

private:
    void note() {
        for (const std::size_t body : scene_.drawn) {
            const State now = engine_.state(body);
            played.tracks[body].push_back({time_, now.position, now.angle});
        }
        std::vector<Place> places;
        for (std::size_t body = 0; body < centers_.size(); ++body) {
            const State now = engine_.state(body);
            const scenes::Rot turn{std::cos(now.angle), std::sin(now.angle)};
            places.push_back({now.position - turn * centers_[body], now.angle});
        }
        played.times.push_back(time_);
        played.frames.push_back(std::move(places));
    }

    const CrossScene& scene_;
    Engine& engine_;
    std::vector<scenes::BodyDef> bodies_;         // as they are now
    std::vector<scenes::Vec2> centers_;           // of mass, in the frame of the parts
    std::vector<std::vector<std::size_t>> parts_; // of each body, as the scene defines them
    double time_ = 0;
    std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

} // namespace

Played play(const CrossScene& scene, Engine& engine) {
    Recorder recorder(scene, engine);
    recorder.played.values = scene.measure(recorder);
    return recorder.played;
}

double reachOf(const scenes::BodyDef& body) {
    double reach = 0;
    for (const scenes::Part& part : body.parts) {
        if (const auto* circle = std::get_if<scenes::Circle>(&part)) {
            reach = std::max(reach, sizeOf(circle->center) + circle->radius);
            continue;
        }
        if (const auto* capsule = std::get_if<scenes::Capsule>(&part)) {
            reach = std::max({reach, sizeOf(capsule->from) + capsule->radius,
                              sizeOf(capsule->to) + capsule->radius});
            continue;
        }
        const auto* box = std::get_if<scenes::Box>(&part);
        for (const scenes::Vec2 corner :
             box != nullptr ? cornersOf(*box) : std::get<scenes::Polygon>(part).corners) {
            reach = std::max(reach, sizeOf(corner));
        }
    }
    return reach;
}

std::optional<double> partingTime(const CrossScene& scene, const Played& one, const Played& other,
                                  double distance) {
    std::vector<double> reaches;
    for (const scenes::BodyDef& body : scene.def.bodies) {
        reaches.push_back(reachOf(body));
    }
    const std::size_t frames = std::min(one.frames.size(), other.frames.size());
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const std::vector<Place>& a = one.frames[frame];
        const std::vector<Place>& b = other.frames[frame];
        for (std::size_t body = 0; body < std::min({a.size(), b.size(), reaches.size()}); ++body) {
            const double turned = std::remainder(a[body].angle - b[body].angle, 2 * kPi);
            if (sizeOf(a[body].position - b[body].position) > distance ||
                std::abs(turned) * reaches[body] > distance) {
                return one.times[frame];
            }
        }
    }
    return std::nullopt;
}

Own statedFor(const Figure& figure, Profile profile) {
    const Own all{figure.tolerance, figure.reason};
    switch (profile) {
    case Profile::Balanced:
        break;
    case Profile::Accurate:
        return figure.accurate.value_or(all);
    case Profile::Thesis:
        return figure.withShock.value_or(figure.thesis.value_or(all));
    case Profile::ThesisWithoutShock:
        return figure.withoutShock.value_or(figure.thesis.value_or(all));
    }
    return all;
}

double toleranceOf(const Figure& figure, Kodo kodo) {
    const double stated = statedFor(figure, kodo.profile).tolerance;
    const bool hasForm = figure.rule == Rule::Exact || figure.rule == Rule::KodoExact;
    if (stated < 0 || !hasForm || !figure.errors) {
        return stated;
    }
    const double rounding = kodo.isDouble ? 1e-12 : 4e-6; // of a number of the size of 1
    const double inDouble = (*figure.errors)[indexOf({kodo.profile, true})];
    const double error = std::max((*figure.errors)[indexOf(kodo)], inDouble); // not float's luck
    return std::min(stated, std::max(10 * error, rounding * std::max(1.0, std::abs(figure.exact))));
}

double toleranceOfBox2d(const Figure& figure, bool isV3) {
    if (figure.rule != Rule::Exact && figure.rule != Rule::KodoExact) {
        return -1;
    }
    const Own all{figure.tolerance, figure.reason};
    const Own old = figure.box2d.value_or(all);
    return std::max(0.0, isV3 ? figure.box2d3.value_or(old).tolerance : old.tolerance);
}

bool holds(const Figure& figure, Kodo kodo, double value, double box2d) {
    const double tolerance = toleranceOf(figure, kodo);
    if (tolerance < 0) {
        return true;
    }
    switch (figure.rule) {
    case Rule::Exact:
    case Rule::KodoExact:
        return std::abs(value - figure.exact) <= tolerance;
    case Rule::Agree:
        return std::abs(value - box2d) <= tolerance;
    case Rule::AtMost:
        return value <= figure.exact + tolerance;
    case Rule::Show:
        break;
    }
    return true;
}

bool box2dHolds(const Figure& figure, bool isV3, double value) {
    if (figure.rule == Rule::AtMost) {
        return value <= figure.exact + figure.tolerance;
    }
    const double tolerance = toleranceOfBox2d(figure, isV3);
    return tolerance < 0 || std::abs(value - figure.exact) <= tolerance;
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
