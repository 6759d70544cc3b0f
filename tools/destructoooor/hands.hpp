// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace destructoooor {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

// What a hand can do in a World, through the public interface alone. Points are in the world (m).

/// Shapes that can be dropped.
enum class Thing : std::uint8_t { Box, Ball, Polygon, Plank, Capsule, Cross };
inline constexpr std::array<std::string_view, 6> kThingNames = {"box",   "ball",    "polygon",
                                                                "plank", "capsule", "cross"};

/// `seed` chooses among polygons. Throws BadDefinition.
BodyId drop(kodo::World& world, Thing what, Vec2 place, Real size, const kodo::Material& material,
            std::uint64_t seed);

/// A dynamic body with a closed outline, which may end where it began; or a sentence why there is
/// none, which counts points from 1.
std::variant<BodyId, std::string> draw(kodo::World& world, std::span<const Vec2> outline);

/// The dynamic body at a point, the last one that was added.
std::optional<BodyId> bodyAt(const kodo::World& world, Vec2 point);

/// Impulses away from a point on all dynamic bodies within a radius (m); speed: m/s at the point.
void explode(kodo::World& world, Vec2 place, Real radius, Real speed);

/// Splits a body along the line through a point; its halves keep their velocities, and joints go to
/// the half on which they are. Returns the half on the side of the normal, and the other one;
/// nothing if the line does not meet the body.
std::optional<std::pair<BodyId, BodyId>> split(kodo::World& world, BodyId body, Vec2 point,
                                               Vec2 normal);
/// Splits all dynamic bodies that a line meets. Returns how many.
int cut(kodo::World& world, Vec2 from, Vec2 to);
/// Splits a body through a point, and its pieces again: up to eight pieces.
void shatter(kodo::World& world, BodyId body, Vec2 point);

/// A static body that nothing touches, to hang joints on.
BodyId addPost(kodo::World& world, Vec2 place);
/// Pins the two bodies at a point to each other, or one to a post. With a speed (rad/s) a motor
/// turns it. False if there is no body.
bool pinAt(kodo::World& world, Vec2 point, Real motorSpeed = 0);
/// A rope, or a spring with hertz > 0, between what is at two points; where there is no body, a
/// post. False if there is no body at all.
bool tie(kodo::World& world, Vec2 from, Vec2 to, Real hertz = 0);

} // namespace destructoooor
