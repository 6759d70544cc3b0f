// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/generator.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <span>
#include <utility>
#include <vector>

namespace apart {

/// How a convex polygon comes apart. Everything here works in the frame of the whole, is a function
/// of its arguments alone, and gives convex pieces that cover the whole without overlap.

/// No piece is smaller than this.
struct PieceLimits {
    kodo::Real area = 0;  // m^2
    kodo::Real width = 0; // m; between the closest two parallel lines that hold the piece
};

/// A straight line: the points p with dot(normal, p) == offset.
struct Line {
    kodo::Vec2 normal; // unit
    kodo::Real offset = 0;

    /// Behind it, where clipped() keeps, lies what is on the left on the way.
    static Line through(kodo::Vec2 point, kodo::Vec2 direction);
    Line flipped() const { return {-normal, -offset}; }
};

kodo::Real areaOf(const kodo::Polygon& polygon);
/// Distance of the closest two parallel lines that hold the polygon.
kodo::Real widthOf(const kodo::Polygon& polygon);
kodo::Polygon rectangle(kodo::Real width, kodo::Real height); // about the origin

/// The part of the polygon with dot(normal, p) <= offset; no corners if there is none.
kodo::Polygon clipped(const kodo::Polygon& polygon, const Line& line);

/// The pieces of `whole` after a blow at `hit`: two or more, or `whole` alone if it is too small to
/// break. All are within the limits. The same key gives the same pieces.
std::vector<kodo::Polygon> fracture(const kodo::Polygon& whole, kodo::Vec2 hit, Pattern pattern,
                                    const PieceLimits& limits, std::uint64_t key);

/// A rectangle cut by two slanted lines into its middle (first) and its sides. Positive lean: the
/// middle is wider above; a share of the height.
std::vector<kodo::Polygon> cutOutMiddle(kodo::Real width, kodo::Real height, kodo::Real lean);

/// How a piece starts.
struct PieceMotion {
    kodo::Vec2 velocity;
    kodo::Real spin = 0; // rad/s
};

/// What of a blow (N s) reaches the pieces. The mount of a block takes as much as it can bear, its
/// strength, and all that would make the pieces faster than kShardSpeed:
///
///   impulse of the blow = mount + pieces,   0 <= pieces <= min(blow - strength, mass kShardSpeed)
kodo::Vec2 impulseOnPieces(kodo::Vec2 blow, kodo::Real strength, kodo::Real mass);

/// Motion of pieces with these masses after an impulse at `hit`: that of the whole, as a rigid body
/// would take the impulse, and outward kicks of `burst` m/s without net momentum or angular
/// momentum. So the sums over the pieces are those of the impulse: P, and hit x P.
std::vector<PieceMotion> motionOfPieces(std::span<const kodo::Mass> pieces, kodo::Vec2 hit,
                                        kodo::Vec2 impulse, kodo::Real burst);

} // namespace apart
