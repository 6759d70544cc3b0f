// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine.hpp"

namespace crosscheck {

inline constexpr double kDt = 1.0 / 60; // s, a common step size of both engines
inline constexpr double kPi = 3.14159265358979323846;

/// What a figure of a scene must agree with.
enum class Rule {
    Exact,     // Kodo and Box2D with the closed form
    KodoExact, // Kodo with the closed form; Box2D deviates by design
    Agree,     // Kodo with Box2D; there is no closed form
    AtMost,    // Kodo is not above `exact`
    Show,      // nothing
};

/// A tolerance of one engine, with its reason. Negative: not judged.
struct Own {
    double tolerance = 0;
    std::string reason;
};

/// Errors against the closed form as they were measured, by profile, first in float, then in
/// double.
using Errors = std::array<double, 8>;

/// One measured number of a scene and how it is judged.
struct Figure {
    std::string what;
    std::string unit;
    Rule rule = Rule::Show;
    double exact = 0;
    double tolerance = 0;
    std::string reason; // of the tolerance
    std::optional<Own> accurate{};
    std::optional<Own> thesis{};       // of both profiles of the thesis
    std::optional<Own> withShock{};    // of thesis2006() alone
    std::optional<Own> withoutShock{}; // of the other one alone
    std::optional<Own> box2d{};        // of 2.4.1, and of 3 if there is no other
    std::optional<Own> box2d3{};
    std::optional<Errors> errors{}; // of the table errors.txt
};

/// The one definition of a scene: the tests judge it, and the page shows it.
struct CrossScene {
    std::string name; // of the test
    std::string title;
    std::string text;       // what happens, and the closed form
    std::string difference; // why engines differ; which one is nearer follows from the figures
    scenes::SceneDef def;
    double bounceThreshold = 1;       // m/s, of Box2D
    std::vector<std::size_t> drawn{}; // bodies whose paths are drawn
    std::vector<Link> links{};        // of a scene that was read
    std::function<std::vector<double>(Engine&)> measure{};
    std::vector<Figure> figures{}; // one for each number that `measure` returns
};

/// Adds to the figures of a scene: adder(scene)("first hit", "s").exact(...).
class FigureAdder {
public:
    FigureAdder(CrossScene& scene, std::string what, std::string unit);
    FigureAdder& exact(double value, double tolerance, const std::string& reason);
    FigureAdder& kodoExact(double value, double tolerance, const std::string& reason);
    FigureAdder& agree(double tolerance, const std::string& reason);
    FigureAdder& atMost(double value, const std::string& reason);
    FigureAdder& accurate(double tolerance, const std::string& reason);
    /// For both profiles of the thesis.
    FigureAdder& thesis(double tolerance, const std::string& reason);
    /// For thesis2006() with its shock passes, or without them.
    FigureAdder& withShock(double tolerance, const std::string& reason);
    FigureAdder& withoutShock(double tolerance, const std::string& reason);
    FigureAdder& box2d(double tolerance, const std::string& reason);
    FigureAdder& box2d3(double tolerance, const std::string& reason);

private:
    FigureAdder& set(Rule rule, double value, double tolerance, const std::string& reason);
    Figure& last();

