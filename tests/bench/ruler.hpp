// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "bench_engine.hpp"

/// One ruler for all engines: it knows the nominal shapes and where an engine says that they are,
/// and shares nothing with any solver. In long double, by brute force behind a sweep along x.
namespace bench {

/// A body as it was defined, and where it is now.
struct Placed {
    std::size_t body = 0; // its place in the scene
    const scenes::BodyDef* def = nullptr;
    BodyState state;
};

/// How deep a pair of parts overlaps (m): along the best of all edge normals for polygons, to the
/// nearest point of the outline for circles; negative when they are apart.
double overlapOf(const scenes::Part& a, const BodyState& whereA, const scenes::Part& b,
                 const BodyState& whereB);

struct Depths {
    std::size_t pairs = 0; // of parts that overlap
    double max = 0;        // m
    double mean = 0;       // m, over those pairs
};

/// Pairs of bodies that do not touch by their definition.
using Apart = std::set<std::pair<std::size_t, std::size_t>>;
Apart pinnedPairs(const scenes::SceneDef& scene);

/// Of all parts of different bodies, of which one at least is not locked, that should not overlap.
Depths depthsOf(const std::vector<Placed>& bodies, const Apart& apart);

/// J, of all bodies that are not locked.
double kineticEnergy(const std::vector<Placed>& bodies);

/// How far bodies have gone from where their definition put them.
struct Drift {
    std::size_t stood = 0; // bodies within 0.25 m sideways and 1 m down of their start
    double sideways = 0;   // m, the farthest
    double down = 0;       // m, the farthest; 0 if all have risen
};
Drift driftOf(const std::vector<Placed>& bodies);

/// A rectangle that nothing should leave.
struct Region {
    scenes::Vec2 lower;
    scenes::Vec2 upper;
};
/// Bodies that are not locked and are outside, or nowhere: not finite.
std::size_t escapedFrom(const Region& region, const std::vector<Placed>& bodies);

} // namespace bench
