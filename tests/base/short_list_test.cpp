// SPDX-License-Identifier: MIT
#include <kodo/base/short_list.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace kodo {
namespace {

std::vector<int> counted(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

// Below, at and beyond what lies in the object itself, the list is that of a vector; so is a copy,
// which shares nothing with it.
TEST(ShortList, IsAListOfAnyLength) {
    for (const int count : {0, 1, 3, 4, 5, 40}) {
        const std::vector<int> numbers = counted(count);
        ShortList<int, 4> list(numbers);
        EXPECT_EQ(list.empty(), count == 0);
        ASSERT_EQ(list.size(), numbers.size());
        const ShortList<int, 4> copy = list;
        for (int& number : list) {
            number = -number;
        }
        EXPECT_EQ(std::vector<int>(copy.begin(), copy.end()), numbers);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            EXPECT_EQ(copy[i], numbers[i]);
            EXPECT_EQ(list[i], -numbers[i]);
        }
        if (count > 0) {
            EXPECT_EQ(copy.back(), count);
            EXPECT_EQ(copy.data() + count, copy.end());
        }
    }
}

// What was moved from has no elements, and does not keep the length of those it gave away.
TEST(ShortList, IsEmptyAfterItWasMovedFrom) {
    for (const int count : {3, 40}) {
        const std::vector<int> numbers = counted(count);
        ShortList<int, 4> list(numbers);
        ShortList<int, 4> other = std::move(list);
        EXPECT_EQ(std::vector<int>(other.begin(), other.end()), numbers);
        EXPECT_TRUE(list.empty()); // NOLINT(bugprone-use-after-move): that is what is asked
        list.push_back(7);
        EXPECT_EQ(std::vector<int>(list.begin(), list.end()), std::vector<int>{7});
        list = std::move(other);
        EXPECT_EQ(std::vector<int>(list.begin(), list.end()), numbers);
    }
}

// The first ones need no heap: they lie within the object.
TEST(ShortList, KeepsAFewInside) {
    ShortList<int, 4> list(counted(4));
    const auto* const self = reinterpret_cast<const char*>(&list);
    const auto* const data = reinterpret_cast<const char*>(list.data());
    EXPECT_TRUE(data >= self && data < self + sizeof list);
    list.push_back(5);
    EXPECT_EQ(std::vector<int>(list.begin(), list.end()), counted(5));
}

} // namespace
} // namespace kodo
