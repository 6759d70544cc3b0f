// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/rot.hpp>

namespace kodo::inline KODO_PRECISION {

/// Where a rigid thing is: its own frame turned by `rotation`, then moved to `position`.
template <std::floating_point T>
struct BasicTransform {
    BasicVec2<T> position;
    BasicRot<T> rotation;

    /// Local to world.
    friend constexpr BasicVec2<T> operator*(const BasicTransform& t, BasicVec2<T> p) {
        return t.rotation * p + t.position;
    }
    /// First b, then a.
    friend constexpr BasicTransform operator*(const BasicTransform& a, const BasicTransform& b) {
        return {a * b.position, a.rotation * b.rotation};
    }
    friend constexpr bool operator==(const BasicTransform&, const BasicTransform&) = default;
};

using Transform = BasicTransform<Real>;

/// World to local.
template <std::floating_point T>
constexpr BasicVec2<T> toLocal(const BasicTransform<T>& t, BasicVec2<T> p) {
    return unrotate(t.rotation, p - t.position);
}

/// b as seen from a: a * between(a, b) is b.
template <std::floating_point T>
constexpr BasicTransform<T> between(const BasicTransform<T>& a, const BasicTransform<T>& b) {
    return {toLocal(a, b.position), a.rotation.inverse() * b.rotation};
}

} // namespace kodo::inline KODO_PRECISION
