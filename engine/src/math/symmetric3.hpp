// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

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

    /// Factorization L D L^T with a unit diagonal of L. Where rounding has made a pivot
    /// meaningless, as with very long arms, the solution along it is 0.
    class Factors {
    public:
        explicit Factors(const Symmetric3& m) : perX_(inverseOf(m.xx, m.xx)) {
            yx_ = perX_ * m.yx;
            zx_ = perX_ * m.zx;
            perY_ = inverseOf(m.yy - yx_ * m.yx, m.yy);
            const Real below = m.zy - yx_ * m.zx;
            zy_ = perY_ * below;
            perZ_ = inverseOf(m.zz - zx_ * m.zx - zy_ * below, m.zz);
        }
        /// x with m x = v.
        Triple solve(const Triple& v) const {
            const Real y = v[1] - yx_ * v[0];
            const Real z = v[2] - zx_ * v[0] - zy_ * y;
            Triple x;
            x[2] = perZ_ * z;
            x[1] = perY_ * y - zy_ * x[2];
            x[0] = perX_ * v[0] - yx_ * x[1] - zx_ * x[2];
            return x;
        }

        /// The first N components of solve(v), for a matrix whose other rows are those of 1.
        template <std::size_t N>
        Triple solveFirst(const Triple& v) const {
            if constexpr (N == 2) {
                const Real x1 = perY_ * (v[1] - yx_ * v[0]);
                return {perX_ * v[0] - yx_ * x1, x1, 0};
            } else {
                return solve(v);
            }
        }

    private:
        static Real inverseOf(Real pivot, Real diagonal) {
            constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
            return pivot > kRounding * diagonal ? 1 / pivot : Real(0); // 0 also for NaN
        }

        Real perX_; // 1 / D
        Real perY_ = 1;
        Real perZ_ = 1;
        Real yx_ = 0; // L
        Real zx_ = 0;
        Real zy_ = 0;
    };
};

} // namespace KODO_PRECISION
} // namespace kodo
