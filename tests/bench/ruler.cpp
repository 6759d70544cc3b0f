// SPDX-License-Identifier: MIT
#include "ruler.hpp"

#include <scenes/scene_mass.hpp>
#include <support/convex_oracle.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {
namespace {

using scenes::Vec2;

/// A part in world coordinates, with its bounds and the index of its body.
struct PlacedPart {
    support::Outline outline;
    Vec2 lower;
    Vec2 upper;
    std::size_t body = 0;
};

std::vector<Vec2> localCorners(const scenes::Part& part) {
    if (const auto* box = std::get_if<scenes::Box>(&part)) {
        return cornersOf(*box);
    }
    if (const auto* circle = std::get_if<scenes::Circle>(&part)) {
        return {circle->center};
    }
    return std::get<scenes::Polygon>(part).corners;
}

PlacedPart placedPart(const scenes::Part& part, const BodyState& where) {
    const auto* circle = std::get_if<scenes::Circle>(&part);
    const double radius = circle != nullptr ? circle->radius : 0;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    PlacedPart placed{{}, {kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
    placed.outline.radius = static_cast<long double>(radius);
    for (const Vec2 local : localCorners(part)) {
        const Vec2 corner = where.position + where.rotation * local;
        placed.outline.corners.push_back(
            {static_cast<long double>(corner.x), static_cast<long double>(corner.y)});
        placed.lower = {std::min(placed.lower.x, corner.x - radius),
                        std::min(placed.lower.y, corner.y - radius)};
        placed.upper = {std::max(placed.upper.x, corner.x + radius),
                        std::max(placed.upper.y, corner.y + radius)};
    }
    return placed;
}

double overlapOf(const PlacedPart& a, const PlacedPart& b) {
    return static_cast<double>(-separationOf(a.outline, b.outline));
}

bool mayCollide(const scenes::BodyDef& a, const scenes::BodyDef& b) {
    const auto accepts = [](const scenes::BodyDef& one, const scenes::BodyDef& other) {
        return one.mask == 0 || (one.mask & other.category) != 0;
    };
    return !(a.locked && b.locked) && accepts(a, b) && accepts(b, a);
}

bool isFinite(const BodyState& state) {
    return std::isfinite(state.position.x) && std::isfinite(state.position.y) &&
           std::isfinite(state.rotation.c) && std::isfinite(state.rotation.s);
}

/// Sorted by their left bounds.
std::vector<PlacedPart> partsOf(const std::vector<Placed>& bodies) {
    std::vector<PlacedPart> parts;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (const scenes::Part& part : bodies[i].def->parts) {
            if (isFinite(bodies[i].state)) {
                parts.push_back(placedPart(part, bodies[i].state));
                parts.back().body = i;
            }
        }
    }
    std::stable_sort(parts.begin(), parts.end(), [](const PlacedPart& one, const PlacedPart& two) {
        return one.lower.x < two.lower.x;
    });
    return parts;
}

} // namespace

double overlapOf(const scenes::Part& a, const BodyState& whereA, const scenes::Part& b,
                 const BodyState& whereB) {
    return overlapOf(placedPart(a, whereA), placedPart(b, whereB));
}

ExcludedPairs jointedPairs(const scenes::SceneDef& scene) {
    ExcludedPairs pairs;
    for (const scenes::RevoluteJointDef& joint : scene.joints) {
        pairs.insert(std::minmax(joint.a, joint.b));
    }
    return pairs;
}

Depths depthsOf(const std::vector<Placed>& bodies, const ExcludedPairs& excluded) {
    const std::vector<PlacedPart> parts = partsOf(bodies);
    Depths depths;
    double sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PlacedPart& a = parts[i];
        for (std::size_t k = i + 1; k < parts.size() && parts[k].lower.x < a.upper.x; ++k) {
            const PlacedPart& b = parts[k];
            const bool near = b.lower.y < a.upper.y && a.lower.y < b.upper.y;
            if (!near || a.body == b.body ||
                !mayCollide(*bodies[a.body].def, *bodies[b.body].def) ||
                excluded.contains(std::minmax(bodies[a.body].body, bodies[b.body].body))) {
                continue;
            }
            const double depth = overlapOf(a, b);
            if (depth > 0) {
                ++depths.pairs;
                sum += depth;
                depths.max = std::max(depths.max, depth);
            }
        }
    }
    depths.mean = depths.pairs == 0 ? 0 : sum / static_cast<double>(depths.pairs);
    return depths;
}

double kineticEnergy(const std::vector<Placed>& bodies) {
    double sum = 0;
    for (const Placed& body : bodies) {
        if (!body.def->locked) {
            const scenes::Mass mass = massOf(*body.def);
            const BodyState& now = body.state;
            sum +=
                (mass.mass * dot(now.velocity, now.velocity) + mass.inertia * now.spin * now.spin) /
                2;
        }
    }
    return sum;
}

Drift driftOf(const std::vector<Placed>& bodies) {
    Drift displacement;
    for (const Placed& body : bodies) {
        if (body.def->locked) {
            continue;
        }
        const Vec2 way = body.state.position - body.def->position;
        displacement.sideways = std::max(displacement.sideways, std::abs(way.x));
        displacement.down = std::max(displacement.down, -way.y);
        displacement.stood += std::abs(way.x) <= 0.25 && way.y >= -1 ? 1 : 0;
    }
    return displacement;
}

std::size_t escapedFrom(const Region& region, const std::vector<Placed>& bodies) {
    BodyState frame;
    for (const Placed& body : bodies) {
        if (region.frame == body.body) {
            frame = body.state;
        }
    }
    const scenes::Rot back{frame.rotation.c, -frame.rotation.s};
    const auto outside = [&](const Placed& body) {
        const Vec2 p = back * (body.state.position - frame.position);
        const bool in = p.x >= region.lower.x && p.x <= region.upper.x && // false for NaN
                        p.y >= region.lower.y && p.y <= region.upper.y;
        return !body.def->locked && !in;
    };
    return static_cast<std::size_t>(std::count_if(bodies.begin(), bodies.end(), outside));
}

} // namespace bench
