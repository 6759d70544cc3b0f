// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>

#include <cmath>
#include <utility>

namespace apart {

using kodo::Box;
using kodo::Circle;
using kodo::Real;
using kodo::Vec2;

namespace {

// Lean of the cuts around the part of a block, see cutOutMiddle().
constexpr Real kWeldLean = Real(0.4);    // a keystone
constexpr Real kLaunchLean = Real(-0.4); // an arrowhead
constexpr Real kMoodLean = Real(0.2);    // good powers are wider at the top, bad ones at the bottom

kodo::BodyDef wallDef(Real width, Real height, Vec2 center) {
    return {.shape = Box{width, height},
            .position = center,
            .material = kodo::withFriction(Real(0.3), 1),
            .type = kodo::BodyType::Static,
            .flags = flagsOf(Role::Wall)};
}

Piece polygonPiece(kodo::Polygon polygon, Real density, Role role) {
    const kodo::Mass mass = massOf(polygon, density);
    return {std::move(polygon), density, role, mass};
}

std::vector<Piece> ballPieces() {
    std::vector<Piece> pieces;
    for (int i = 0; i < kSplitBalls; ++i) {
        const Real share = static_cast<Real>(2 * i + 1) / (2 * kSplitBalls) - Real(0.5);
        const Vec2 center{share * kCellWidth, 0};
        kodo::Mass mass = massOf(Circle{kBallRadius}, kBallDensity);
        mass.center = center;
        pieces.push_back({Circle{kBallRadius, center}, kBallDensity, Role::Ball, mass});
    }
    return pieces;
}

Real leanOf(Power power) {
    if (power == Power::Weld || power == Power::Launch) {
        return power == Power::Weld ? kWeldLean : kLaunchLean;
    }
    switch (moodOf(power)) {
    case Mood::Good:
        return kMoodLean;
    case Mood::Mixed:
        return 0;
    case Mood::Bad:
        break;
    }
    return -kMoodLean;
}

std::vector<Piece> partPieces(const BlockKind& kind, Vec2 size) {
    std::vector<Piece> pieces;
    for (kodo::Polygon& polygon : cutOutMiddle(size.x, size.y, leanOf(kind.power))) {
        const bool middle = pieces.empty();
        pieces.push_back(polygonPiece(std::move(polygon), middle ? kPartDensity : densityOf(kind),
                                      middle ? Role::Part : Role::Shard));
    }
    return pieces;
}

} // namespace

std::array<kodo::BodyDef, 3> wallDefs() {
    const Real height = kFieldHeight + kWallThickness + kWallBelow;
    const Real middle = (kFieldHeight + kWallThickness - kWallBelow) / 2;
    const Real x = (kFieldWidth + kWallThickness) / 2;
    return {wallDef(kWallThickness, height, {-x, middle}),
            wallDef(kWallThickness, height, {x, middle}),
            wallDef(kFieldWidth, kWallThickness, {0, kFieldHeight + kWallThickness / 2})};
}

kodo::BodyDef paddleDef(Real x) {
    return {.shape = paddleShape(),
            .position = {x, kPaddleY},
            .material = kPaddleMaterial,
            .density = kPaddleDensity,
            .type = kodo::BodyType::Kinematic,
            .flags = flagsOf(Role::Paddle)};
}

std::array<kodo::Polygon, 2> wingShapes() {
    const kodo::Polygon right{
        {{Real(1.9), Real(-0.25)}, {3, Real(0.45)}, {Real(2.85), Real(0.65)}, {Real(1.9), 0}}};
    kodo::Polygon left;
    for (std::size_t i = right.corners.size(); i-- > 0;) { // mirrored, so in reverse order
        left.corners.push_back({-right.corners[i].x, right.corners[i].y});
    }
    return {left, right};
}

bool isGone(Vec2 place) {
    constexpr Real kOutside = Real(1.5); // m
    return place.y < -kOutside || place.y > kFieldHeight + kOutside ||
           std::abs(place.x) > kFieldWidth / 2 + kOutside;
}

Vec2 centerOf(const Cell& cell) {
    const Real columns = static_cast<Real>(2 * cell.column + 1) / 2;
    const Real rows = static_cast<Real>(2 * cell.row + 1) / 2;
    return {columns * kCellWidth - kFieldWidth / 2, kFieldHeight - rows * kCellHeight};
}

kodo::BodyDef blockDef(const BlockKind& kind, const PlacedShape& placed) {
    kodo::BodyDef def{.shape = placed.shape,
                      .position = placed.frame.position,
                      .rotation = placed.frame.rotation,
                      .material = kBlockMaterial,
                      .density = densityOf(kind),
                      .type = kodo::BodyType::Kinematic,
                      .flags = flagsOf(Role::Block)};
    if (kind.power != Power::None) {
        Real mass = 0;
        for (const Piece& piece : piecesOf(kind, placed.shape, {}, 0)) {
            mass += piece.mass.mass;
        }
        const Vec2 size = extentOf(placed.shape).extent();
        def.density = mass / (size.x * size.y);
    }
    return def;
}

kodo::BodyDef blockDef(const BlockKind& kind, Vec2 center) {
    return blockDef(kind, {Box{kCellWidth, kCellHeight}, {center, {}}});
}

std::int32_t pointsOf(const BlockKind& kind) {
    return kPoints[static_cast<std::size_t>(kind.stuff)] +
           (kind.power == Power::None ? 0 : kPowerPoints);
}

Real densityOf(const BlockKind& kind) {
    return kStuffDensity[static_cast<std::size_t>(kind.stuff)];
}

PieceLimits shardLimits() {
    return {kLeastArea * kCellWidth * kCellHeight, kLeastWidth * kCellHeight};
}

Real shardStrength(Stuff stuff, Real area) {
    const auto whole = static_cast<Real>(kStrength[static_cast<std::size_t>(stuff)]) / 1000;
    return whole * kShardToughness * area / (kCellWidth * kCellHeight);
}

std::vector<Piece> piecesOf(const BlockKind& kind, const kodo::Shape& shape, Vec2 hit,
                            std::uint64_t key) {
    if (kind.power == Power::Split) {
        return ballPieces();
    }
    if (kind.power != Power::None) {
        return partPieces(kind, extentOf(shape).extent());
    }
    std::vector<Piece> pieces;
    for (const kodo::Polygon& whole : polygonsOf(shape)) {
        for (kodo::Polygon& polygon : fracture(whole, hit, kind.pattern, shardLimits(), key)) {
            pieces.push_back(polygonPiece(std::move(polygon), densityOf(kind), Role::Shard));
        }
    }
    return pieces;
}

kodo::BodyDef pieceDef(const Piece& piece, const PieceMotion& motion,
                       const kodo::Transform& frame) {
    return {.shape = piece.shape,
            .position = frame.position,
            .rotation = frame.rotation,
            .velocity = motion.velocity,
            .angularVelocity = motion.spin,
            .material = piece.role == Role::Part ? kPartMaterial : kShardMaterial,
            .density = piece.density,
            .flags = flagsOf(piece.role) | kFalls};
}

} // namespace apart
