// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <string>
#include <vector>

/// Energy and momentum over time, for tools/trade --dials: small scenes with known conserved
/// quantities, in one precision of Kodo, or in Box2D 3.
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
    double microseconds = 0; // CPU time a step
};

/// What a scene changes is given as shares of these.
struct Scales {
    double energy = 1;     // J
    double momentum = 0;   // kg m/s; 0: not conserved
    double angular = 0;    // kg m^2/s; 0: not conserved
    std::string errorName; // if `other` of measure() names none
};

struct Totals {
    double energy = 0; // J
    double px = 0;     // kg m/s
    double py = 0;
    double angular = 0; // kg m^2/s
};

/// Plays a scene of any engine. `other` is an error that energy does not tell, and its name; below
/// 0 there is none.
template <typename Step, typename Sum, typename Other>
Series measure(const Run& run, const Scales& scales, Step step, Sum totals, Other other) {
    const Totals start = totals();
    Series series;
    series.errorName = scales.errorName;
    const long steps = std::lround(run.seconds / run.dt);
    const long every = std::max(steps / 240, 1L);
    double worst = 0;
    double spent = 0; // s, in steps alone
    for (long i = 1; i <= steps; ++i) {
        const std::clock_t begin = std::clock();
        step();
        spent += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        const Totals now = totals();
        const double energy = (now.energy - start.energy) / scales.energy;
        worst = std::isfinite(energy) ? std::max(worst, std::abs(energy)) : 1e9;
        if (i % every == 0) {
            const double p = std::hypot(now.px - start.px, now.py - start.py);
            const double turn = std::abs(now.angular - start.angular);
            series.samples.push_back({static_cast<double>(i) * run.dt, energy,
                                      scales.momentum > 0 ? p / scales.momentum : 0,
                                      scales.angular > 0 ? turn / scales.angular : 0});
        }
    }
    series.microseconds = 1e6 * spent / static_cast<double>(steps);
    const double own = other(series.errorName);
    series.error = own >= 0 ? own : worst;
    const double lostFrom = run.scene == "net" ? 500 : run.scene == "mass ratio" ? 0.09 : 0.5;
    series.lost = run.scene == "crowd" ? worst > 1e3 : series.error > lostFrom;
    return series;
}

namespace f32 {
Series play(const Run& run);
}
namespace f64 {
Series play(const Run& run);
}

namespace v3 {
bool isBuilt();
Series play(const Run& run);
} // namespace v3

} // namespace conserve
