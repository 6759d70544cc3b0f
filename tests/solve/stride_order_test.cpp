// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "propagation/stride_order.hpp"

namespace {

using kodo::StrideOrder;

// W6: every contact exactly once per pass.
TEST(StrideOrder, VisitsEachPlaceOnce) {
    for (std::size_t count = 1; count <= 300; ++count) {
        for (std::uint64_t pass = 0; pass < 20; ++pass) {
            StrideOrder order(count, pass);
            std::vector<int> visits(count, 0);
            for (std::size_t k = 0; k < count; ++k) {
                ++visits.at(order.next());
            }
            EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " places, pass " << pass;
        }
    }
}

TEST(StrideOrder, RepeatsAfterEachRound) {
    StrideOrder order(35, 7);
    std::vector<std::size_t> first;
    std::vector<std::size_t> second;
    for (int k = 0; k < 35; ++k) {
        first.push_back(order.next());
    }
    for (int k = 0; k < 35; ++k) {
        second.push_back(order.next());
    }
    EXPECT_EQ(first, second);
}

TEST(StrideOrder, StrideIsCoprimeToTheCount) {
    for (const std::size_t count : {2u, 12u, 360u, 30030u, 65536u}) {
        for (std::uint64_t pass = 0; pass < 50; ++pass) {
            EXPECT_EQ(std::gcd(StrideOrder(count, pass).stride(), count), 1u);
        }
    }
}

TEST(StrideOrder, AcceptsACountOfZero) {
    EXPECT_EQ(StrideOrder(0, 3).stride(), 1u);
}

// Passes upwards and downwards must be equally likely, or a pile would lean. Of 10,000 passes, half
// have a stride below half of the count. Three standard deviations are 150.
TEST(StrideOrder, GoesUpAsOftenAsDown) {
    constexpr std::size_t kCount = 1009; // a prime: every stride is allowed
    int up = 0;
    for (std::uint64_t pass = 0; pass < 10000; ++pass) {
        up += StrideOrder(kCount, pass).stride() * 2 <= kCount ? 1 : 0;
    }
    EXPECT_NEAR(up, 5000, 150);
}

// Each of two neighbours must come first in half of the passes.
TEST(StrideOrder, FavoursNeitherOfTwoNeighbours) {
    constexpr std::size_t kCount = 60;
    int first = 0;
    for (std::uint64_t pass = 0; pass < 10000; ++pass) {
        StrideOrder order(kCount, pass);
        std::size_t place = order.next();
        while (place != 20 && place != 21) {
            place = order.next();
        }
        first += place == 20 ? 1 : 0;
    }
    EXPECT_NEAR(first, 5000, 150);
}

TEST(StrideOrder, DependsOnlyOnCountAndPass) {
    StrideOrder a(100, 42);
    StrideOrder b(100, 42);
    for (int k = 0; k < 100; ++k) {
        EXPECT_EQ(a.next(), b.next());
    }
}

} // namespace
