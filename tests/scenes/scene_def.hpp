// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// Scenes as plain data that knows no engine: the tests, the benchmark and the sandbox build the
/// same scene from it. SI units, x right, y up, polygons counter-clockwise. Only + - * / and sqrt
/// go into the numbers, so that a scene has the same bits on every machine.
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

/// An orientation as (cos, sin) of its angle.
struct Rot {
    double c = 1;
    double s = 0;
    friend constexpr Vec2 operator*(Rot q, Vec2 v) {
        return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
    }
};

/// The direction of a slope that climbs `rise` over `run`.
inline Rot slope(double rise, double run) {
    const double size = std::sqrt(rise * rise + run * run);
    return {run / size, rise / size};
}

/// The orientation whose half angle has this tangent: every angle below half a turn, and no sine.
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

struct Polygon {
    std::vector<Vec2> corners; // counter-clockwise, at most 8, so that every engine takes them
};
using Part = std::variant<Circle, Box, Polygon>;

struct Material {
    double friction = 0.6;
    double restitution = 0;
};

struct BodyDef {
    std::vector<Part> parts;
    Vec2 position{}; // m; of the frame of the parts
    Rot rotation{};
    Vec2 velocity{};    // m/s, of the centre of mass
    double spin = 0;    // rad/s, counter-clockwise
    double density = 1; // kg/m^2
    Material material{};
    bool locked = false;     // nothing moves or turns it but its own velocity and spin
    bool weightless = false; // gravity does not pull it
    // Bits, for scenes in which not everything meets. There every body needs a kind.
    std::uint16_t kind = 0;  // what it is
    std::uint16_t meets = 0; // the kinds that it touches, if they touch its own; 0: everything
};

/// Two bodies that stay together at a point and turn about it, perhaps driven. They do not touch.
struct PinDef {
    std::size_t a = 0; // places in the list of bodies
    std::size_t b = 0;
    Vec2 point{};           // m, world, where the bodies start
    double motorSpeed = 0;  // rad/s, of b relative to a
    double motorTorque = 0; // N m at most; 0: no motor
};

struct SceneDef {
    std::string name;
    Vec2 gravity{}; // m/s^2
    std::vector<BodyDef> bodies;
    std::vector<PinDef> pins{};
};

inline constexpr Vec2 kDown{0, -10}; // m/s^2; round, so that closed forms are easy to follow

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

/// A locked box whose top is at y = 0: the ground, or a slope when it is turned about the origin.
inline BodyDef ground(double width, Material material = {}, Rot rotation = {}) {
    BodyDef def = box(width, 2, rotation * Vec2{0, -1}, material);
    def.rotation = rotation;
    def.locked = true;
    return def;
}

/// Numbers that look random and are the same everywhere: SplitMix64.
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

/// The direction at a share (0..1) of the way around, from the x axis counter-clockwise. Not even
/// in the angle: tan(45 degrees) is 1, so this fills each quarter without a sine.
inline Vec2 direction(double share) {
    double quarters = 4 * share;
    Vec2 quarter{1, 0};
    for (; quarters >= 1; quarters -= 1) {
        quarter = {-quarter.y, quarter.x};
    }
    const Rot turn = turnedBy(quarters);
    return Rot{quarter.x, quarter.y} * Vec2{turn.c, turn.s};
}

/// Convex, `corners` of them on an ellipse around the origin. Corner k lies at the share
/// (k + jitter) / corners of the way around, so that no two of them meet.
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
