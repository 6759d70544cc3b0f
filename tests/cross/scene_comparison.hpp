// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "cross_scene.hpp"

namespace crosscheck {

/// A number that a scene compares.
enum class What { X, Y, Angle, Speed, Spin, Highest, Lowest, Touch, Impulse, Energy };
struct WhatWords {
    std::string_view name;
    std::string_view unit;
};
inline constexpr std::array<WhatWords, 10> kWhats{{{"x", "m"},
                                                   {"y", "m"},
                                                   {"angle", "rad"},
                                                   {"speed", "m/s"},
                                                   {"spin", "rad/s"},
                                                   {"highest", "m"},
                                                   {"lowest", "m"},
                                                   {"touch", "s"},
                                                   {"impulse", "N s"},
                                                   {"energy", "J"}}};

struct Comparison {
    What what = What::X;
    std::size_t a = 0;
    std::size_t b = 0;
    long step = 0; // after which the number is taken
};

/// Plays the scene and takes its numbers.
class Measure {
public:
    Measure(scenes::SceneDef def, std::vector<Link> links, std::vector<Comparison> all, double rate)
        : def_(std::move(def)), links_(std::move(links)), all_(std::move(all)), rate_(rate) {}

    std::vector<double> operator()(Engine& engine, long steps) const;

private:
    double number(const Engine& engine, const Comparison& one, const State& at) const;
    void follow(const Engine& engine, const Comparison& one, double time, double& value) const;

    scenes::SceneDef def_;
    std::vector<Link> links_;
    std::vector<Comparison> all_;
    double rate_;
};

} // namespace crosscheck
