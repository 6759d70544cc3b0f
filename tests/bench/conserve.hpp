// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

/// Energy and momentum over time, for tools/trade --dials: small scenes with known conserved
/// quantities, in one precision of Kodo.
namespace conserve {

struct Run {
    std::string scene;
    double dt = 1.0 / 60; // s
    double seconds = 10;
    double ratio = 1;                      // of masses, where the scene has one
    bool propagation = false;              // the solver of the thesis
    std::map<std::string, double> numbers; // of the settings: substeps, jointHertz, ...
};

struct Sample {
    double time = 0;     // s
    double energy = 0;   // change since the start, as share of the energy that is exchanged
    double momentum = 0; // change of the linear momentum, as share of that of the fastest part
    double angular = 0;  // change of the angular momentum, as share of its scale
};

struct Series {
    std::vector<Sample> samples; // at most 240
    double error = 0;            // of the scene: see errorName
    std::string errorName;
    bool lost = false;       // collapsed, or not finite
    double microseconds = 0; // CPU time a simulated second
};

namespace f32 {
Series play(const Run& run);
}
namespace f64 {
Series play(const Run& run);
}

} // namespace conserve
