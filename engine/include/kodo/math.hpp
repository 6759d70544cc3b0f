// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// A number type.
template <typename T>
concept Arithmetic = std::floating_point<T> || std::integral<T>;

/// A point or a free vector: x to the right, y up. Metres, unless a comment names another unit. The
/// engine uses Vec2; tests use BasicVec2<long double> as a reference of higher precision.
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
    /// Divides each coordinate, which is exact for integers too. The thesis multiplies by 1 / s
    /// (2.3.1), which rounds twice.
    friend constexpr BasicVec2 operator/(BasicVec2 v, T s) { return {v.x / s, v.y / s}; }
    constexpr BasicVec2& operator+=(BasicVec2 v) { return *this = *this + v; }
    constexpr BasicVec2& operator-=(BasicVec2 v) { return *this = *this - v; }
    constexpr BasicVec2& operator*=(T s) { return *this = s * *this; }
    friend constexpr bool operator==(BasicVec2, BasicVec2) = default;
};

using Vec2 = BasicVec2<Real>;

/// Dot product: |a| |b| cos(angle from a to b) [Thesis06, eq. 2.1].
template <typename T>
constexpr T dot(BasicVec2<T> a, BasicVec2<T> b) {
    return a.x * b.x + a.y * b.y;
}

/// Cross product, its z component: |a| |b| sin(angle from a to b). Positive if b lies
/// counter-clockwise of a.
template <typename T>
constexpr T cross(BasicVec2<T> a, BasicVec2<T> b) {
    return a.x * b.y - a.y * b.x;
}

/// w x r: velocity (m/s) of the end of an arm r (m) that rotates with w (rad/s) [Thesis06,
/// eq. 4.5].
template <typename T>
constexpr BasicVec2<T> cross(T w, BasicVec2<T> r) {
    return {-w * r.y, w * r.x};
}

/// v rotated by 90 degrees counter-clockwise [Thesis06, eq. 2.2].
template <typename T>
constexpr BasicVec2<T> perp(BasicVec2<T> v) {
    return {-v.y, v.x};
}

/// |v|^2. Overflows for |v| above 1e19 (float).
template <typename T>
constexpr T lengthSquared(BasicVec2<T> v) {
    return dot(v, v);
}

/// |v|. Same bits on every machine, since IEEE 754 defines the rounding of the square root.
/// Overflows for |v| above 1e19 (float).
template <std::floating_point T>
T length(BasicVec2<T> v) {
    return std::sqrt(dot(v, v));
}

/// v / |v|, or the zero vector if |v| is 0 or underflows.
template <std::floating_point T>
BasicVec2<T> normalize(BasicVec2<T> v) {
    const T size = length(v);
    return size > 0 ? v / size : BasicVec2<T>{};
}

