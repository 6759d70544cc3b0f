// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

/// Lists of kinds of joints and shapes that tests, judges and fuzz targets need. Each is compared
/// with the list of kinds in the public header: a kind that is left out does not compile.
namespace support {

template <typename Kind, typename... Others>
inline constexpr bool kIsOneOf = (std::is_same_v<Kind, Others> || ...);

/// Whether Kinds contains each alternative of a variant.
template <typename Variant, typename... Kinds>
inline constexpr bool kHasEveryKind = false;
template <typename... Alternatives, typename... Kinds>
inline constexpr bool kHasEveryKind<std::variant<Alternatives...>, Kinds...> =
    (kIsOneOf<Alternatives, Kinds...> && ...);

/// Samples of a variant in the order given, which braces also evaluate in this order.
template <typename Variant>
struct EveryKind {
    template <typename... Kinds>
    explicit EveryKind(const Kinds&... samples) : list{samples...} {
        static_assert(kHasEveryKind<Variant, Kinds...>, "a kind of the variant has no sample");
    }
    std::vector<Variant> list;
};

/// A function object with one overload for each kind.
template <typename... Overloads>
struct Each : Overloads... {
    using Overloads::operator()...;
};
template <typename... Overloads>
Each(Overloads...) -> Each<Overloads...>; // clang 14 deduces none for aggregates

} // namespace support
