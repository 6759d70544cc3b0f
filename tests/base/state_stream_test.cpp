// SPDX-License-Identifier: MIT
#include "base/checksum.hpp"
#include "base/state_stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

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
    StateStream stream;
    (stream(numbers), ...);
    return stream.takeWritten();
}

template <typename Number>
Number readBack(Number number) {
    const std::vector<std::byte> bytes = written(number);
    EXPECT_EQ(bytes.size(), sizeof(Number));
    StateStream stream(bytes);
    Number result{};
    stream(result);
    EXPECT_EQ(stream.left(), 0u);
    return result;
}

TEST(StateStream, WritesTheLowByteFirst) {
    EXPECT_EQ(written(std::uint32_t{0x04030201}), bytesOf({1, 2, 3, 4}));
    EXPECT_EQ(written(std::uint16_t{0x0201}, true, std::uint8_t{7}), bytesOf({1, 2, 1, 7}));
    EXPECT_EQ(written(-2), bytesOf({0xfe, 0xff, 0xff, 0xff}));
    EXPECT_EQ(written(1.0f), bytesOf({0, 0, 0x80, 0x3f}));
    EXPECT_EQ(written(-2.0), bytesOf({0, 0, 0, 0, 0, 0, 0, 0xc0}));
}

TEST(StateStream, ReadsWrittenNumbersBack) {
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

TEST(StateStream, KeepsTheSignOfZeroAndTheBitsOfANan) {
    EXPECT_TRUE(std::signbit(readBack(-0.0f)));
    EXPECT_FALSE(std::signbit(readBack(0.0)));
    const std::vector<std::byte> strange = bytesOf({1, 2, 0xc3, 0x7f}); // a NaN with a payload
    StateStream stream(strange);
    float nan = 0;
    stream(nan);
    EXPECT_TRUE(std::isnan(nan));
    EXPECT_EQ(written(nan), strange);
}

TEST(StateStream, RefusesToReadBeyondTheEnd) {
    const std::vector<std::byte> bytes = bytesOf({1, 2, 3});
    StateStream stream(bytes);
    std::uint32_t number = 9;
    EXPECT_THROW(stream(number), BadSnapshot);
    EXPECT_EQ(number, 9u);
    EXPECT_EQ(stream.left(), 3u);
    std::uint16_t half = 0;
    stream(half);
    EXPECT_EQ(half, 0x0201);
    EXPECT_THROW(stream(half), BadSnapshot);
}

TEST(StateStream, RefusesABoolOtherThanZeroOrOne) {
    const std::vector<std::byte> bytes = bytesOf({2});
    StateStream stream(bytes);
    bool value = false;
    EXPECT_THROW(stream(value), BadSnapshot);
}

struct Inner {
    std::uint8_t small = 0;
    std::vector<std::uint16_t> list;
};
struct Id {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
};
struct Outer {
    Inner inner;
    std::optional<bool> maybe;
    std::array<std::uint8_t, 2> pair{};
    std::variant<std::uint8_t, Inner> kind;
    Id id;
};
static_assert(countMembers<Inner>() == 2 && countMembers<Outer>() == 5);

/// An aggregate that leaves a member out.
struct Partly {
    std::uint8_t stored = 0;
    std::uint8_t scratch = 0;
    void visitState(StateStream& stream) { stream(stored); }
};

TEST(StateStream, WritesAllMembersOfAnAggregateInOrder) {
    const Outer outer{{1, {2, 3}}, true, {4, 5}, Inner{6, {}}, {7, 8, 9}};
    StateStream stream;
    stream.write(outer);
    const std::vector<std::byte> bytes = stream.takeWritten();
    EXPECT_EQ(bytes, bytesOf({1, 2, 0, 0, 0, 2, 0, 3, 0, 1, 1, 4, 5, 1,
                              6, 0, 0, 0, 0, 7, 0, 0, 0, 8, 0, 0, 0}));
    StateStream again(bytes);
    Outer read;
    again(read);
    EXPECT_EQ(again.left(), 0u);
    StateStream copy;
    copy.write(read);
    EXPECT_EQ(copy.takeWritten(), bytes);
    EXPECT_EQ(read.id.world, 0u); // the World of an id is not stored
}

TEST(StateStream, LeavesOutWhatVisitStateDoes) {
    EXPECT_EQ(written(Partly{1, 2}), bytesOf({1}));
    EXPECT_EQ(written(std::vector<Partly>{{1, 2}, {3, 4}}), bytesOf({2, 0, 0, 0, 1, 3}));
}

TEST(StateStream, RefusesAKindOrLengthThatIsNotThere) {
    const std::vector<std::byte> kind = bytesOf({2, 0, 0, 0, 0, 0});
    std::variant<std::uint8_t, Inner> value;
    StateStream stream(kind);
    EXPECT_THROW(stream(value), BadSnapshot);
    const std::vector<std::byte> length = bytesOf({3, 0, 0, 0, 1, 2});
    std::vector<std::uint8_t> list;
    StateStream other(length);
    EXPECT_THROW(other(list), BadSnapshot);
}

TEST(Checksum, DetectsEveryChangedByte) {
    for (const int size : {6, 32, 77}) { // less than a round of words, one, and two with a rest
        std::vector<std::byte> bytes;
        for (int i = 0; i < size; ++i) {
            bytes.push_back(static_cast<std::byte>(i * 37));
        }
        const std::uint64_t good = checksumOf(bytes);
        for (std::byte& byte : bytes) {
            const std::byte old = byte;
            for (int other = 1; other < 256; ++other) {
                byte = old ^ static_cast<std::byte>(other);
                ASSERT_NE(checksumOf(bytes), good);
            }
            byte = old;
        }
    }
}

TEST(Checksum, DetectsTwoChangedSignsExchangedWordsAndAddedZeros) {
    std::vector<std::byte> bytes(96);
    const std::uint64_t good = checksumOf(bytes);
    bytes[7] = bytes[39] = std::byte{0x80}; // the highest bits of two words of one lane
    EXPECT_NE(checksumOf(bytes), good);
    bytes[7] = std::byte{0};
    const std::uint64_t one = checksumOf(bytes);
    std::swap(bytes[39], bytes[47]);
    EXPECT_NE(checksumOf(bytes), one);
    bytes.assign(97, std::byte{0});
    EXPECT_NE(checksumOf(bytes), good);
}

} // namespace
} // namespace kodo
