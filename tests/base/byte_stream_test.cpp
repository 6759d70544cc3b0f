// SPDX-License-Identifier: MIT
#include "base/byte_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace kodo {
namespace {

std::vector<std::byte> bytesOf(std::initializer_list<int> values) {
    std::vector<std::byte> bytes;
    for (const int value : values) {
        bytes.push_back(static_cast<std::byte>(value));
    }
    return bytes;
}

template <typename... Numbers>
std::vector<std::byte> written(Numbers... numbers) {
    ByteStream stream;
    (stream.number(numbers), ...);
    return stream.takeWritten();
}

template <typename Number>
Number readBack(Number number) {
    const std::vector<std::byte> bytes = written(number);
    EXPECT_EQ(bytes.size(), sizeof(Number));
    ByteStream stream(bytes);
    Number result{};
    stream.number(result);
    EXPECT_EQ(stream.left(), 0u);
    return result;
}

TEST(ByteStream, WritesTheLowByteFirst) {
    EXPECT_EQ(written(std::uint32_t{0x04030201}), bytesOf({1, 2, 3, 4}));
    EXPECT_EQ(written(std::uint16_t{0x0201}, true, std::uint8_t{7}), bytesOf({1, 2, 1, 7}));
    EXPECT_EQ(written(-2), bytesOf({0xfe, 0xff, 0xff, 0xff}));
    EXPECT_EQ(written(1.0f), bytesOf({0, 0, 0x80, 0x3f}));
    EXPECT_EQ(written(-2.0), bytesOf({0, 0, 0, 0, 0, 0, 0, 0xc0}));
}

TEST(ByteStream, ReadsWrittenNumbersBack) {
    for (const std::int32_t value : {0, 1, -1, std::numeric_limits<std::int32_t>::min(),
                                     std::numeric_limits<std::int32_t>::max()}) {
        EXPECT_EQ(readBack(value), value);
        EXPECT_EQ(readBack(static_cast<std::uint64_t>(value)), static_cast<std::uint64_t>(value));
    }
    EXPECT_EQ(readBack(std::numeric_limits<double>::denorm_min()),
              std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(readBack(-std::numeric_limits<float>::infinity()),
              -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(readBack(true));
    EXPECT_FALSE(readBack(false));
}

TEST(ByteStream, KeepsTheSignOfZeroAndTheBitsOfANan) {
    EXPECT_TRUE(std::signbit(readBack(-0.0f)));
    EXPECT_FALSE(std::signbit(readBack(0.0)));
    const std::vector<std::byte> strange = bytesOf({1, 2, 0xc3, 0x7f}); // a NaN with a payload
    ByteStream stream(strange);
    float nan = 0;
    stream.number(nan);
    EXPECT_TRUE(std::isnan(nan));
    EXPECT_EQ(written(nan), strange);
}

TEST(ByteStream, RefusesToReadBeyondTheEnd) {
    const std::vector<std::byte> bytes = bytesOf({1, 2, 3});
    ByteStream stream(bytes);
    std::uint32_t number = 9;
    EXPECT_THROW(stream.number(number), BadSnapshot);
    EXPECT_EQ(number, 9u);
    EXPECT_EQ(stream.left(), 3u);
    std::uint16_t half = 0;
    stream.number(half);
    EXPECT_EQ(half, 0x0201);
    EXPECT_THROW(stream.number(half), BadSnapshot);
}

TEST(ByteStream, RefusesABoolOtherThanZeroOrOne) {
    const std::vector<std::byte> bytes = bytesOf({2});
    ByteStream stream(bytes);
    bool value = false;
    EXPECT_THROW(stream.number(value), BadSnapshot);
}

// A published test vector of FNV-1a. Every change of a single byte changes the checksum.
TEST(Checksum, IsFnv1aAndDetectsEveryChangedByte) {
    std::vector<std::byte> bytes = bytesOf({'f', 'o', 'o', 'b', 'a', 'r'});
    EXPECT_EQ(checksumOf(bytes), 0x85944171f73967e8u);
    for (std::byte& byte : bytes) {
        const std::byte old = byte;
        for (int other = 1; other < 256; ++other) {
            byte = old ^ static_cast<std::byte>(other);
            ASSERT_NE(checksumOf(bytes), 0x85944171f73967e8u);
        }
        byte = old;
    }
}

} // namespace
} // namespace kodo
