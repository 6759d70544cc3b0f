// SPDX-License-Identifier: MIT
#include <array>
#include <variant>

#include "c_world.hpp"

namespace {

using namespace c_test;

constexpr std::array<kodo_Vec2, 6> kCorner{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
const std::vector<kodo::Vec2> kSameCorner{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(CGeometry, AHullIsThatOfCpp) {
    std::array<kodo_Vec2, 6> corners{};
    std::size_t count = 0;
    EXPECT_OK(kodo_convexHull(kCorner.data(), kCorner.size(), corners.data(), 6, &count));
    const auto expected = std::get<kodo::Polygon>(kodo::convexHull(kSameCorner)).corners;
    ASSERT_EQ(expected.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(expected[i].x, corners[i].x);
        EXPECT_EQ(expected[i].y, corners[i].y);
    }
}

TEST(CGeometry, PartsOfAConcaveOutlineMakeTheBodyOfCpp) {
    std::array<kodo_Vec2, 16> corners{};
    std::array<std::size_t, 4> sizes{};
    kodo_Polygons made{corners.data(), corners.size(), 0, sizes.data(), sizes.size(), 0};
    EXPECT_OK(kodo_decompose(kCorner.data(), kCorner.size(), &made));
    ASSERT_GE(made.count, 2u);
    std::vector<kodo_Shape> parts;
    const kodo_Vec2* first = corners.data();
    for (std::size_t i = 0; i < made.count; ++i) {
        parts.push_back(kodo_polygon(first, sizes[i]));
        first += sizes[i];
    }
    EXPECT_EQ(corners.data() + made.cornerCount, first);
    const CWorld world;
    world.add(bodyAt(0, 0, kodo_compound(parts.data(), parts.size())));
    kodo::World other = cppWorld();
    other.add({.shape = std::get<kodo::Compound>(kodo::decompose(kSameCorner))});
    EXPECT_EQ(other.stateHash(), world.hash());
}

TEST(CGeometry, WhatHasNoRoomIsCountedAlone) {
    kodo_Polygons made{};
    EXPECT_OK(kodo_decompose(kCorner.data(), kCorner.size(), &made));
    EXPECT_GE(made.count, 2u);
    EXPECT_GE(made.cornerCount, 8u);
}

TEST(CGeometry, BadPointsHaveTheSentenceOfCpp) {
    const std::array<kodo_Vec2, 4> crossed{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
    kodo_Polygons made{};
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_decompose(crossed.data(), crossed.size(), &made));
    const std::vector<kodo::Vec2> same{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    EXPECT_EQ(std::get<kodo::Problem>(kodo::decompose(same)).text(), kodo_errorText());
    std::size_t count = 0;
    EXPECT_EQ(KODO_BAD_DEFINITION, kodo_convexHull(crossed.data(), 2, nullptr, 0, &count));
    EXPECT_EQ(KODO_WRONG_USE, kodo_convexHull(nullptr, 2, nullptr, 0, &count));
    EXPECT_EQ(KODO_WRONG_USE, kodo_decompose(crossed.data(), 4, nullptr));
}

} // namespace
