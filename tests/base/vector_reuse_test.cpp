// SPDX-License-Identifier: MIT
#include "base/vector_reuse.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kodo {
namespace {

// Lists of bodies between two steps: forces that cancel out, or bodies that come and go, must not
// lengthen them without end.
TEST(AppendIndex, KeepsAllIndicesAndABoundedLength) {
    constexpr std::uint32_t kCount = 7;
    std::vector<std::uint32_t> list;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        appendIndex(list, i * i % kCount, kCount);
        ASSERT_LE(list.size(), 2 * kCount + 1);
    }
    EXPECT_EQ(std::set<std::uint32_t>(list.begin(), list.end()),
              (std::set<std::uint32_t>{0, 1, 2, 4})); // the squares modulo 7
}

} // namespace
} // namespace kodo
