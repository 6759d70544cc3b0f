// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine.hpp"

namespace crosscheck {

inline constexpr double kDt = 1.0 / 60; // s; what users of both engines step with
inline constexpr double kPi = 3.14159265358979323846;

/// One figure from both engines.
struct Both {
    double kodo = 0;
    double box2d = 0;
};

/// The figures of one test. Each row says what must agree and how closely; holds() is false when
/// one does not, and shows all of them. All are shown always when CROSS_TABLES is set.
class Comparison {
public:
    /// The engines agree with each other.
    void agree(const std::string& what, Both figure, double tolerance);
    /// There is a closed form, and both agree with it.
    void witness(const std::string& what, double exact, Both figure, double tolerance);
    /// Box2D differs from the closed form by its design, so Kodo alone must agree with it. Both
    /// errors go into the test report.
    void judge(const std::string& what, double exact, Both figure, double tolerance);
    /// Nothing to agree on, but the table shows it.
    void show(const std::string& what, Both figure);

    testing::AssertionResult holds() const;

private:
    struct Row {
        std::string what;
        std::optional<double> exact;
        Both figure;
        double tolerance;
        bool good;
    };
    std::string table() const;

    std::vector<Row> rows_;
};

/// Runs the same measurement in both engines. figures[i] is what `measure` put at place i.
std::vector<Both> inBoth(const scenes::SceneDef& scene,
                         const std::function<std::vector<double>(Engine&)>& measure,
                         double bounceThreshold = 1);

void run(Engine& engine, double seconds, double dt = kDt);

/// The first blow between two bodies: the end of the first step with an impulse between them, and
/// the impulse of that step and the next two (Kodo may part a soft blow between two steps, and
/// Box2D follows an impact at its time with an ordinary one). The engine stands after these.
struct Hit {
    double time = -1; // s; -1: never
    double impulse = 0;
};
Hit runToHit(Engine& engine, std::size_t a, std::size_t b, double mostSeconds, double dt = kDt);

/// The time (s) from which on nothing among the bodies from `first` on moves faster than `speed`
/// (m/s or rad/s), or -1 if something does at the end.
double runToRest(Engine& engine, std::size_t first, std::size_t last, double seconds,
                 double speed = 0.01);

/// Kinetic and potential energy (J) of the bodies that move.
double energy(const Engine& engine, const scenes::SceneDef& scene);

} // namespace crosscheck
