// SPDX-License-Identifier: MIT
#include <kodo/state_hash.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace kodo {
namespace {

template <typename... Values>
std::uint64_t hashOf(Values... values) {
    StateHash hash;
    (hash.add(values), ...);
    return hash.value();
}

// The published test vectors of FNV-1a with 64 bits.
TEST(StateHash, IsFnv1a) {
    EXPECT_EQ(hashOf(), 0xcbf29ce484222325u);
    EXPECT_EQ(hashOf('a'), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(hashOf('f', 'o', 'o', 'b', 'a', 'r'), 0x85944171f73967e8u);
}

// Little-endian on every machine: the bytes of "foobar" as numbers of 4 and 2 bytes.
TEST(StateHash, HashesTheLowByteFirst) {
    EXPECT_EQ(hashOf(std::uint32_t{0x626f6f66}, std::uint16_t{0x7261}), 0x85944171f73967e8u);
}

TEST(StateHash, HashesMinusZeroAsZero) {
    EXPECT_EQ(hashOf(-0.0f), hashOf(0.0f));
    EXPECT_EQ(hashOf(-0.0), hashOf(0.0));
    EXPECT_NE(hashOf(0.0f), hashOf(std::numeric_limits<float>::denorm_min()));
    EXPECT_NE(hashOf(0.0), hashOf(std::numeric_limits<double>::denorm_min()));
}

TEST(StateHash, HashesTheBitsOfAFloat) {
    EXPECT_EQ(hashOf(1.0f), hashOf(std::uint32_t{0x3f800000}));
    EXPECT_EQ(hashOf(-2.0), hashOf(std::uint64_t{0xc000000000000000}));
}

TEST(StateHash, DependsOnOrderAndWidth) {
    EXPECT_NE(hashOf(1, 2), hashOf(2, 1));
    EXPECT_NE(hashOf(std::uint8_t{1}), hashOf(std::uint16_t{1}));
}

} // namespace
} // namespace kodo
