// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine.hpp"

namespace crosscheck {

inline constexpr double kDt = 1.0 / 60; // s, a common step size of both engines
inline constexpr double kPi = 3.14159265358979323846;

/// One measured value of both engines.
struct Both {
    double kodo = 0;
    double box2d = 0;
};

/// The measured values of one test, with the kind of agreement and the tolerance of each row.
/// holds() is false if a row fails, and prints all rows. With CROSS_TABLES set, the table is always
/// printed.
class Comparison {
public:
    /// Both engines agree with each other.
    void agree(const std::string& what, Both figure, double tolerance);
    /// Both engines agree with the closed form.
    void witness(const std::string& what, double exact, Both figure, double tolerance);
    /// Only Kodo must agree with the closed form, since Box2D deviates by design. Both errors go
    /// into the test report.
    void judge(const std::string& what, double exact, Both figure, double tolerance);
    /// Printed in the table without a check.
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

/// Runs the same measurement in both engines; figures[i] is value i returned by `measure`.
std::vector<Both> inBoth(const scenes::SceneDef& scene,
                         const std::function<std::vector<double>(Engine&)>& measure,
                         double bounceThreshold = 1);

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

/// Kinetic and potential energy (J) of the dynamic bodies.
double energy(const Engine& engine, const scenes::SceneDef& scene);

} // namespace crosscheck
