// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Scenes as plain data, independent of any engine, shared by tests, benchmark and sandbox. SI
/// units, x right, y up, polygons counter-clockwise. Only + - * / and sqrt are used, so the numbers
/// are bitwise equal on every machine.
namespace scenes {

struct Vec2 {
    double x = 0;
    double y = 0;
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(double s, Vec2 v) { return {s * v.x, s * v.y}; }
};

constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// A rotation as (cos, sin) of its angle.
struct Rot {
    double c = 1;
    double s = 0;
    friend constexpr Vec2 operator*(Rot q, Vec2 v) {
        return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
    }
};

/// The rotation of a slope that rises by `rise` over `run`.
inline Rot slope(double rise, double run) {
    const double size = std::sqrt(rise * rise + run * run);
    return {run / size, rise / size};
}

/// The rotation by twice the arctangent of `tangentOfHalf`, within half a turn, without
/// trigonometric functions.
constexpr Rot turnedBy(double tangentOfHalf) {
    const double t = tangentOfHalf;
    return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

struct Circle {
    double radius = 0;
    Vec2 center{};
};
struct Box {
    double width = 0;
    double height = 0;
    Vec2 center{};
};
inline std::vector<Vec2> cornersOf(const Box& box) {
    const Vec2 x{box.width / 2, 0};
    const Vec2 y{0, box.height / 2};
    return {box.center - x - y, box.center + x - y, box.center + x + y, box.center - x + y};
}

/// A disc drawn along a line.
struct Capsule {
    Vec2 from{};
    Vec2 to{};
    double radius = 0;
};
struct Polygon {
    std::vector<Vec2> corners; // counter-clockwise; at most 8, the limit of Box2D
};
using Part = std::variant<Circle, Box, Polygon, Capsule>;

struct Material {
    double friction = 0.6;
    double restitution = 0;
    double surfaceSpeed = 0; // m/s, of a belt that runs clockwise around the body
};

struct BodyDef {
    std::vector<Part> parts;
    Vec2 position{}; // m, of the frame of the parts
    Rot rotation{};
    Vec2 velocity{};    // m/s, of the centre of mass
    double spin = 0;    // rad/s, counter-clockwise
    double density = 1; // kg/m^2
    Material material{};
    bool locked = false;     // static, or kinematic if it has a velocity
    bool weightless = false; // not affected by gravity
    bool upright = false;    // never rotates
    bool sensor = false;     // detects overlap, without any response
    // Collision filter bits, for scenes with filtering. There, every body needs a category.
    std::uint16_t category = 0;
    std::uint16_t mask = 0; // categories to collide with; both masks must accept; 0: all
};

/// Angles of b relative to a, 0 at the start.
struct AngleLimits {
    double lower = 0; // rad
    double upper = 0; // rad
};

/// A revolute joint, optionally with a motor or limits. The two bodies do not collide.
struct RevoluteJointDef {
    std::size_t a = 0; // indices of bodies
    std::size_t b = 0;
    Vec2 point{};           // m, world, at the start
    double motorSpeed = 0;  // rad/s, of b relative to a
    double motorTorque = 0; // N m, maximum; 0: no motor
    std::optional<AngleLimits> limits{};
};

/// A static line; its upper side, from left to right.
struct ChainDef {
    std::vector<Vec2> points;
    Material material{};
};

struct SceneDef {
    std::string name;
    Vec2 gravity{}; // m/s^2
    std::vector<BodyDef> bodies;
    std::vector<RevoluteJointDef> joints{};
    std::vector<ChainDef> chains{};
    bool sleep = false; // of tests that compare: bodies at rest fall asleep
};

inline constexpr Vec2 kDown{0, -10}; // m/s^2, a round number for simple closed forms

inline BodyDef ball(double radius, Vec2 position, Material material = {}) {
    BodyDef def;
    def.parts = {Circle{radius}};
    def.position = position;
    def.material = material;
    return def;
}

inline BodyDef box(double width, double height, Vec2 position, Material material = {}) {
    BodyDef def;
    def.parts = {Box{width, height}};
    def.position = position;
    def.material = material;
    return def;
}

/// A static box with its top at y = 0: the ground, or a slope if rotated about the origin.
inline BodyDef ground(double width, Material material = {}, Rot rotation = {}) {
    BodyDef def = box(width, 2, rotation * Vec2{0, -1}, material);
    def.rotation = rotation;
    def.locked = true;
    return def;
}

/// Pseudorandom numbers, identical on every machine: SplitMix64.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// low <= result < high.
    double between(double low, double high) {
        constexpr double kUnit = 1.0 / 9007199254740992.0; // 2^-53
        return low + (high - low) * (static_cast<double>(next() >> 11) * kUnit);
    }
    /// 0 <= result < count.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

private:
    std::uint64_t state_;
};

/// A direction at a share (0..1) of the full turn, counter-clockwise from the x axis. Not uniform
/// in angle: interpolating the tangent of the half angle within each quadrant avoids trigonometric
/// functions.
inline Vec2 direction(double share) {
    double quarters = 4 * share;
    Vec2 quarter{1, 0};
    for (; quarters >= 1; quarters -= 1) {
        quarter = {-quarter.y, quarter.x};
    }
    const Rot turn = turnedBy(quarters);
    return Rot{quarter.x, quarter.y} * Vec2{turn.c, turn.s};
}

/// A convex polygon with `corners` corners on an ellipse around the origin. Corner k lies at the
/// share (k + jitter) / corners of the turn, so no two corners coincide.
inline Polygon randomPolygon(Dice& dice, std::size_t corners, double width, double height) {
    Polygon polygon;
    for (std::size_t k = 0; k < corners; ++k) {
        const double share = static_cast<double>(k) + dice.between(0, 0.6);
        const Vec2 corner = direction(share / static_cast<double>(corners));
        polygon.corners.push_back({corner.x * width / 2, corner.y * height / 2});
    }
    return polygon;
}

} // namespace scenes
