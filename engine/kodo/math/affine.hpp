// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/transform.hpp>

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

    /// Empty when the map is singular: it flattens the plane, and nothing can undo that.
    constexpr std::optional<BasicAffine> inverse() const {
        const T d = determinant();
        if (!(d < 0 || d > 0)) {
            return std::nullopt;
        }
        const BasicAffine linear{{y.y / d, -x.y / d}, {-y.x / d, x.x / d}, {}};
        return BasicAffine{linear.x, linear.y, -(linear * origin)};
    }
};

using Affine = BasicAffine<Real>;

} // namespace kodo::inline KODO_PRECISION
