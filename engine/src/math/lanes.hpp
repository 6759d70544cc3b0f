// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

/// SIMD lanes for loops over independent elements. Each lane computes the same bits as a single
/// Real: only +, -, *, /, comparisons and selections are used, and none is fused. The number of
/// lanes depends on the instruction set. A file that includes this one is compiled once per
/// instruction set. Everything here has internal linkage, so that code for one set is never linked
/// into another.
namespace kodo {
inline namespace KODO_PRECISION {
namespace { // NOLINT: see above

#ifdef __AVX2__
constexpr std::size_t kLaneBytes = 32;
#else
constexpr std::size_t kLaneBytes = 16;
#endif
constexpr int kLanes = static_cast<int>(kLaneBytes / sizeof(Real));

using Lanes = Real __attribute__((vector_size(kLaneBytes)));

#define KODO_LANES_INLINE [[gnu::always_inline]] inline

KODO_LANES_INLINE Lanes load(const Real* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
KODO_LANES_INLINE void store(Real* to, Lanes lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}
KODO_LANES_INLINE Lanes all(Real value) {
    return value - Lanes{};
}
KODO_LANES_INLINE Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}
KODO_LANES_INLINE Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}

/// True if any lane is above the limit.
KODO_LANES_INLINE bool anyAbove(Lanes lanes, Real limit) {
    using Words = std::uint64_t __attribute__((vector_size(kLaneBytes)));
    const auto above = lanes > all(limit);
    Words words;
    std::memcpy(&words, &above, sizeof words);
    std::uint64_t any = 0;
    for (std::size_t i = 0; i < kLaneBytes / sizeof any; ++i) {
        any |= words[i];
    }
    return any != 0;
}

/// Two numbers of each of kLanes structures.
struct Couple {
    Lanes x;
    Lanes y;
};

/// Four numbers of each of kLanes structures.
struct Quad {
    Lanes x;
    Lanes y;
    Lanes z;
    Lanes w;
};

/// Offsets, in Reals, of consecutive rows of four.
constexpr std::uint32_t kRowStarts[] = {0, 4, 8, 12, 16, 20, 24, 28};

#if defined(__AVX2__) && !defined(KODO_DOUBLE) // 8 floats
using Half = Real __attribute__((vector_size(16)));

KODO_LANES_INLINE Half loadHalf(const Real* from) {
    Half half;
    std::memcpy(&half, from, sizeof half);
    return half;
}
KODO_LANES_INLINE Lanes loadPair(const Real* low, const Real* high) {
    return __builtin_shufflevector(loadHalf(low), loadHalf(high), 0, 1, 2, 3, 4, 5, 6, 7);
}
KODO_LANES_INLINE void storePair(Real* low, Real* high, Lanes lanes) {
    // Stores halves of memory: with a shuffle, GCC 12 emits one more instruction.
    std::memcpy(low, &lanes, sizeof(Half));
    std::memcpy(high, reinterpret_cast<const char*>(&lanes) + sizeof(Half), sizeof(Half));
}
/// Transposes rows of four into columns, in both halves.
KODO_LANES_INLINE Quad transpose(Lanes r0, Lanes r1, Lanes r2, Lanes r3) {
    const Lanes a = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes b = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
    const Lanes c = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
    const Lanes d = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(c, d, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(c, d, 2, 3, 10, 11, 6, 7, 14, 15)};
}
/// Reads kLanes consecutive pairs.
KODO_LANES_INLINE Couple loadPairs(const Real* from) {
    const Lanes low = load(from);
    const Lanes high = load(from + kLanes);
    return {__builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14),
            __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15)};
}
/// Reads four numbers at each base + index[i].
KODO_LANES_INLINE Quad gather(const Real* base, const std::uint32_t* index) {
    const auto at = [&](int i) { return base + index[i]; };
    return transpose(loadPair(at(0), at(4)), loadPair(at(1), at(5)), loadPair(at(2), at(6)),
                     loadPair(at(3), at(7)));
}
KODO_LANES_INLINE void scatter(Real* base, const std::uint32_t* index, const Quad& quad) {
    const auto at = [&](int i) { return base + index[i]; };
    const Quad rows = transpose(quad.x, quad.y, quad.z, quad.w);
    storePair(at(0), at(4), rows.x);
    storePair(at(1), at(5), rows.y);
    storePair(at(2), at(6), rows.z);
    storePair(at(3), at(7), rows.w);
}
#elif defined(__AVX2__) || !defined(KODO_DOUBLE) // 4 lanes: a structure is one row
KODO_LANES_INLINE Quad transpose(Lanes r0, Lanes r1, Lanes r2, Lanes r3) {
    const Lanes a = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
    const Lanes b = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
    const Lanes c = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
    const Lanes d = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
    return {__builtin_shufflevector(a, b, 0, 1, 4, 5), __builtin_shufflevector(a, b, 2, 3, 6, 7),
            __builtin_shufflevector(c, d, 0, 1, 4, 5), __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}
KODO_LANES_INLINE Couple loadPairs(const Real* from) {
    const Lanes low = load(from);
    const Lanes high = load(from + kLanes);
    return {__builtin_shufflevector(low, high, 0, 2, 4, 6),
            __builtin_shufflevector(low, high, 1, 3, 5, 7)};
}
KODO_LANES_INLINE Quad gather(const Real* base, const std::uint32_t* index) {
    const auto at = [&](int i) { return load(base + index[i]); };
    return transpose(at(0), at(1), at(2), at(3));
}
KODO_LANES_INLINE void scatter(Real* base, const std::uint32_t* index, const Quad& quad) {
    const auto at = [&](int i) { return base + index[i]; };
    const Quad rows = transpose(quad.x, quad.y, quad.z, quad.w);
    store(at(0), rows.x);
    store(at(1), rows.y);
    store(at(2), rows.z);
    store(at(3), rows.w);
}
#else                                            // 2 doubles: a structure is two rows
KODO_LANES_INLINE Couple loadPairs(const Real* from) {
    const Lanes low = load(from);
    const Lanes high = load(from + kLanes);
    return {__builtin_shufflevector(low, high, 0, 2), __builtin_shufflevector(low, high, 1, 3)};
}
KODO_LANES_INLINE Quad gather(const Real* base, const std::uint32_t* index) {
    const Real* const p = base + index[0];
    const Real* const q = base + index[1];
    return {Lanes{p[0], q[0]}, Lanes{p[1], q[1]}, Lanes{p[2], q[2]}, Lanes{p[3], q[3]}};
}
KODO_LANES_INLINE void scatter(Real* base, const std::uint32_t* index, const Quad& quad) {
    for (int i = 0; i < kLanes; ++i) {
        Real* const to = base + index[i];
        to[0] = quad.x[i];
        to[1] = quad.y[i];
        to[2] = quad.z[i];
        to[3] = quad.w[i];
    }
}
#endif

/// Four consecutive numbers.
using Row = Real __attribute__((vector_size(4 * sizeof(Real))));

/// Addresses of kLanes rows: base + index[i].
struct RowPlaces {
    Real* base;
    const std::uint32_t* index;
};

/// Writes the rows whose bit is set in `which`. Each row is one store: it is often read next, and
/// store forwarding needs one store that covers the load. Not inlined and without a Quad, since
/// otherwise the compiler keeps all numbers in memory for this rare case.
[[maybe_unused, gnu::noinline]] void scatterSome(RowPlaces places, Lanes x, Lanes y, Lanes z,
                                                 Lanes w, unsigned which) {
    alignas(Lanes) Real rows[4 * kLanes];
    scatter(rows, kRowStarts, {x, y, z, w});
    for (int i = 0; i < kLanes; ++i) {
        if ((which >> i & 1) != 0) {
            Row row;
            std::memcpy(&row, rows + 4 * i, sizeof row);
            std::memcpy(places.base + places.index[i], &row, sizeof row);
        }
    }
}

} // namespace
} // namespace KODO_PRECISION
} // namespace kodo
