// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/transform.hpp>

#include <algorithm>
#include <optional>

namespace kodo::inline KODO_PRECISION {

/// A 3x2 matrix: any affine map of the plane, scale and shear included [Thesis06, 2.3.2]. Rigid
/// bodies need only a Transform; this is for drawing and for building shapes.
template <std::floating_point T>
struct BasicAffine {
    BasicVec2<T> x{1, 0}; // where the x axis goes
    BasicVec2<T> y{0, 1}; // where the y axis goes
    BasicVec2<T> origin;  // where the origin goes

    static constexpr BasicAffine from(const BasicTransform<T>& t) {
        return {t.rotation.xAxis(), t.rotation.yAxis(), t.position};
    }
    static constexpr BasicAffine scale(T sx, T sy) { return {{sx, 0}, {0, sy}, {}}; }

    friend constexpr BasicVec2<T> operator*(const BasicAffine& m, BasicVec2<T> p) {
        return p.x * m.x + p.y * m.y + m.origin;
    }
    /// First b, then a.
    friend constexpr BasicAffine operator*(const BasicAffine& a, const BasicAffine& b) {
        return {b.x.x * a.x + b.x.y * a.y, b.y.x * a.x + b.y.y * a.y, a * b.origin};
    }
    friend constexpr bool operator==(const BasicAffine&, const BasicAffine&) = default;

    /// By how much the map multiplies areas; negative when it mirrors.
    constexpr T determinant() const { return cross(x, y); }

    /// Empty when the map is singular: it flattens the plane, and nothing can undo that; or when
    /// the inverse has numbers that are not finite. How large the map's own are does not matter,
    /// since each column is first divided by its larger entry.
    std::optional<BasicAffine> inverse() const {
        const T sizeX = largerOf(x);
        const T sizeY = largerOf(y);
        const BasicVec2<T> u = x / sizeX;
        const BasicVec2<T> v = y / sizeY;
        const T d = cross(u, v);
        if (!(d < 0 || d > 0)) { // nor for NaN
            return std::nullopt;
        }
        const BasicAffine linear{
            {v.y / d / sizeX, -u.y / d / sizeY}, {-v.x / d / sizeX, u.x / d / sizeY}, {}};
        const BasicAffine result{linear.x, linear.y, -(linear * origin)};
        const bool finite = isFinite(result.x) && isFinite(result.y) && isFinite(result.origin);
        return finite ? std::optional(result) : std::nullopt;
    }

private:
    static constexpr T largerOf(BasicVec2<T> v) {
        return std::max(v.x < 0 ? -v.x : v.x, v.y < 0 ? -v.y : v.y);
    }
};

using Affine = BasicAffine<Real>;

} // namespace kodo::inline KODO_PRECISION
