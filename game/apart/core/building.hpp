// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

// Free blocks and joints of a level: the parts of buildings and machines. Unlike the blocks of the
// grid they have any place, angle and size. All numbers are integers, as in Level.

/// Shape of a free block. The first four are rectangles.
enum class Form : std::uint8_t {
    Brick,
    Beam,
    Plank,
    Square,
    Wedge, // right triangle; its height is on the right
    Gable, // isosceles triangle
    Round,
    Wheel,    // round, drawn with spokes
    Voussoir, // stone of an arch: a sector of a ring, with straight sides
    L,        // a column on the left, on a foot
    T,        // a bar on a stem
};
inline constexpr std::array<std::string_view, 11> kFormNames = {
    "brick", "beam", "plank", "square", "wedge", "gable", "round", "wheel", "voussoir", "L", "T"};

constexpr bool isRectangle(Form form) {
    return form <= Form::Square;
}
constexpr bool isRound(Form form) {
    return form == Form::Round || form == Form::Wheel;
}

/// A free block of a level.
struct FreeBlock {
    std::uint8_t kind = 0; // index into Level::kinds
    Form form = Form::Brick;
    bool mirrored = false;   // left and right exchanged
    std::int32_t x = 0;      // 1/1000 m, of its middle; of the centre of the ring of a voussoir
    std::int32_t y = 0;      // 1/1000 m
    std::int32_t turn = 0;   // 1/1000 degree, counter-clockwise; of a voussoir from the crown
    std::int32_t width = 0;  // 1/1000 m; diameter of a round one; inner radius of a voussoir
    std::int32_t height = 0; // 1/1000 m; of a voussoir along the radius
    std::int32_t extra = 0;  // 1/1000 m, thickness of L and T; 1/1000 degree, angle of a voussoir

    friend bool operator==(const FreeBlock&, const FreeBlock&) = default;
};

/// A block of the usual size of its form, at the origin. A voussoir has a radius of 2 m and spans
/// 30 degrees.
FreeBlock usualBlock(Form form);

/// The shape of a free block in its frame, and the place of that frame in the field.
struct PlacedShape {
    kodo::Shape shape;
    kodo::Transform frame;
};
PlacedShape placedShapeOf(const FreeBlock& block);

/// Kinds of joints of a level.
enum class LinkKind : std::uint8_t {
    Pin,    // a hinge
    Rope,   // the ends are at most its length apart
    Spring, // pulls and pushes along its line
    Slider, // b slides along a line fixed to a
    Motor,  // a hinge that turns b
};
inline constexpr std::array<std::string_view, 5> kLinkNames = {"pin", "rope", "spring", "slider",
                                                               "motor"};

/// A joint between two free blocks, or between the field and a free block.
struct LinkDef {
    LinkKind kind = LinkKind::Pin;
    std::int32_t a = -1;    // index into Level::freeBlocks; -1: the field
    std::int32_t b = 0;     // index into Level::freeBlocks
    std::int32_t fromX = 0; // 1/1000 m, world: the place of a pin, motor or slider; the end at a of
    std::int32_t fromY = 0; // a rope or spring
    std::int32_t toX = 0;   // 1/1000 m, world: the end at b of a rope or spring
    std::int32_t toY = 0;
    std::int32_t slack = 0; // 1/1000 m, of a rope or spring beyond the distance of its ends
    std::int32_t hertz = 0; // 1/1000 Hz, stiffness of a spring
    std::int32_t axis = 0;  // 1/1000 degree, direction of a slider
    bool limited = false;   // low and high are given
    std::int32_t low = 0;   // limits: 1/1000 degree of a pin, 1/1000 m of a slider
    std::int32_t high = 0;
    std::int32_t speed = 0;    // 1/1000 rad/s, of a motor
    std::int32_t torque = 0;   // 1/1000 N m, of a motor; friction of a pin
    std::int32_t strength = 0; // 1/1000 N; a larger force breaks the joint; 0: unbreakable

    friend bool operator==(const LinkDef&, const LinkDef&) = default;
};

/// A way to bring a building down, an honour: what the ball did before the largest fall.
struct WayDef {
    std::string name;    // shown to the player
    std::string strikes; // letters of blocks, one of which it had struck last; empty: any block
    // Whether it had touched a wall or an obstruction before its first block; nullopt: either.
    std::optional<bool> bank{};

    friend bool operator==(const WayDef&, const WayDef&) = default;
};
inline constexpr std::size_t kMostWays = 3; // of a level

/// The joint between two bodies that are at their places at the start of the level.
kodo::JointDef jointOf(const LinkDef& link, kodo::BodyView a, kodo::BodyView b);

/// The polygons of a shape, in its frame. A circle becomes a polygon of the same area.
std::vector<kodo::Polygon> polygonsOf(const kodo::Shape& shape);
kodo::Aabb extentOf(const kodo::Shape& shape);  // m, in its frame
kodo::Aabb boundsOf(const PlacedShape& placed); // m, in the field
/// The shape of a block about its middle: of its body, or of one part of a body of many blocks.
kodo::Shape shapeOfBlock(kodo::BodyView body, std::size_t part, bool ownsBody);

} // namespace apart