/// True if neither coordinate is infinite or NaN.
template <std::floating_point T>
bool isFinite(BasicVec2<T> v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

/// Sine and cosine of one angle.
template <std::floating_point T>
struct SinCos {
    T sin;
    T cos;
};

/// Sine and cosine of an angle (rad), with the same bits on every machine. Defined for float,
/// double and long double. Accurate to rounding up to 1e5 rad (float).
template <std::floating_point T>
KODO_API SinCos<T> sinCos(T radians);
/// Angle of the vector (x, y), -pi to pi (rad), with the same bits on every machine.
template <std::floating_point T>
KODO_API T atan2(T y, T x);

/// A rotation, stored as the cosine and sine of its angle [Thesis06, 2.3.1]. To rotate a vector
/// takes four multiplications and no sine. The default is no rotation.
template <std::floating_point T>
struct BasicRot {
    T c = 1;
    T s = 0;

    /// Rotation by an angle (rad), counter-clockwise. NaN for an angle that is not finite.
    static BasicRot fromAngle(T radians) {
        const T zero = radians - radians; // NaN unless the angle is finite
        if (zero != 0) {
            return {zero, zero};
        }
        const SinCos<T> both = sinCos(radians);
        return {both.cos, both.sin};
    }
    /// -pi to pi (rad).
    T angle() const { return atan2(s, c); }

    constexpr BasicVec2<T> xAxis() const { return {c, s}; }
    constexpr BasicVec2<T> yAxis() const { return {-s, c}; }
    constexpr BasicRot inverse() const { return {c, -s}; }

    /// Rotates a vector: local to world [Thesis06, eq. 2.3].
    friend constexpr BasicVec2<T> operator*(BasicRot q, BasicVec2<T> v) {
        return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
    }
    /// Rotation by b, then by a.
    friend constexpr BasicRot operator*(BasicRot a, BasicRot b) {
        return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
    }
    friend constexpr bool operator==(BasicRot, BasicRot) = default;
};

using Rot = BasicRot<Real>;

/// Rotates a vector by the inverse of q: world to local.
template <std::floating_point T>
constexpr BasicVec2<T> unrotate(BasicRot<T> q, BasicVec2<T> v) {
    return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

/// q scaled to unit length. It must not be zero.
template <std::floating_point T>
BasicRot<T> normalize(BasicRot<T> q) {
    const T scale = 1 / std::sqrt(q.c * q.c + q.s * q.s);
    return {scale * q.c, scale * q.s};
}

/// q rotated by an angle (rad), counter-clockwise. An angle of 0 returns q unchanged. One step of
/// Newton's method corrects the rounding of the length.
template <std::floating_point T>
BasicRot<T> turned(BasicRot<T> q, T radians) {
    if (radians == 0) {
        return q;
    }
    const SinCos<T> both = sinCos(radians);
    const BasicRot<T> next = BasicRot<T>{both.cos, both.sin} * q;
    const T missing = (1 - (next.c * next.c + next.s * next.s)) / 2;
    return {next.c + missing * next.c, next.s + missing * next.s};
}

/// Pose of a frame: rotation by `rotation`, then translation by `position` (m).
template <std::floating_point T>
struct BasicTransform {
    BasicVec2<T> position{};
    BasicRot<T> rotation{};

    /// Local to world.
    friend constexpr BasicVec2<T> operator*(const BasicTransform& t, BasicVec2<T> p) {
        return t.rotation * p + t.position;
    }
    /// Transform by b, then by a.
    friend constexpr BasicTransform operator*(const BasicTransform& a, const BasicTransform& b) {
        return {a * b.position, a.rotation * b.rotation};
    }
    friend constexpr bool operator==(const BasicTransform&, const BasicTransform&) = default;
};

using Transform = BasicTransform<Real>;

/// Point p (world) in the frame t: the inverse of t * p.
template <std::floating_point T>
constexpr BasicVec2<T> toLocal(const BasicTransform<T>& t, BasicVec2<T> p) {
    return unrotate(t.rotation, p - t.position);
}

/// Pose b relative to the frame a: a * between(a, b) is b.
template <std::floating_point T>
constexpr BasicTransform<T> between(const BasicTransform<T>& a, const BasicTransform<T>& b) {
    return {toLocal(a, b.position), a.rotation.inverse() * b.rotation};
}

/// Axis-aligned bounding box (m). Both corners are included.
template <std::floating_point T>
struct BasicAabb {
    BasicVec2<T> lower{}; // left, bottom
    BasicVec2<T> upper{}; // right, top

    constexpr BasicVec2<T> center() const { return T(0.5) * (lower + upper); }
    constexpr BasicVec2<T> extent() const { return upper - lower; }

    constexpr bool contains(BasicVec2<T> p) const {
        return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y;
    }
    constexpr bool contains(const BasicAabb& other) const {
        return lower.x <= other.lower.x && lower.y <= other.lower.y && other.upper.x <= upper.x &&
               other.upper.y <= upper.y;
    }
    /// The box grown by a margin (m) on each side.
    constexpr BasicAabb grown(T margin) const {
        return {{lower.x - margin, lower.y - margin}, {upper.x + margin, upper.y + margin}};
    }
    friend constexpr bool operator==(const BasicAabb&, const BasicAabb&) = default;
};

using Aabb = BasicAabb<Real>;

/// True if two boxes overlap or touch.
template <std::floating_point T>
constexpr bool overlap(const BasicAabb<T>& a, const BasicAabb<T>& b) {
    // branchless: these branches mispredict
    return (a.lower.x <= b.upper.x) & (b.lower.x <= a.upper.x) & (a.lower.y <= b.upper.y) &
           (b.lower.y <= a.upper.y);
}

/// Smallest box that contains both.
template <std::floating_point T>
constexpr BasicAabb<T> unite(const BasicAabb<T>& a, const BasicAabb<T>& b) {
    return {{(std::min)(a.lower.x, b.lower.x), (std::min)(a.lower.y, b.lower.y)},
            {(std::max)(a.upper.x, b.upper.x), (std::max)(a.upper.y, b.upper.y)}};
}

/// Smallest box that contains all points. There must be at least one.
template <std::floating_point T>
constexpr BasicAabb<T> aabbOf(std::span<const BasicVec2<T>> points) {
    BasicAabb<T> box{points[0], points[0]};
    for (const BasicVec2<T> p : points.subspan(1)) {
        box = unite(box, {p, p});
    }
    return box;
}

} // namespace KODO_PRECISION
} // namespace kodo
