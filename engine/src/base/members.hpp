// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

namespace kodo {
namespace detail {

struct AnyMember {
    template <typename T>
    operator T() const;
};
template <typename T, typename... Given>
concept TakesMembers = requires {
    T{Given{}...};
};

} // namespace detail

/// Number of members of an aggregate.
template <typename T, typename... Given>
consteval std::size_t countMembers() {
    static_assert(std::is_aggregate_v<T>, "a class lists its state in visitState()");
    if constexpr (detail::TakesMembers<T, Given..., detail::AnyMember>) {
        return countMembers<T, Given..., detail::AnyMember>();
    } else {
        return sizeof...(Given);
    }
}

/// Calls visit(members...) with all members of an aggregate, in order.
template <typename T, typename Visit>
constexpr decltype(auto) withMembers(T& value, Visit visit) {
    constexpr std::size_t kCount = countMembers<std::remove_const_t<T>>();
    static_assert((kCount > 0 && kCount <= 9) || kCount == 14, "add a case below");
    if constexpr (kCount == 1) {
        auto& [a] = value;
        return visit(a);
    } else if constexpr (kCount == 2) {
        auto& [a, b] = value;
        return visit(a, b);
    } else if constexpr (kCount == 3) {
        auto& [a, b, c] = value;
        return visit(a, b, c);
    } else if constexpr (kCount == 4) {
        auto& [a, b, c, d] = value;
        return visit(a, b, c, d);
    } else if constexpr (kCount == 5) {
        auto& [a, b, c, d, e] = value;
        return visit(a, b, c, d, e);
    } else if constexpr (kCount == 6) {
        auto& [a, b, c, d, e, f] = value;
        return visit(a, b, c, d, e, f);
    } else if constexpr (kCount == 7) {
        auto& [a, b, c, d, e, f, g] = value;
        return visit(a, b, c, d, e, f, g);
    } else if constexpr (kCount == 8) {
        auto& [a, b, c, d, e, f, g, h] = value;
        return visit(a, b, c, d, e, f, g, h);
    } else if constexpr (kCount == 9) {
        auto& [a, b, c, d, e, f, g, h, i] = value;
        return visit(a, b, c, d, e, f, g, h, i);
    } else {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
        return visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
    }
}

} // namespace kodo
