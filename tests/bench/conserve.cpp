// SPDX-License-Identifier: MIT
// Reads runs from the standard input, one a line: SCENE | NAME=VALUE ..., and prints a JSON object
// for each. Names: double, dt, seconds, ratio, propagation, box2d3, and the numbers of
// StepSettings. Without Box2D 3 in the build a run in it is null.
#include "conserve.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

namespace {

using namespace conserve;

std::string number(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return std::isfinite(value) ? digits : "null";
}

std::string asJson(const Series& series) {
    std::string text = R"({"error":)" + number(series.error) + R"(,"errorName":")" +
                       series.errorName + R"(","lost":)" + (series.lost ? "true" : "false") +
                       R"(,"us":)" + number(series.microseconds) + R"(,"samples":[)";
    for (const Sample& one : series.samples) {
        text += (text.back() == '[' ? "[" : ",[") + number(one.time) + "," + number(one.energy) +
                "," + number(one.momentum) + "," + number(one.angular) + "]";
    }
    return text + "]}";
}

} // namespace

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        const std::size_t bar = line.find('|');
        Run run;
        run.scene = line.substr(0, line.find_last_not_of(' ', bar - 1) + 1);
        std::istringstream words(line.substr(bar + 1));
        bool twice = false;
        bool inBox2d3 = false;
        for (std::string word; words >> word;) {
            const std::size_t equals = word.find('=');
            const std::string name = word.substr(0, equals);
            const double value = std::stod(word.substr(equals + 1));
            if (name == "double") {
                twice = value > 0;
            } else if (name == "box2d3") {
                inBox2d3 = value > 0;
            } else if (name == "dt") {
                run.dt = value;
            } else if (name == "seconds") {
                run.seconds = value;
            } else if (name == "ratio") {
                run.ratio = value;
            } else if (name == "propagation") {
                run.propagation = value > 0;
            } else {
                run.numbers[name] = value;
            }
        }
        if (inBox2d3) {
            std::cout << (v3::isBuilt() ? asJson(v3::play(run)) : "null") << std::endl;
        } else {
            std::cout << asJson(twice ? f64::play(run) : f32::play(run)) << std::endl;
        }
    }
    return 0;
}
