// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sandbox.hpp"

namespace destructoooor {

/// A parameter of the simulation, changed by a slider or by keys. A switch has the values 0 and 1.
struct Knob {
    std::string label;
    double low = 0;
    double high = 1;
    double stride = 1; // change per key press; values are low plus multiples of it
    std::function<double(const Sandbox&)> value;
    std::function<void(Sandbox&, double)> set;
    std::vector<std::string> words{}; // shown instead of the values, from `low` on
};

std::vector<Knob> makeKnobs();

/// The nearest value on the grid of the knob.
double snapped(const Knob& knob, double value);
/// The present value as text.
std::string valueText(const Knob& knob, const Sandbox& sandbox);

} // namespace destructoooor
