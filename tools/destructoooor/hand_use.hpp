// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox.hpp"

namespace destructoooor {

/// What a pointer does in the scene.
enum class Hand : std::uint8_t {
    Drag,
    Drop,
    Draw,
    Cut,
    Shatter,
    Weld,
    Pin,
    Motor,
    Rope,
    Spring,
    Explode
};
struct HandWords {
    std::string_view name;
    std::string_view what;
};
inline constexpr std::array<HandWords, 11> kHands = {{
    {"Drag", "Hold a body and throw it."},
    {"Drop", "Click: a new body. Wheel: its size."},
    {"Draw", "Draw an outline; it becomes a body."},
    {"Cut", "Draw a line; it cuts what it meets."},
    {"Shatter", "Click: a body breaks into pieces."},
    {"Weld", "From one body to another: they become one."},
    {"Pin", "Click: pins two bodies, or one to the wall."},
    {"Motor", "Click: a pin with a motor."},
    {"Rope", "From one point to another: a rope."},
    {"Spring", "From one point to another: a spring."},
    {"Explode", "Click: pushes all around away."},
}};

/// What Hand::Drop makes.
struct Dropped {
    Thing thing = Thing::Box;
    float size = 1; // m
};

inline constexpr Real kPathStride = Real(0.15); // m, between points of a drawn line

/// Does what a hand does along the way of the pointer (m), from its press to its release, which is
/// the last point and no corner of a drawn outline. Nothing for Hand::Drag, which Sandbox::grab()
/// and its siblings are for. Returns why not, or an empty text.
std::string use(Sandbox& sandbox, Hand hand, std::span<const Vec2> path, const Dropped& dropped);

/// A pointer from its press to its release, and what its hand does meanwhile. Points are in m.
class Stroke {
public:
    void press(Sandbox& sandbox, Hand hand, Vec2 at);
    void move(Sandbox& sandbox, Vec2 at);
    /// The hand acts. Returns why it does nothing, or an empty text.
    std::string release(Sandbox& sandbox, const Dropped& dropped, Vec2 at);
    /// The hand lets go and does not act: the pointer is wanted for something else.
    void abandon(Sandbox& sandbox);

    bool isDown() const { return !path_.empty(); }
    std::span<const Vec2> path() const { return path_; }

private:
    Hand hand_ = Hand::Drag; // that of the press
    std::vector<Vec2> path_; // since the press
};

/// Draws water, the World, and the outlines of the second World.
void drawScene(const Sandbox& sandbox, kodo::DebugDraw& picture, const kodo::DrawOptions& look);

} // namespace destructoooor
