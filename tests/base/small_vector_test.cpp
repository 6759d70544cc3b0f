// SPDX-License-Identifier: MIT
#include <kodo/convex_shape.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace kodo {
namespace {

std::vector<int> counted(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

// Below, at and beyond the inline capacity, the elements are those of a vector. A copy shares
// nothing with its original.
TEST(SmallVector, BehavesLikeAVectorOfAnyLength) {
    for (const int count : {0, 1, 3, 4, 5, 40}) {
        const std::vector<int> numbers = counted(count);
        SmallVector<int, 4> list(numbers);
        EXPECT_EQ(list.empty(), count == 0);
        ASSERT_EQ(list.size(), numbers.size());
        const SmallVector<int, 4> copy = list;
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

// A moved-from vector is empty and does not keep its former length.
TEST(SmallVector, IsEmptyAfterAMove) {
    for (const int count : {3, 40}) {
        const std::vector<int> numbers = counted(count);
        SmallVector<int, 4> list(numbers);
        SmallVector<int, 4> other = std::move(list);
        EXPECT_EQ(std::vector<int>(other.begin(), other.end()), numbers);
        EXPECT_TRUE(list.empty()); // NOLINT(bugprone-use-after-move): the case under test
        list.push_back(7);
        EXPECT_EQ(std::vector<int>(list.begin(), list.end()), std::vector<int>{7});
        list = std::move(other);
        EXPECT_EQ(std::vector<int>(list.begin(), list.end()), numbers);
    }
}

// Elements up to the inline capacity need no heap.
TEST(SmallVector, StoresAFewElementsInline) {
    SmallVector<int, 4> list(counted(4));
    const auto* const self = reinterpret_cast<const char*>(&list);
    const auto* const data = reinterpret_cast<const char*>(list.data());
    EXPECT_TRUE(data >= self && data < self + sizeof list);
    list.push_back(5);
    EXPECT_EQ(std::vector<int>(list.begin(), list.end()), counted(5));
}

} // namespace
} // namespace kodo
