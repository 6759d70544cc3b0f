// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <algorithm>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// Affine map of the plane, as a 3x2 matrix, with scale and shear [Thesis06, 2.3.2]. It serves to
/// draw and to build shapes; the pose of a body is a Transform.
template <std::floating_point T>
struct BasicAffine {
    BasicVec2<T> x{1, 0};  // image of the x axis
    BasicVec2<T> y{0, 1};  // image of the y axis
    BasicVec2<T> origin{}; // image of the origin

    static constexpr BasicAffine from(const BasicTransform<T>& t) {
        return {t.rotation.xAxis(), t.rotation.yAxis(), t.position};
    }
    static constexpr BasicAffine scale(T sx, T sy) { return {{sx, 0}, {0, sy}, {}}; }

    friend constexpr BasicVec2<T> operator*(const BasicAffine& m, BasicVec2<T> p) {
        return p.x * m.x + p.y * m.y + m.origin;
    }
    /// Map by b, then by a.
    friend constexpr BasicAffine operator*(const BasicAffine& a, const BasicAffine& b) {
        return {b.x.x * a.x + b.x.y * a.y, b.y.x * a.x + b.y.y * a.y, a * b.origin};
    }
    friend constexpr bool operator==(const BasicAffine&, const BasicAffine&) = default;

    /// Factor of areas; negative for a reflection.
    constexpr T determinant() const { return cross(x, y); }

    /// Inverse map, or std::nullopt if the matrix is singular or the inverse is not finite. Each
    /// column is divided by its largest entry first, so large and small scales lose no precision.
    std::optional<BasicAffine> inverse() const {
        const T sizeX = largerOf(x);
        const T sizeY = largerOf(y);
        const BasicVec2<T> u = x / sizeX;
        const BasicVec2<T> v = y / sizeY;
        const T d = cross(u, v);
        if (!(d < 0 || d > 0)) { // also for NaN
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

} // namespace KODO_PRECISION
} // namespace kodo
