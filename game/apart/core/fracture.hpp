// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/generator.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <span>
#include <utility>
#include <vector>

namespace apart {

// Fracture of convex polygons. All functions are pure and work in the frame of the whole polygon.
// The pieces are convex and cover the whole without overlap.

/// Lower limits of the size of a piece.
struct PieceLimits {
    kodo::Real area = 0;  // m^2
    kodo::Real width = 0; // m; see widthOf()
};

/// A straight line: the points p with dot(normal, p) == offset.
struct Line {
    kodo::Vec2 normal; // unit
    kodo::Real offset = 0;

    /// The side left of `direction` is the one that clipped() keeps.
    static Line through(kodo::Vec2 point, kodo::Vec2 direction);
    Line flipped() const { return {-normal, -offset}; }
};

kodo::Real areaOf(const kodo::Polygon& polygon);
/// Smallest distance (m) of two parallel lines that enclose the polygon.
kodo::Real widthOf(const kodo::Polygon& polygon);
kodo::Polygon rectangle(kodo::Real width, kodo::Real height); // centred at the origin

/// The part of the polygon with dot(normal, p) <= offset; no corners if it is empty.
kodo::Polygon clipped(const kodo::Polygon& polygon, const Line& line);

/// The pieces of `whole` after an impact at `hit`: at least two, or `whole` alone if it is too
/// small to break. All pieces are within the limits. The same key gives the same pieces.
std::vector<kodo::Polygon> fracture(const kodo::Polygon& whole, kodo::Vec2 hit, Pattern pattern,
                                    const PieceLimits& limits, std::uint64_t key);

/// A rectangle cut by two slanted lines into its middle (first) and its two sides. `lean` is the
/// slope dx/dy of the right line; if positive, the middle is wider at the top.
std::vector<kodo::Polygon> cutOutMiddle(kodo::Real width, kodo::Real height, kodo::Real lean);

/// Initial velocity of a piece.
struct PieceMotion {
    kodo::Vec2 velocity;
    kodo::Real spin = 0; // rad/s
};

/// The share of the impulse `impact` (N s) that the pieces receive. The mount of the block
/// takes the rest: its strength, and all that would make the pieces faster than kShardSpeed.
///
///   impact = mount + pieces,   |pieces| = max(0, min(|impact| - strength, mass kShardSpeed))
kodo::Vec2 impulseOnPieces(kodo::Vec2 impact, kodo::Real strength, kodo::Real mass);

/// Velocities of pieces with these masses after an impulse P (N s) at `hit`: the response of the
/// whole as a rigid body, plus outward kicks of `burst` m/s. The kicks have no net momentum and no
/// net angular momentum, so the sums over the pieces are P and hit x P.
std::vector<PieceMotion> motionOfPieces(std::span<const kodo::Mass> pieces, kodo::Vec2 hit,
                                        kodo::Vec2 impulse, kodo::Real burst);

} // namespace apart
