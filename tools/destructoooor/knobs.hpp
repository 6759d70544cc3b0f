// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sandbox.hpp"

namespace destructoooor {

/// One number of the integration that a slider, or a key, moves. A switch goes from 0 to 1.
struct Knob {
    std::string label;
    double low = 0;
    double high = 1;
    double stride = 1; // of a key; values are multiples of it
    std::function<double(const Sandbox&)> value;
    std::function<void(Sandbox&, double)> set;
    std::vector<std::string> words{}; // instead of the number, from `low` on
};

std::vector<Knob> makeKnobs();

/// The nearest value that the knob can take.
double snapped(const Knob& knob, double value);
/// As it is shown.
std::string valueText(const Knob& knob, const Sandbox& sandbox);

} // namespace destructoooor
