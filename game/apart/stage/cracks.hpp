// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <kodo/world/world.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// One straight piece of a crack, in the frame of the block's outline (m).
struct CrackLine {
    Vec2 from;
    Vec2 to;
    Real width = 0;
};

/// The cracks that grow from the point of an impact into an outline. The same arguments always give
/// the same cracks. `damage` 0..1 is the share of the strength that is gone.
std::vector<CrackLine> growCracks(const kodo::Convex& outline, Vec2 point, Real damage,
                                  std::uint32_t seed);

/// The cracks of all blocks that were hit and still stand.
class Cracks {
public:
    void add(const kodo::BodyView& block, Vec2 worldPoint, Real damage);
    void forget(kodo::BodyId block);
    std::span<const CrackLine> of(kodo::BodyId block) const;

private:
    struct Entry {
        kodo::BodyId block;
        std::vector<CrackLine> lines;
    };
    std::vector<Entry> entries_;
};

} // namespace apart
