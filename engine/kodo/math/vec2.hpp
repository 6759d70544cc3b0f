// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cmath>
#include <concepts>

namespace kodo::inline KODO_PRECISION {

template <typename T>
concept Arithmetic = std::floating_point<T> || std::integral<T>;

/// A point or a free vector: x right, y up. Metres unless the name of a value says otherwise.
/// The engine uses `Vec2`; tests also instantiate BasicVec2<long double> as an accuracy oracle.
template <Arithmetic T>
struct BasicVec2 {
    T x{};
    T y{};

    friend constexpr BasicVec2 operator+(BasicVec2 a, BasicVec2 b) {
        return {a.x + b.x, a.y + b.y};
    }
    friend constexpr BasicVec2 operator-(BasicVec2 a, BasicVec2 b) {
        return {a.x - b.x, a.y - b.y};
    }
    friend constexpr BasicVec2 operator-(BasicVec2 v) { return {-v.x, -v.y}; }
    friend constexpr BasicVec2 operator*(T s, BasicVec2 v) { return {s * v.x, s * v.y}; }
    friend constexpr BasicVec2 operator*(BasicVec2 v, T s) { return {s * v.x, s * v.y}; }
    /// A true division of each coordinate, exact for integers too. The thesis multiplies by the
    /// reciprocal (2.3.1), which rounds twice; write `(1 / s) * v` where that is good enough.
    friend constexpr BasicVec2 operator/(BasicVec2 v, T s) { return {v.x / s, v.y / s}; }
    constexpr BasicVec2& operator+=(BasicVec2 v) { return *this = *this + v; }
    constexpr BasicVec2& operator-=(BasicVec2 v) { return *this = *this - v; }
    constexpr BasicVec2& operator*=(T s) { return *this = s * *this; }
    friend constexpr bool operator==(BasicVec2, BasicVec2) = default;
};

using Vec2 = BasicVec2<Real>;

/// |a| |b| cos(angle from a to b) [Thesis06, eq. 2.1].
template <typename T>
constexpr T dot(BasicVec2<T> a, BasicVec2<T> b) {
    return a.x * b.x + a.y * b.y;
}

/// Perp-dot, the z of the 3D cross product: positive when b lies counter-clockwise of a.
template <typename T>
constexpr T cross(BasicVec2<T> a, BasicVec2<T> b) {
    return a.x * b.y - a.y * b.x;
}

/// w x r: the velocity (m/s) that an angular velocity w (rad/s) gives the end of the arm r (m)
/// [Thesis06, eq. 4.5].
template <typename T>
constexpr BasicVec2<T> cross(T w, BasicVec2<T> r) {
    return {-w * r.y, w * r.x};
}

/// v turned a quarter counter-clockwise [Thesis06, eq. 2.2].
template <typename T>
constexpr BasicVec2<T> perp(BasicVec2<T> v) {
    return {-v.y, v.x};
}

template <typename T>
constexpr T lengthSquared(BasicVec2<T> v) {
    return dot(v, v);
}

/// By the square root alone, which rounds alike on every machine. Overflows beyond 1e19 (float).
template <std::floating_point T>
T length(BasicVec2<T> v) {
    return std::sqrt(dot(v, v));
}

/// v / |v|, or the zero vector for one too short to have a direction.
template <std::floating_point T>
BasicVec2<T> normalize(BasicVec2<T> v) {
    const T size = length(v);
    return size > 0 ? v / size : BasicVec2<T>{};
}

template <std::floating_point T>
bool isFinite(BasicVec2<T> v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

} // namespace kodo::inline KODO_PRECISION
