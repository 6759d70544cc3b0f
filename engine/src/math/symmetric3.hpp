// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// Three components: along x, along y, and about the centre of mass of a body.
using Triple = std::array<Real, 3>;

constexpr Real dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A symmetric positive definite 3x3 matrix, stored as its lower triangle.
struct Symmetric3 {
    Real xx = 1;
    Real yx = 0;
    Real yy = 1;
    Real zx = 0;
    Real zy = 0;
    Real zz = 1;

    Triple times(const Triple& v) const {
        return {xx * v[0] + yx * v[1] + zx * v[2], yx * v[0] + yy * v[1] + zy * v[2],
                zx * v[0] + zy * v[1] + zz * v[2]};
    }
    void add(const Symmetric3& m) {
        xx += m.xx;
        yx += m.yx;
        yy += m.yy;
        zx += m.zx;
        zy += m.zy;
        zz += m.zz;
    }
    /// Subtracts factor v v^T.
    void subtract(const Triple& v, Real factor) {
        const Triple u{factor * v[0], factor * v[1], factor * v[2]};
        xx -= u[0] * v[0];
        yx -= u[1] * v[0];
        yy -= u[1] * v[1];
        zx -= u[2] * v[0];
        zy -= u[2] * v[1];
        zz -= u[2] * v[2];
    }
    /// The inertia for the motion at a point that is `arm` (m) from the present one.
    Symmetric3 seenFrom(Vec2 arm) const {
        const Real x = zx + arm.y * xx - arm.x * yx;
        const Real y = zy + arm.y * yx - arm.x * yy;
        return {xx, yx, yy, x, y, zz + arm.y * (zx + x) - arm.x * (zy + y)};
    }

    /// The inertia that a hinge feels which is `arm` (m) from the present point: for the motion of
    /// that point, while the rotation is free. With F, c and z as its blocks,
    ///
    ///   u = F^-1 c,  w = perp(arm) - u,  s = z - c . u
    ///   F' = (s F + det F perp(w) perp(w)^T) / (s + w . F w)
    ///
    /// A sum of positive terms: it stays positive however unlike the terms of the inertia are.
    Symmetric3 hinged(Vec2 arm) const {
        constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
        const Real product = xx * yy;
        const Real determinant = std::max(product - yx * yx, kRounding * product);
        const Vec2 u = Vec2{yy * zx - yx * zy, xx * zy - yx * zx} / determinant;
        const Real s = std::max(zz - (zx * u.x + zy * u.y), kRounding * zz);
        const Vec2 w = perp(arm) - u;
        const Real g = xx * w.x * w.x + yy * w.y * w.y + 2 * (yx * w.x * w.y);
        const Real per = 1 / (s + g);
        const Real share = per * s;
        const Real rest = per * determinant;
        return {share * xx + rest * w.y * w.y,
                share * yx - rest * w.x * w.y,
                share * yy + rest * w.x * w.x,
                0,
                0,
                0};
    }

    /// x with m x = v. Where rounding has made the determinant meaningless, as with very long arms,
    /// x is small.
    Triple solve(const Triple& v) const {
        const Symmetric3 m = hinged({}); // once the rotation is eliminated
        const Real x = v[0] - zx / zz * v[2];
        const Real y = v[1] - zy / zz * v[2];
        constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
        const Real product = m.xx * m.yy;
        const Real per = 1 / std::max(product - m.yx * m.yx, kRounding * product);
        const Real first = per * (m.yy * x - m.yx * y);
        const Real second = per * (m.xx * y - m.yx * x);
        return {first, second, (v[2] - zx * first - zy * second) / zz};
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
