// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "sandbox.hpp"

namespace destructoooor {

/// One number of the simulation that can be changed while it runs. The names are those of the API.
struct Dial {
    std::string_view group{};
    std::string_view name{};
    std::string_view what{};  // what it does, in one line
    std::string_view price{}; // what it costs; empty: nothing that can be measured
    double low = 0;
    double high = 1;
    double stride = 1;
    std::function<double(const Sandbox&)> value{};
    std::function<void(Sandbox&, double)> set{};
    /// False where the present solver has no such number.
    std::function<bool(const Sandbox&)> shown = [](const Sandbox&) { return true; };
    std::vector<std::string_view> words{}; // instead of the numbers from `low` on
    std::string_view lowest{};             // a word for `low` alone; empty: its number
};

/// All dials, group by group.
const std::vector<Dial>& dials();

/// The profiles of settings.hpp by name.
struct Profile {
    std::string_view name;
    kodo::StepSettings settings;
};
std::span<const Profile> profiles();

/// The value moved to the raster of the dial, within its limits.
double snapped(const Dial& dial, double value);

} // namespace destructoooor