    CrossScene& scene_;
};

inline FigureAdder figure(CrossScene& scene, const std::string& what, const std::string& unit) {
    return {scene, what, unit};
}

inline const char* const kStatic =
    "shock passes treat lower bodies as static: records and friction lack the load";

/// All scenes, in the order of the page.
const std::vector<CrossScene>& sceneBook();

// The chapters of the book.
std::vector<CrossScene> impactScenes();
std::vector<CrossScene> dropScenes();
std::vector<CrossScene> slideScenes();
std::vector<CrossScene> pileScenes();
std::vector<CrossScene> jointScenes();
std::vector<CrossScene> loadScenes();
std::vector<CrossScene> filterScenes();
std::vector<CrossScene> moverScenes();
std::vector<CrossScene> fractureScenes();
std::vector<CrossScene> worldScenes();
std::vector<CrossScene> machineScenes();

/// Where a body was at the end of a step.
struct TrackPoint {
    double time = 0; // s
    scenes::Vec2 position;
    double angle = 0; // rad
};

/// A pair that began to exchange impulses in a step.
struct Impact {
    double time = 0; // s
    std::size_t a = 0;
    std::size_t b = 0;
    double impulse = 0; // N s, of that step
};

/// The frame of a body's parts.
struct Place {
    scenes::Vec2 position; // m
    double angle = 0;      // rad, -pi..pi
};

/// A part that became a body of its own, which has the next index from this frame on.
struct Split {
    std::size_t frame = 0;
    std::size_t body = 0;
    std::size_t part = 0; // of the body as the scene defines it
};

/// A scene as one engine played it.
struct Played {
    std::vector<double> values;
    std::map<std::size_t, std::vector<TrackPoint>> tracks; // by body
    std::vector<Impact> impacts;                           // the first of them
    std::vector<double> times;                             // s, of each frame; frame 0 is the start
    std::vector<std::vector<Place>> frames;                // by body
    std::vector<Split> splits;
};
Played play(const CrossScene& scene, Engine& engine);

/// Distance (m) from the frame of a body to the farthest point of its parts.
double reachOf(const scenes::BodyDef& body);

/// The end (s) of the first step after which a point of a body is farther than `distance` (m) from
/// its place in the other play: by the position of the body's frame, or by its angle times reach.
/// nullopt if there is none within the time of both.
std::optional<double> partingTime(const CrossScene& scene, const Played& one, const Played& other,
                                  double distance);

/// A play of Kodo.
struct Kodo {
    Profile profile = Profile::Balanced;
    bool isDouble = false;
};
inline std::size_t indexOf(Kodo kodo) {
    return 2 * static_cast<std::size_t>(kodo.profile) + (kodo.isDouble ? 1 : 0);
}

/// What a scene states for an engine. Negative: not judged.
Own statedFor(const Figure& figure, Profile profile);
/// The tolerance of a play of Kodo: what the scene states, but for a closed form at most ten times
/// the error that was measured, or rounding. Negative: not judged.
double toleranceOf(const Figure& figure, Kodo kodo);
/// That of Box2D 2.4.1, or of 3. Negative: the figure has no closed form.
double toleranceOfBox2d(const Figure& figure, bool isV3);

/// True if the value satisfies the rule, or is not judged. `box2d` is that of 2.4.1.
bool holds(const Figure& figure, Kodo kodo, double value, double box2d);
/// True if Box2D is within its tolerance of the closed form, or there is none.
bool box2dHolds(const Figure& figure, bool isV3, double value);

// Used by measurements.

void run(Engine& engine, double seconds, double dt = kDt);

/// The first impact between two bodies: the end of the first step with an impulse, and the sum of
/// that step and the next two. Kodo may distribute a soft impact over two steps. Box2D follows a
/// time-of-impact step by a regular one. The engine's state is the one after the three steps.
struct Hit {
    double time = -1; // s; -1: never
    double impulse = 0;
};
Hit runToHit(Engine& engine, std::size_t a, std::size_t b, double mostSeconds, double dt = kDt);

/// The time (s) from which no body from `first` to `last` is faster than `speed` (m/s or rad/s). -1
/// if one still is at the end.
double runToRest(Engine& engine, std::size_t first, std::size_t last, double seconds,
                 double speed = 0.01);

/// Mean normal force (N) between two bodies over the next second.
double meanForce(Engine& engine, std::size_t a, std::size_t b);

/// Kinetic and potential energy (J) of the dynamic bodies.
double energy(const Engine& engine, const scenes::SceneDef& scene);

inline double sizeOf(scenes::Vec2 v) {
    return std::sqrt(dot(v, v));
}

} // namespace crosscheck
