// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bench_engine.hpp"

/// Overlap measurement common to all engines, from nominal shapes and reported poses, independent
/// of any solver. In long double, by brute force after a sweep along x.
namespace bench {

/// A body with its definition and current state.
struct Placed {
    std::size_t body = 0; // index in the scene
    const scenes::BodyDef* def = nullptr;
    BodyState state;
};

/// Overlap (m) of two parts: along the best edge normal for polygons, to the nearest boundary point
/// for circles. Negative if they are separated.
double overlapOf(const scenes::Part& a, const BodyState& whereA, const scenes::Part& b,
                 const BodyState& whereB);

struct Depths {
    std::size_t pairs = 0; // number of overlapping parts
    double max = 0;        // m
    double mean = 0;       // m, over these pairs
};

/// Excluded pairs of bodies, which do not collide by definition.
using ExcludedPairs = std::set<std::pair<std::size_t, std::size_t>>;
ExcludedPairs jointedPairs(const scenes::SceneDef& scene);

/// Overlaps between parts of different bodies that may collide, of which at least one is dynamic.
Depths depthsOf(const std::vector<Placed>& bodies, const ExcludedPairs& excluded);

/// Kinetic energy (J) of the dynamic bodies.
double kineticEnergy(const std::vector<Placed>& bodies);

/// Displacement of bodies from their definition.
struct Drift {
    std::size_t stood = 0; // bodies within 0.25 m horizontally and 1 m downwards of their start
    double sideways = 0;   // m, maximum
    double down = 0;       // m, maximum; 0 if all have risen
};
Drift driftOf(const std::vector<Placed>& bodies);

/// A rectangle that should contain the origins of all bodies.
struct Region {
    scenes::Vec2 lower;
    scenes::Vec2 upper;
    std::optional<std::size_t> frame{}; // index of the body that carries the rectangle
};
/// Number of dynamic bodies outside the region or without finite state.
std::size_t escapedFrom(const Region& region, const std::vector<Placed>& bodies);

} // namespace bench
