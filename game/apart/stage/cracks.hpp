// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>
#include <kodo/shapes/convex.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// One straight piece of a crack (m), from the middle of its block.
struct CrackLine {
    Vec2 from;
    Vec2 to;
    Real width = 0;
};

/// The cracks that grow from the point of an impact, in the outline's frame, into it. The same
/// arguments always give the same cracks. `damage` 0..1 is the share of the strength that is gone.
std::vector<CrackLine> growCracks(const kodo::Convex& outline, Vec2 point, Real damage,
                                  std::uint32_t seed);

/// The cracks of all blocks that were hit and still stand.
class Cracks {
public:
    /// Blocks go by their key, which is theirs for life.
    void add(std::uint32_t block, const kodo::Convex& outline, Vec2 point, Real damage);
    void forget(std::uint32_t block);
    std::span<const CrackLine> of(std::uint32_t block) const;

private:
    struct Entry {
        std::uint32_t block;
        std::vector<CrackLine> lines;
    };
    std::vector<Entry> entries_;
};

} // namespace apart
