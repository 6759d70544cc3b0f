// SPDX-License-Identifier: MIT
// No two buildings look alike: their silhouettes, compared cell by cell.
#include <apart/core/assets.hpp>
#include <apart/core/tuning.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdio>

namespace {

using namespace apart;
using kodo::Vec2;

constexpr int kWide = 32; // cells; each is a square of 0.75 m
constexpr int kHigh = 24;
constexpr int kSamples = 4; // points along each side of a cell: 0.19 m apart, for thin planks
constexpr Real kCell = kFieldWidth / kWide;

/// The cells that blocks of a building cover at a sample point.
struct Silhouette {
    std::string name;
    std::bitset<kWide * kHigh> cells{};
    int left = kWide; // bounding box, in cells
    int right = -1;
    int low = kHigh;

    bool has(int x, int y) const {
        return x >= 0 && x < kWide && y >= 0 && y < kHigh &&
               cells[static_cast<std::size_t>(y * kWide + x)];
    }
    void add(int x, int y) {
        if (x < 0 || x >= kWide || y < 0 || y >= kHigh) {
            return;
        }
        cells.set(static_cast<std::size_t>(y * kWide + x));
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
    }
    Silhouette mirrored() const {
        Silhouette other{name};
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                if (has(x, y)) {
                    other.add(kWide - 1 - x, y);
                }
            }
        }
        return other;
    }
};

bool covers(const std::vector<Vec2>& corners, Vec2 point) {
    for (std::size_t i = 0; i < corners.size(); ++i) { // counter-clockwise
        const Vec2 next = corners[(i + 1) % corners.size()];
        if (cross(next - corners[i], point - corners[i]) < 0) {
            return false;
        }
    }
    return true;
}

void addBlock(Silhouette& silhouette, const PlacedShape& placed) {
    constexpr Real kStep = kCell / kSamples;
    for (const kodo::Polygon& polygon : polygonsOf(placed.shape)) {
        std::vector<Vec2> corners;
        Vec2 low{kFieldWidth, kFieldHeight};
        Vec2 high{-kFieldWidth, 0};
        for (const Vec2 corner : polygon.corners) {
            corners.push_back(placed.frame * corner);
            low = {std::min(low.x, corners.back().x), std::min(low.y, corners.back().y)};
            high = {std::max(high.x, corners.back().x), std::max(high.y, corners.back().y)};
        }
        for (Real y = (std::floor(low.y / kStep) + Real(0.5)) * kStep; y < high.y; y += kStep) {
            for (Real x = (std::floor(low.x / kStep) + Real(0.5)) * kStep; x < high.x; x += kStep) {
                if (covers(corners, {x, y})) {
                    silhouette.add(static_cast<int>(std::floor((x + kFieldWidth / 2) / kCell)),
                                   static_cast<int>(std::floor(y / kCell)));
                }
            }
        }
    }
}

/// Of the blocks that stand or belong to a machine. Empty for a level without a building.
Silhouette silhouetteOf(const Level& level) {
    Silhouette silhouette{level.name};
    for (const FreeBlock& block : level.freeBlocks) {
        const Support support = level.kinds[block.kind].support;
        if (support == Support::Standing || support == Support::Moving) {
            addBlock(silhouette, placedShapeOf(block));
        }
    }
    return silhouette;
}

/// Intersection over union, with `b` moved by whole cells.
double overlapOf(const Silhouette& a, const Silhouette& b, int right, int up) {
    std::size_t both = 0;
    for (int y = 0; y < kHigh; ++y) {
        for (int x = 0; x < kWide; ++x) {
            both += a.has(x, y) && b.has(x - right, y - up) ? 1 : 0;
        }
    }
    return static_cast<double>(both) /
           static_cast<double>(a.cells.count() + b.cells.count() - both);
}

/// The larger overlap: in place, and with feet and middles of both in one place.
double likeness(const Silhouette& a, const Silhouette& b) {
    const int right = (a.left + a.right - b.left - b.right) / 2;
    return std::max(overlapOf(a, b, 0, 0), overlapOf(a, b, right, a.low - b.low));
}

std::vector<Silhouette> allBuildings() {
    std::vector<Silhouette> all;
    for (const std::string& name : levelNames()) {
        Silhouette silhouette = silhouetteOf(std::get<Level>(loadLevel(name)));
        if (silhouette.cells.any()) {
            all.push_back(std::move(silhouette));
        }
    }
    return all;
}

// A building that lacks a quarter of another, say its roof or a storey, has an overlap of 0.75 with
// it: that is the same idea again. Below 0.7 it is another one. Compact buildings in the middle of
// the field share much of their core: a triangle has 0.5 with the rectangle around it.
constexpr double kAlike = 0.7;

TEST(Silhouettes, OfALevelAndItsMirrorImageAreAlike) {
    const Silhouette ship = silhouetteOf(std::get<Level>(loadLevel("ship")));
    EXPECT_EQ(likeness(ship, ship), 1);
    EXPECT_EQ(ship.mirrored().mirrored().cells, ship.cells);
    Silhouette moved{"moved"};
    for (int y = 0; y < kHigh; ++y) {
        for (int x = 0; x < kWide; ++x) {
            if (ship.has(x, y)) {
                moved.add(x + 1, y - 2);
            }
        }
    }
    EXPECT_LT(overlapOf(ship, moved, 0, 0), 0.9);
    EXPECT_EQ(likeness(ship, moved), 1);
}

TEST(Silhouettes, OfABuildingWithoutItsTopAreAlike) {
    for (const Silhouette& whole : allBuildings()) {
        Silhouette lower{"lower"};
        std::size_t left = whole.cells.count() * 3 / 4; // cells
        for (int y = 0; y < kHigh; ++y) {
            for (int x = 0; x < kWide; ++x) {
                if (left > 0 && whole.has(x, y)) {
                    lower.add(x, y);
                    --left;
                }
            }
        }
        EXPECT_GT(likeness(whole, lower), kAlike) << whole.name;
    }
}

TEST(Silhouettes, NoTwoBuildingsAreAlike) {
    const std::vector<Silhouette> all = allBuildings();
    EXPECT_GE(all.size(), 24u);
    double most = 0;
    std::string pair;
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const double share =
                std::max(likeness(all[a], all[b]), likeness(all[a], all[b].mirrored()));
            EXPECT_LT(share, kAlike) << all[a].name << " and " << all[b].name;
            if (share > most) {
                most = share;
                pair = all[b].name + " and " + all[a].name;
            }
        }
    }
    std::printf("%zu buildings; the most alike: %s, overlap %.2f\n", all.size(), pair.c_str(),
                most);
}

} // namespace
