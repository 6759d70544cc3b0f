// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene.hpp"

namespace destructoooor {

/// One stop of a guided tour: a scene with settings of its own, and what to look at.
struct Stop {
    std::string_view scene; // its name in the catalogue
    std::string_view text;
    std::string_view look; // at what, in the picture or among the measures
    kodo::StepSettings settings;
    Real seconds;        // after which the overlap is judged, if nothing was touched
    kodo::Range overlap; // mm, the deepest one that is expected then
    std::optional<kodo::StepSettings> beside{}; // of a second World from the same start
};

/// A lesson in some stops.
struct Tour {
    std::string_view name;
    std::string_view lesson;
    std::vector<Stop> stops;
};

/// The two lessons of the sandbox of 2006 [Thesis06, Appendix A].
std::span<const Tour> tours();

} // namespace destructoooor
