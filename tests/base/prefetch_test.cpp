// SPDX-License-Identifier: MIT
#include "base/prefetch.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace kodo {
namespace {

TEST(PrefetchList, IsVisitedInTheOrderOfInsertion) {
    struct Large {
        char bytes[128];
    };
    const std::vector<Large> list(100);
    for (const std::uint32_t count : {0u, 1u, 5u, 6u, 7u, 20u}) {
        PrefetchList<20> places;
        std::vector<std::uint32_t> wanted;
        for (std::uint32_t k = 0; k < count; ++k) {
            places.add(99 - k, k % 3 != 1);
            if (k % 3 != 1) {
                wanted.push_back(99 - k);
            }
        }
        std::vector<std::uint32_t> visited;
        visitPrefetched<2>(places.list(), std::span(list),
                           [&](std::uint32_t place) { visited.push_back(place); });
        EXPECT_EQ(visited, wanted);
    }
}

} // namespace
} // namespace kodo
