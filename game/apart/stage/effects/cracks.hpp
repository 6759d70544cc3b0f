// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <kodo/convex_shape.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// One straight segment of a crack (m), relative to the centre of its block.
struct CrackLine {
    Vec2 from;
    Vec2 to;
    Real width = 0;
};

/// Cracks that grow from the point of an impact into the convex shape, in the shape's frame.
/// Deterministic in its arguments. `damage` is the lost share of the strength, 0..1.
std::vector<CrackLine> growCracks(const kodo::ConvexShape& outline, Vec2 point, Real damage,
                                  std::uint32_t seed);

/// Cracks of all damaged blocks.
class Cracks {
public:
    /// `block` is the key of the block, constant for its lifetime.
    void add(std::uint32_t block, const kodo::ConvexShape& outline, Vec2 point, Real damage);
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
