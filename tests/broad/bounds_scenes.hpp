// SPDX-License-Identifier: MIT
#pragma once

#include <support/random_numbers.hpp>

#include "broad/bounds_pair.hpp"
#include "math/octagon.hpp"

namespace kodo::bounds_scenes {

inline std::vector<BoundsPair> byBruteForce(const std::vector<Octagon>& bounds) {
    std::vector<BoundsPair> pairs;
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
        for (std::uint32_t k = i + 1; k < bounds.size(); ++k) {
            if (overlap(bounds[i], bounds[k])) {
                pairs.push_back({i, k});
            }
        }
    }
    return pairs;
}

inline Octagon boxAt(Real x, Real y, Real width = 1, Real height = 1) {
    return Octagon::of(Aabb{{x, y}, {x + width, y + height}});
}

/// Boxes with corners cut off: by up to half of each diagonal extent at either end.
inline std::vector<Octagon> randomScene(support::RandomNumbers& random, std::size_t count) {
    const double wide = static_cast<double>(random.between(1, 40));
    const double high = static_cast<double>(random.between(1, 40));
    std::vector<Octagon> bounds;
    for (std::size_t i = 0; i < count; ++i) {
        const Real x = random.between(-wide, wide);
        const Real y = random.between(-high, high);
        const Real width = random.between(0, 2);
        Octagon octagon = boxAt(x, y, width, random.between(0, 2));
        for (const int diagonal : {2, 3}) {
            const Real length = octagon.upper[diagonal] - octagon.lower[diagonal];
            octagon.lower[diagonal] += length * random.between(0, 0.5);
            octagon.upper[diagonal] -= length * random.between(0, 0.5);
        }
        bounds.push_back(octagon);
    }
    return bounds;
}

} // namespace kodo::bounds_scenes
